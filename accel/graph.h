#pragma once
// The cells-and-portals graph, of cells and of the spaces that people know.

#include <cstdint>
#include <vector>

#include "accel/scene.h"

namespace enfilade::accel {

/// Neighbours of each cell: links [offsets[c], offsets[c + 1]) of cell c.
struct CellGraph {
    struct Link {
        CellId to;
        PortalId portal;
    };
    std::vector<std::uint32_t> offsets;  ///< [cell_count + 1]
    std::vector<Link> links;             ///< [2 * portal_count]
};

[[nodiscard]] CellGraph cell_graph(const SceneView& view);

/// Two spaces that touch through portals: what `export` writes as GraphML.
struct SpaceLink {
    SpaceId a;
    SpaceId b;
    PortalKind kind;
    std::uint32_t portal_count;
};

/// All pairs of different spaces with portals between them, in ascending order of (a, b, kind), a < b.
[[nodiscard]] std::vector<SpaceLink> space_graph(const SceneView& view);

/// Component number of each cell, numbered by their first cell: one component in a building whose rooms all have doors.
[[nodiscard]] std::vector<std::uint32_t> components(const CellGraph& graph);

}  // namespace enfilade::accel

#pragma once
// The graph of the spaces that people know (rooms, doors, windows, ...), from the portals between their cells.

#include <cstdint>
#include <vector>

#include "accel/scene.h"
#include "modeler/exports/scene_measure.h"

namespace enfilade::modeler {

/// A space through which light passes: walls and slabs are no places.
struct SpaceNode {
    std::uint32_t space = 0;  ///< into SceneView::spaces
    CellMeasure measure;      ///< summed over its cells; the centre of mass may lie outside a room that is not convex
};

/// All portals of one kind between two spaces.
struct SpaceLink {
    std::uint32_t from = 0;  ///< into SceneView::spaces, the lower one
    std::uint32_t to = 0;
    accel::PortalKind kind = accel::PortalKind::Clear;
    double opening = 0;  ///< square metres
};

struct SpaceGraph {
    std::vector<SpaceNode> nodes;  ///< by space
    std::vector<SpaceLink> links;  ///< by from, to, kind; cuts inside a space are none
};

/// `areas`: portal_areas(scene).
[[nodiscard]] SpaceGraph space_graph(const accel::SceneView& scene, const std::vector<double>& areas);

}  // namespace enfilade::modeler

#pragma once
// A mesh as a generalized map: each connected piece between a volume of its own and what lies outside of it.

#include <cstdint>
#include <vector>

#include "gmap/cell_tuples.h"
#include "modeler/meshes/mesh_report.h"

namespace enfilade::modeler {

/// Faces that are checked together: a shell of a CityJSON solid, or all of a file that knows no solids.
struct MeshBody {
    std::uint32_t first_face = 0;
    std::uint32_t face_count = 0;
    bool is_shell = false;  ///< the file says that this is one closed surface
};

/// The map of a body. An *entry* is a place in `tuples.ring`: a corner of a face, and the edge from it to the next one.
struct MeshMap {
    gmap::CellTuples tuples;            ///< piece p lies between volumes 2p and 2p + 1
    gmap::Map map;                      ///< of the tuples
    std::vector<std::uint32_t> vertex;  ///< [vertex of the map] of the mesh; none for those on cuts
    std::vector<std::uint32_t> face;    ///< [face of the map] of the mesh
    std::uint32_t piece_count = 0;

    // Derived from the map.
    std::vector<std::uint32_t> entry_face;              ///< [entry] face of the map
    std::vector<std::uint32_t> edge;                    ///< [entry]
    std::vector<std::uint32_t> uses;                    ///< [edge] number of entries
    std::vector<std::array<std::uint32_t, 2>> entries;  ///< [edge] the first two of them

    [[nodiscard]] std::uint32_t next(std::uint32_t entry) const {
        const std::uint32_t f = entry_face[entry];
        return entry + 1 < tuples.ring_first[f + 1] ? entry + 1 : tuples.ring_first[f];
    }
    [[nodiscard]] std::uint32_t before(std::uint32_t entry) const {
        const std::uint32_t f = entry_face[entry];
        return entry > tuples.ring_first[f] ? entry - 1 : tuples.ring_first[f + 1] - 1;
    }
    [[nodiscard]] std::uint32_t piece(std::uint32_t map_face) const { return tuples.face_volumes[map_face][0] / 2; }
    /// The two darts of an entry on the side of volume 2p: at its corner, and at the next one.
    [[nodiscard]] gmap::DartId dart(std::uint32_t entry, std::uint32_t end) const {
        const std::uint32_t first = tuples.ring_first[entry_face[entry]];
        return gmap::DartId{4 * first + 2 * (entry - first) + end};
    }
};

/// Rings as they go into the map: corners that repeat the one before and spikes left out. What was left out is blamed
/// and reported (T6, G2).
class CleanRings {
public:
    CleanRings(const MeshBody& body, MeshReport& report);

    /// The outer ring of a face; empty where nothing is left of it.
    [[nodiscard]] std::vector<std::uint32_t> outer(std::uint32_t face) const;
    [[nodiscard]] std::vector<std::uint32_t> inner(const MeshHole& hole) const;

private:
    const Mesh& mesh_;
    std::vector<bool> rough_;  ///< [face of the body] has to be cleaned
    MeshBody body_;
};

/// Builds maps; one for all bodies of a mesh, so that a small shell costs no pass over all vertices.
class MeshMapBuilder {
public:
    explicit MeshMapBuilder(const Mesh& mesh) : mesh_(mesh), local_(mesh.points.size(), UINT32_MAX) {}

    /// The map of the faces of `body` but those that `left_out` marks ([face of the body]; may be empty).
    [[nodiscard]] MeshMap build(const MeshBody& body, const CleanRings& rings, const std::vector<bool>& left_out);

private:
    const Mesh& mesh_;
    std::vector<std::uint32_t> local_;  ///< [vertex] its number in the map being built
};

}  // namespace enfilade::modeler

#pragma once
// T1-T7 of one body: what its map says, in findings about its faces and vertices.

#include <cstdint>
#include <vector>

#include "modeler/meshes/mesh_map.h"

namespace enfilade::modeler {

/// What is wrong with a piece; bits.
enum PieceFault : std::uint8_t {
    open_piece = 1,
    crowded_piece = 2,
    pinched_piece = 4,
    one_sided_piece = 8,
    folded_piece = 16  ///< a face meets itself along an edge: G2 says so
};

/// Faces joined by edges that have two of them. Within a patch one side can be told from the other.
struct MeshPatches {
    std::vector<std::uint32_t> patch;  ///< [face of the map]
    std::vector<bool> turned;          ///< [face of the map] its ring runs against that of the patch's first face
    std::vector<bool> one_sided;       ///< [patch]
    std::uint32_t count = 0;
};

struct MeshTopology {
    MeshMap map;
    std::vector<std::uint8_t> faults;  ///< [piece]
    MeshPatches patches;
};

/// T4: faces that repeat another are marked in `left_out` ([face of the body]), blamed and reported; true where any is.
[[nodiscard]] bool find_repeated_faces(const MeshMap& map, const MeshBody& body, MeshReport& report,
                                       std::vector<bool>& left_out);

/// T2: edges with one face, hole by hole; those that lie on one another are seams of split vertices: one finding.
void check_holes(MeshTopology& topology, MeshReport& report, MeshCount& count);

/// T4: edges with more than two faces, chain by chain.
void check_crowding(MeshTopology& topology, MeshReport& report);

/// T3: fills the patches; those with one side alone are errors.
void check_sides(MeshTopology& topology, MeshReport& report, MeshCount& count);

/// T5: one umbrella a vertex; one piece where the file says that this is one shell.
void check_umbrellas(MeshTopology& topology, const MeshBody& body, MeshReport& report);

/// T1-T7 by `gmap::validate`, on the pieces that nothing is said of yet: what is left are shells too small (T6) and
/// handles (T7, a note).
void check_map(MeshTopology& topology, MeshReport& report);

}  // namespace enfilade::modeler

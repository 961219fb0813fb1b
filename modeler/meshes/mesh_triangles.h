#pragma once
// The faces of a mesh as triangles, found on the way through G2 and G3.

#include <array>
#include <cstdint>
#include <vector>

#include "modeler/meshes/mesh_report.h"

namespace enfilade::modeler {

struct MeshTriangles {
    std::vector<std::array<std::uint32_t, 3>> corners;  ///< vertices of the mesh, turning as the face does
    std::vector<std::uint32_t> face;                    ///< ascending
    std::vector<bool> missing;                          ///< [face] no triangles: its ring is at fault, or it is flat
};

/// G1: vertices at the place of another one of the same piece ([face] `piece`), and vertices that no face uses.
void check_places(const std::vector<std::uint32_t>& place, const std::vector<std::uint32_t>& piece, MeshReport& report,
                  MeshCount& count);

/// G2: every face is one disc with an area. G3: its corners lie in one plane, and so do its triangles.
[[nodiscard]] MeshTriangles check_faces(const std::vector<std::uint32_t>& place, MeshReport& report, MeshCount& count);

}  // namespace enfilade::modeler

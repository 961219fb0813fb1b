#pragma once
// G4 and G5: do surfaces pierce themselves or each other, and do solids lie as they should?

#include <cstdint>
#include <vector>

#include "modeler/meshes/mesh_triangles.h"

namespace enfilade::modeler {

/// A connected surface of the mesh.
struct MeshPiece {
    std::uint32_t first_face = 0;  ///< of the mesh
    std::uint32_t solid = 0;       ///< into Mesh::solids; none where the file names none
    std::uint32_t shell = 0;       ///< of the solid: 0 is the outer one
    std::uint32_t group = 0;       ///< pieces of one group may not overlap
    bool closed = false;           ///< no fault of topology: it has an inside
    bool one_sided = false;
};

/// What each face belongs to.
struct MeshPieces {
    std::vector<MeshPiece> pieces;     ///< ascending by group
    std::vector<std::uint32_t> piece;  ///< [face]; none where it is in no map
    std::vector<bool> turned;          ///< [face] its ring runs against that of its patch's first face
};

/// Two triangles that meet where they should not; of different pieces: that pierce each other.
struct Crossing {
    std::uint32_t a = 0, b = 0;  ///< triangles, a < b
};

/// Pairs of triangles of one group that cross, ascending; `place` says which vertices are one point. Within a piece any
/// common point beyond shared corners and sides counts, between pieces one has to go through the other. Exact. Ends
/// early, with `complete` false, where there are far too many.
[[nodiscard]] std::vector<Crossing> find_crossings(const Mesh& mesh, const MeshTriangles& triangles,
                                                   const MeshPieces& pieces, const std::vector<std::uint32_t>& place,
                                                   bool& complete);

/// G4: surfaces that pierce themselves. Returns the pairs of pieces that pierce each other, ascending.
[[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> check_crossings(
    const MeshTriangles& triangles, const MeshPieces& pieces, const std::vector<std::uint32_t>& place,
    MeshReport& report, MeshCount& count);

/// T3: faces that are turned against the others of their surface. G5: volumes are positive, voids lie in their solid,
/// solids do not overlap.
void check_solids(const MeshTriangles& triangles, const MeshPieces& pieces, const std::vector<std::uint32_t>& place,
                  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& crossing, MeshReport& report);

}  // namespace enfilade::modeler

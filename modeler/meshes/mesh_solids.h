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

/// Two triangles of a piece that meet where they should not.
struct Crossing {
    std::uint32_t a = 0, b = 0;  ///< triangles, a < b
    bool pierces = false;        ///< a side of one goes through the inside of the other
};

using PiecePairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// What the search for crossings found; everything ascending.
struct Crossings {
    std::vector<Crossing> within;  ///< a piece: any common point beyond shared corners and sides
    PiecePairs piercing;           ///< pieces of a group of which one goes through the other, deeper than they touch
    PiecePairs near;               ///< pieces of a group whose triangles come near each other
    bool complete = true;          ///< false: the search ended early, there are far too many
};

/// Nearer than this surfaces of different pieces touch: what rounding makes of coordinates of this size.
[[nodiscard]] double touching_distance(const Mesh& mesh);

/// `place` says which vertices are one point. Exact.
[[nodiscard]] Crossings find_crossings(const Mesh& mesh, const MeshTriangles& triangles, const MeshPieces& pieces,
                                       const std::vector<std::uint32_t>& place);

/// G4: surfaces that go through themselves.
void check_crossings(const Crossings& crossings, const MeshTriangles& triangles, const MeshPieces& pieces,
                     const std::vector<std::uint32_t>& place, MeshReport& report, MeshCount& count);

/// T3: faces that are turned against the others of their surface. G5: volumes are positive, voids lie in their solid,
/// solids do not overlap.
void check_solids(const MeshTriangles& triangles, const MeshPieces& pieces, const std::vector<std::uint32_t>& place,
                  const Crossings& crossings, MeshReport& report);

}  // namespace enfilade::modeler

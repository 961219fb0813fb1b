#pragma once
// What every mesh that a reader lets through has to be.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "modeler/meshes/mesh.h"

namespace enfilade::modeler {

/// Aborts where a number of the mesh leads out of its arrays, or a coordinate is not finite.
inline void require_consistent(const Mesh& mesh) {
    const auto require = [](bool holds) {
        if (!holds) std::abort();
    };
    require(!mesh.ring_first.empty() && mesh.ring_first.front() == 0 && mesh.ring_first.back() == mesh.ring.size());
    require(std::is_sorted(mesh.ring_first.begin(), mesh.ring_first.end()));
    for (const std::uint32_t v : mesh.ring) require(v < mesh.points.size());
    for (const std::uint32_t v : mesh.hole_ring) require(v < mesh.points.size());
    for (const MeshHole& hole : mesh.holes)
        require(hole.face < mesh.face_count() && hole.first + std::size_t{hole.count} <= mesh.hole_ring.size());
    for (const auto& point : mesh.points)
        for (const double x : point) require(std::isfinite(x) && std::abs(x) <= 1e12);
    std::size_t face = 0, shell = 0;
    for (const MeshSolid& solid : mesh.solids) {
        require(solid.first_shell == shell && solid.first_vertex <= mesh.points.size());
        shell += solid.shell_count;
    }
    require(mesh.solids.empty() || shell == mesh.shells.size());
    for (const MeshShell& s : mesh.shells) {
        require(s.first_face == face);
        face += s.face_count;
    }
    require(mesh.shells.empty() || face == mesh.face_count());
    for (const MeshGroup& group : mesh.groups) require(group.first_face <= mesh.face_count());
}

}  // namespace enfilade::modeler

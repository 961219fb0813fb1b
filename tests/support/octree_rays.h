#pragma once
// Rays that octrees might fall over: along, on and through what its lattice and its triangles are made of.

#include <array>
#include <cstdint>

#include "accel/octree/octree.h"
#include "render/object_tracer.h"
#include "tests/support/object_rays.h"
#include "tests/support/tried_mesh.h"

namespace enfilade::test {

enum class OctreeRayFamily : std::uint8_t {
    Outside,             ///< from around the mesh into it
    Inside,              ///< from within
    Far,                 ///< from 10 to 1e6 sizes away
    AtCorners,           ///< aimed exactly at a corner of a triangle
    AtEdges,             ///< at a point of an edge
    FromTriangles,       ///< starting at a corner, on an edge, in the middle of a triangle
    AlongAxes,           ///< the other parts are 0 and -0.0; half of them through corners of triangles
    NearlyAlongAxes,     ///< the other parts are 1e-3 to 1e-45
    InLatticePlanes,     ///< from a plane of the lattice along it, or out of it
    AlongLatticeEdges,   ///< in two planes at once
    FromLatticeCorners,  ///< to other corners, mostly along diagonals
    Scaled,              ///< directions of length 1e-18 and 1e18
    Parts                ///< only between two distances, some of them equal, some of them backwards
};

struct NamedOctreeRays {
    OctreeRayFamily family;
    const char* name;
};

inline constexpr std::array octree_ray_families = {
    NamedOctreeRays{OctreeRayFamily::Outside, "outside"},
    NamedOctreeRays{OctreeRayFamily::Inside, "inside"},
    NamedOctreeRays{OctreeRayFamily::Far, "far"},
    NamedOctreeRays{OctreeRayFamily::AtCorners, "at corners"},
    NamedOctreeRays{OctreeRayFamily::AtEdges, "at edges"},
    NamedOctreeRays{OctreeRayFamily::FromTriangles, "from triangles"},
    NamedOctreeRays{OctreeRayFamily::AlongAxes, "along axes"},
    NamedOctreeRays{OctreeRayFamily::NearlyAlongAxes, "nearly along axes"},
    NamedOctreeRays{OctreeRayFamily::InLatticePlanes, "in lattice planes"},
    NamedOctreeRays{OctreeRayFamily::AlongLatticeEdges, "along lattice edges"},
    NamedOctreeRays{OctreeRayFamily::FromLatticeCorners, "from lattice corners"},
    NamedOctreeRays{OctreeRayFamily::Scaled, "scaled"},
    NamedOctreeRays{OctreeRayFamily::Parts, "parts"},
};

/// Draws them for one mesh and lattice.
class OctreeRays {
public:
    OctreeRays(const TriedMesh& mesh, const accel::OctreeFrame& frame, std::uint64_t seed);
    [[nodiscard]] render::ObjectRay take(OctreeRayFamily family);

private:
    render::ObjectRay outside();
    render::ObjectRay at_edges(bool corners);
    render::ObjectRay from_triangles();
    render::ObjectRay along_axes();
    render::ObjectRay nearly_along_axes();
    render::ObjectRay in_lattice(int planes);
    render::ObjectRay from_lattice_corners();
    render::ObjectRay parts();

    double share() { return 0.5 * numbers_.next() + 0.5; }  ///< [0, 1)
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(share() * n); }
    render::Vec3d in_box(double wider = 1);
    render::Vec3d corner();
    double lattice_place(int axis, std::uint32_t plane) const;
    std::uint32_t lattice_plane();

    const TriedMesh& mesh_;
    accel::OctreeFrame frame_;
    RandomNumbers numbers_;
    render::Vec3d middle_;
};

}  // namespace enfilade::test

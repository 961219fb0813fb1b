#pragma once
// Every way to ask an octree, against brute force.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "render/object_tracer.h"
#include "tests/support/tried_mesh.h"

namespace enfilade::test {

/// One way to walk: as the functions of ObjectTracer, for one mesh.
struct OctreeWalk {
    std::string name;
    std::function<bool(render::ObjectRay&)> nearest;  ///< whether it hit
    std::function<bool(const render::ObjectRay&)> blocked;
    /// nullptr: it walks single rays
    std::function<void(const std::int32_t*valid, render::ObjectRays&)> nearest16, nearest16_apart;
};

/// Every one there is: the scalar walk, those of registers by every instruction set that the machine has, and those of
/// the paper. octree: has to outlive them
[[nodiscard]] std::vector<OctreeWalk> octree_walks(const TriedOctree& octree);

/// Sixteen of them by columns, the last again and again where fewer are left.
[[nodiscard]] render::ObjectRays rays_together(const std::vector<render::ObjectRay>& rays, std::size_t first);

/// What so many rays came to.
struct OctreeTally {
    std::uint64_t rays = 0, hits = 0;
    /// Other answers than those of brute force, of rays that run along a triangle's plane: the test itself takes a
    /// place beside the triangle for the meeting, so which leaves are passed before decides.
    std::uint64_t beside = 0;
    std::uint64_t wrong = 0;  ///< other answers
    std::string first_wrong;  ///< the first of them, with all digits
    void add(const OctreeTally& other);
};

/// Asks for the nearest, whether any, and for all by sixteens, neighbours and strangers, in every walk. Answers
/// have to be those of brute force to the last bit. rays: in groups of 16 as they are to be asked together
[[nodiscard]] OctreeTally judge_octree(const TriedMesh& mesh, const std::vector<OctreeWalk>& walks,
                                       const std::vector<render::ObjectRay>& rays);

}  // namespace enfilade::test

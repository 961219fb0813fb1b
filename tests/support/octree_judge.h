#pragma once
// Every way to ask an octree, against brute force.

#include <cstdint>
#include <string>
#include <vector>

#include "accel/octree/linked_octree.h"
#include "render/object_tracer.h"
#include "render/octree_kernels.h"
#include "tests/support/tried_mesh.h"

namespace enfilade::test {

/// A walk: the scalar one, or one of registers by an instruction set.
struct OctreeVariant {
    std::string name;
    const render::detail::OctreeKernels* kernels;
};

/// Those that the machine has.
[[nodiscard]] const std::vector<OctreeVariant>& octree_variants();

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

/// Asks for the nearest, whether any, and for all by sixteens, neighbours and strangers, with every variant. Answers
/// have to be those of brute force to the last bit. rays: in groups of 16 as they are to be asked together
[[nodiscard]] OctreeTally judge_octree(const TriedMesh& mesh, const accel::OctreeView& tree,
                                       const std::vector<render::ObjectRay>& rays);

}  // namespace enfilade::test

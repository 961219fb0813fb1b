#pragma once
// Octrees of a mesh asked by rays of every family.

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "tests/support/octree_judge.h"
#include "tests/support/octree_rays.h"
#include "tests/support/tried_mesh.h"

namespace enfilade::test {

/// The mesh, so many times larger, then so far away along (1, -0.7, 0.4).
inline accel::InputMesh moved(accel::InputMesh mesh, float scale, float offset) {
    for (auto& v : mesh.vertices) {
        v[0] = scale * v[0] + offset;
        v[1] = scale * v[1] - 0.7f * offset;
        v[2] = scale * v[2] + 0.4f * offset;
    }
    return mesh;
}

/// 16 * groups rays of every family, by every walk through the octree: expects the answers of brute force.
inline OctreeTally judge_every_family(const TriedMesh& mesh, const TriedOctree& octree, int groups,
                                      std::uint64_t seed) {
    const std::vector<OctreeWalk> walks = octree_walks(octree);
    OctreeRays draw(mesh, octree.tree().frame, seed);
    OctreeTally sum;
    for (const NamedOctreeRays& named : octree_ray_families) {
        std::vector<render::ObjectRay> rays;
        for (int i = 0; i < 16 * groups; ++i) rays.push_back(draw.take(named.family));
        const OctreeTally tally = judge_octree(mesh, walks, rays);
        EXPECT_EQ(tally.wrong, 0u) << named.name << ": " << tally.first_wrong;
        sum.add(tally);
    }
    return sum;
}

}  // namespace enfilade::test

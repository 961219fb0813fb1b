#pragma once
// Scenes and rays for trees of boxes, and what rays meet there by trying every triangle.

#include <cstdint>
#include <random>
#include <vector>

#include "accel/scene.h"
#include "render/cuda/bvh_forest.h"
#include "tests/support/object_scenes.h"

namespace enfilade::test {

/// A scene without its cells, and its trees. Leaves hold up to eight triangles, or one.
struct TriedForest {
    explicit TriedForest(const accel::SceneView& view, std::uint32_t largest_leaf = 8, float split_share = 0)
        : scene(view),
          forest(build_forest(
              scene, {.largest_leaf = largest_leaf, .split_share = split_share, .mesh_split_share = split_share},
              accel::SerialExecutor())) {}
    render::cuda::TriangleScene scene;
    render::cuda::BvhForest forest;
};

/// Rays from places in the box, along its axes now and then.
inline std::vector<render::cuda::BvhQuery> rays_in(const render::SahBox& box, std::uint64_t seed, int count) {
    std::mt19937_64 random(seed);
    const auto number = [&] { return static_cast<float>(random() >> 40) * 0x1p-24f; };
    const auto place = [&] {
        return render::Vec3f{box.low[0] + number() * (box.high[0] - box.low[0]),
                             box.low[1] + number() * (box.high[1] - box.low[1]),
                             box.low[2] + number() * (box.high[2] - box.low[2])};
    };
    std::vector<render::cuda::BvhQuery> rays;
    for (int i = 0; i < count; ++i) {
        const render::Vec3f from = place(), to = place();
        render::Vec3f d = to - from;
        if (i % 7 == 3) d.x = 0;
        if (i % 7 == 5) d.y = d.z = 0;
        if (d.x == 0 && d.y == 0 && d.z == 0) d.z = 1;
        rays.push_back({from, d, 0, i % 5 == 0 ? 1.0f : 3e38f, i % 11 == 0 ? 0u : render::no_object});
    }
    return rays;
}

/// What a ray meets: items and instances as trees have them.
struct BvhTruth {
    float t = 0;
    std::uint32_t item = ~0u;  ///< ~0: nothing
    std::uint32_t instance = render::no_object;
};

/// By the watertight test, of all triangles of the scene: the same numbers as trees.
inline BvhTruth try_all(const TriedForest& tried, const render::cuda::BvhQuery& query) {
    using namespace render::cuda;
    BvhTruth best;
    best.t = query.far;
    const std::vector<BvhExtent> extents = extents_of(tried.scene, tried.forest);
    const auto try_space = [&](const SpaceRay<TriangleTest::Watertight>& ray, std::uint32_t begin, std::uint32_t end,
                               std::uint32_t instance) {
        for (std::uint32_t t = begin; t < end; ++t) {
            if (!tried.scene.can_be_hit[t]) continue;
            const TriangleRecord record = record_of(tried.scene, t, TriangleTest::Watertight);
            float at;
            if (!ray.meets(load_record(&record, 0), query.near, best.t, at)) continue;
            if (at == best.t && best.item != ~0u && instance >= best.instance) continue;
            best = {at, t, instance};
        }
    };
    SpaceRay<TriangleTest::Watertight> ray;
    for (std::uint32_t k = 0; k < tried.scene.instances.size(); ++k) {
        const std::uint32_t mesh = tried.scene.mesh_of[k];
        if (k == query.skipped || tried.forest.meshes[mesh].nodes.empty()) continue;
        const InstanceAt at = load_instance(tried.scene.instances.data(), k);
        ray.aim(at.turned(query.origin - at.origin), at.turned(query.direction), &extents[k]);
        try_space(ray, tried.scene.mesh_first[mesh], tried.scene.mesh_first[mesh + 1], k);
    }
    ray.aim(query.origin, query.direction, &extents.back());
    try_space(ray, 0, tried.scene.face_triangles, render::no_object);
    return best;
}

}  // namespace enfilade::test

#pragma once
// A scene as Bvh2Walk reads it, laid out by the host.

#include <vector>

#include "render/cuda/bvh2_walk.h"
#include "render/cuda/bvh_forest.h"

namespace enfilade::render::cuda {

struct Bvh2Arrays {
    std::vector<BvhNode> nodes;
    std::vector<TriangleRecord> records;
    std::vector<BvhInstance> instances;
    std::vector<BvhExtent> extents;
    bool is_empty = false;

    /// Of these arrays.
    [[nodiscard]] Bvh2View view() const {
        return {nodes.data(),
                records.data(),
                instances.data(),
                extents.data(),
                static_cast<std::uint32_t>(instances.size()),
                is_empty ? 1u : 0u};
    }
};

/// The scene's tree first, then those of the meshes; instances name the roots of theirs.
[[nodiscard]] Bvh2Arrays lay_out_bvh2(const TriangleScene& scene, const BvhForest& forest, TriangleTest test);

}  // namespace enfilade::render::cuda

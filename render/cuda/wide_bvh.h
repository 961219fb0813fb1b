#pragma once
// A scene as WideBvhWalk reads it, laid out by the host.

#include <vector>

#include "render/cuda/bvh_forest.h"
#include "render/cuda/wide_bvh_walk.h"

namespace enfilade::render::cuda {

struct WideBvhArrays {
    std::vector<WideNode> nodes;
    std::vector<TriangleRecord> records;
    std::vector<BvhInstance> instances;
    std::vector<BvhExtent> extents;
    bool is_empty = false;
    int depth = 0;  ///< nodes on the longest path of one tree

    /// Of these arrays.
    [[nodiscard]] WideBvhView view() const {
        return {nodes.data(),
                records.data(),
                instances.data(),
                extents.data(),
                static_cast<std::uint32_t>(instances.size()),
                is_empty ? 1u : 0u};
    }
};

/// The scene's tree first, then those of the meshes; instances name the roots of theirs. Binary nodes become wide ones
/// where the surface area heuristic says so (Ylitie, Karras, Laine 2017, section 3.1; a node costs 1, a record 0.3);
/// where that were deeper than `largest_wide_depth`, where depth says so. \pre leaves of the forest hold one item
[[nodiscard]] WideBvhArrays lay_out_wide_bvh(const TriangleScene& scene, const BvhForest& forest, TriangleTest test);

}  // namespace enfilade::render::cuda

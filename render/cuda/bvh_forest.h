#pragma once
// The trees of a scene as the host builds them: one over faces and objects together, one for each mesh.

#include <vector>

#include "accel/parallel_for.h"
#include "render/cuda/bvh_ray.h"
#include "render/cuda/triangle_scene.h"
#include "render/sah_tree.h"

namespace enfilade::render::cuda {

/// Items of `top` are triangles of faces, and objects with `instance_bit`, which have leaves of their own: where faces
/// stand between objects, one tree parts both. Items of `meshes` are triangles by their numbers in the scene.
struct BvhForest {
    SahTree top;
    std::vector<SahTree> meshes;  ///< [mesh]; without nodes where nothing of it is ever hit
};

struct BvhForestOptions {
    std::uint32_t largest_leaf = 8;
    float node_cost = 1.2f;
    float split_share = 0;       ///< of faces: see triangle_entries
    float mesh_split_share = 0;  ///< of meshes
};

/// Cost: about 1 us a triangle and core.
[[nodiscard]] BvhForest build_forest(const TriangleScene& scene, const BvhForestOptions& options,
                                     const accel::Executor& executor);

/// The record of an item.
[[nodiscard]] TriangleRecord record_of(const TriangleScene& scene, std::uint32_t item, TriangleTest test);

/// Of each instance's mesh, then of the scene.
[[nodiscard]] std::vector<BvhExtent> extents_of(const TriangleScene& scene, const BvhForest& forest);

}  // namespace enfilade::render::cuda

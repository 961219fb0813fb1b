#include "render/cuda/bvh2.h"

namespace enfilade::render::cuda {
namespace {

/// Appends a tree; where its root lies.
std::uint32_t append_tree(const TriangleScene& scene, const SahTree& tree, TriangleTest test, Bvh2Arrays& arrays) {
    const auto first_node = static_cast<std::uint32_t>(arrays.nodes.size());
    const auto first_record = static_cast<std::uint32_t>(arrays.records.size());
    for (BvhNode node : tree.nodes) {
        for (std::uint32_t& child : node.child) child += (child & leaf_bit) != 0 ? first_record : first_node;
        arrays.nodes.push_back(node);
    }
    for (const std::uint32_t item : tree.order) {
        TriangleRecord record = record_of(scene, item & ~last_bit, test);
        if ((item & last_bit) != 0) record.item |= end_bit;
        arrays.records.push_back(record);
    }
    return first_node;
}

}  // namespace

Bvh2Arrays lay_out_bvh2(const TriangleScene& scene, const BvhForest& forest, TriangleTest test) {
    Bvh2Arrays arrays;
    arrays.is_empty = forest.top.nodes.empty();
    append_tree(scene, forest.top, test, arrays);
    std::vector<std::uint32_t> roots;
    for (const SahTree& tree : forest.meshes) roots.push_back(append_tree(scene, tree, test, arrays));
    arrays.instances = scene.instances;
    for (std::size_t k = 0; k < arrays.instances.size(); ++k) arrays.instances[k].root = roots[scene.mesh_of[k]];
    arrays.extents = extents_of(scene, forest);
    return arrays;
}

}  // namespace enfilade::render::cuda

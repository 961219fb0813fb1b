#include "render/cuda/octree_arrays.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <type_traits>

#include "render/cuda/launch.h"

namespace enfilade::render::cuda {
namespace {

constexpr std::uint32_t columns = 10;  ///< floats a reference in accel::LinkedOctree

template <class T>
Buffer<T> uploaded(Device& device, const T* values, std::size_t count) {
    return Buffer<T>(device, std::span<const T>(values, count));
}

/// A leaf's triangles from columns to records.
struct WriteRecords {
    ColumnTree from;
    Quad* records;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        const accel::LinkedLeaf& leaf = from.view.leaves[i];
        for (std::uint32_t j = 0; j < leaf.count; ++j) {
            const ColumnTree::Place place = {leaf.first + j, leaf.count};
            std::uint32_t none = 0;
            const TriangleCorners p = from.triangle(place, none);
            Quad* to = records + 3 * std::size_t{leaf.first / columns + j};
            to[0] = {p.a[0], p.a[1], p.a[2], from.number(place, 0)};
            to[1] = {p.b[0], p.b[1], p.b[2], 0};
            to[2] = {p.c[0], p.c[1], p.c[2], 0};
        }
    }
};

/// The same, to what leads to the mesh's corners.
struct WriteReferences {
    ColumnTree from;
    const accel::MeshTriangle* triangles;
    IndexedTree::Reference* references;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        const accel::LinkedLeaf& leaf = from.view.leaves[i];
        for (std::uint32_t j = 0; j < leaf.count; ++j) {
            const std::uint32_t number = from.number({leaf.first + j, leaf.count}, 0);
            const accel::MeshTriangle& triangle = triangles[number];
            references[leaf.first / columns + j] = {triangle.corners[0], triangle.corners[1], triangle.corners[2],
                                                    number};
        }
    }
};

struct WriteQuads {
    const accel::Vertex* places;
    Quad* quads;
    ENFILADE_HD void operator()(std::uint64_t i) const { quads[i] = {places[i].x, places[i].y, places[i].z, 0}; }
};

/// Leaves whose `first` counts references, and what each octant reads of them.
struct WriteLeaves {
    const accel::LinkedLeaf* from;
    accel::LinkedLeaf* leaves;
    OctantLeaf* by_octant;  ///< or nullptr
    std::uint32_t count;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        accel::LinkedLeaf leaf = from[i];
        leaf.first /= columns;
        leaves[i] = leaf;
        if (by_octant == nullptr) return;
        const std::uint32_t triangles = leaf.count < many_triangles ? leaf.count : many_triangles;
        for (std::uint32_t octant = 0; octant < 8; ++octant)
            by_octant[std::size_t{octant} * count + i] = {leaf.first,
                                                          head_of(leaf, octant, 0).exits.bits | triangles << 24};
    }
};

}  // namespace

OctreeArrays upload_octree(Device& device, const accel::LinkedOctree& tree) {
    OctreeArrays arrays;
    arrays.view = tree.copied([&](const auto* values, std::size_t count) {
        using T = std::remove_cvref_t<decltype(*values)>;
        Buffer<T>* to = nullptr;
        if constexpr (std::is_same_v<T, accel::LinkedLeaf>) to = &arrays.leaves;
        else if constexpr (std::is_same_v<T, float>) to = &arrays.corners;
        else to = &arrays.jumps;
        *to = uploaded(device, values, count);
        return static_cast<const T*>(to->data());
    });
    if (arrays.view.leaves == nullptr) return arrays;
    for (const accel::LinkedLeaf* leaf = tree.view().leaves; leaf != tree.view().leaves + arrays.leaves.size(); ++leaf)
        arrays.references += leaf->count;
    return arrays;
}

OctreeArrays build_octree_arrays(Device& device, const accel::MeshPart& mesh, const accel::OctreeOptions& options,
                                 const accel::Executor& executor) {
    const accel::Octree tree = accel::build_octree(mesh, options, executor);
    OctreeArrays arrays = upload_octree(device, accel::LinkedOctree(tree, mesh, executor));
    if (arrays.view.leaves == nullptr) return arrays;
    use_jump_levels(device, tree, accel::jump_levels_for(tree.frame.depth, tree.leaves.size(), most_device_jump_levels),
                    arrays);
    return arrays;
}

void use_jump_levels(Device& device, const accel::Octree& tree, std::uint32_t levels, OctreeArrays& arrays) {
    const accel::JumpTable table = accel::build_jump_table(tree, levels);
    arrays.jumps = uploaded(device, table.entries.data(), table.entries.size());
    arrays.view.jumps = arrays.jumps.data();
    arrays.view.jump_levels = table.levels;
}

MeshOnDevice::MeshOnDevice(Device& device, const accel::MeshPart& mesh, std::size_t vertex_count,
                           std::size_t triangle_count)
    : places(uploaded(device, mesh.places, vertex_count)),
      triangles(uploaded(device, mesh.triangles, triangle_count)),
      used(device, mesh.used) {}

LeafArrays DeviceOctree::leaf_arrays(Device& device, const DeviceOctreeLayout& layout) {
    const std::size_t count = arrays_.leaves.size();
    leaves_ = Buffer<accel::LinkedLeaf>(device, count);
    if (layout.has_octant_leaves) octant_leaves_ = Buffer<OctantLeaf>(device, 8 * count);
    for_each(
        device, count,
        WriteLeaves{arrays_.leaves.data(), leaves_.data(), octant_leaves_.data(), static_cast<std::uint32_t>(count)});
    return {octant_leaves_.data(), leaves_.data(), static_cast<std::uint32_t>(count)};
}

DeviceOctree::DeviceOctree(Device& device, OctreeArrays arrays, const DeviceOctreeLayout& layout,
                           const MeshOnDevice* mesh)
    : arrays_(std::move(arrays)) {
    const ColumnTree columns_tree = {arrays_.view};
    size_ = arrays_.view.box.size;
    tree_ = columns_tree;
    if (layout.triangles == TriangleLayout::Columns || arrays_.view.leaves == nullptr) return;
    const LeafArrays leaves = leaf_arrays(device, layout);
    accel::OctreeView view = arrays_.view;
    view.leaves = leaves_.data();  // not nullptr: there is something to hit
    view.corners = nullptr;
    if (layout.triangles == TriangleLayout::Records) {
        quads_ = Buffer<Quad>(device, 3 * arrays_.references);
        for_each(device, arrays_.leaves.size(), WriteRecords{columns_tree, quads_.data()});
        tree_ = RecordTree{view, leaves, quads_.data()};
    } else {
        if (mesh == nullptr) throw std::invalid_argument("indexed triangles lead to a mesh");
        quads_ = Buffer<Quad>(device, mesh->places.size());
        references_ = Buffer<IndexedTree::Reference>(device, arrays_.references);
        for_each(device, mesh->places.size(), WriteQuads{mesh->places.data(), quads_.data()});
        for_each(device, arrays_.leaves.size(),
                 WriteReferences{columns_tree, mesh->triangles.data(), references_.data()});
        tree_ = IndexedTree{view, leaves, references_.data(), quads_.data()};
    }
    device.wait();
    arrays_.leaves = {};
    arrays_.corners = {};
}

DeviceOctree::DeviceOctree(Device& device, const accel::RopeOctree& tree, bool walks_in_double) {
    const accel::RopeView view = tree.copied([&](const auto* values, std::size_t count) {
        using T = std::remove_cvref_t<decltype(*values)>;
        Buffer<T> copy = uploaded(device, values, count);
        const T* at = copy.data();
        if constexpr (std::is_same_v<T, accel::RopeTriangle>) rope_triangles_ = std::move(copy);
        else if constexpr (std::is_same_v<T, accel::RopeBox>) rope_boxes_ = std::move(copy);
        else (cube_map_.size() == 0 && words_.size() != 0 ? cube_map_ : words_) = std::move(copy);
        return at;
    });
    for (int k = 0; k < 3; ++k) size_ = std::max(size_, view.high[k] - view.low[k]);
    if (walks_in_double) tree_ = RopeTree<double>{view};
    else tree_ = RopeTree<float>{view};
}

std::size_t DeviceOctree::bytes() const {
    const bool needs_leaves = octant_leaves_.size() == 0;  // else only those of very many triangles are read
    return arrays_.bytes() + octant_leaves_.bytes() + (needs_leaves ? leaves_.bytes() : 0) + quads_.bytes() +
           references_.bytes() + words_.bytes() + rope_triangles_.bytes() + rope_boxes_.bytes() + cube_map_.bytes();
}

}  // namespace enfilade::render::cuda

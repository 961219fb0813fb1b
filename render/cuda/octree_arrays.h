#pragma once
// Octrees of one mesh in a device's memory, in every layout that kernels walk.

#include <cstddef>
#include <cstdint>
#include <variant>

#include "accel/octree/linked_octree.h"
#include "accel/octree/rope_octree.h"
#include "render/cuda/buffer.h"
#include "render/cuda/octree_layouts.h"
#include "render/cuda/octree_options.h"

namespace enfilade::render::cuda {

/// The arrays that a walk reads, as accel::LinkedOctree has them; where they were uploaded or built (octree_build.h).
struct OctreeArrays {
    accel::OctreeView view = {};  ///< of the arrays below; `leaves` is nullptr where there are none
    Buffer<accel::LinkedLeaf> leaves;
    Buffer<float> corners;  ///< ten a reference, and padding
    Buffer<accel::JumpEntry> jumps;
    std::size_t references = 0;
    [[nodiscard]] std::size_t bytes() const { return leaves.bytes() + corners.bytes() + jumps.bytes(); }
};

[[nodiscard]] OctreeArrays upload_octree(Device& device, const accel::LinkedOctree& tree);

/// Of their tables the flat part may be deeper as well: a look less a leaf.
inline constexpr std::uint32_t most_device_jump_levels = 7;

/// Built and linked by the host, uploaded, with the deeper table.
[[nodiscard]] OctreeArrays build_octree_arrays(Device& device, const accel::MeshPart& mesh,
                                               const accel::OctreeOptions& options, const accel::Executor& executor);

/// Exchanges the table by which leaves are found for a deeper or a flatter one. levels: of its flat part; the tree's
/// depth less that is even. \throws std::invalid_argument where it is not
void use_jump_levels(Device& device, const accel::Octree& tree, std::uint32_t levels, OctreeArrays& arrays);

/// How triangles lie (octree_layouts.h).
enum class TriangleLayout : std::uint8_t { Columns, Records, Indexed };

struct DeviceOctreeLayout {
    TriangleLayout triangles = TriangleLayout::Records;
    bool has_octant_leaves = false;  ///< with Records and Indexed: 8 bytes a leaf and octant, else 32 a leaf
};

/// Where a mesh's triangles and its corners are read from, by number.
struct MeshOnDevice {
    MeshOnDevice(Device& device, const accel::MeshPart& mesh, std::size_t vertices, std::size_t triangles);
    Buffer<accel::Vertex> places;
    Buffer<accel::MeshTriangle> triangles;
    Buffer<std::uint32_t> used;
};

/// An octree that kernels walk, ours or the paper's. Movable; the device must outlive it.
class DeviceOctree {
public:
    using Tree = std::variant<ColumnTree, RecordTree, IndexedTree, RopeTree<float>, RopeTree<double>>;

    /// Ours. Other layouts than Columns are written by the device from the arrays, which are then released but for what
    /// is walked. mesh: for Indexed alone
    DeviceOctree(Device& device, OctreeArrays arrays, const DeviceOctreeLayout& layout,
                 const MeshOnDevice* mesh = nullptr);
    /// The paper's.
    DeviceOctree(Device& device, const accel::RopeOctree& tree, bool walks_in_double);

    [[nodiscard]] const Tree& tree() const { return tree_; }
    /// What its walk may read.
    [[nodiscard]] std::size_t bytes() const;
    /// The longest side of the triangles' box.
    [[nodiscard]] float size() const { return size_; }

private:
    [[nodiscard]] LeafArrays leaf_arrays(Device& device, const DeviceOctreeLayout& layout);

    Tree tree_;
    float size_ = 0;
    OctreeArrays arrays_;
    Buffer<OctantLeaf> octant_leaves_;
    Buffer<accel::LinkedLeaf> leaves_;  ///< whose `first` counts references
    Buffer<Quad> quads_;                ///< records, or corners of the mesh
    Buffer<IndexedTree::Reference> references_;
    Buffer<std::uint32_t> words_;
    Buffer<accel::RopeTriangle> rope_triangles_;
    Buffer<accel::RopeBox> rope_boxes_;
    Buffer<accel::RopeAddress> cube_map_;
};

}  // namespace enfilade::render::cuda

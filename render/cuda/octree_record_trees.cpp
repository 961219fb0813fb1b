#include "render/cuda/octree_record_trees.h"

#include <span>
#include <type_traits>
#include <vector>

#include "render/cuda/device_scene.h"

namespace enfilade::render::cuda {

RecordTree copy_records(const accel::LinkedOctree& tree, DeviceArrays& arrays) {
    constexpr std::uint32_t columns = 10;  // floats a reference there
    std::span<const accel::LinkedLeaf> from;
    RecordTree copy = {};
    copy.view = tree.copied([&](const auto* values, std::size_t count) {
        using T = std::remove_cvref_t<decltype(*values)>;
        if constexpr (std::is_same_v<T, accel::LinkedLeaf>) from = {values, count};
        if constexpr (std::is_same_v<T, accel::JumpEntry>) return arrays.copy(values, count);
        else return static_cast<const T*>(nullptr);
    });
    if (from.empty()) return copy;
    const ColumnTree by_columns = {tree.view()};
    std::vector<accel::LinkedLeaf> leaves(from.begin(), from.end());
    std::vector<Quad> records;
    for (accel::LinkedLeaf& leaf : leaves) {
        for (std::uint32_t j = 0; j < leaf.count; ++j) {
            const ColumnTree::Place place = {leaf.first + j, leaf.count};
            std::uint32_t none = 0;
            const TriangleCorners p = by_columns.triangle(place, none);
            records.push_back({p.a[0], p.a[1], p.a[2], by_columns.number(place, 0)});
            records.push_back({p.b[0], p.b[1], p.b[2], 0});
            records.push_back({p.c[0], p.c[1], p.c[2], 0});
        }
        leaf.first /= columns;
    }
    copy.leaves = {nullptr, arrays.copy(leaves.data(), leaves.size()), static_cast<std::uint32_t>(leaves.size())};
    copy.records = arrays.copy(records.data(), records.size());
    copy.view.leaves = copy.leaves.as_linked;
    return copy;
}

}  // namespace enfilade::render::cuda

#pragma once
// A binary tree of boxes by the surface area heuristic, over whatever has a box: triangles, objects, both.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "accel/parallel_for.h"
#include "render/bvh_walk.h"

namespace enfilade::render {

/// A box along the axes.
struct SahBox {
    std::array<float, 3> low, high;

    static SahBox none() {
        constexpr float far = std::numeric_limits<float>::max();
        return {{far, far, far}, {-far, -far, -far}};
    }
    void add(const SahBox& other) {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], other.low[k]);
            high[k] = std::max(high[k], other.high[k]);
        }
    }
    void add(const accel::Vertex& v) { add({{v.x, v.y, v.z}, {v.x, v.y, v.z}}); }
    [[nodiscard]] float centre(std::size_t axis) const { return 0.5f * low[axis] + 0.5f * high[axis]; }
    [[nodiscard]] double half_area() const {
        const double x = double{high[0]} - low[0], y = double{high[1]} - low[1], z = double{high[2]} - low[2];
        return x >= 0 ? x * y + y * z + z * x : 0;
    }
};

/// What the builder sorts. An item may have several, each with a box of a part of it.
struct SahEntry {
    SahBox box;
    std::uint32_t item;
};

struct SahOptions {
    std::uint32_t largest_leaf = 8;           ///< entries
    float node_cost = 1.2f;                   ///< of two boxes, in triangles
    std::uint32_t first_alone = 0xffffffffu;  ///< items from here on have leaves of their own
    float alone_cost = 1;                     ///< of one of those, in triangles
};

/// Nodes as bvh_walk.h has them: parents before children, the root first, none where there are no entries; leaves name
/// the first of their places in `order`. One entry alone is twice the child of a node, which needs two.
struct SahTree {
    std::vector<BvhNode> nodes;
    std::vector<std::uint32_t> order;  ///< items, leaf by leaf; the last of each leaf has `last_bit`
    SahBox box = SahBox::none();
};

/// By 16 bins an axis (Wald 2007). However the boxes lie, no path is longer than `largest_bvh_depth`, and there are no
/// more nodes than entries. The tree does not depend on the executor. Cost: about 0.5 us an entry and core.
/// \pre items are below 2^31
[[nodiscard]] SahTree build_sah_tree(std::vector<SahEntry> entries, const accel::Executor& executor,
                                     const SahOptions& options = {});

}  // namespace enfilade::render

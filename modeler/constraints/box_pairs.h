#pragma once
// Which boxes of a set touch each other: a tree of boxes joined with itself.

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "modeler/constraints/exact3.h"

namespace enfilade::modeler {

/// A closed box on the grid.
struct GridBox {
    Point3 low = {INT32_MAX, INT32_MAX, INT32_MAX};
    Point3 high = {INT32_MIN, INT32_MIN, INT32_MIN};

    void add(const Point3& p) {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    }
    void add(const GridBox& box) { add(box.low), add(box.high); }
    [[nodiscard]] bool touches(const GridBox& box) const {
        for (std::size_t i = 0; i < 3; ++i)
            if (box.high[i] < low[i] || high[i] < box.low[i]) return false;
        return true;
    }
};

/// Halves at the median of the longest axis, so that long thin boxes side by side part as well as small ones do.
class BoxTree {
public:
    explicit BoxTree(const std::vector<GridBox>& boxes) : boxes_(boxes), order_(boxes.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        if (!order_.empty()) build(0, std::uint32_t(order_.size()));
    }

    /// Calls visit(i, j) once, i < j, for each two boxes that touch. The order depends on the boxes alone.
    template <class Visit>
    void for_each_touching_pair(Visit visit) const {
        if (!nodes_.empty()) join_self(0, visit);
    }

private:
    static constexpr std::uint32_t leaf_size = 6;

    struct Node {
        GridBox box;
        std::uint32_t first = 0, last = 0;  ///< into order_
        std::uint32_t right = 0;            ///< the left child follows its parent; 0: leaf
    };

    std::uint32_t build(std::uint32_t first, std::uint32_t last) {
        const std::uint32_t at = std::uint32_t(nodes_.size());
        nodes_.push_back({{}, first, last, 0});
        GridBox middles;  // of twice the box's middle: no rounding
        for (std::uint32_t k = first; k < last; ++k) {
            nodes_[at].box.add(boxes_[order_[k]]);
            middles.add(middle2(order_[k]));
        }
        if (last - first <= leaf_size) return at;
        std::size_t axis = 0;
        for (std::size_t i = 1; i < 3; ++i)
            if (extent(middles, i) > extent(middles, axis)) axis = i;
        const std::uint32_t half = first + (last - first) / 2;
        std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
                         [&](std::uint32_t a, std::uint32_t b) {
                             const std::int32_t at_a = middle2(a)[axis], at_b = middle2(b)[axis];
                             return at_a != at_b ? at_a < at_b : a < b;
                         });
        build(first, half);
        const std::uint32_t right = build(half, last);
        nodes_[at].right = right;
        return at;
    }

    [[nodiscard]] static std::int64_t extent(const GridBox& box, std::size_t axis) {
        return std::int64_t(box.high[axis]) - box.low[axis];
    }
    [[nodiscard]] Point3 middle2(std::uint32_t box) const {
        Point3 sum;
        for (std::size_t i = 0; i < 3; ++i) sum[i] = boxes_[box].low[i] + boxes_[box].high[i];
        return sum;
    }

    template <class Visit>
    void meet(std::uint32_t i, std::uint32_t j, Visit& visit) const {
        if (boxes_[i].touches(boxes_[j])) visit(std::min(i, j), std::max(i, j));
    }

    template <class Visit>
    void join_self(std::uint32_t n, Visit& visit) const {
        const Node& node = nodes_[n];
        if (node.right != 0) {
            join_self(n + 1, visit);
            join_self(node.right, visit);
            join(n + 1, node.right, visit);
            return;
        }
        for (std::uint32_t a = node.first; a < node.last; ++a)
            for (std::uint32_t b = a + 1; b < node.last; ++b) meet(order_[a], order_[b], visit);
    }

    template <class Visit>
    void join(std::uint32_t n, std::uint32_t m, Visit& visit) const {
        const Node &a = nodes_[n], &b = nodes_[m];
        if (!a.box.touches(b.box)) return;
        if (a.right == 0 && b.right == 0) {
            for (std::uint32_t k = a.first; k < a.last; ++k) {
                if (!boxes_[order_[k]].touches(b.box)) continue;
                for (std::uint32_t l = b.first; l < b.last; ++l) meet(order_[k], order_[l], visit);
            }
        } else if (b.right == 0 || (a.right != 0 && a.last - a.first >= b.last - b.first)) {
            join(n + 1, m, visit);
            join(a.right, m, visit);
        } else {
            join(n, m + 1, visit);
            join(n, b.right, visit);
        }
    }

    const std::vector<GridBox>& boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace enfilade::modeler

#pragma once
// Pairs of boxes that overlap, by a tree over their Morton order.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace enfilade::modeler {

/// A box in floats, rounded outward: half the memory, and no pair is lost.
struct NearBox {
    std::array<float, 3> low{};
    std::array<float, 3> high{};

    static float below(double x) {
        const auto f = static_cast<float>(x);
        return f <= x ? f : std::nextafter(f, -std::numeric_limits<float>::infinity());
    }
    static float above(double x) {
        const auto f = static_cast<float>(x);
        return f >= x ? f : std::nextafter(f, std::numeric_limits<float>::infinity());
    }
    [[nodiscard]] bool overlaps(const NearBox& other) const {
        for (std::size_t i = 0; i < 3; ++i)
            if (low[i] > other.high[i] || other.low[i] > high[i]) return false;
        return true;
    }
    void add(const NearBox& other) {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], other.low[i]);
            high[i] = std::max(high[i], other.high[i]);
        }
    }
};

/// The tree: boxes sorted along a Morton curve and halved again and again down to leaves of a few.
class NearBoxes {
public:
    explicit NearBoxes(std::span<const NearBox> boxes) : order_(sorted(boxes)) {
        boxes_.reserve(boxes.size());
        for (const std::uint32_t k : order_) boxes_.push_back(boxes[k]);
        if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
    }

    /// Calls `found(a, b)` once for each pair of boxes that overlap, a and b being their numbers.
    template <class Found>
    void pairs(Found&& found) const {
        if (!nodes_.empty()) within(0, found);
    }

private:
    static constexpr std::uint32_t leaf_size = 6;

    /// Children of node n: n + 1, and `right`; a leaf has none (0).
    struct Node {
        NearBox box;
        std::uint32_t begin = 0, end = 0;
        std::uint32_t right = 0;
    };

    static std::vector<std::uint32_t> sorted(std::span<const NearBox> boxes) {
        std::vector<std::uint32_t> order(boxes.size());
        if (boxes.empty()) return order;
        NearBox all = boxes.front();
        for (const NearBox& box : boxes) all.add(box);
        double size = 0;
        for (std::size_t i = 0; i < 3; ++i) size = std::max(size, double(all.high[i]) - all.low[i]);
        const double scale = size > 0 ? 2097151 / size : 0;  // 21 bits an axis
        std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed(boxes.size());
        for (std::uint32_t k = 0; k < boxes.size(); ++k) {
            std::uint64_t code = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const double middle = (double(boxes[k].low[i]) + boxes[k].high[i]) / 2 - all.low[i];
                code |= spread(static_cast<std::uint64_t>(middle * scale)) << i;
            }
            keyed[k] = {code, k};
        }
        std::sort(keyed.begin(), keyed.end());
        for (std::size_t k = 0; k < order.size(); ++k) order[k] = keyed[k].second;
        return order;
    }

    /// Bits 0, 1, 2, ... to 0, 3, 6, ...
    static std::uint64_t spread(std::uint64_t x) {
        x &= 0x1FFFFF;
        x = (x | x << 32) & 0x1F00000000FFFFull;
        x = (x | x << 16) & 0x1F0000FF0000FFull;
        x = (x | x << 8) & 0x100F00F00F00F00Full;
        x = (x | x << 4) & 0x10C30C30C30C30C3ull;
        return (x | x << 2) & 0x1249249249249249ull;
    }

    std::uint32_t build(std::uint32_t begin, std::uint32_t end) {
        const auto number = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({boxes_[begin], begin, end, 0});
        if (end - begin <= leaf_size) {
            for (std::uint32_t k = begin; k < end; ++k) nodes_[number].box.add(boxes_[k]);
            return number;
        }
        const std::uint32_t middle = begin + (end - begin) / 2;
        build(begin, middle);
        const std::uint32_t right = build(middle, end);
        nodes_[number].right = right;
        nodes_[number].box = nodes_[number + 1].box;
        nodes_[number].box.add(nodes_[right].box);
        return number;
    }

    template <class Found>
    void within(std::uint32_t n, Found& found) const {
        const Node& node = nodes_[n];
        if (node.right != 0) {
            within(n + 1, found);
            within(node.right, found);
            between(n + 1, node.right, found);
            return;
        }
        for (std::uint32_t a = node.begin; a < node.end; ++a)
            for (std::uint32_t b = a + 1; b < node.end; ++b)
                if (boxes_[a].overlaps(boxes_[b])) found(order_[a], order_[b]);
    }

    template <class Found>
    void between(std::uint32_t m, std::uint32_t n, Found& found) const {
        const Node &a = nodes_[m], &b = nodes_[n];
        if (!a.box.overlaps(b.box)) return;
        if (a.right != 0 && (b.right == 0 || a.end - a.begin >= b.end - b.begin)) {
            between(m + 1, n, found);
            between(a.right, n, found);
        } else if (b.right != 0) {
            between(m, n + 1, found);
            between(m, b.right, found);
        } else {
            for (std::uint32_t i = a.begin; i < a.end; ++i) {
                if (!boxes_[i].overlaps(b.box)) continue;
                for (std::uint32_t j = b.begin; j < b.end; ++j)
                    if (boxes_[i].overlaps(boxes_[j])) found(order_[i], order_[j]);
            }
        }
    }

    std::vector<std::uint32_t> order_;
    std::vector<NearBox> boxes_;  ///< in that order
    std::vector<Node> nodes_;
};

}  // namespace enfilade::modeler

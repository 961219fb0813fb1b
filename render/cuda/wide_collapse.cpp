#include "render/cuda/wide_collapse.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace enfilade::render::cuda {
namespace {

constexpr float node_cost = 1, item_cost = 0.3f, alone_cost = 3;
constexpr std::uint32_t leaf_items = 3;
constexpr float never = std::numeric_limits<float>::infinity();

}  // namespace

WideCollapse::WideCollapse(const SahTree& tree, std::uint32_t first_alone)
    : tree_(tree), first_alone_(first_alone), choices_(tree.nodes.size()) {
    if (tree.nodes.empty()) return;
    std::vector<float> areas(tree.nodes.size());
    areas[0] = static_cast<float>(tree.box.half_area());
    for (std::uint32_t n = 0; n < tree.nodes.size(); ++n)
        for (std::size_t side = 0; side < 2; ++side)
            if ((tree.nodes[n].child[side] & leaf_bit) == 0)
                areas[tree.nodes[n].child[side]] = static_cast<float>(box_of(n, side).half_area());
    for (auto n = static_cast<std::uint32_t>(tree.nodes.size()); n-- > 0;) choose(n, areas[n]);
}

SahBox WideCollapse::box_of(std::uint32_t node, std::size_t side) const {
    const BvhNode& n = tree_.nodes[node];
    return {{n.low[0][side], n.low[1][side], n.low[2][side]}, {n.high[0][side], n.high[1][side], n.high[2][side]}};
}

std::uint32_t WideCollapse::items_of(std::uint32_t code) const {
    return (code & leaf_bit) != 0 ? 1 : choices_[code].item_count;
}

bool WideCollapse::can_be_leaf(std::uint32_t code) const {
    return (code & leaf_bit) != 0 ? (tree_.order[code & ~leaf_bit] & ~last_bit) < first_alone_
                                  : choices_[code].can_be_leaf != 0;
}

int WideCollapse::height_of(std::uint32_t code) const { return (code & leaf_bit) != 0 ? -1 : choices_[code].height; }

float WideCollapse::cost_of(std::uint32_t code, float area, int as) const {
    if ((code & leaf_bit) == 0) return choices_[code].cost[static_cast<std::size_t>(as)];
    return area * (can_be_leaf(code) ? item_cost : alone_cost);
}

void WideCollapse::choose(std::uint32_t node, float area) {
    const std::uint32_t left = tree_.nodes[node].child[0], right = tree_.nodes[node].child[1];
    const auto left_area = static_cast<float>(box_of(node, 0).half_area());
    const auto right_area = static_cast<float>(box_of(node, 1).half_area());
    Choice& choice = choices_[node];
    choice.item_count = is_single(node) ? 1 : items_of(left) + items_of(right);
    choice.can_be_leaf = choice.item_count <= leaf_items && can_be_leaf(left) && can_be_leaf(right) ? 1 : 0;
    choice.height = static_cast<std::uint8_t>(1 + std::max(height_of(left), height_of(right)));
    const auto distribute = [&](int as) {
        float best = never;
        for (int k = 1; k < as; ++k) {
            const float cost = cost_of(left, left_area, std::min(k, most - 1)) +
                               cost_of(right, right_area, std::min(as - k, most - 1));
            if (!(cost < best)) continue;
            best = cost;
            choice.to_left[static_cast<std::size_t>(as)] = static_cast<std::uint8_t>(k);
        }
        return best;
    };
    const float as_node = distribute(most) + area * node_cost;
    const float as_leaf = choice.can_be_leaf != 0 ? area * static_cast<float>(choice.item_count) * item_cost : never;
    choice.is_leaf = as_leaf <= as_node ? 1 : 0;
    choice.cost[1] = std::min(as_leaf, as_node);
    for (int as = 2; as < most; ++as) {
        const float before = choice.cost[static_cast<std::size_t>(as - 1)];
        const float cost = distribute(as);
        if (!(cost < before)) choice.to_left[static_cast<std::size_t>(as)] = 0;
        choice.cost[static_cast<std::size_t>(as)] = std::min(cost, before);
    }
}

void WideCollapse::add_items(std::uint32_t code, WideChild& child) const {
    if ((code & leaf_bit) != 0) {
        child.items[child.item_count++] = tree_.order[code & ~leaf_bit] & ~last_bit;
        return;
    }
    add_items(tree_.nodes[code].child[0], child);
    if (!is_single(code)) add_items(tree_.nodes[code].child[1], child);
}

void WideCollapse::add(std::uint32_t code, const SahBox& box, int as, WideChildren& children) const {
    const bool is_inner = (code & leaf_bit) == 0;
    if (is_inner && as > 1) {
        while (as > 1 && choices_[code].to_left[static_cast<std::size_t>(as)] == 0) --as;
        if (as > 1) return open(code, as, children);
    }
    WideChild& child = children.of[static_cast<std::size_t>(children.count++)];
    child.box = box;
    child.node = code;
    if (!is_inner || choices_[code].is_leaf != 0) add_items(code, child);
}

void WideCollapse::open(std::uint32_t node, int as, WideChildren& children) const {
    const int to_left = choices_[node].to_left[static_cast<std::size_t>(as)];
    add(tree_.nodes[node].child[0], box_of(node, 0), std::min(to_left, most - 1), children);
    if (!is_single(node)) add(tree_.nodes[node].child[1], box_of(node, 1), std::min(as - to_left, most - 1), children);
}

void WideCollapse::open_highest(WideChildren& children) const {
    while (children.count < most) {
        int highest = -1;
        for (int i = 0; i < children.count; ++i)
            if (children.of[static_cast<std::size_t>(i)].item_count == 0 &&
                (highest < 0 || height_of(children.of[static_cast<std::size_t>(i)].node) >
                                    height_of(children.of[static_cast<std::size_t>(highest)].node)))
                highest = i;
        if (highest < 0) return;
        const std::uint32_t node = children.of[static_cast<std::size_t>(highest)].node;
        for (std::size_t side = 0; side < 2; ++side) {
            WideChild child;
            child.box = box_of(node, side);
            child.node = tree_.nodes[node].child[side];
            if (items_of(child.node) == 1 || (items_of(child.node) <= leaf_items && can_be_leaf(child.node)))
                add_items(child.node, child);
            children.of[static_cast<std::size_t>(side == 0 ? highest : children.count++)] = child;
        }
    }
}

WideChildren WideCollapse::children_of(std::uint32_t node) const {
    WideChildren children;
    if (!is_by_height_ || is_single(node)) {
        open(node, most, children);
        return children;
    }
    children.count = 1;
    children.of[0].node = node;
    open_highest(children);
    return children;
}

int WideCollapse::depth() const {
    if (tree_.nodes.empty()) return 0;
    int deepest = 0;
    std::vector<std::pair<std::uint32_t, int>> waiting = {{0, 1}};
    while (!waiting.empty()) {
        const auto [node, depth] = waiting.back();
        waiting.pop_back();
        deepest = std::max(deepest, depth);
        const WideChildren children = children_of(node);
        for (int i = 0; i < children.count; ++i)
            if (const WideChild& child = children.of[static_cast<std::size_t>(i)]; child.item_count == 0)
                waiting.emplace_back(child.node, depth + 1);
    }
    return deepest;
}

}  // namespace enfilade::render::cuda

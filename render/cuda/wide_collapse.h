#pragma once
// Which nodes of a binary tree become nodes of an eight-wide one.

#include <array>
#include <cstdint>
#include <vector>

#include "render/sah_tree.h"

namespace enfilade::render::cuda {

/// A child of a wide node: a binary node that becomes a wide one, or up to three items.
struct WideChild {
    SahBox box;
    std::uint32_t node = 0;        ///< binary; of a leaf of no meaning
    std::uint32_t item_count = 0;  ///< 0: it is a node
    std::array<std::uint32_t, 3> items = {};
};

struct WideChildren {
    std::array<WideChild, 8> of;
    int count = 0;
};

/// Costs of every binary node, bottom-up, and what they choose (Ylitie, Karras, Laine 2017, section 3.1).
class WideCollapse {
public:
    /// The tree must outlive it. first_alone: items from here on have leaves of their own. \pre leaves hold one item
    WideCollapse(const SahTree& tree, std::uint32_t first_alone);

    /// Of the wide node that a binary node becomes, in the tree's order.
    [[nodiscard]] WideChildren children_of(std::uint32_t node) const;
    /// Wide nodes on the longest path.
    [[nodiscard]] int depth() const;
    /// From here on the highest subtrees are opened first, whatever it costs: each level then takes three binary ones.
    void choose_by_height() { is_by_height_ = true; }

private:
    static constexpr int most = 8;
    /// A binary inner node.
    struct Choice {
        std::array<float, most> cost;         ///< [i]: as i children or fewer, from 1 on
        std::array<std::uint8_t, 9> to_left;  ///< [i]: how many of i go to the left; 0: i - 1 cost no more
        std::uint8_t is_leaf;                 ///< as one child it is a leaf
        std::uint8_t height;                  ///< binary nodes below it on the longest path
        std::uint8_t can_be_leaf;
        std::uint32_t item_count;
    };
    [[nodiscard]] float cost_of(std::uint32_t code, float area, int as) const;
    [[nodiscard]] std::uint32_t items_of(std::uint32_t code) const;
    [[nodiscard]] bool can_be_leaf(std::uint32_t code) const;
    [[nodiscard]] int height_of(std::uint32_t code) const;
    void choose(std::uint32_t node, float area);
    void open(std::uint32_t node, int as, WideChildren& children) const;
    void add(std::uint32_t code, const SahBox& box, int as, WideChildren& children) const;
    void open_highest(WideChildren& children) const;
    void add_items(std::uint32_t code, WideChild& child) const;
    [[nodiscard]] SahBox box_of(std::uint32_t node, std::size_t side) const;
    [[nodiscard]] bool is_single(std::uint32_t node) const {
        return tree_.nodes[node].child[0] == tree_.nodes[node].child[1];
    }

    const SahTree& tree_;
    std::uint32_t first_alone_;
    bool is_by_height_ = false;
    std::vector<Choice> choices_;  ///< [binary node]
};

}  // namespace enfilade::render::cuda

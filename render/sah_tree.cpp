#include "render/sah_tree.h"

#include <cmath>
#include <span>

namespace enfilade::render {
namespace {

constexpr std::uint32_t bin_count = 16;
constexpr std::uint32_t piece_size = 1 << 14;  ///< entries: smaller trees are built as one task
constexpr std::uint32_t heuristic_depth = 32;  ///< below, halves: 32 more levels are enough for 2^31 entries

/// Entries [begin, end), at some depth.
struct Range {
    std::uint32_t begin, end, depth;
    [[nodiscard]] std::uint32_t size() const { return end - begin; }
};

struct Split {
    std::size_t axis = 3;  ///< 3: none
    std::uint32_t bin = 0;
    double cost = std::numeric_limits<double>::infinity();
};

/// Which bin a centre falls into.
struct Binning {
    float low;
    float scale;  ///< 0: all in one place
    [[nodiscard]] std::uint32_t operator()(float centre) const {
        return std::min(bin_count - 1, static_cast<std::uint32_t>(std::max(0.0f, (centre - low) * scale)));
    }
};

Binning binning_of(const SahBox& centres, std::size_t axis) {
    const float size = centres.high[axis] - centres.low[axis];
    const float scale = size > 0 ? static_cast<float>(bin_count) / size : 0.0f;
    return {centres.low[axis], std::isfinite(scale) ? scale : 0.0f};
}

struct Bin {
    SahBox box = SahBox::none();
    double cost = 0;  ///< of its entries, in triangles
};

/// Keeps in `best` the cheapest place to cut between bins of an axis.
void try_cuts(const std::array<Bin, bin_count>& bins, std::size_t axis, Split& best) {
    std::array<double, bin_count> cost_above{};
    SahBox box = SahBox::none();
    double sum = 0;
    for (std::uint32_t b = bin_count - 1; b > 0; --b) {
        box.add(bins[b].box);
        sum += bins[b].cost;
        cost_above[b] = sum > 0 ? box.half_area() * sum : std::numeric_limits<double>::infinity();
    }
    box = SahBox::none();
    sum = 0;
    for (std::uint32_t b = 0; b + 1 < bin_count; ++b) {
        box.add(bins[b].box);
        sum += bins[b].cost;
        if (sum == 0) continue;
        const double cost = box.half_area() * sum + cost_above[b + 1];
        if (cost < best.cost) best = {axis, b + 1, cost};
    }
}

/// Builds the tree under one range into nodes of its own.
class SubtreeBuilder {
public:
    SubtreeBuilder(std::span<SahEntry> entries, const SahOptions& options, std::vector<BvhNode>& nodes)
        : entries_(entries), options_(options), nodes_(nodes) {}

    /// What stands for the range in its parent: a leaf, or the node built for it. A half for which
    /// `leaves_out(half, node, side)` is left for others to build.
    template <class LeavesOut>
    std::uint32_t build(Range range, const LeavesOut& leaves_out) {
        std::uint32_t middle = 0;
        if (range.size() <= 1 || !find_middle(range, middle)) return leaf_bit | range.begin;
        const auto node = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        const std::array<Range, 2> halves = {Range{range.begin, middle, range.depth + 1},
                                             Range{middle, range.end, range.depth + 1}};
        for (std::size_t c = 0; c < 2; ++c) {
            const SahBox box = box_of(halves[c]);
            for (std::size_t k = 0; k < 3; ++k) {
                nodes_[node].low[k][c] = box.low[k];
                nodes_[node].high[k][c] = box.high[k];
            }
            const std::uint32_t child = leaves_out(halves[c], node, c) ? 0 : build(halves[c], leaves_out);
            nodes_[node].child[c] = child;
        }
        return node;
    }

    [[nodiscard]] SahBox box_of(Range range) const {
        SahBox box = SahBox::none();
        for (std::uint32_t i = range.begin; i < range.end; ++i) box.add(entries_[i].box);
        return box;
    }

private:
    [[nodiscard]] double cost_of(const SahEntry& e) const {
        return e.item < options_.first_alone ? 1.0 : double{options_.alone_cost};
    }

    /// Sorts the range into two parts that meet at `middle`; false where one leaf serves better.
    bool find_middle(Range range, std::uint32_t& middle) {
        const auto here = entries_.subspan(range.begin, range.size());
        const bool may_be_leaf =
            range.size() <= options_.largest_leaf &&
            std::ranges::all_of(here, [&](const SahEntry& e) { return e.item < options_.first_alone; });
        Split best;
        if (range.depth < heuristic_depth) {
            SahBox centres = SahBox::none(), all = SahBox::none();
            for (const SahEntry& e : here) {
                const std::array<float, 3> centre = {e.box.centre(0), e.box.centre(1), e.box.centre(2)};
                centres.add({centre, centre});
                all.add(e.box);
            }
            best = best_split(here, centres);
            const double leaf_cost = all.half_area() * range.size();
            if (range.depth > 0 && may_be_leaf && !(best.cost + options_.node_cost * all.half_area() < leaf_cost))
                return false;
            if (best.axis < 3) {
                const Binning bin_of = binning_of(centres, best.axis);
                const auto rest = std::partition(here.begin(), here.end(), [&](const SahEntry& e) {
                    return bin_of(e.box.centre(best.axis)) < best.bin;
                });
                middle = range.begin + static_cast<std::uint32_t>(rest - here.begin());
                return true;
            }
        } else if (may_be_leaf) {
            return false;
        }
        middle = range.begin + range.size() / 2;  // all centres in one place, or too deep: any halves
        return true;
    }

    Split best_split(std::span<const SahEntry> here, const SahBox& centres) const {
        std::array<std::array<Bin, bin_count>, 3> bins;
        const std::array<Binning, 3> bin_of = {binning_of(centres, 0), binning_of(centres, 1), binning_of(centres, 2)};
        for (const SahEntry& e : here) {
            const double cost = cost_of(e);
            for (std::size_t k = 0; k < 3; ++k) {
                Bin& bin = bins[k][bin_of[k](e.box.centre(k))];
                bin.box.add(e.box);
                bin.cost += cost;
            }
        }
        Split best;
        for (std::size_t k = 0; k < 3; ++k)
            if (bin_of[k].scale > 0) try_cuts(bins[k], k, best);
        return best;
    }

    std::span<SahEntry> entries_;
    const SahOptions& options_;
    std::vector<BvhNode>& nodes_;
};

/// A part of the tree that is built apart from the others, and where it hangs.
struct Piece {
    Range range;
    std::uint32_t parent;
    std::size_t side;
    std::uint32_t root = 0;
    std::vector<BvhNode> nodes = {};
};

/// Marks where leaves end: before every place where one begins.
void mark_leaves(std::span<const BvhNode> nodes, std::vector<std::uint32_t>& order) {
    for (const BvhNode& node : nodes)
        for (const std::uint32_t child : node.child)
            if ((child & leaf_bit) != 0 && (child & ~leaf_bit) > 0) order[(child & ~leaf_bit) - 1] |= last_bit;
    order.back() |= last_bit;
}

}  // namespace

SahTree build_sah_tree(std::vector<SahEntry> entries, const accel::Executor& executor, const SahOptions& options) {
    SahTree tree;
    if (entries.empty()) return tree;
    const auto count = static_cast<std::uint32_t>(entries.size());

    std::vector<Piece> pieces;
    SubtreeBuilder top(entries, options, tree.nodes);
    const std::uint32_t root = top.build({0, count, 0}, [&](Range range, std::uint32_t parent, std::size_t side) {
        if (range.size() > piece_size || range.size() <= options.largest_leaf) return false;
        pieces.push_back({range, parent, side});
        return true;
    });
    executor.run(pieces.size(), [&](std::size_t i) {
        SubtreeBuilder builder(entries, options, pieces[i].nodes);
        const auto whole = [](Range, std::uint32_t, std::size_t) { return false; };
        pieces[i].root = builder.build(pieces[i].range, whole);
    });
    for (const Piece& piece : pieces) {
        const auto first = static_cast<std::uint32_t>(tree.nodes.size());
        const auto moved = [&](std::uint32_t child) { return (child & leaf_bit) != 0 ? child : first + child; };
        tree.nodes[piece.parent].child[piece.side] = moved(piece.root);
        for (BvhNode node : piece.nodes) {
            for (std::uint32_t& child : node.child) child = moved(child);
            tree.nodes.push_back(node);
        }
    }
    const SahBox box = tree.box = top.box_of({0, count, 0});
    if ((root & leaf_bit) != 0) {  // one entry: twice the child of a node, which needs two
        tree.nodes.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            tree.nodes[0].low[k][0] = tree.nodes[0].low[k][1] = box.low[k];
            tree.nodes[0].high[k][0] = tree.nodes[0].high[k][1] = box.high[k];
        }
        tree.nodes[0].child[0] = tree.nodes[0].child[1] = root;
    }
    tree.order.reserve(count);
    for (const SahEntry& e : entries) tree.order.push_back(e.item);
    mark_leaves(tree.nodes, tree.order);
    return tree;
}

}  // namespace enfilade::render

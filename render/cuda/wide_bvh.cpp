#include "render/cuda/wide_bvh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "render/cuda/wide_collapse.h"

namespace enfilade::render::cuda {
namespace {

/// What the walk rounds in units of a quantised box, and twice that again (WideBvhWalk::slabs).
constexpr double quantum_slack = 1.0 / 128;

/// A node's grid on one axis.
struct Grid {
    float origin;
    int exponent;

    /// Holds [low, high], rounding included: 253 steps for it, one more at either end.
    Grid(float low, float high) {
        const double size = double{high} - low;
        const double least_step = std::max(0x1p-22 * std::max(std::abs(double{low}), std::abs(double{high})), 0x1p-100);
        exponent = static_cast<int>(std::ceil(std::log2(std::max(size / 253, least_step))));
        origin = static_cast<float>(low - std::ldexp(1.0, exponent));
    }
    [[nodiscard]] std::uint8_t floor(float at) const {
        return byte(std::floor(std::ldexp(double{at} - double{origin}, -exponent) - quantum_slack));
    }
    [[nodiscard]] std::uint8_t ceiling(float at) const {
        return byte(std::ceil(std::ldexp(double{at} - double{origin}, -exponent) + quantum_slack));
    }

private:
    static std::uint8_t byte(double a) { return static_cast<std::uint8_t>(std::clamp(a, 0.0, 255.0)); }
};

/// Puts each child into a slot so that all together lie in their octants as far as can be: [slot], -1 where none is.
/// Of all ways the best, by the sets of slots that the first children may take.
std::array<int, 8> slots_of(const WideChildren& children, const SahBox& box) {
    std::array<std::array<double, 8>, 8> gain{};
    const auto count = static_cast<std::size_t>(children.count);
    for (std::size_t c = 0; c < count; ++c)
        for (std::size_t slot = 0; slot < 8; ++slot)
            for (std::size_t k = 0; k < 3; ++k) {
                const double away = double{children.of[c].box.centre(k)} - double{box.centre(k)};
                gain[c][slot] += (slot >> k & 1) != 0 ? away : -away;
            }
    std::array<double, 256> best;
    std::array<std::uint8_t, 256> last_slot{};
    best.fill(-std::numeric_limits<double>::infinity());
    best[0] = 0;
    std::size_t all = 0;  // of the sets as large as there are children the best
    for (std::size_t taken = 0; taken < 256; ++taken) {
        const auto c = static_cast<std::size_t>(std::popcount(taken));
        if (c == count && (all == 0 || best[taken] > best[all])) all = taken;
        for (std::size_t slot = 0; slot < 8 && c < count; ++slot) {
            const std::size_t next = taken | std::size_t{1} << slot;
            if (next == taken || !(best[taken] + gain[c][slot] > best[next])) continue;
            best[next] = best[taken] + gain[c][slot];
            last_slot[next] = static_cast<std::uint8_t>(slot);
        }
    }
    std::array<int, 8> child_in;
    child_in.fill(-1);
    for (int c = children.count; c-- > 0;) {
        child_in[last_slot[all]] = c;
        all &= ~(std::size_t{1} << last_slot[all]);
    }
    return child_in;
}

class WideWriter {
public:
    WideWriter(const TriangleScene& scene, TriangleTest test, WideBvhArrays& arrays)
        : scene_(scene), test_(test), arrays_(arrays) {}

    /// Appends a tree; where its root lies.
    std::uint32_t append(const SahTree& tree) {
        const auto root = static_cast<std::uint32_t>(arrays_.nodes.size());
        if (tree.nodes.empty()) return root;
        WideCollapse collapse(tree, instance_bit);
        int depth = collapse.depth();
        if (depth > largest_wide_depth) {
            collapse.choose_by_height();
            depth = collapse.depth();
        }
        arrays_.depth = std::max(arrays_.depth, depth);
        arrays_.nodes.emplace_back();
        write(collapse, 0, root);
        return root;
    }

private:
    void write(const WideCollapse& collapse, std::uint32_t binary, std::uint32_t at) {
        const WideChildren children = collapse.children_of(binary);
        SahBox box = SahBox::none();
        for (std::size_t c = 0; c < static_cast<std::size_t>(children.count); ++c) box.add(children.of[c].box);
        const std::array<int, 8> child_in = slots_of(children, box);
        WideNode node = {};
        node.first_node = static_cast<std::uint32_t>(arrays_.nodes.size());
        node.first_record = static_cast<std::uint32_t>(arrays_.records.size());
        set_boxes(children, child_in, box, node);
        std::uint32_t record_count = 0;
        for (std::size_t slot = 0; slot < 8; ++slot) {
            if (child_in[slot] < 0) continue;
            const WideChild& child = children.of[static_cast<std::size_t>(child_in[slot])];
            if (child.item_count == 0) {
                node.inner = static_cast<std::uint8_t>(node.inner | 1u << slot);
                node.meta[slot] = static_cast<std::uint8_t>(1u << 5 | (24 + slot));
                arrays_.nodes.emplace_back();
                continue;
            }
            node.meta[slot] = static_cast<std::uint8_t>(((1u << child.item_count) - 1) << 5 | record_count);
            for (std::uint32_t i = 0; i < child.item_count; ++i)
                arrays_.records.push_back(record_of(scene_, child.items[i], test_));
            record_count += child.item_count;
        }
        arrays_.nodes[at] = node;
        std::uint32_t next = node.first_node;
        for (std::size_t slot = 0; slot < 8; ++slot)
            if ((node.inner >> slot & 1) != 0)
                write(collapse, children.of[static_cast<std::size_t>(child_in[slot])].node, next++);
    }

    static void set_boxes(const WideChildren& children, const std::array<int, 8>& child_in, const SahBox& box,
                          WideNode& node) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Grid grid(box.low[k], box.high[k]);
            node.origin[k] = grid.origin;
            node.exponent[k] = static_cast<std::uint8_t>(grid.exponent + 127);
            for (std::size_t slot = 0; slot < 8; ++slot) {
                if (child_in[slot] < 0) continue;
                const SahBox& of = children.of[static_cast<std::size_t>(child_in[slot])].box;
                node.low[k][slot] = grid.floor(of.low[k]);
                node.high[k][slot] = grid.ceiling(of.high[k]);
            }
        }
    }

    const TriangleScene& scene_;
    TriangleTest test_;
    WideBvhArrays& arrays_;
};

}  // namespace

WideBvhArrays lay_out_wide_bvh(const TriangleScene& scene, const BvhForest& forest, TriangleTest test) {
    WideBvhArrays arrays;
    arrays.is_empty = forest.top.nodes.empty();
    WideWriter writer(scene, test, arrays);
    writer.append(forest.top);
    std::vector<std::uint32_t> roots;
    for (const SahTree& tree : forest.meshes) roots.push_back(writer.append(tree));
    arrays.instances = scene.instances;
    for (std::size_t k = 0; k < arrays.instances.size(); ++k) arrays.instances[k].root = roots[scene.mesh_of[k]];
    arrays.extents = extents_of(scene, forest);
    return arrays;
}

}  // namespace enfilade::render::cuda

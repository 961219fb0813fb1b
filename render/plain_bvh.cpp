#include "render/plain_bvh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "render/mesh_soundness.h"

namespace enfilade::render {
namespace {

constexpr std::uint32_t bin_count = 16;
constexpr std::uint32_t largest_leaf = 8;
constexpr std::uint32_t piece_size = 1 << 14;  ///< triangles: smaller trees are built as one task
constexpr std::uint32_t heuristic_depth = 32;  ///< below, halves: 32 more levels are enough for 2^31 triangles
constexpr float node_cost = 1.2f;              ///< of two boxes, in triangles

struct Box {
    std::array<float, 3> low, high;

    static Box none() {
        constexpr float far = std::numeric_limits<float>::max();
        return {{far, far, far}, {-far, -far, -far}};
    }
    void add(const Box& other) {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], other.low[k]);
            high[k] = std::max(high[k], other.high[k]);
        }
    }
    [[nodiscard]] float centre(std::size_t axis) const { return 0.5f * low[axis] + 0.5f * high[axis]; }
    [[nodiscard]] double half_area() const {
        const double x = double{high[0]} - low[0], y = double{high[1]} - low[1], z = double{high[2]} - low[2];
        return x >= 0 ? x * y + y * z + z * x : 0;
    }
};

/// A triangle as the builder sorts it.
struct Entry {
    Box box;
    std::uint32_t triangle;
};

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

Binning binning_of(const Box& centres, std::size_t axis) {
    const float size = centres.high[axis] - centres.low[axis];
    const float scale = size > 0 ? static_cast<float>(bin_count) / size : 0.0f;
    return {centres.low[axis], std::isfinite(scale) ? scale : 0.0f};
}

struct Bin {
    Box box = Box::none();
    std::uint32_t count = 0;
};

/// Keeps in `best` the cheapest place to cut between bins of an axis.
void try_cuts(const std::array<Bin, bin_count>& bins, std::size_t axis, Split& best) {
    std::array<double, bin_count> cost_above{};
    Box box = Box::none();
    std::uint32_t count = 0;
    for (std::uint32_t b = bin_count - 1; b > 0; --b) {
        box.add(bins[b].box);
        count += bins[b].count;
        cost_above[b] = count > 0 ? box.half_area() * count : std::numeric_limits<double>::infinity();
    }
    box = Box::none();
    count = 0;
    for (std::uint32_t b = 0; b + 1 < bin_count; ++b) {
        box.add(bins[b].box);
        count += bins[b].count;
        if (count == 0) continue;
        const double cost = box.half_area() * count + cost_above[b + 1];
        if (cost < best.cost) best = {axis, b + 1, cost};
    }
}

/// Builds the tree under one range into nodes of its own.
class SubtreeBuilder {
public:
    SubtreeBuilder(std::span<Entry> entries, std::vector<BvhNode>& nodes) : entries_(entries), nodes_(nodes) {}

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
            const Box box = box_of(halves[c]);
            for (std::size_t k = 0; k < 3; ++k) {
                nodes_[node].low[k][c] = box.low[k];
                nodes_[node].high[k][c] = box.high[k];
            }
            const std::uint32_t child = leaves_out(halves[c], node, c) ? 0 : build(halves[c], leaves_out);
            nodes_[node].child[c] = child;
        }
        return node;
    }

    [[nodiscard]] Box box_of(Range range) const {
        Box box = Box::none();
        for (std::uint32_t i = range.begin; i < range.end; ++i) box.add(entries_[i].box);
        return box;
    }

private:
    /// Sorts the range into two parts that meet at `middle`; false where one leaf serves better.
    bool find_middle(Range range, std::uint32_t& middle) {
        const auto here = entries_.subspan(range.begin, range.size());
        Split best;
        if (range.depth < heuristic_depth) {
            Box centres = Box::none(), all = Box::none();
            for (const Entry& e : here) {
                const std::array<float, 3> centre = {e.box.centre(0), e.box.centre(1), e.box.centre(2)};
                centres.add({centre, centre});
                all.add(e.box);
            }
            best = best_split(here, centres);
            const double leaf_cost = all.half_area() * range.size();
            if (range.depth > 0 && range.size() <= largest_leaf &&
                !(best.cost + node_cost * all.half_area() < leaf_cost))
                return false;
            if (best.axis < 3) {
                const Binning bin_of = binning_of(centres, best.axis);
                const auto rest = std::partition(here.begin(), here.end(), [&](const Entry& e) {
                    return bin_of(e.box.centre(best.axis)) < best.bin;
                });
                middle = range.begin + static_cast<std::uint32_t>(rest - here.begin());
                return true;
            }
        } else if (range.size() <= largest_leaf) {
            return false;
        }
        middle = range.begin + range.size() / 2;  // all centres in one place, or too deep: any halves
        return true;
    }

    static Split best_split(std::span<const Entry> here, const Box& centres) {
        std::array<std::array<Bin, bin_count>, 3> bins;
        const std::array<Binning, 3> bin_of = {binning_of(centres, 0), binning_of(centres, 1), binning_of(centres, 2)};
        for (const Entry& e : here) {
            for (std::size_t k = 0; k < 3; ++k) {
                Bin& bin = bins[k][bin_of[k](e.box.centre(k))];
                bin.box.add(e.box);
                ++bin.count;
            }
        }
        Split best;
        for (std::size_t k = 0; k < 3; ++k)
            if (bin_of[k].scale > 0) try_cuts(bins[k], k, best);
        return best;
    }

    std::span<Entry> entries_;
    std::vector<BvhNode>& nodes_;
};

std::vector<Entry> entries_of(const accel::SceneView& scene, const accel::ObjectMesh& mesh) {
    std::vector<Entry> entries;
    entries.reserve(mesh.triangle_count);
    for (std::uint32_t t = 0; t < mesh.triangle_count; ++t) {
        if (!can_be_hit(scene, mesh, t)) continue;
        const auto& corners = scene.mesh_triangles[mesh.first_triangle + t].corners;
        const accel::Vertex& a = scene.mesh_vertices[mesh.first_vertex + corners[0]];
        const accel::Vertex& b = scene.mesh_vertices[mesh.first_vertex + corners[1]];
        const accel::Vertex& c = scene.mesh_vertices[mesh.first_vertex + corners[2]];
        Box box = {{a.x, a.y, a.z}, {a.x, a.y, a.z}};
        box.add({{b.x, b.y, b.z}, {b.x, b.y, b.z}});
        box.add({{c.x, c.y, c.z}, {c.x, c.y, c.z}});
        entries.push_back({box, t});
    }
    return entries;
}

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

PlainBvh::PlainBvh(const accel::SceneView& scene, accel::MeshId id, const accel::Executor& executor) {
    const accel::ObjectMesh& mesh = scene.meshes[index(id)];
    places_ = reinterpret_cast<const float*>(scene.mesh_vertices.data() + mesh.first_vertex);
    triangles_ = scene.mesh_triangles.data() + mesh.first_triangle;
    std::vector<Entry> entries = entries_of(scene, mesh);
    if (entries.empty()) return;
    const auto count = static_cast<std::uint32_t>(entries.size());

    std::vector<Piece> pieces;
    SubtreeBuilder top(entries, nodes_);
    const std::uint32_t root = top.build({0, count, 0}, [&](Range range, std::uint32_t parent, std::size_t side) {
        if (range.size() > piece_size || range.size() <= largest_leaf) return false;
        pieces.push_back({range, parent, side});
        return true;
    });
    executor.run(pieces.size(), [&](std::size_t i) {
        SubtreeBuilder builder(entries, pieces[i].nodes);
        const auto whole = [](Range, std::uint32_t, std::size_t) { return false; };
        pieces[i].root = builder.build(pieces[i].range, whole);
    });
    for (const Piece& piece : pieces) {
        const auto first = static_cast<std::uint32_t>(nodes_.size());
        const auto moved = [&](std::uint32_t child) { return (child & leaf_bit) != 0 ? child : first + child; };
        nodes_[piece.parent].child[piece.side] = moved(piece.root);
        for (BvhNode node : piece.nodes) {
            for (std::uint32_t& child : node.child) child = moved(child);
            nodes_.push_back(node);
        }
    }
    const Box box = top.box_of({0, count, 0});
    std::ranges::copy(box.low, low_);
    std::ranges::copy(box.high, high_);
    if ((root & leaf_bit) != 0) {  // one triangle: twice the child of a node, which needs two
        nodes_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            nodes_[0].low[k][0] = nodes_[0].low[k][1] = box.low[k];
            nodes_[0].high[k][0] = nodes_[0].high[k][1] = box.high[k];
        }
        nodes_[0].child[0] = nodes_[0].child[1] = root;
    }
    order_.reserve(count);
    for (const Entry& e : entries) order_.push_back(e.triangle);
    mark_leaves(nodes_, order_);
}

BvhView PlainBvh::view() const {
    return {nodes_.empty() ? nullptr : nodes_.data(),
            order_.data(),
            places_,
            triangles_,
            {low_[0], low_[1], low_[2]},
            {high_[0], high_[1], high_[2]}};
}

}  // namespace enfilade::render

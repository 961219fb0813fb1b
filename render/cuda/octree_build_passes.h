#pragma once
// Inside of octree_build.cu: what is done to each node, block of triangles, or place of a level.

#include <cstdint>

#include "accel/octree/lattice_triangles.h"
#include "accel/octree/octant_test.h"
#include "accel/octree/octree_split.h"
#include "render/cuda/streams_atomics.h"
#include "render/cuda/warp.h"

namespace enfilade::render::cuda::build {

/// The host tests triangles in blocks of so many, and asks more closely where one of a block is not in one octant: so
/// blocks are the same here.
inline constexpr std::uint32_t block_size = 16;
inline constexpr std::uint32_t blocks_a_warp = warp_size / block_size;
inline constexpr std::uint32_t none = 0xffffffffu;

/// A node of the level that is worked on.
struct Node {
    std::uint64_t budget;
    std::uint32_t low[3];
    std::uint32_t count;
    std::uint32_t first;  ///< of its triangles: in the level's list of work, else in that of what is settled
    std::uint32_t child;  ///< the first of eight in the next level, or none
    bool is_work;         ///< it may be split; its list begins with a whole block
};

[[nodiscard]] ENFILADE_HD std::uint32_t whole_blocks(std::uint32_t count) {
    return (count + block_size - 1) / block_size * block_size;
}

/// The triangles' box, of so many at a time.
struct Bounds {
    static constexpr std::uint32_t grain = 1024;
    struct Box {
        float low[3], high[3];
    };
    const accel::Vertex* places;
    const accel::MeshTriangle* triangles;
    const std::uint32_t* used;
    std::uint32_t count;
    Box* boxes;

    /// Of equal numbers (0 and -0) the first is kept, as the host keeps it.
    static ENFILADE_HD void add(float p, float& low, float& high) {
        low = p < low ? p : low;
        high = high < p ? p : high;
    }
    static ENFILADE_HD Box nothing() {
        constexpr float far = 3.402823466e38f;
        return {{far, far, far}, {-far, -far, -far}};
    }
    ENFILADE_HD void operator()(std::uint64_t chunk) const {
        Box box = nothing();
        const std::uint32_t begin = static_cast<std::uint32_t>(chunk) * grain;
        const std::uint32_t end = count - begin < grain ? count : begin + grain;
        for (std::uint32_t i = begin; i < end; ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                const accel::Vertex& v = places[triangles[used[i]].corners[c]];
                add(v.x, box.low[0], box.high[0]);
                add(v.y, box.low[1], box.high[1]);
                add(v.z, box.low[2], box.high[2]);
            }
        }
        boxes[chunk] = box;
    }
};

/// Corners in the lattice.
struct PlaceCorners {
    const accel::Vertex* places;
    const accel::MeshTriangle* triangles;
    const std::uint32_t* used;
    accel::OctreeFrame frame;
    float* corners;  ///< [triangle][9]

    ENFILADE_HD void operator()(std::uint64_t i) const {
        for (std::size_t c = 0; c < 3; ++c) {
            const accel::Vertex v = places[triangles[used[i]].corners[c]];
            float* to = corners + 9 * i + 3 * c;
            to[0] = accel::detail::in_lattice(v.x, frame.low[0], frame.cells_a_unit[0]);
            to[1] = accel::detail::in_lattice(v.y, frame.low[1], frame.cells_a_unit[1]);
            to[2] = accel::detail::in_lattice(v.z, frame.low[2], frame.cells_a_unit[2]);
        }
    }
};

/// The root's list: all triangles.
struct CountUp {
    std::uint32_t* list;
    ENFILADE_HD void operator()(std::uint64_t i) const { list[i] = static_cast<std::uint32_t>(i); }
};

/// To which node each block of the level's work belongs.
struct FindNodes {
    const std::uint32_t* work_first;  ///< [node]
    std::uint32_t nodes;
    std::uint32_t* block_node;

    ENFILADE_HD void operator()(std::uint64_t block) const {
        const std::uint32_t at = static_cast<std::uint32_t>(block) * block_size;
        std::uint32_t low = 0, past = nodes;  // work_first[low] <= at, and past is behind all for which that holds
        while (past - low > 1) {
            const std::uint32_t middle = low + (past - low) / 2;
            (work_first[middle] <= at ? low : past) = middle;
        }
        block_node[block] = low;
    }
};

/// A list's place: of which node, and whether there is a triangle.
struct Level {
    const Node* nodes;
    const std::uint32_t* work;        ///< triangles of nodes that may be split
    const std::uint32_t* block_node;  ///< [block of `work`]
    std::uint32_t blocks;

    [[nodiscard]] ENFILADE_HD bool has(std::uint32_t at) const {
        if (at / block_size >= blocks) return false;
        const Node& node = nodes[block_node[at / block_size]];
        return at - node.first < node.count;
    }
};

/// Which octants of their nodes triangles meet: accel::detail::LatticeTriangles::find_octants, a lane each.
struct FindOctants {
    Level level;
    const float* corners;
    float quarter;  ///< of a node's width
    float slack;
    std::uint8_t* octants;  ///< [place in `work`]
    std::uint32_t* counts;  ///< [octant][block]

    ENFILADE_HD void load(std::uint32_t at, accel::detail::SpaceCorner* p) const {
        const Node& node = level.nodes[level.block_node[at / block_size]];
        const float* c = corners + 9 * std::size_t{level.work[at]};
        const float x = static_cast<float>(node.low[0]) + 2 * quarter,
                    y = static_cast<float>(node.low[1]) + 2 * quarter,
                    z = static_cast<float>(node.low[2]) + 2 * quarter;
        for (int i = 0; i < 3; ++i) p[i] = {c[3 * i] - x, c[3 * i + 1] - y, c[3 * i + 2] - z};
    }

    ENFILADE_HD void operator()(const Warp& warp, std::uint64_t w) const {
        using namespace accel::detail;
        const std::uint32_t first = static_cast<std::uint32_t>(w) * warp_size;
        PerLane<std::uint32_t> found;
        PerLane<bool> is_spread, meets;
        for (int lane : warp.lanes()) {
            const std::uint32_t at = first + static_cast<std::uint32_t>(lane);
            found[lane] = 0;
            if (level.has(at)) {
                SpaceCorner p[3];
                load(at, p);
                found[lane] = halves_of_box(p[0].x, p[1].x, p[2].x, 0, slack) &
                              halves_of_box(p[0].y, p[1].y, p[2].y, 1, slack) &
                              halves_of_box(p[0].z, p[1].z, p[2].z, 2, slack);
            }
            is_spread[lane] = (found[lane] & (found[lane] - 1u)) != 0;
        }
        const std::uint32_t spread = warp.ballot(is_spread);
        for (int lane : warp.lanes()) {
            const std::uint32_t at = first + static_cast<std::uint32_t>(lane);
            if (level.has(at) && (spread >> (lane / 16 * 16) & 0xffffu) != 0) {
                SpaceCorner p[3];
                load(at, p);
                found[lane] &= ~missed_octants(p[0], p[1], p[2], quarter, quarter + slack);
            }
            if (at / block_size < level.blocks) octants[at] = static_cast<std::uint8_t>(found[lane]);
        }
        for (std::uint32_t octant = 0; octant < 8; ++octant) {
            for (int lane : warp.lanes()) meets[lane] = (found[lane] >> octant & 1u) != 0;
            const std::uint32_t all = warp.ballot(meets);
            for (int lane : warp.lanes()) {
                const std::uint32_t block = (first + static_cast<std::uint32_t>(lane)) / block_size;
                if (lane % 16 == 0 && block < level.blocks)
                    counts[std::size_t{octant} * level.blocks + block] = count_bits(all >> lane & 0xffffu);
            }
        }
    }
};

/// Triangles of a node that meet an octant. before: sums of FindOctants::counts before each
[[nodiscard]] ENFILADE_HD std::uint32_t octant_count(const Node& node, std::uint32_t octant, std::uint32_t blocks,
                                                     const std::uint32_t* before) {
    const std::uint32_t* row = before + std::size_t{octant} * blocks + node.first / block_size;
    return row[whole_blocks(node.count) / block_size] - row[0];
}

/// Whether nodes are split: as accel::detail::SplitRule.
struct Decide {
    const Node* nodes;
    const std::uint32_t* before;
    std::uint32_t blocks;
    std::uint32_t* splits;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        const Node& node = nodes[i];
        splits[i] = 0;
        if (!node.is_work) return;
        accel::detail::OctantCounts counts = {};
        for (std::uint32_t octant = 0; octant < 8; ++octant)
            counts[octant] = octant_count(node, octant, blocks, before);
        splits[i] = accel::detail::SplitRule::tries_by_size(node.count, node.budget, counts) ? 1 : 0;
    }
};

/// The next level's nodes, without their places.
struct MakeNodes {
    Node* nodes;
    const std::uint32_t* before;
    std::uint32_t blocks;
    const std::uint32_t *splits, *ranks;  ///< and the sums before each
    std::uint32_t half;                   ///< of a node's width, in cells
    std::uint32_t leaf_size;
    bool is_deepest;  ///< the next level is
    Node* next;
    std::uint32_t *work_sizes, *settled_sizes;  ///< [next]

    ENFILADE_HD void operator()(std::uint64_t i) const {
        Node& node = nodes[i];
        node.child = splits[i] != 0 ? 8 * ranks[i] : none;
        if (splits[i] == 0) return;
        accel::detail::OctantCounts counts = {};
        for (std::uint32_t octant = 0; octant < 8; ++octant)
            counts[octant] = octant_count(node, octant, blocks, before);
        const std::array<std::uint64_t, 8> budgets = accel::detail::SplitRule::shares(node.budget, counts);
        for (std::uint32_t octant = 0; octant < 8; ++octant) {
            const std::uint32_t to = node.child + octant;
            const bool is_work = !is_deepest && counts[octant] > leaf_size;
            Node& child = next[to];
            child.budget = budgets[octant];
            for (std::uint32_t k = 0; k < 3; ++k) child.low[k] = node.low[k] + (octant >> k & 1u) * half;
            child.count = counts[octant];
            child.child = none;
            child.is_work = is_work;
            work_sizes[to] = is_work ? whole_blocks(child.count) : 0;
            settled_sizes[to] = is_work ? 0 : child.count;
        }
    }
};

struct SetPlaces {
    Node* nodes;
    const std::uint32_t *work_first, *settled_first;
    ENFILADE_HD void operator()(std::uint64_t i) const {
        nodes[i].first = nodes[i].is_work ? work_first[i] : settled_first[i];
    }
};

/// Writes the next level's lists, each in its parent's order.
struct Deal {
    Level level;
    const std::uint8_t* octants;
    const std::uint32_t* before;
    const Node* next;
    std::uint32_t *work, *settled;

    ENFILADE_HD void operator()(const Warp& warp, std::uint64_t w) const {
        const std::uint32_t first = static_cast<std::uint32_t>(w) * warp_size;
        for (std::uint32_t octant = 0; octant < 8; ++octant) {
            PerLane<bool> meets;
            for (int lane : warp.lanes()) {
                const std::uint32_t at = first + static_cast<std::uint32_t>(lane);
                meets[lane] = level.has(at) && (octants[at] >> octant & 1u) != 0;
            }
            const std::uint32_t all = warp.ballot(meets);
            for (int lane : warp.lanes()) {
                if (!meets[lane]) continue;
                const std::uint32_t at = first + static_cast<std::uint32_t>(lane), block = at / block_size;
                const Node& node = level.nodes[level.block_node[block]];
                if (node.child == none) continue;
                const Node& child = next[node.child + octant];
                const std::uint32_t* row = before + std::size_t{octant} * level.blocks;
                const std::uint32_t earlier = count_bits(all >> (lane / 16 * 16) & ((1u << lane % 16) - 1));
                (child.is_work ? work : settled)[child.first + row[block] - row[node.first / block_size] + earlier] =
                    level.work[at];
            }
        }
    }
};

/// How much there is below a node, or before it.
struct Extent {
    std::uint32_t inner, leaves, references;
};

struct SumUp {
    const Node* nodes;
    const Extent* below;  ///< of the next level's nodes
    Extent* sums;
    ENFILADE_HD void operator()(std::uint64_t i) const {
        const Node& node = nodes[i];
        Extent sum = {0, 1, node.count};
        if (node.child != none) {
            sum = {1, 0, 0};
            for (std::uint32_t octant = 0; octant < 8; ++octant) {
                const Extent& child = below[node.child + octant];
                sum = {sum.inner + child.inner, sum.leaves + child.leaves, sum.references + child.references};
            }
        }
        sums[i] = sum;
    }
};

/// Where nodes and what is below them stand in the tree, from the root down; leaves and children are written.
struct PlaceNodes {
    const Node *nodes, *next;
    const Extent *below, *starts;
    Extent* next_starts;
    std::uint32_t level, unused;  ///< unused: levels of the lattice below the deepest leaf
    accel::OctreeEntry* children;
    std::uint32_t* inner_levels;
    accel::OctreeLeaf* leaves;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        const Node& node = nodes[i];
        Extent start = starts[i];
        if (node.child == none) {
            leaves[start.leaves] = {{node.low[0] >> unused, node.low[1] >> unused, node.low[2] >> unused},
                                    level,
                                    start.references,
                                    node.count};
            return;
        }
        accel::OctreeEntry* to = children + std::size_t{8} * start.inner;
        inner_levels[start.inner++] = level;
        for (std::uint32_t octant = 0; octant < 8; ++octant) {
            const std::uint32_t child = node.child + octant;
            next_starts[child] = start;
            to[octant] = next[child].child == none ? accel::OctreeEntry{accel::OctreeEntry::leaf_bit | start.leaves}
                                                   : accel::OctreeEntry{start.inner};
            start = {start.inner + below[child].inner, start.leaves + below[child].leaves,
                     start.references + below[child].references};
        }
    }
};

/// The triangles of a level's leaves.
struct WriteReferences {
    const Node* nodes;
    const Extent* starts;
    const std::uint32_t *work, *settled, *used;
    std::uint32_t* references;
    ENFILADE_HD void operator()(const Warp& warp, std::uint64_t i) const {
        const Node& node = nodes[i];
        if (node.child != none) return;
        const std::uint32_t* from = (node.is_work ? work : settled) + node.first;
        for (int lane : warp.lanes())
            for (std::uint32_t j = static_cast<std::uint32_t>(lane); j < node.count; j += warp_size)
                references[starts[i].references + j] = used[from[j]];
    }
};

}  // namespace enfilade::render::cuda::build

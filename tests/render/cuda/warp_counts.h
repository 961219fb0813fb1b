#pragma once
// What the lanes of warps do while they walk rays, counted on the host cell by cell: how many of them work, and how
// many different cells they read at a time.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "accel/scene.h"
#include "render/walk.h"

namespace enfilade::test {

/// The cells that a ray enters, in order.
using CellPath = std::vector<std::uint32_t>;

struct PathEvents : render::NoEvents {
    CellPath* path = nullptr;
    void crossed(std::uint32_t cell) { path->push_back(cell); }
};

/// Empty for what is no ray.
inline CellPath path_of(const accel::SceneView& scene, render::Vec3f origin, render::Vec3f direction,
                        std::uint32_t cell) {
    render::Ray<float> ray;
    if (!make_ray(origin, direction, ray)) return {};
    CellPath path = {cell};
    PathEvents events;
    events.path = &path;
    render::NoThroughput none;
    (void)walk(scene, ray, cell, render::NoLimit{}, none, events);
    return path;
}

struct WarpCounts {
    std::uint64_t steps = 0;       ///< of warps: each active lane walks through one cell
    std::uint64_t cells = 0;       ///< of lanes
    std::uint64_t lines = 0;       ///< tested by lanes
    std::uint64_t line_slots = 0;  ///< 32 times the most lines of a lane, step by step
    std::uint64_t different = 0;   ///< cells in a warp's step
    std::uint64_t fetches = 0;     ///< of warps
    std::uint64_t rays = 0;        ///< that they fetched

    [[nodiscard]] double lanes_busy() const { return double(cells) / (32.0 * double(steps)); }
    [[nodiscard]] double lines_busy() const { return double(lines) / double(line_slots); }
    [[nodiscard]] double lanes_beginning() const { return double(rays) / (32.0 * double(fetches)); }
    [[nodiscard]] double cells_a_step() const { return double(different) / double(steps); }
};

/// A warp at work.
class CountedWarp {
public:
    CountedWarp(const accel::SceneView& scene, const std::vector<CellPath>& paths) : scene_(&scene), paths_(&paths) {}

    [[nodiscard]] int idle() const { return 32 - busy_; }
    /// Gives idle lanes the next rays of an order, from `next` on.
    void fetch(const std::vector<std::uint32_t>& order, std::size_t& next, WarpCounts& counts) {
        if (next < order.size()) ++counts.fetches;
        for (Lane& lane : lanes_)
            while (lane.path == nullptr && next < order.size()) {
                const CellPath& path = (*paths_)[order[next++]];
                if (path.empty()) continue;
                lane = {&path, 0};
                ++counts.rays;
                ++busy_;
            }
    }
    void step(WarpCounts& counts) {
        std::set<std::uint32_t> cells;
        std::uint64_t most = 0;
        for (Lane& lane : lanes_) {
            if (lane.path == nullptr) continue;
            const std::uint32_t cell = (*lane.path)[lane.at++];
            const std::uint64_t lines = scene_->cells[cell].section_count;
            cells.insert(cell);
            ++counts.cells;
            counts.lines += lines;
            most = std::max(most, lines);
            if (lane.at < lane.path->size()) continue;
            lane.path = nullptr;
            --busy_;
        }
        ++counts.steps;
        counts.line_slots += 32 * most;
        counts.different += cells.size();
    }

private:
    struct Lane {
        const CellPath* path = nullptr;
        std::size_t at = 0;
    };
    const accel::SceneView* scene_;
    const std::vector<CellPath>* paths_;
    Lane lanes_[32];
    int busy_ = 0;
};

/// `warps` of them take turns; each fetches rays as soon as `refill` lanes are idle. 32: a thread a ray.
inline WarpCounts count_warps(const accel::SceneView& scene, const std::vector<CellPath>& paths,
                              const std::vector<std::uint32_t>& order, int refill, std::size_t warps = 64) {
    WarpCounts counts;
    std::vector<CountedWarp> all(warps, CountedWarp(scene, paths));
    std::size_t next = 0;
    for (bool is_busy = true; is_busy;) {
        is_busy = false;
        for (CountedWarp& warp : all) {
            if (warp.idle() >= refill) warp.fetch(order, next, counts);
            if (warp.idle() == 32) continue;
            warp.step(counts);
            is_busy = true;
        }
    }
    return counts;
}

}  // namespace enfilade::test

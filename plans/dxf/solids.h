#pragma once
// Whether a place is in a wall or mass.

#include <utility>
#include <vector>

#include "plans/box_index.h"
#include "plans/dxf/wall_runs.h"
#include "plans/vector2.h"

namespace enfilade::plans {

/// Even-odd rule; places on the outline may count either way.
[[nodiscard]] inline bool holds(const std::vector<Point>& ring, Point p) {
    bool inside = false;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point a = ring[k], b = ring[(k + 1) % ring.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
    return inside;
}

/// Runs as strips, with their openings, 5 mm wider than drawn
class Solids {
public:
    explicit Solids(std::vector<WallRun> runs, std::vector<WallMass> masses = {})
        : runs_(std::move(runs)),
          masses_(std::move(masses)),
          runs_at_(boxes_of(runs_)),
          masses_at_(boxes_of(masses_)) {}

    [[nodiscard]] bool operator()(Point p) const {
        bool found = false;
        runs_at_.near(p, [&](std::uint32_t k) {
            found = found || distance(p, runs_[k].start, runs_[k].end) <= runs_[k].thickness / 2 + slack;
        });
        masses_at_.near(p, [&](std::uint32_t k) { found = found || holds(masses_[k].polygon, p); });
        return found;
    }

private:
    static constexpr double slack = 0.005;

    static std::vector<PlanBox> boxes_of(const std::vector<WallRun>& runs) {
        std::vector<PlanBox> boxes(runs.size());
        for (std::size_t k = 0; k < runs.size(); ++k) {
            boxes[k].add(runs[k].start);
            boxes[k].add(runs[k].end);
            boxes[k] = boxes[k].grown(runs[k].thickness / 2 + slack);
        }
        return boxes;
    }
    static std::vector<PlanBox> boxes_of(const std::vector<WallMass>& masses) {
        std::vector<PlanBox> boxes(masses.size());
        for (std::size_t k = 0; k < masses.size(); ++k)
            for (const Point p : masses[k].polygon) boxes[k].add(p);
        return boxes;
    }

    std::vector<WallRun> runs_;
    std::vector<WallMass> masses_;
    BoxIndex runs_at_;
    BoxIndex masses_at_;
};

}  // namespace enfilade::plans

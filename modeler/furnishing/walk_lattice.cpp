#include "modeler/furnishing/walk_lattice.h"

#include <algorithm>
#include <cmath>

namespace enfilade::modeler {

using plans::Point;

namespace {

std::int32_t floor_divided(std::int64_t a, std::int64_t b) {
    return std::int32_t(a >= 0 ? a / b : -((-a + b - 1) / b));
}

}  // namespace

WalkLattice::WalkLattice(const Floor& floor, std::int32_t step, double radius, double margin)
    : step_(step), clear_(radius + 0.5 * step + margin) {
    const GridBox box = floor.box();
    x_low_ = floor_divided(box.x_low, step);
    y_low_ = floor_divided(box.y_low, step);
    columns_ = floor_divided(box.x_high, step) - x_low_ + 2;
    rows_ = floor_divided(box.y_high, step) - y_low_ + 2;
    blocked_.assign(std::size_t(columns_) * std::size_t(rows_), 1);
    reached_.assign(blocked_.size(), 0);
    // Inside: between odd and even crossings of each row.
    std::vector<std::vector<double>> crossings{std::size_t(rows_)};
    for (const FloorSide& side : floor.sides()) {
        const auto [low, high] = std::minmax(side.a.y, side.b.y);
        for (std::int32_t r = std::max(0, floor_divided(low, step) - y_low_); r < rows_; ++r) {
            const double y = double(y_low_ + r) * step;
            if (y >= high) break;
            if (y < low) continue;
            const double t = (y - side.a.y) / (double(side.b.y) - side.a.y);
            crossings[std::size_t(r)].push_back(side.a.x + t * (double(side.b.x) - side.a.x));
        }
    }
    for (std::int32_t r = 0; r < rows_; ++r) {
        std::vector<double>& xs = crossings[std::size_t(r)];
        std::sort(xs.begin(), xs.end());
        for (std::size_t k = 0; k + 1 < xs.size(); k += 2) {
            const auto from = std::max(0, std::int32_t(std::ceil(xs[k] / step)) - x_low_);
            const auto to = std::min(columns_ - 1, std::int32_t(std::floor(xs[k + 1] / step)) - x_low_);
            for (std::int32_t c = from; c <= to; ++c)
                blocked_[std::size_t(r) * std::size_t(columns_) + std::size_t(c)] = 0;
        }
    }
    for (const FloorSide& side : floor.sides()) put({side.a, side.b}, 1);
}

Point WalkLattice::at(std::uint32_t node) const {
    const auto columns = std::uint32_t(columns_);
    return {double(x_low_ + std::int32_t(node % columns)) * step_,
            double(y_low_ + std::int32_t(node / columns)) * step_};
}

template <class Visit>
void WalkLattice::near(const Ring& ring, double distance, Visit visit) const {
    const GridBox box = box_around(ring);
    const double reach = std::ceil(distance);
    const auto bound = [&](double v, std::int32_t low, std::int32_t count, bool up) {
        const double steps = (up ? std::floor(v / step_) : std::ceil(v / step_)) - low;
        return std::int32_t(std::clamp(steps, up ? -1.0 : 0.0, up ? count - 1.0 : double(count)));
    };
    const std::int32_t c0 = bound(box.x_low - reach, x_low_, columns_, false);
    const std::int32_t c1 = bound(box.x_high + reach, x_low_, columns_, true);
    const std::int32_t r0 = bound(box.y_low - reach, y_low_, rows_, false);
    const std::int32_t r1 = bound(box.y_high + reach, y_low_, rows_, true);
    for (std::int32_t r = r0; r <= r1; ++r)
        for (std::int32_t c = c0; c <= c1; ++c) {
            const Point p{double(x_low_ + c) * step_, double(y_low_ + r) * step_};
            if (distance2(p, ring) < distance * distance)
                visit(std::uint32_t(r) * std::uint32_t(columns_) + std::uint32_t(c));
        }
}

bool WalkLattice::put(const Ring& obstacle, int by) {
    bool changed = false;
    near(obstacle, clear_, [&](std::uint32_t node) {
        changed = changed || blocked_[node] == 0;
        blocked_[node] = std::uint16_t(blocked_[node] + by);
    });
    return changed;
}

std::optional<std::uint32_t> WalkLattice::free_node(Point p, double reach) const {
    std::optional<std::uint32_t> best;
    double least = reach * reach;
    const auto x = std::int32_t(std::floor(p.x)), y = std::int32_t(std::floor(p.y));
    near({{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}, reach, [&](std::uint32_t node) {
        if (blocked_[node] != 0) return;
        const Point d = at(node) - p;
        if (plans::dot(d, d) >= least) return;
        least = plans::dot(d, d);
        best = node;
    });
    return best;
}

std::vector<std::uint32_t> WalkLattice::nodes_near(const Ring& ring, double reach) const {
    std::vector<std::uint32_t> nodes;
    near(ring, reach, [&](std::uint32_t node) {
        if (blocked_[node] == 0) nodes.push_back(node);
    });
    return nodes;
}

void WalkLattice::start_reaching() { ++round_; }

void WalkLattice::reach(std::uint32_t from) {
    if (blocked_[from] != 0 || reached_[from] == round_) return;
    const auto columns = std::uint32_t(columns_);
    queue_.assign(1, from);
    reached_[from] = round_;
    for (std::size_t k = 0; k < queue_.size(); ++k) {
        const std::uint32_t node = queue_[k];
        const auto visit = [&](std::uint32_t next) {
            if (blocked_[next] != 0 || reached_[next] == round_) return;
            reached_[next] = round_;
            queue_.push_back(next);
        };
        // The outermost nodes lie on the border or beyond it: free ones have four neighbours.
        visit(node - 1);
        visit(node + 1);
        visit(node - columns);
        visit(node + columns);
    }
}

}  // namespace enfilade::modeler

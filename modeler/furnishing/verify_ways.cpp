#include "modeler/furnishing/verify_ways.h"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.h"
#include "modeler/furnishing/occupancy.h"
#include "modeler/furnishing/walkways.h"

namespace enfilade::modeler {

using plans::Point;

namespace {

/// Distances of nodes from what stands and from walls, up to a bound; negative outside the room.
class DistanceField {
public:
    DistanceField(const RoomShape& room, double bound) : step_(fine_step(room.floor, room.frame.unit)), bound_(bound) {
        const GridBox box = room.floor.box();
        x_ = std::int32_t(std::floor(double(box.x_low) / step_));
        y_ = std::int32_t(std::floor(double(box.y_low) / step_));
        columns_ = std::int32_t(std::ceil(double(box.x_high) / step_)) - x_ + 1;
        rows_ = std::int32_t(std::ceil(double(box.y_high) / step_)) - y_ + 1;
        square_.assign(std::size_t(columns_) * std::size_t(rows_), 1.01 * bound * bound);
        mark_outside(room);
        for (const FloorSide& side : room.floor.sides()) add({place(side.a), place(side.b)});
    }

    /// A closed polygon, or a segment: what lies inside has no distance.
    void add(const std::vector<Point>& polygon) {
        Point low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
        for (const Point p : polygon) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        const auto index = [&](double v, std::int32_t first, std::int32_t count) {
            return std::int32_t(std::clamp(std::floor(v / step_) - first, 0.0, double(count - 1)));
        };
        for (std::int32_t r = index(low.y - bound_, y_, rows_); r <= index(high.y + bound_ + step_, y_, rows_); ++r)
            for (std::int32_t c = index(low.x - bound_, x_, columns_);
                 c <= index(high.x + bound_ + step_, x_, columns_); ++c) {
                double& at = square_[node(c, r)];
                at = std::min(at, square_distance(at_node(c, r), polygon));
            }
    }

    /// Sets of nodes further than `least` from everything.
    [[nodiscard]] DisjointSets parts(double least) const {
        DisjointSets sets;
        sets.reset(square_.size());
        const auto is_free = [&](std::uint32_t n) { return square_[n] >= least * least; };
        for (std::int32_t r = 0; r < rows_; ++r)
            for (std::int32_t c = 0; c < columns_; ++c) {
                const std::uint32_t n = node(c, r);
                if (!is_free(n)) continue;
                if (c + 1 < columns_ && is_free(n + 1)) sets.join(n, n + 1);
                if (r + 1 < rows_ && is_free(n + std::uint32_t(columns_))) sets.join(n, n + std::uint32_t(columns_));
            }
        return sets;
    }
    [[nodiscard]] bool is_free(std::uint32_t n, double least) const { return square_[n] >= least * least; }

    /// The nearest free node.
    [[nodiscard]] std::uint32_t nearest(Point p, double reach, double least) const {
        std::uint32_t best = UINT32_MAX;
        double nearest = reach;
        const auto around = std::int32_t(std::ceil(reach / step_)) + 1;
        const auto c0 = std::int32_t(std::floor(p.x / step_)) - x_, r0 = std::int32_t(std::floor(p.y / step_)) - y_;
        for (std::int32_t r = std::max(0, r0 - around); r <= std::min(rows_ - 1, r0 + around); ++r)
            for (std::int32_t c = std::max(0, c0 - around); c <= std::min(columns_ - 1, c0 + around); ++c) {
                const double d = plans::distance(at_node(c, r), p);
                if (d >= nearest || !is_free(node(c, r), least)) continue;
                nearest = d;
                best = node(c, r);
            }
        return best;
    }

    [[nodiscard]] std::int32_t step() const { return step_; }
    static Point place(plans::GridPoint p) { return {double(p.x), double(p.y)}; }

private:
    [[nodiscard]] std::uint32_t node(std::int32_t c, std::int32_t r) const {
        return std::uint32_t(r) * std::uint32_t(columns_) + std::uint32_t(c);
    }
    [[nodiscard]] Point at_node(std::int32_t c, std::int32_t r) const {
        return {double(x_ + c) * step_, double(y_ + r) * step_};
    }

    static double square_distance(Point p, const std::vector<Point>& polygon) {
        double least = HUGE_VAL;
        int winding = 0;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Point a = polygon[k], b = polygon[(k + 1) % polygon.size()];
            const double d = plans::distance(p, a, b);
            least = std::min(least, d * d);
            const double side = plans::cross(b - a, p - a);
            if (a.y <= p.y && b.y > p.y && side > 0) ++winding;
            if (a.y > p.y && b.y <= p.y && side < 0) --winding;
        }
        return winding != 0 ? 0 : least;
    }

    /// By the crossings of each column, from below.
    void mark_outside(const RoomShape& room) {
        std::vector<std::vector<double>> crossings{std::size_t(columns_)};
        for (const FloorSide& side : room.floor.sides()) {
            const Point a = place(side.a), b = place(side.b);
            const auto [low, high] = std::minmax(a.x, b.x);
            const auto first = std::max(0, std::int32_t(std::ceil(low / step_)) - x_);
            for (std::int32_t c = first; c < columns_ && double(x_ + c) * step_ < high; ++c)
                crossings[std::size_t(c)].push_back(a.y + (double(x_ + c) * step_ - a.x) / (b.x - a.x) * (b.y - a.y));
        }
        for (std::int32_t c = 0; c < columns_; ++c) {
            std::vector<double>& ys = crossings[std::size_t(c)];
            std::sort(ys.begin(), ys.end());
            for (std::int32_t r = 0; r < rows_; ++r) {
                const double y = double(y_ + r) * step_;
                const auto below = std::lower_bound(ys.begin(), ys.end(), y) - ys.begin();
                if (below % 2 == 0) square_[node(c, r)] = 0;
            }
        }
    }

    std::int32_t step_ = 1, x_ = 0, y_ = 0, columns_ = 0, rows_ = 0;
    double bound_ = 0;
    std::vector<double> square_;
};

}  // namespace

std::vector<std::string> closed_ways(const RoomShape& room, const std::vector<CheckedPiece>& pieces) {
    std::vector<std::string> closed;
    std::vector<const RoomOpening*> gates;
    for (const RoomOpening& gate : room.gates)
        if (is_passage(gate.beyond)) gates.push_back(&gate);
    if (gates.empty()) return closed;
    const double unit = room.frame.unit;
    const double step = fine_step(room.floor, unit), least = walker_radius / unit + step / 2;
    DistanceField field(room, least);
    const auto add = [&](bool by_rule) {
        for (const CheckedPiece& piece : pieces) {
            if (piece.by_rule != by_rule || !is_obstacle(room, piece.z_low, piece.z_high)) continue;
            std::vector<Point> polygon;
            for (const plans::GridPoint p : piece.footprint) polygon.push_back(DistanceField::place(p));
            field.add(polygon);
        }
    };
    add(false);
    std::vector<std::uint32_t> nodes;
    for (const RoomOpening* gate : gates)
        nodes.push_back(field.nearest(standing_place(*gate, unit), std::max(standing_reach(unit), step), least));
    DisjointSets before = field.parts(least);
    add(true);
    DisjointSets after = field.parts(least);
    for (std::size_t a = 0; a < gates.size(); ++a)
        for (std::size_t b = a; b < gates.size(); ++b) {
            if (nodes[a] == UINT32_MAX || nodes[b] == UINT32_MAX || before.find(nodes[a]) != before.find(nodes[b]))
                continue;
            if (field.is_free(nodes[a], least) && field.is_free(nodes[b], least) &&
                after.find(nodes[a]) == after.find(nodes[b]))
                continue;
            closed.push_back(std::to_string(gates[a]->space) + " to " + std::to_string(gates[b]->space));
        }
    return closed;
}

}  // namespace enfilade::modeler

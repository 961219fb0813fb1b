#include "plans/wall_joints.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "base/disjoint_sets.h"
#include "plans/box_index.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double kOuterLimit = 4;     ///< mitres reach this many half thicknesses from the joint, then are cut off
constexpr double kInnerLimit = 0.49;  ///< inner corners lie within this share of either wall
constexpr double kAlong = 0.3;        ///< sine of the angle below which an end runs along its host, not into it

bool before(Point l, Point r) { return l.x != r.x ? l.x < r.x : l.y < r.y; }

/// One wall end, seen from its joint.
struct End {
    std::uint32_t wall = 0;
    int which = 0;  ///< 0: start, 1: end
    Point at;
    Point along;  ///< unit, leaving the joint
    double half = 0;
    double angle = 0;
    [[nodiscard]] Point left() const { return turned_left(along); }
    [[nodiscard]] OutlinePart left_side() const { return which == 0 ? OutlinePart::Left : OutlinePart::Right; }
    [[nodiscard]] OutlinePart right_side() const { return which == 0 ? OutlinePart::Right : OutlinePart::Left; }
};

class Shaper {
public:
    Shaper(const std::vector<WallOutline>& walls, const std::vector<std::string>& ids, double join)
        : walls_(walls), ids_(ids), join_(join), index_(boxes(walls, join)) {
        joints_.ends.resize(walls.size());
    }

    Joints run() {
        std::vector<End> ends = all_ends();
        for (std::size_t first = 0; first < ends.size();) {
            std::size_t last = first;
            while (last < ends.size() && ends[last].at == ends[first].at) ++last;
            shape_joint(std::span(ends).subspan(first, last - first));
            first = last;
        }
        return std::move(joints_);
    }

private:
    static std::vector<PlanBox> boxes(const std::vector<WallOutline>& walls, double join) {
        std::vector<PlanBox> all(walls.size());
        for (std::size_t w = 0; w < walls.size(); ++w) {
            for (const double t : walls[w].stations) all[w].add(walls[w].axis.at(t));
            if (!all[w].empty()) all[w] = all[w].grown(walls[w].half + join);
        }
        return all;
    }

    /// By place, then counter-clockwise, then by id.
    [[nodiscard]] std::vector<End> all_ends() const {
        std::vector<End> ends;
        for (std::uint32_t w = 0; w < walls_.size(); ++w) {
            const WallAxis& axis = walls_[w].axis;
            if (walls_[w].stations.empty()) continue;
            const Point out = turned_left(axis.normal(0)) * -1;
            const Point back = turned_left(axis.normal(1));
            ends.push_back({w, 0, axis.at(0), out, walls_[w].half, std::atan2(out.y, out.x)});
            ends.push_back({w, 1, axis.at(1), back, walls_[w].half, std::atan2(back.y, back.x)});
        }
        std::sort(ends.begin(), ends.end(), [&](const End& l, const End& r) {
            if (!(l.at == r.at)) return before(l.at, r.at);
            if (l.angle != r.angle) return l.angle < r.angle;
            if (l.half != r.half) return l.half > r.half;
            return std::pair(ids_[l.wall], l.which) < std::pair(ids_[r.wall], r.which);
        });
        return ends;
    }

    EndShape& shape(const End& end) { return joints_.ends[end.wall][std::size_t(end.which)]; }

    void shape_joint(std::span<const End> ends) {
        const std::optional<End> host = host_of(ends);
        for (const End& end : ends) {
            shape(end).left = end.at + end.left() * end.half;
            shape(end).right = end.at - end.left() * end.half;
        }
        if (ends.size() == 1) {
            if (!host) joints_.free_ends.push_back({ends[0].wall, ends[0].at});
            else cut_along(ends[0], *host);
            return;
        }
        for (std::size_t i = 0; i < ends.size(); ++i)
            shape_wedge(ends[i], ends[(i + 1) % ends.size()], i + 1 == ends.size(), host.has_value());
        for (const End& end : ends) shape(end).between.push_back(end.at);
    }

    /// The wall in whose strip the joint lies, without ending there: as an end at the nearest point of its axis.
    [[nodiscard]] std::optional<End> host_of(std::span<const End> ends) const {
        std::optional<End> best;
        double best_distance = HUGE_VAL;
        index_.near(ends[0].at, [&](std::uint32_t w) {
            if (std::any_of(ends.begin(), ends.end(), [&](const End& end) { return end.wall == w; })) return;
            const WallAxis& axis = walls_[w].axis;
            const double t = axis.nearest(ends[0].at);
            const double away = distance(ends[0].at, axis.at(t));
            if (away > walls_[w].half + join_) return;
            const bool nearer = !best || away < best_distance || (away == best_distance && ids_[w] < ids_[best->wall]);
            if (!nearer) return;
            best_distance = away;
            best = End{w, 0, axis.at(t), turned_left(axis.normal(t)) * -1, walls_[w].half, 0};
        });
        return best;
    }

    /// Ends the wall on the host's axis, so that both corners lie inside the host whatever the angle.
    void cut_along(const End& end, const End& host) {
        const double sine = cross(end.along, host.along);
        if (std::abs(sine) < kAlong) return;
        const auto onto_axis = [&](Point from) {
            return from + end.along * (cross(host.at - from, host.along) / sine);
        };
        const Point left = onto_axis(shape(end).left);
        const Point right = onto_axis(shape(end).right);
        const double limit = kInnerLimit * walls_[end.wall].axis.length();
        if (dot(left - end.at, end.along) > limit || dot(right - end.at, end.along) > limit) return;
        shape(end).left = left;
        shape(end).right = right;
    }

    /// The corner between the left face of u and the right face of v, the next end counter-clockwise.
    void shape_wedge(const End& u, const End& v, bool wraps, bool hosted) {
        double wedge = v.angle - u.angle + (wraps ? 2 * std::numbers::pi : 0);
        if (u.wall == v.wall && u.which == v.which) wedge = 2 * std::numbers::pi;
        const Point u_normal = u.left();
        const Point v_normal = v.left() * -1;
        const double sine = dot(u.along, v_normal);
        const double cosine = dot(u_normal, v_normal);
        const bool outer = wedge > std::numbers::pi;
        if (cosine > 0.999 && walls_[u.wall].axis.straight() && walls_[v.wall].axis.straight())
            joints_.continuations.push_back({u.wall, u.left_side(), v.wall, v.right_side()});
        // How far the corner lies along u: where its face, at u.half, meets the line at v.half from the joint.
        // Written so that equal thicknesses stay exact when the walls are almost one line.
        double reach = HUGE_VAL;
        if (1 + cosine > 1e-9) {
            reach = u.half * sine / (1 + cosine);
            if (u.half != v.half) reach += std::abs(sine) > 1e-9 ? (v.half - u.half) / sine : HUGE_VAL;
        }
        const Point corner = u.at + u_normal * u.half + u.along * reach;
        const bool sharp = std::isfinite(reach) && within_limits(u, v, corner, outer, hosted);
        if (sharp) {
            shape(u).left = corner;
            shape(v).right = corner;
        } else if (outer) {
            // Both end square: u also covers the triangle between its corner, the neighbour's and the joint.
            shape(u).between.push_back(shape_right_of(v));
        }
    }

    [[nodiscard]] static Point shape_right_of(const End& end) { return end.at - end.left() * end.half; }

    [[nodiscard]] bool within_limits(const End& u, const End& v, Point corner, bool outer, bool hosted) const {
        const Point arm = corner - u.at;
        if (outer) return !hosted && norm(arm) <= kOuterLimit * std::max(u.half, v.half);
        return dot(arm, u.along) <= kInnerLimit * walls_[u.wall].axis.length() &&
               dot(arm, v.along) <= kInnerLimit * walls_[v.wall].axis.length();
    }

    const std::vector<WallOutline>& walls_;
    const std::vector<std::string>& ids_;
    double join_;
    BoxIndex index_;
    Joints joints_;
};

}  // namespace

void gather_ends(std::vector<Point>& starts, std::vector<Point>& finishes, const std::vector<bool>& skip, double join) {
    struct Place {
        std::int64_t column, row;
        std::uint32_t end;
    };
    std::vector<Point*> ends;
    std::vector<Place> places;
    for (std::size_t w = 0; w < starts.size(); ++w)
        for (Point* end : {&starts[w], &finishes[w]})
            if (!skip[w]) {
                places.push_back({std::int64_t(std::floor(end->x / join)), std::int64_t(std::floor(end->y / join)),
                                  std::uint32_t(ends.size())});
                ends.push_back(end);
            }
    const auto cell_before = [](const Place& l, const Place& r) {
        return l.column != r.column ? l.column < r.column : l.row < r.row;
    };
    std::sort(places.begin(), places.end(), cell_before);
    DisjointSets gathered(ends.size());
    for (const Place& place : places)
        for (std::int64_t column = place.column - 1; column <= place.column + 1; ++column) {
            auto near = std::lower_bound(places.begin(), places.end(), Place{column, place.row - 1, 0}, cell_before);
            for (; near != places.end() && near->column == column && near->row <= place.row + 1; ++near)
                if (distance(*ends[near->end], *ends[place.end]) <= join) gathered.join(near->end, place.end);
        }
    // The middle of the box around all ends of a place does not depend on their order.
    std::vector<PlanBox> boxes(ends.size());
    for (std::uint32_t e = 0; e < ends.size(); ++e) boxes[gathered.find(e)].add(*ends[e]);
    for (std::uint32_t e = 0; e < ends.size(); ++e) {
        const PlanBox& box = boxes[gathered.find(e)];
        *ends[e] = {box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
    }
}

Joints shape_ends(const std::vector<WallOutline>& walls, const std::vector<std::string>& ids, double join) {
    return Shaper(walls, ids, join).run();
}

}  // namespace enfilade::plans

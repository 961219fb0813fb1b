// Wall ends that nearly meet: brought together, or extended onto the wall that they stop short of.
//
// An end is left alone where it shares its place with another end, or lies in another wall's body away from that
// wall's ends: outlines are tight there. Every other end within reach of something is moved to it. Walls are visited
// by id, each sees what those before it did, and rounds run until none moves.
//
// A door may stand in the gap between two walls (people leave the wall out where the door is): the wall that it is
// bound to is extended through the gap first.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "plans/box_index.h"
#include "plans/clean_steps.h"

namespace enfilade::plans {
namespace {

constexpr double kOnePlace = 0.0004;  ///< m: outlines make one place of such ends anyway
constexpr double kHarmless = 0.001;   ///< m: smaller moves are noted, not warned of
constexpr double kCrossing = 0.3;     ///< sine of the least angle at which an end runs into a wall rather than along it
constexpr double kSameWay = 0.9;      ///< cosine: walls leaving a place like this lie beside each other
constexpr double kBesideEnd = 0.15;   ///< m: openings that begin this close to a wall's end stand beside it
constexpr double kBesideDoor = 0.3;   ///< m: a gap may be wider than the door in it
constexpr double kWidestGap = 3;      ///< m
constexpr int kMostRounds = 16;

struct End {
    std::uint32_t wall = UINT32_MAX;
    int which = 0;  ///< 0: start, 1: end
};

class Joiner {
public:
    Joiner(Storey& storey, double gap, CleanReport& report) : storey_(storey), gap_(gap), report_(report) {
        order_.resize(storey.walls.size());
        std::iota(order_.begin(), order_.end(), 0u);
        std::sort(order_.begin(), order_.end(),
                  [&](std::uint32_t l, std::uint32_t r) { return wall(l).id < wall(r).id; });
        for (std::uint32_t w = 0; w < storey.walls.size(); ++w) axes_.push_back(axis_of(wall(w)));
    }

    bool run() {
        bool any = false;
        for (int round = 0; round < kMostRounds; ++round) {
            const BoxIndex index(boxes());
            index_ = &index;
            bool moved = false;
            for (const std::uint32_t w : order_)
                for (const int which : {0, 1}) moved = bridge({w, which}) || moved;
            for (const std::uint32_t w : order_)
                for (const int which : {0, 1}) moved = settle({w, which}) || moved;
            index_ = nullptr;
            if (!moved) break;
            any = true;
        }
        return any;
    }

private:
    [[nodiscard]] const Wall& wall(std::uint32_t w) const { return storey_.walls[w]; }
    [[nodiscard]] Point place(End e) const { return e.which == 0 ? wall(e.wall).start : wall(e.wall).end; }
    [[nodiscard]] double half(std::uint32_t w) const { return wall(w).thickness / 2; }

    /// Unit vector that leaves the end along its wall.
    [[nodiscard]] Point along(End e) const {
        const Point left = axes_[e.wall].normal(e.which);
        return turned_left(left) * (e.which == 0 ? -1 : 1);
    }

    /// Of all that an end may meet: the strips of the walls and what lies within the gap of them, twice over since
    /// walls move within a round.
    [[nodiscard]] std::vector<PlanBox> boxes() const {
        std::vector<PlanBox> all(axes_.size());
        for (std::uint32_t w = 0; w < axes_.size(); ++w) {
            const WallAxis& axis = axes_[w];
            const int pieces = axis.straight() ? 1 : 16;
            for (int k = 0; k <= pieces; ++k) all[w].add(axis.at(double(k) / pieces));
            const double bulge = axis.radius() * (1 - std::cos(axis.extent() / pieces / 2));
            all[w] = all[w].grown(bulge + half(w) + 2 * gap_ + kOnePlace);
        }
        return all;
    }

    template <class Visit>
    void neighbours(End e, Visit visit) const {
        index_->near(place(e), [&](std::uint32_t w) {
            if (w != e.wall) visit(w);
        });
    }

    [[nodiscard]] bool shares_place(End e) const {
        bool shares = false;
        neighbours(e, [&](std::uint32_t w) {
            for (const int which : {0, 1}) shares = shares || distance(place(e), place({w, which})) <= kOnePlace;
        });
        return shares;
    }

    /// Whether another wall goes straight on from this end: for who meets it, there is no end here.
    [[nodiscard]] bool goes_on(End e) const {
        bool on = false;
        neighbours(e, [&](std::uint32_t w) {
            for (const int which : {0, 1})
                on = on || (distance(place(e), place({w, which})) <= kOnePlace &&
                            dot(along(e), along({w, which})) < -kSameWay);
        });
        return on;
    }

    [[nodiscard]] double distance_to_axis(Point p, std::uint32_t w) const {
        return distance(p, axes_[w].at(axes_[w].nearest(p)));
    }

    [[nodiscard]] bool in_body(Point p, std::uint32_t w) const { return distance_to_axis(p, w) <= half(w) + kOnePlace; }

    /// In the body of a wall that has no end nearby.
    [[nodiscard]] bool meets_middle(End e) const {
        bool meets = false;
        neighbours(e, [&](std::uint32_t w) {
            if (meets || !in_body(place(e), w)) return;
            const int which = distance(place(e), place({w, 0})) <= distance(place(e), place({w, 1})) ? 0 : 1;
            meets = distance(place(e), place({w, which})) > gap_ || goes_on({w, which});
        });
        return meets;
    }

    [[nodiscard]] bool settled(End e) const { return shares_place(e) || meets_middle(e); }

    bool settle(End e) {
        if (settled(e)) return false;
        if (const std::optional<End> other = nearest_end(e)) return join(e, *other);
        bool inside = false;
        neighbours(e, [&](std::uint32_t w) { inside = inside || in_body(place(e), w); });
        return !inside && extend(e);
    }

    /// The nearest end within the gap, but for those of walls beside this one.
    [[nodiscard]] std::optional<End> nearest_end(End e) const {
        std::optional<End> best;
        double best_distance = gap_;
        const Point far = place({e.wall, 1 - e.which});
        neighbours(e, [&](std::uint32_t w) {
            for (const int which : {0, 1}) {
                const End f{w, which};
                const double away = distance(place(e), place(f));
                if (away > best_distance || distance(far, place(f)) <= 2 * away) continue;
                if (distance(place({w, 1 - which}), place(e)) <= 2 * away) continue;
                if (dot(along(e), along(f)) > kSameWay) continue;
                if (best && away == best_distance &&
                    std::tie(wall(best->wall).id, best->which) < std::tie(wall(w).id, which))
                    continue;
                best = f;
                best_distance = away;
            }
        });
        return best;
    }

    bool join(End e, End f) {
        const Point from = place(e);
        const Point to = place(f);
        Point at = to;
        if (!settled(f)) {
            // Both are loose: where their walls would meet, else half way.
            at = (from + to) * 0.5;
            const double sine = cross(along(e), along(f));
            if (axes_[e.wall].straight() && axes_[f.wall].straight() && std::abs(sine) > kCrossing) {
                const Point corner = from + along(e) * (cross(to - from, along(f)) / sine);
                if (distance(corner, from) <= gap_ && distance(corner, to) <= gap_) at = corner;
            }
        }
        if ((at != from && !may_move(e, at)) || (at != to && !may_move(f, at))) return false;
        for (const End moving : {e, f}) {
            const Point was = place(moving);
            if (was == at) continue;
            const End other = moving.wall == e.wall ? f : e;
            const double moved = distance(was, at);
            Finding finding = about("P215", moved < kHarmless ? Severity::Note : Severity::Warning, "wall",
                                    wall(moving.wall), storey_, at);
            finding.elements.push_back({"wall", wall(other.wall).id, wall(other.wall).name});
            finding.sentence = named("Wall", wall(moving.wall), storey_) + " ended " +
                               millimetres_text(distance(from, to)) + " from the end of wall " +
                               called(wall(other.wall)) + " at " + place_text(at) + ": its end was moved by " +
                               millimetres_text(moved) + " to meet it.";
            finding.hint = "Draw both ends at one point.";
            finding.moved_mm = moved * 1000;
            report_.add(std::move(finding));
            move(moving, at, wall(moving.wall).arc_extent);
        }
        return true;
    }

    /// Walls do not shrink to less than half for the sake of a joint.
    [[nodiscard]] bool may_move(End e, Point at) const {
        const Point far = place({e.wall, 1 - e.which});
        const double now = distance(far, at);
        return now >= 2 * shortest_wall && now >= distance(far, place(e)) / 2;
    }

    struct Reach {
        double share = 0;   ///< of the own axis, beyond 0 or 1
        double length = 0;  ///< m, beyond the end
        std::uint32_t wall = UINT32_MAX;
    };

    /// Extends the end along its own axis to the first axis that it runs into.
    bool extend(End e) {
        std::optional<Reach> best;
        double gap = 0;
        neighbours(e, [&](std::uint32_t w) {
            const double short_by = distance_to_axis(place(e), w) - half(w);
            if (short_by > gap_) return;
            const std::optional<Reach> reach = reach_of(e, w, (half(w) + gap_) / kCrossing);
            if (!reach) return;
            if (best &&
                (reach->length > best->length || (reach->length == best->length && wall(best->wall).id < wall(w).id)))
                return;
            best = reach;
            gap = short_by;
        });
        if (!best) return false;
        const Point at = axes_[e.wall].at(best->share);
        const double extent = wall(e.wall).arc_extent * (e.which == 0 ? 1 - best->share : best->share);
        Finding finding = about("P216", gap < kHarmless ? Severity::Note : Severity::Warning, "wall", wall(e.wall),
                                storey_, place(e));
        finding.elements.push_back({"wall", wall(best->wall).id, wall(best->wall).name});
        finding.sentence = named("Wall", wall(e.wall), storey_) + " ended " + millimetres_text(gap) +
                           " short of wall " + called(wall(best->wall)) + " at " + place_text(place(e)) +
                           ": it was extended by " + millimetres_text(best->length) + " to the axis of that wall.";
        finding.hint = "Draw it up to the other wall.";
        finding.moved_mm = best->length * 1000;
        report_.add(std::move(finding));
        move(e, at, extent);
        return true;
    }

    /// Where the axis, extended by `most` metres at most, crosses that of `host`: the change of side is found step by
    /// step, then by halves, which serves arcs and lines alike.
    [[nodiscard]] std::optional<Reach> reach_of(End e, std::uint32_t host, double most) const {
        const WallAxis& axis = axes_[e.wall];
        const WallAxis& other = axes_[host];
        const double sign = e.which == 0 ? -1 : 1;
        const auto share = [&](double length) { return e.which + sign * length / axis.length(); };
        const auto side = [&](double length) {
            const Point p = axis.at(share(length));
            const double t = other.nearest(p);
            return dot(p - other.at(t), other.normal(t));
        };
        // An arc must not run full circle.
        if (!axis.straight() && std::abs(axis.extent()) * (1 + most / axis.length()) >= 2 * std::numbers::pi)
            return std::nullopt;
        constexpr int kSteps = 16;
        double low = 0;
        const double first = side(0);
        double high = most;
        bool crosses = false;
        for (int k = 1; k <= kSteps && !crosses; ++k) {
            high = most * k / kSteps;
            crosses = (side(high) > 0) != (first > 0);
            if (!crosses) low = high;
        }
        if (!crosses) return std::nullopt;
        for (int k = 0; k < 60; ++k) {
            const double middle = low + (high - low) / 2;
            ((side(middle) > 0) != (first > 0) ? high : low) = middle;
        }
        // Beyond the ends of `host` the side changes without a crossing.
        if (distance_to_axis(axis.at(share(high)), host) > gap_) return std::nullopt;
        return Reach{share(high), high, host};
    }

    /// The opening that reaches farthest beyond the end, out of those that begin at the wall or next to it.
    [[nodiscard]] std::pair<const Opening*, double> overhanging(End e) {
        const Opening* farthest = nullptr;
        double most = end_margin;
        const double length = axes_[e.wall].length();
        for (const std::uint32_t o : openings_of(wall(e.wall).id)) {
            const Opening& opening = storey_.openings[o];
            const double middle = e.which == 0 ? -opening.offset : opening.offset - length;
            const double beyond = middle + opening.width / 2;
            if (middle - opening.width / 2 > kBesideEnd || !(beyond <= kWidestGap)) continue;
            if (beyond < most || (beyond == most && (farthest == nullptr || farthest->id < opening.id))) continue;
            farthest = &opening;
            most = beyond;
        }
        return {farthest, most};
    }

    struct FarSide {
        Point at;
        double length = HUGE_VAL;
        std::uint32_t wall = UINT32_MAX;
    };

    /// What the wall meets first when it goes on straight for `most` metres: an end that faces it, or an axis.
    [[nodiscard]] FarSide across(End e, double most) const {
        FarSide best;
        const Point from = place(e);
        const Point ahead = along(e) * -1;
        const auto consider = [&](const FarSide& side) {
            if (side.length > most || side.length < kOnePlace) return;
            if (side.length > best.length || (side.length == best.length && wall(best.wall).id < wall(side.wall).id))
                return;
            best = side;
        };
        const int samples = int(std::ceil(most / gap_)) + 1;
        for (int k = 0; k <= samples; ++k)
            index_->near(from + ahead * (most * k / samples), [&](std::uint32_t w) {
                if (w == e.wall) return;
                for (const int which : {0, 1}) {
                    const Point arm = place({w, which}) - from;
                    if (std::abs(cross(ahead, arm)) > std::max(half(w), half(e.wall))) continue;
                    if (dot(along({w, which}), ahead) > kSameWay) consider({place({w, which}), dot(arm, ahead), w});
                }
                if (const auto reach = reach_of(e, w, most))
                    consider({axes_[e.wall].at(reach->share), reach->length, w});
            });
        return best;
    }

    bool bridge(End e) {
        if (!axes_[e.wall].straight()) return false;
        const auto [opening, beyond] = overhanging(e);
        if (opening == nullptr || settled(e)) return false;
        const FarSide side = across(e, beyond + kBesideDoor);
        if (side.wall == UINT32_MAX) return false;
        Finding finding = about("P219", Severity::Warning, "opening", *opening, storey_, (place(e) + side.at) * 0.5);
        finding.elements.push_back({"wall", wall(e.wall).id, wall(e.wall).name});
        finding.elements.push_back({"wall", wall(side.wall).id, wall(side.wall).name});
        finding.sentence = named("Opening", *opening, storey_) + " stands in a gap of " + metres_text(side.length) +
                           " between walls " + called(wall(e.wall)) + " and " + called(wall(side.wall)) + " at " +
                           place_text(place(e)) + ": the first was extended to the second.";
        finding.hint = "Draw one wall through, and the opening in it.";
        finding.moved_mm = side.length * 1000;
        report_.add(std::move(finding));
        move(e, side.at, 0);
        return true;
    }

    void move(End e, Point at, double extent) {
        Wall& moving = storey_.walls[e.wall];
        const WallAxis before = axes_[e.wall];
        (e.which == 0 ? moving.start : moving.end) = at;
        moving.arc_extent = extent;
        axes_[e.wall] = axis_of(moving);
        const WallAxis& after = axes_[e.wall];
        for (const std::uint32_t o : openings_of(moving.id)) {
            Opening& opening = storey_.openings[o];
            const double share = opening.offset / before.length();
            if (share > 0 && share < 1) opening.offset = after.nearest(before.at(share)) * after.length();
            else if (e.which == 0) opening.offset += after.length() - before.length();
        }
    }

    [[nodiscard]] const std::vector<std::uint32_t>& openings_of(const std::string& id) {
        if (hosted_.empty())
            for (std::uint32_t o = 0; o < storey_.openings.size(); ++o) hosted_[storey_.openings[o].wall].push_back(o);
        static const std::vector<std::uint32_t> none_hosted;
        const auto found = hosted_.find(id);
        return found == hosted_.end() ? none_hosted : found->second;
    }

    [[nodiscard]] static std::string place_text(Point p) {
        return "(" + rounded_text(p.x, 3) + ", " + rounded_text(p.y, 3) + ")";
    }

    Storey& storey_;
    double gap_;
    CleanReport& report_;
    std::vector<std::uint32_t> order_;  ///< walls by id
    std::vector<WallAxis> axes_;        ///< [wall]
    std::unordered_map<std::string, std::vector<std::uint32_t>> hosted_;
    const BoxIndex* index_ = nullptr;
};

}  // namespace

bool join_walls(Storey& storey, double join_gap, CleanReport& report) {
    if (storey.walls.size() < 2 || !(join_gap > 0)) return false;
    return Joiner(storey, join_gap, report).run();
}

}  // namespace enfilade::plans

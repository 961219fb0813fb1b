#include <algorithm>
#include <cmath>
#include <numbers>

#include "modeler/furnishing/candidates.h"

namespace enfilade::modeler {

using plans::Point;

namespace {

constexpr double touching = 2.5;         // grid units off the wall: what rounding outward needs
constexpr double spacing = 0.4;          // metres between even places along a wall
constexpr double curve_spacing = 0.25;   // metres
constexpr std::size_t most_places = 48;  // of one run
constexpr double largest_turn = 0.6;     // radians between sides of one curved wall
constexpr double bulge = 0.05;           // metres by which a curved wall may come before a chord
constexpr double hollow = 0.15;          // metres behind a chord that may be empty

double angle_of(Point look) { return std::atan2(look.x, -look.y); }

class WallSearcher {
public:
    WallSearcher(const Occupancy& occupancy, const std::vector<WallRing>& rings, const WallSearch& search)
        : room_(occupancy.room()), occupancy_(occupancy), rings_(rings), search_(search), unit_(room_.frame.unit) {}

    std::vector<Candidate> run() {
        for (const WallRing& ring : rings_) {
            for (const WallRun& run : ring.runs) along(run);
            along_curves(ring);
        }
        return std::move(candidates_);
    }

private:
    [[nodiscard]] bool turned() const { return search_.turned; }

    void along(const WallRun& run) {
        const double width = search_.size.width;
        if (run.length < width + 2 * touching) return;
        places_.clear();
        // In corners sharper than a right angle the piece's front corner touches first.
        const double reach = search_.gap + search_.size.depth + touching;
        const auto corner = [&](double turn) {
            const double inner = std::numbers::pi - turn;
            return turn > 0 && inner < std::numbers::pi / 2 - 1e-6 ? reach / std::tan(inner) : 0;
        };
        starts_at(corner(run.turn_before), run);
        ends_at(run.length - corner(run.turn_after), run);
        places_.push_back(run.length / 2);
        for (const WallSpan& span : run.spans) {
            if (span.beyond == Beyond::Wall) continue;
            starts_at(span.to + beside_opening(span), run);
            ends_at(span.from - beside_opening(span), run);
            if (span.beyond == Beyond::Window) places_.push_back((span.from + span.to) / 2);
        }
        beside_bodies(run, reach);
        const int count = std::max(1, int((run.length - width) * unit_ / spacing));
        for (int k = 0; k <= count && count < 200; ++k) places_.push_back(width / 2 + (run.length - width) * k / count);
        std::sort(places_.begin(), places_.end());
        places_.erase(
            std::unique(places_.begin(), places_.end(), [&](double a, double b) { return b - a < 0.01 / unit_; }),
            places_.end());
        thin_out(places_);
        for (const double u : places_) add(run, u);
    }

    [[nodiscard]] double beside_opening(const WallSpan& span) const {
        return is_passage(span.beyond) ? 0.06 / unit_ : 0;
    }
    void starts_at(double u, const WallRun&) { places_.push_back(u + search_.size.width / 2 + touching); }
    void ends_at(double u, const WallRun&) { places_.push_back(u - search_.size.width / 2 - touching); }

    /// Beside what stands along this run.
    void beside_bodies(const WallRun& run, double reach) {
        for (const Body& body : occupancy_.bodies()) {
            if (search_.hangs && (body.z_high <= search_.z_low || body.z_low >= search_.z_high)) continue;
            double from = HUGE_VAL, to = -HUGE_VAL, nearest = HUGE_VAL;
            for (const plans::GridPoint p : body.ring) {
                const Point d{p.x - run.a.x, p.y - run.a.y};
                from = std::min(from, plans::dot(d, run.along));
                to = std::max(to, plans::dot(d, run.along));
                nearest = std::min(nearest, plans::dot(d, run.inward));
            }
            if (nearest > reach || nearest < -reach || to < 0 || from > run.length) continue;
            starts_at(to, run);
            ends_at(from, run);
        }
    }

    static void thin_out(std::vector<double>& places) {
        if (places.size() <= most_places) return;
        std::vector<double> kept;
        for (std::size_t k = 0; k < most_places; ++k)
            kept.push_back(places[k * (places.size() - 1) / (most_places - 1)]);
        places = std::move(kept);
    }

    void add(const WallRun& run, double u) {
        const double half = search_.size.width / 2;
        if (u - half < 0 || u + half > run.length) return;
        const std::int32_t low = search_.hangs ? search_.z_low : room_.z_floor;
        if (!is_backed(run, u - half, u + half, low, search_.z_high)) return;
        if (search_.hangs && std::any_of(run.spans.begin(), run.spans.end(), [&](const WallSpan& span) {
                return span.from < u + half && span.to > u - half && span.wall_top < search_.z_high;
            }))
            return;
        Candidate candidate;
        const Point look = turned() ? run.inward * -1.0 : run.inward;
        candidate.pose.angle = angle_of(look);
        candidate.pose.at = run.a + run.along * u + run.inward * (search_.gap + search_.size.depth / 2 + touching);
        candidate.wall_share = u / run.length;
        candidates_.push_back(candidate);
    }

    [[nodiscard]] static bool is_curved(const WallRun& run) {
        return (run.turn_before != 0 && std::abs(run.turn_before) < largest_turn) ||
               (run.turn_after != 0 && std::abs(run.turn_after) < largest_turn);
    }

    /// Where neighbouring runs turn little: chords between two points of the wall.
    void along_curves(const WallRing& ring) {
        const double width = search_.size.width;
        if (width * 2 > ring.length) return;
        std::size_t count = 0;
        for (const WallRun& run : ring.runs) {
            if (!is_curved(run) || run.length > 3 * width + 1 / unit_) continue;
            const double step = curve_spacing / unit_;
            const double first = std::ceil(run.start / step) * step;
            for (double s = first; s < run.start + run.length && count < 8 * most_places; s += step, ++count)
                add_chord(ring, s);
        }
    }

    void add_chord(const WallRing& ring, double s) {
        const double width = search_.size.width;
        const Point from = ring.at(s - width / 2), to = ring.at(s + width / 2);
        const Point way = to - from;
        const double length = plans::norm(way);
        if (length < 0.8 * width) return;
        const Point along = way * (1 / length), inward = plans::turned_left(along);
        for (const double share : {-0.4, -0.25, 0.0, 0.25, 0.4}) {
            const double off = plans::dot(ring.at(s + share * width) - from, inward) * unit_;
            if (off > bulge || off < -hollow) return;
        }
        if (!chord_is_backed(ring, s)) return;
        Pose pose;
        pose.at = (from + to) * 0.5 + inward * (search_.size.depth / 2);
        pose.angle = angle_of(inward);
        const auto pushed = pushed_back(room_, pose, search_.size, search_.gap, 0.5 / unit_);
        if (!pushed) return;
        Candidate candidate{*pushed, 0.5};
        if (turned()) candidate.pose.angle = angle_of(inward * -1.0);
        candidates_.push_back(candidate);
    }

    [[nodiscard]] bool chord_is_backed(const WallRing& ring, double s) const {
        const double half = search_.size.width / 2;
        const std::int32_t low = search_.hangs ? search_.z_low : room_.z_floor;
        for (const WallRun& run : ring.runs) {
            for (const double round : {-ring.length, 0.0, ring.length}) {
                const double from = s - half - run.start + round, to = s + half - run.start + round;
                if (to <= 0 || from >= run.length) continue;
                if (!is_backed(run, std::max(from, 0.0), std::min(to, run.length), low, search_.z_high)) return false;
            }
        }
        return true;
    }

    const RoomShape& room_;
    const Occupancy& occupancy_;
    const std::vector<WallRing>& rings_;
    const WallSearch& search_;
    double unit_;
    std::vector<double> places_;
    std::vector<Candidate> candidates_;
};

}  // namespace

std::vector<Candidate> wall_candidates(const Occupancy& occupancy, const std::vector<WallRing>& rings,
                                       const WallSearch& search) {
    return WallSearcher(occupancy, rings, search).run();
}

std::optional<Pose> pushed_back(const RoomShape& room, Pose pose, PieceSize size, double gap, double most) {
    const Point along = pose.along(), inward = pose.front();
    const Point back = pose.at - inward * (size.depth / 2);
    const double half = size.width / 2 + touching;
    GridBox box{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    for (const double u : {-half, half})
        for (const double v : {-most, most}) {
            const Point p = back + along * u + inward * v;
            box.x_low = std::min(box.x_low, std::int32_t(std::floor(p.x)));
            box.y_low = std::min(box.y_low, std::int32_t(std::floor(p.y)));
            box.x_high = std::max(box.x_high, std::int32_t(std::ceil(p.x)));
            box.y_high = std::max(box.y_high, std::int32_t(std::ceil(p.y)));
        }
    double highest = -HUGE_VAL;
    room.floor.near(box, [&](std::uint32_t k) {
        const auto [ga, gb] = room.floor.sides()[k];
        const Point a = Point{double(ga.x), double(ga.y)} - back, b = Point{double(gb.x), double(gb.y)} - back;
        double ua = plans::dot(a, along), va = plans::dot(a, inward), ub = plans::dot(b, along),
               vb = plans::dot(b, inward);
        if (std::max(ua, ub) <= -half || std::min(ua, ub) >= half) return;
        // Clipped to the strip behind the piece.
        const auto v_at = [&](double u) { return ub == ua ? va : va + (vb - va) * (u - ua) / (ub - ua); };
        for (const double v : {v_at(std::clamp(ua, -half, half)), v_at(std::clamp(ub, -half, half))})
            if (v >= -most && v <= most) highest = std::max(highest, v);
    });
    if (highest == -HUGE_VAL) return std::nullopt;
    pose.at = pose.at + inward * (highest + gap + touching);
    return pose;
}

}  // namespace enfilade::modeler

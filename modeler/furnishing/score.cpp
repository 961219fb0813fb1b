#include "modeler/furnishing/score.h"

#include <algorithm>
#include <cmath>

namespace enfilade::modeler {

using plans::Point;

namespace {

constexpr double touches = 0.08;  // metres: what people see as touching
constexpr double useless = 0.55;  // metres: gaps between that and this are too narrow for a person or a piece

class Scorer {
public:
    Scorer(const Occupancy& occupancy, const Candidate& candidate, PieceSize size)
        : occupancy_(occupancy),
          room_(occupancy.room()),
          candidate_(candidate),
          pose_(candidate.pose),
          size_(size),
          unit_(room_.frame.unit) {}

    double sum(const ObjectRule& rule) {
        const ScoreWeights& w = rule.score;
        double result = 0;
        if (w.corner != 0 || w.gap != 0) {
            const double left = way_beside(-1), right = way_beside(1);
            result += w.corner * (std::min(left, right) < touches ? 1 : 0);
            const auto is_useless = [](double way) { return way >= touches && way < useless; };
            result += w.gap * (1 - 0.5 * is_useless(left) - 0.5 * is_useless(right));
        }
        if (w.window != 0) result += w.window * nearest(room_.windows, 2.0);
        if (w.door != 0) result += w.door * nearest(room_.gates, 2.5);
        if (w.wall_middle != 0 && candidate_.wall_share >= 0)
            result += w.wall_middle * (1 - 2 * std::abs(candidate_.wall_share - 0.5));
        if (w.centre != 0) {
            const double radius = std::sqrt(std::max(room_.area_m2, 1e-6) / 3.14159265358979);
            result += w.centre * closeness(plans::distance(pose_.at, room_.middle) * unit_, radius);
        }
        if (w.open_front != 0) {
            const Point from = pose_.at + pose_.front() * (size_.depth / 2 + 1);
            result += w.open_front * free_way(from, pose_.front(), 3.0) / 3.0;
        }
        if (w.near != 0 && !rule.near.empty()) result += w.near * nearest_kind(rule.near);
        if (w.facing != 0 && !rule.facing.empty()) result += w.facing * faces_kind(rule.facing);
        return result;
    }

private:
    static double closeness(double distance, double reach) { return std::max(0.0, 1 - distance / reach); }

    /// Metres along a way before a wall or a piece is met.
    [[nodiscard]] double free_way(Point from, Point way, double most) const {
        double free = room_.floor.free_way(from, way, most / unit_);
        for (const Body& body : occupancy_.bodies()) {
            if (body.hangs || body.carrier != UINT32_MAX) continue;
            const Point d = body.pose.at - from;
            const double reach = (body.width + body.depth) / 2;
            if (std::abs(plans::cross(way, d)) > reach || plans::dot(way, d) + reach < 0) continue;
            free = std::min(free, first_meeting(body.ring, from, way, free));
        }
        return free * unit_;
    }

    static double first_meeting(const Ring& ring, Point from, Point way, double most) {
        double free = most;
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const plans::GridPoint ga = ring[k], gb = ring[(k + 1) % ring.size()];
            const Point a{ga.x - from.x, ga.y - from.y}, b{gb.x - from.x, gb.y - from.y};
            const double sa = plans::cross(way, a), sb = plans::cross(way, b);
            if ((sa > 0) == (sb > 0)) continue;
            const double at = plans::dot(way, a + (b - a) * (sa / (sa - sb)));
            if (at >= 0) free = std::min(free, at);
        }
        return free;
    }

    [[nodiscard]] double way_beside(double side) const {
        const Point way = pose_.along() * side;
        // Near its back, where the wall's end or the neighbour is.
        const Point from = pose_.at + way * (size_.width / 2 - 1) - pose_.front() * (size_.depth * 0.25);
        return free_way(from, way, 1.5);
    }

    [[nodiscard]] double nearest(const std::vector<RoomOpening>& openings, double reach) const {
        double best = 0;
        for (const RoomOpening& opening : openings) {
            const double d = std::max(0.0, plans::distance(pose_.at, opening.a, opening.b) - size_.depth / 2) * unit_;
            best = std::max(best, closeness(d, reach));
        }
        return best;
    }

    [[nodiscard]] double nearest_kind(const std::string& kind) const {
        double best = 0;
        for (const Body& body : occupancy_.bodies())
            if (body.kind == kind)
                best = std::max(best, closeness(plans::distance(body.pose.at, pose_.at) * unit_, 3.0));
        return best;
    }

    [[nodiscard]] double faces_kind(const std::string& kind) const {
        double best = 0;
        for (const Body& body : occupancy_.bodies()) {
            if (body.kind != kind) continue;
            const Point d = body.pose.at - pose_.at;
            const double length = plans::norm(d);
            if (!(length > 0)) continue;
            best = std::max(best, std::max(0.0, plans::dot(d, pose_.front()) / length) *
                                      (0.3 + 0.7 * closeness(length * unit_, 6.0)));
        }
        return best;
    }

    const Occupancy& occupancy_;
    const RoomShape& room_;
    const Candidate& candidate_;
    const Pose& pose_;
    PieceSize size_;
    double unit_;
};

}  // namespace

double score(const Occupancy& occupancy, const Candidate& candidate, PieceSize size, const ObjectRule& rule) {
    return Scorer(occupancy, candidate, size).sum(rule);
}

}  // namespace enfilade::modeler

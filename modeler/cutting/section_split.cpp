#include "modeler/cutting/section_split.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

constexpr std::size_t few_sections = 64;

/// Prefix sums over a ring: what any chord leaves on either side of it.
class Ring {
public:
    Ring(std::span<const GridPoint> points, std::vector<PolygonSide> sides, const SahOptions& options)
        : points_(points), sides_(std::move(sides)), options_(options) {
        const std::size_t n = sides_.size();
        lengths_.assign(n + 1, 0), areas_.assign(n + 1, 0), sections_.assign(n + 1, 0), faces_.assign(n + 1, 0);
        for (std::size_t k = 0; k < n; ++k) {
            const bool begins = begins_section(k);
            if (begins) starts_.push_back(std::uint32_t(k));
            const GridPoint a = at(k), b = at(k + 1);
            lengths_[k + 1] = lengths_[k] + std::hypot(double(b.x) - a.x, double(b.y) - a.y);
            areas_[k + 1] = areas_[k] + double(orientation(at(0), a, b));
            sections_[k + 1] = sections_[k] + (begins ? 1 : 0);
            faces_[k + 1] = faces_[k] + (begins ? sides_[k].faces : 0);
        }
    }

    [[nodiscard]] const std::vector<PolygonSide>& sides() const { return sides_; }
    [[nodiscard]] double cost() const { return cost(lengths_.back(), areas_.back(), sections_.back(), faces_.back()); }

    struct Chord {
        std::uint32_t a = 0, b = 0;
        double cost = 0;  ///< of both sides together
    };
    /// The chord that costs least, if it leaves convex pieces and is cheaper than none.
    [[nodiscard]] bool best_chord(Chord& best) const {
        const std::size_t n = starts_.size();
        if (n < 5) return false;
        std::vector<Chord> chords;
        const double limit = cost() * (1 - 1e-9);
        const auto consider = [&](std::size_t i, std::size_t j) {
            const Chord chord = price(starts_[std::min(i, j)], starts_[std::max(i, j)]);
            if (chord.cost < limit) chords.push_back(chord);
        };
        for (std::size_t i = 0; i < n; ++i) {
            if (n <= few_sections) {
                for (std::size_t j = i + 2; j < n; ++j) consider(i, j);
            } else {
                for (std::size_t step = 2; step <= n / 2; step += (step + 1) / 2) consider(i, (i + step) % n);
            }
        }
        const auto cheaper = [](const Chord& p, const Chord& q) {
            return std::tie(p.cost, p.a, p.b) < std::tie(q.cost, q.a, q.b);
        };
        for (int attempt = 0; attempt < 4 && !chords.empty(); ++attempt) {
            const auto least = std::min_element(chords.begin(), chords.end(), cheaper);
            best = *least;
            if (is_sound(best)) return true;
            chords.erase(least);
        }
        return false;
    }

    [[nodiscard]] std::vector<PolygonSide> part(const Chord& chord, bool first, std::uint32_t line) const {
        const std::size_t n = sides_.size();
        const std::size_t from = first ? chord.a : chord.b, to = first ? chord.b : chord.a + n;
        std::vector<PolygonSide> ring;
        for (std::size_t k = from; k < to; ++k) ring.push_back(sides_[k % n]);
        ring.push_back({sides_[to % n].from, sides_[from % n].from, line, cut_tag});
        return ring;
    }

private:
    [[nodiscard]] GridPoint at(std::size_t k) const { return points_[sides_[k % sides_.size()].from]; }

    [[nodiscard]] bool begins_section(std::size_t k) const {
        const PolygonSide& side = sides_[k];
        const PolygonSide& before = sides_[(k + sides_.size() - 1) % sides_.size()];
        return side.tag == cut_tag || before.tag == cut_tag || side.look != before.look ||
               !goes_straight(points_[before.from], points_[side.from], points_[side.to], before.line, side.line);
    }

    [[nodiscard]] double cost(double length, double area2, double sections, double faces) const {
        const double surface = length * options_.unit * options_.height + area2 * options_.unit * options_.unit;
        return surface * (options_.cost.visit + options_.cost.section * sections + options_.cost.face * faces);
    }

    [[nodiscard]] Chord price(std::uint32_t i, std::uint32_t j) const {
        const GridPoint a = at(i), b = at(j);
        const double chord = std::hypot(double(b.x) - a.x, double(b.y) - a.y);
        const double length = lengths_[j] - lengths_[i];
        const double area = areas_[j] - areas_[i] + double(orientation(at(0), b, a));
        // Thinner than the grid on one side: no cut.
        if (std::min(area, areas_.back() - area) < 4 * least_gap * chord) return {i, j, cost()};
        const double sections = sections_[j] - sections_[i], faces = faces_[j] - faces_[i];
        return {i, j,
                cost(length + chord, area, sections + 1, faces + 1) +
                    cost(lengths_.back() - length + chord, areas_.back() - area, sections_.back() - sections + 1,
                         faces_.back() - faces + 1)};
    }

    /// Whether both parts are convex and no other corner is too near to the chord, which bent sides may bring there.
    [[nodiscard]] bool is_sound(const Chord& chord) const {
        const std::size_t n = sides_.size();
        const GridPoint a = at(chord.a), b = at(chord.b);
        const auto distance = [](GridPoint p, GridPoint q) { return std::hypot(double(q.x) - p.x, double(q.y) - p.y); };
        const double length = distance(a, b);
        for (std::size_t k = 0; k < n; ++k) {
            if (k == chord.a || k == chord.b) continue;
            const bool is_first = k > chord.a && k < chord.b;
            const double off = double(orientation(a, b, at(k))) / length * (is_first ? -1 : 1);
            const bool is_beside = std::min(distance(a, at(k)), distance(b, at(k))) < 8 * least_gap;
            if (off <= 0 || (off < least_gap && !is_beside)) return false;
        }
        for (const bool first : {true, false}) {
            std::vector<RingCorner> corners;
            for (const PolygonSide& side : part(chord, first, cut_tag))
                corners.push_back({points_[side.from], side.line});
            if (reflex_corner(corners)) return false;
        }
        return true;
    }

    std::span<const GridPoint> points_;
    std::vector<PolygonSide> sides_;
    const SahOptions& options_;
    std::vector<std::uint32_t> starts_;                       ///< sides that begin a section
    std::vector<double> lengths_, areas_, sections_, faces_;  ///< [side + 1] of those before it
};

}  // namespace

void split_sections(std::span<const GridPoint> points, std::span<const PolygonSide> ring, const SahOptions& options,
                    std::uint32_t& next_line, Partition& pieces) {
    std::vector<std::vector<PolygonSide>> waiting = {{ring.begin(), ring.end()}};
    while (!waiting.empty()) {
        const Ring current(points, std::move(waiting.back()), options);
        waiting.pop_back();
        Ring::Chord chord;
        if (current.best_chord(chord)) {
            waiting.push_back(current.part(chord, false, next_line));
            waiting.push_back(current.part(chord, true, next_line));
            ++next_line;
            continue;
        }
        pieces.sides.insert(pieces.sides.end(), current.sides().begin(), current.sides().end());
        pieces.first_side.push_back(std::uint32_t(pieces.sides.size()));
    }
}

}  // namespace enfilade::modeler

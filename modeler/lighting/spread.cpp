#include "modeler/lighting/spread.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace enfilade::modeler {
namespace {

using plans::Point;

constexpr std::size_t most_means = 200;  ///< of more, a lattice is as good
constexpr double samples_a_lamp = 48;
constexpr double least_samples = 400;
constexpr int most_rounds = 40;
constexpr std::array<double, 4> clearances = {0.3, 0.15, 0.05, 0.01};  ///< metres: the first with any place

/// The region's own axes: along its longest walls, and its extent there.
struct Frame {
    Point along{1, 0};
    Point low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};

    [[nodiscard]] Point in(Point p) const { return {p.x * along.x + p.y * along.y, p.y * along.x - p.x * along.y}; }
    [[nodiscard]] Point out(Point p) const { return {p.x * along.x - p.y * along.y, p.x * along.y + p.y * along.x}; }
    [[nodiscard]] double width() const { return high.x - low.x; }
    [[nodiscard]] double depth() const { return high.y - low.y; }
};

/// Walls by direction, quarter turns apart alike, in steps of half a degree; the one with most metres of wall.
Point main_direction(const SpreadRegion& region) {
    constexpr double quarter = std::numbers::pi / 2, step = std::numbers::pi / 360;
    std::map<int, std::pair<double, double>> metres;  // bin -> length, length * angle from the bin's middle
    for (const auto& [a, b] : region.sides) {
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (!(length > 0)) continue;
        double angle = std::fmod(std::atan2(b.y - a.y, b.x - a.x) + 2 * std::numbers::pi, quarter);
        if (angle > quarter - step / 2) angle -= quarter;
        const int bin = int(std::lround(angle / step));
        metres[bin].first += length;
        metres[bin].second += length * (angle - bin * step);
    }
    double most = 0, best = 0;
    for (const auto& [bin, sum] : metres)
        if (sum.first > most + 1e-9) most = sum.first, best = bin * step + sum.second / sum.first;
    return {std::cos(best), std::sin(best)};
}

Frame frame_of(const SpreadRegion& region) {
    Frame frame;
    frame.along = main_direction(region);
    for (const auto& side : region.sides)
        for (const Point p : side) {
            const Point q = frame.in(p);
            frame.low = {std::min(frame.low.x, q.x), std::min(frame.low.y, q.y)};
            frame.high = {std::max(frame.high.x, q.x), std::max(frame.high.y, q.y)};
        }
    return frame;
}

class Spread {
public:
    Spread(const SpreadRegion& region, std::size_t count, bool is_exact)
        : region_(region), count_(count), is_exact_(is_exact), frame_(frame_of(region)) {}

    std::vector<Point> run() {
        if (count_ == 0 || region_.sides.empty() || !(region_.area > 0)) return {};
        std::vector<Point> places = grid();
        for (const double clearance : clearances) {
            if (!places.empty()) break;
            places = count_ > most_means ? lattice(clearance) : means(clearance);
        }
        std::ranges::sort(places, {}, [](Point p) { return std::pair(p.y, p.x); });
        for (Point& p : places) p = frame_.out(p);
        return places;
    }

private:
    [[nodiscard]] bool is_free(Point p, double clearance) const { return region_.is_free(frame_.out(p), clearance); }

    /// Rows along the longer side of a rectangle; empty where the region is none, or a place is taken.
    [[nodiscard]] std::vector<Point> grid() const {
        const double width = frame_.width(), depth = frame_.depth();
        if (region_.area < 0.95 * width * depth) return {};
        const bool is_wide = width >= depth;
        const double longer = std::max(width, depth), shorter = std::min(width, depth);
        const double pitch = std::sqrt(width * depth / double(count_));
        const auto rows = std::size_t(std::max(1.0, std::round(shorter / pitch)));
        const std::size_t each = std::max<std::size_t>(1, (count_ + rows / 2) / rows);
        if (is_exact_ && rows * each != count_) return {};
        const double stretch = (longer / double(each)) / (shorter / double(rows));
        if (rows > 1 && (stretch > 2.5 || stretch < 0.4)) return {};
        std::vector<Point> places;
        for (std::size_t r = 0; r < rows; ++r)
            for (std::size_t k = 0; k < each; ++k) {
                const double u = (double(k) + 0.5) * longer / double(each);
                const double v = (double(r) + 0.5) * shorter / double(rows);
                places.push_back({frame_.low.x + (is_wide ? u : v), frame_.low.y + (is_wide ? v : u)});
                if (!is_free(places.back(), clearances.back())) return {};
            }
        return places;
    }

    /// The free places of a square lattice.
    [[nodiscard]] std::vector<Point> free_places(double step, double clearance) const {
        std::vector<Point> places;
        const auto columns = std::size_t(frame_.width() / step) + 1, rows = std::size_t(frame_.depth() / step) + 1;
        const double left = frame_.low.x + (frame_.width() - double(columns - 1) * step) / 2;
        const double bottom = frame_.low.y + (frame_.depth() - double(rows - 1) * step) / 2;
        for (std::size_t j = 0; j < rows; ++j)
            for (std::size_t i = 0; i < columns; ++i) {
                const Point p{left + double(i) * step, bottom + double(j) * step};
                if (is_free(p, clearance)) places.push_back(p);
            }
        return places;
    }

    /// As wide a lattice as has enough places; what is too many is left out evenly.
    [[nodiscard]] std::vector<Point> lattice(double clearance) const {
        double narrow = std::sqrt(region_.area / double(count_)) / 2, wide = 4 * narrow;
        std::vector<Point> best = free_places(narrow, clearance);
        if (best.size() < count_) return best;
        for (int round = 0; round < 12; ++round) {
            const double middle = (narrow + wide) / 2;
            std::vector<Point> places = free_places(middle, clearance);
            if (places.size() < count_) wide = middle;
            else narrow = middle, best = std::move(places);
        }
        std::vector<Point> kept;
        for (std::size_t k = 0; k < count_; ++k) kept.push_back(best[k * best.size() / count_]);
        return kept;
    }

    [[nodiscard]] std::vector<Point> means(double clearance) const {
        const double wanted = std::max(least_samples, samples_a_lamp * double(count_));
        const std::vector<Point> samples = free_places(std::sqrt(region_.area / wanted), clearance);
        if (samples.size() <= count_) return samples;
        std::vector<Point> centres = far_apart(samples);
        std::vector<std::uint32_t> owner(samples.size(), 0);
        for (int round = 0; round < most_rounds && assign(samples, centres, owner); ++round)
            move_to_means(samples, owner, centres);
        return freed(samples, centres, clearance);
    }

    /// The sample nearest to the middle, then always the one farthest from those taken.
    [[nodiscard]] std::vector<Point> far_apart(const std::vector<Point>& samples) const {
        Point middle{0, 0};
        for (const Point p : samples) middle = middle + p;
        middle = middle * (1 / double(samples.size()));
        std::vector<Point> centres = {nearest(samples, middle)};
        std::vector<double> distance(samples.size(), HUGE_VAL);
        while (centres.size() < count_) {
            std::size_t farthest = 0;
            for (std::size_t k = 0; k < samples.size(); ++k) {
                distance[k] = std::min(distance[k], square(samples[k] - centres.back()));
                if (distance[k] > distance[farthest]) farthest = k;
            }
            centres.push_back(samples[farthest]);
        }
        return centres;
    }

    /// Whether any sample has changed its owner.
    static bool assign(const std::vector<Point>& samples, const std::vector<Point>& centres,
                       std::vector<std::uint32_t>& owner) {
        bool changed = false;
        for (std::size_t k = 0; k < samples.size(); ++k) {
            std::uint32_t best = 0;
            double least = HUGE_VAL;
            for (std::uint32_t c = 0; c < centres.size(); ++c)
                if (const double d = square(samples[k] - centres[c]); d < least) least = d, best = c;
            changed = changed || owner[k] != best;
            owner[k] = best;
        }
        return changed || centres.size() == 1;
    }

    static void move_to_means(const std::vector<Point>& samples, const std::vector<std::uint32_t>& owner,
                              std::vector<Point>& centres) {
        std::vector<Point> sums(centres.size(), Point{0, 0});
        std::vector<double> counts(centres.size(), 0);
        for (std::size_t k = 0; k < samples.size(); ++k)
            sums[owner[k]] = sums[owner[k]] + samples[k], counts[owner[k]] += 1;
        for (std::size_t c = 0; c < centres.size(); ++c)
            if (counts[c] > 0) centres[c] = sums[c] * (1 / counts[c]);
    }

    /// A mean that is not free (around a corner, in a column) goes to the nearest sample that no other has taken.
    [[nodiscard]] std::vector<Point> freed(std::vector<Point> samples, const std::vector<Point>& centres,
                                           double clearance) const {
        std::vector<Point> places;
        for (const Point c : centres) {
            const Point place = is_free(c, clearance) ? c : nearest(samples, c);
            std::erase_if(samples, [&](Point p) { return square(p - place) < 1e-12; });
            places.push_back(place);
            if (samples.empty()) break;
        }
        return places;
    }

    static double square(Point p) { return p.x * p.x + p.y * p.y; }
    static Point nearest(const std::vector<Point>& samples, Point to) {
        return *std::ranges::min_element(samples, {}, [&](Point p) { return square(p - to); });
    }

    const SpreadRegion& region_;
    std::size_t count_;
    bool is_exact_;
    Frame frame_;
};

}  // namespace

std::vector<Point> spread(const SpreadRegion& region, std::size_t count, bool is_exact) {
    return Spread(region, count, is_exact).run();
}

}  // namespace enfilade::modeler

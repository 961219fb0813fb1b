#include "tools/footpath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "accel/locate.h"
#include "render/move_camera.h"

namespace enfilade::tools {

namespace {

using render::Vec3d;

constexpr double shoulder = 0.22;        ///< metres from the eyes, to both sides
constexpr double least_shoulder = 0.12;  ///< where corners are rounded
constexpr double knees = 1.2;            ///< below the eyes
constexpr double level = 0.02;           ///< rise of a way that is not a stair
constexpr std::size_t farthest_skip = 24;
constexpr std::array<double, 4> radii = {0.8, 0.55, 0.35, 0.2};
constexpr std::array<double, 4> reaches = {1.0, 0.7, 0.45, 0.25};  ///< how far before a corner it is rounded
constexpr double stride = 0.05;                                    ///< metres, in which directions are measured
constexpr double least_run = 1e-4;                                 ///< of a stride; others go up or down on the spot
constexpr double steepest_look = 0.5;                              ///< rise by run
constexpr double look_ahead = 0.7;   ///< middle of the stretch whose directions a look averages, metres ahead
constexpr double look_spread = 0.5;  ///< standard deviation of their weights
constexpr int arc_pieces = 8;

bool is_clear(const accel::SceneView& scene, Vec3d a, Vec3d b) {
    const std::optional<accel::CellId> cell = accel::locate(scene, {a.x, a.y, a.z});
    if (!cell) return false;
    const render::Place there = render::move_camera(scene, {a, *cell}, b - a, 0);
    return render::length(there.point - b) < 1e-6;
}

Vec3d flat(Vec3d v) { return {v.x, v.y, 0}; }

/// A quarter turn to the left, of length 1; nothing for vertical ways.
std::optional<Vec3d> left_of(Vec3d way) {
    const double size = std::hypot(way.x, way.y);
    if (!(size > 1e-9)) return std::nullopt;
    return Vec3d{-way.y / size, way.x / size, 0};
}

bool is_level(Vec3d a, Vec3d b) { return std::abs(a.z - b.z) < level; }

/// Leaves out the points between two that see each other. Stops and stairs stay as they are.
std::vector<std::size_t> shortened(const accel::SceneView& scene, std::span<const Vec3d> points,
                                   std::span<const std::size_t> stops) {
    std::vector<std::size_t> kept = {0};
    while (kept.back() + 1 < points.size()) {
        const std::size_t from = kept.back();
        const auto stop = std::ranges::upper_bound(stops, from);
        std::size_t to = std::min({points.size() - 1, from + farthest_skip, stop == stops.end() ? SIZE_MAX : *stop});
        for (; to > from + 1; --to) {
            bool all_level = true;
            for (std::size_t k = from; k < to; ++k) all_level = all_level && is_level(points[k], points[k + 1]);
            if (all_level && can_walk(scene, points[from], points[to], shoulder)) break;
        }
        kept.push_back(to);
    }
    return kept;
}

/// Where a way comes back the way it went, two points beside the stop take its place: one walks round, instead of
/// turning on the spot.
void add_turn(const accel::SceneView& scene, Vec3d before, Vec3d stop, Vec3d after, std::vector<Vec3d>& way) {
    const Vec3d in = flat(stop - before), out = flat(after - stop);
    const std::optional<Vec3d> left = left_of(in);
    const double sizes = render::length(in) * render::length(out);
    if (left && render::dot(in, out) < -0.7 * sizes) {
        for (const double radius : radii) {
            const Vec3d a = stop + radius * *left, b = stop - radius * *left;
            if (!can_walk(scene, before, a, shoulder) || !can_walk(scene, a, b, shoulder) ||
                !can_walk(scene, b, after, shoulder))
                continue;
            way.push_back(a);
            way.push_back(b);
            return;
        }
    }
    way.push_back(stop);
}

/// The corner as a parabola that begins and ends `reach` metres from it, or the corner itself where there is no room.
void add_rounded(const accel::SceneView& scene, Vec3d before, Vec3d corner, Vec3d after, std::vector<Vec3d>& way) {
    const Vec3d in = corner - before, out = after - corner;
    const double in_length = render::length(in), out_length = render::length(out);
    if (in_length > 1e-9 && out_length > 1e-9) {
        for (const double reach : reaches) {
            const double used = std::min({reach, in_length / 2, out_length / 2});
            const Vec3d a = corner - (used / in_length) * in, b = corner + (used / out_length) * out;
            std::array<Vec3d, arc_pieces + 1> arc;
            for (int k = 0; k <= arc_pieces; ++k) {
                const double t = double(k) / arc_pieces;
                arc[std::size_t(k)] = (1 - t) * (1 - t) * a + 2 * t * (1 - t) * corner + t * t * b;
            }
            bool is_good = true;
            for (std::size_t k = 0; k < arc_pieces && is_good; ++k)
                is_good = can_walk(scene, arc[k], arc[k + 1], least_shoulder);
            if (!is_good) continue;
            way.insert(way.end(), arc.begin(), arc.end());
            return;
        }
    }
    way.push_back(corner);
}

}  // namespace

bool can_walk(const accel::SceneView& scene, Vec3d a, Vec3d b, double clearance) {
    if (!is_clear(scene, a, b)) return false;
    const std::optional<Vec3d> left = left_of(b - a);
    if (!left) return true;
    const Vec3d aside = clearance * *left;
    if (!is_clear(scene, a + aside, b + aside) || !is_clear(scene, a - aside, b - aside)) return false;
    const Vec3d down = {0, 0, -knees};
    return !is_level(a, b) || is_clear(scene, a + down, b + down);  // a flight has its steps there
}

Footpath::Footpath(const accel::SceneView& scene, std::span<const Vec3d> points, std::span<const std::size_t> stops) {
    const std::vector<std::size_t> kept = shortened(scene, points, stops);
    std::vector<Vec3d> way;
    for (std::size_t k = 0; k < kept.size(); ++k) {
        const bool is_inner = k > 0 && k + 1 < kept.size();
        if (is_inner && std::ranges::binary_search(stops, kept[k]))
            add_turn(scene, way.back(), points[kept[k]], points[kept[k + 1]], way);
        else way.push_back(points[kept[k]]);
    }
    for (std::size_t k = 0; k < way.size(); ++k) {
        if (k > 0 && k + 1 < way.size()) add_rounded(scene, way[k - 1], way[k], way[k + 1], points_);
        else points_.push_back(way[k]);
    }
    measure();
}

void Footpath::measure() {
    double metres = 0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
        if (k > 0) metres += render::length(points_[k] - points_[k - 1]);
        walked_.push_back(metres);
    }
    double heading = 0;
    for (std::size_t k = 0; (double(k) + 0.5) * stride < metres; ++k) {
        const Vec3d way = at((double(k) + 1) * stride) - at(double(k) * stride);
        const double run = std::hypot(way.x, way.y);
        if (run > least_run) {
            const double turned = headings_.empty() ? 0 : heading;
            heading = turned + std::remainder(std::atan2(way.y, way.x) - turned, 2 * std::numbers::pi);
        }
        headings_.push_back(heading);
        slopes_.push_back(std::clamp(way.z / std::max(run, least_run), -steepest_look, steepest_look));
    }
}

Vec3d Footpath::look(double metres) const {
    double heading = 0, slope = 0, weight = 0;
    // A bell over what lies ahead; what is past or beyond the end counts as the first and the last stride.
    for (double at = -2.5 * look_spread; at <= 2.5 * look_spread && !headings_.empty(); at += stride) {
        const double place = (metres + look_ahead + at) / stride;
        const std::size_t k = std::size_t(std::clamp(place, 0.0, double(headings_.size() - 1)));
        const double part = std::exp(-0.5 * (at / look_spread) * (at / look_spread));
        heading += part * headings_[k];
        slope += part * slopes_[k];
        weight += part;
    }
    if (!(weight > 0)) return {1, 0, 0};
    return {std::cos(heading / weight), std::sin(heading / weight), slope / weight};
}

Vec3d Footpath::at(double metres) const {
    if (points_.size() < 2) return points_.empty() ? Vec3d{0, 0, 0} : points_.front();
    const auto after = std::ranges::upper_bound(walked_, metres);
    std::size_t k =
        std::size_t(std::clamp<std::ptrdiff_t>(after - walked_.begin(), 1, std::ptrdiff_t(walked_.size()) - 1));
    const auto piece = [&] { return walked_[k] - walked_[k - 1]; };
    while (piece() <= 0 && k > 1) --k;
    while (piece() <= 0 && k + 1 < walked_.size()) ++k;
    if (piece() <= 0) return points_[k];
    return points_[k - 1] + ((metres - walked_[k - 1]) / piece()) * (points_[k] - points_[k - 1]);
}

}  // namespace enfilade::tools

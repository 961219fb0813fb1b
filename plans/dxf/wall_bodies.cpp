#include "plans/dxf/wall_bodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plans/dxf/curved_bodies.h"
#include "plans/dxf/intervals.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

using dxf::Interval;
using dxf::Intervals;
using dxf::without;

constexpr double pi = std::numbers::pi;
constexpr double same_direction = 0.4 * pi / 180;
constexpr double same_bundle = 0.06 * pi / 180;
constexpr double bin = 0.005;  ///< metres of wall thickness

struct Segment2 {
    Point a;
    Point b;
    double angle = 0;  ///< [0, pi)
    std::optional<double> height;
};

std::vector<Segment2> straight_strokes(const std::vector<SheetStroke>& strokes) {
    std::vector<Segment2> segments;
    for (const SheetStroke& s : strokes) {
        if (s.stroke.bulge != 0 || distance(s.stroke.a, s.stroke.b) < 0.002) continue;
        const Point d = s.stroke.b - s.stroke.a;
        double angle = std::atan2(d.y, d.x);
        if (angle < 0) angle += pi;
        if (angle >= pi - 1e-9) angle -= pi;
        segments.push_back({s.stroke.a, s.stroke.b, angle, wall_height(s)});
    }
    std::sort(segments.begin(), segments.end(), [](const Segment2& l, const Segment2& r) {
        return std::tie(l.angle, l.a.x, l.a.y, l.b.x, l.b.y) < std::tie(r.angle, r.a.x, r.a.y, r.b.x, r.b.y);
    });
    return segments;
}

/// Lines on one line that touch become one.
void merge_collinear(std::vector<FaceLine>& lines, double same_line) {
    std::sort(lines.begin(), lines.end(), [](const FaceLine& l, const FaceLine& r) { return l.v < r.v; });
    std::vector<FaceLine> merged;
    for (std::size_t first = 0; first < lines.size();) {
        std::size_t end = first + 1;
        while (end < lines.size() && lines[end].v - lines[first].v < same_line) ++end;
        std::sort(lines.begin() + std::ptrdiff_t(first), lines.begin() + std::ptrdiff_t(end),
                  [](const FaceLine& l, const FaceLine& r) { return l.u0 < r.u0; });
        const std::size_t begin = merged.size();
        for (std::size_t k = first; k < end; ++k) {
            if (merged.size() > begin && lines[k].u0 <= merged.back().u1 + 0.002 &&
                lines[k].height == merged.back().height)
                merged.back().u1 = std::max(merged.back().u1, lines[k].u1);
            else merged.push_back(lines[k]);
        }
        first = end;
    }
    lines = std::move(merged);
}

/// A line with two others at the same distance on both sides of it: the middle of their wall, for at most of its
/// length.
bool is_centre_line(const std::vector<FaceLine>& lines, std::size_t k, double same_line) {
    constexpr double thickest = 0.45;  // metres, of walls with something drawn in their middle
    const FaceLine& line = lines[k];
    Intervals left = {{line.u0, line.u1}};
    std::size_t high = k + 1;
    for (std::size_t low = k; low-- > 0 && line.v - lines[low].v < thickest / 2;) {
        const double mirrored = 2 * line.v - lines[low].v;
        while (high < lines.size() && lines[high].v < mirrored - same_line) ++high;
        // Below come lines farther away, and so above.
        for (std::size_t other = high; other < lines.size() && lines[other].v < mirrored + same_line; ++other) {
            const Interval both = {std::max(lines[low].u0, lines[other].u0), std::min(lines[low].u1, lines[other].u1)};
            if (both.high <= both.low || lines[low].v > line.v - same_line) continue;
            Intervals rest;
            for (const Interval& piece : left)
                for (const Interval& kept : without(piece, {both})) rest.push_back(kept);
            left = std::move(rest);
        }
    }
    double uncovered = 0;
    for (const Interval& piece : left) uncovered += piece.high - piece.low;
    return uncovered < 0.3 * (line.u1 - line.u0);
}

void drop_centre_lines(std::vector<FaceLine>& lines, double same_line) {
    std::vector<FaceLine> faces;
    for (std::size_t k = 0; k < lines.size(); ++k)
        if (!is_centre_line(lines, k, same_line)) faces.push_back(lines[k]);
    lines = std::move(faces);
}

/// Lines of nearly one direction: the faces of a wall are as parallel as the drawing is exact.
struct Bundle {
    std::uint32_t first = 0;  ///< into segments by angle
    std::uint32_t end = 0;
    double angle = 0;  ///< of the longest line
    double longest = 0;
};

/// Cut where the direction jumps, or where it has crept too far (arcs drawn as hundreds of lines). Longest first.
std::vector<Bundle> bundles_of(const std::vector<Segment2>& segments) {
    std::vector<Bundle> bundles;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
        if (bundles.empty() || segments[i].angle - segments[i - 1].angle > same_bundle ||
            segments[i].angle - segments[bundles.back().first].angle > same_direction / 2)
            bundles.push_back({i, i, 0, -1});
        Bundle& bundle = bundles.back();
        bundle.end = i + 1;
        const double length = distance(segments[i].a, segments[i].b);
        if (length > bundle.longest) bundle.longest = length, bundle.angle = segments[i].angle;
    }
    std::stable_sort(bundles.begin(), bundles.end(),
                     [](const Bundle& l, const Bundle& r) { return l.longest > r.longest; });
    return bundles;
}

/// Directions are grouped around the longest lines, so that short crooked ones join them and not the other way round.
/// Bundles join whole, each the nearest group: the two faces of a wall never part.
std::vector<FaceGroup> face_groups(const std::vector<Segment2>& segments, double same_line) {
    const std::vector<Bundle> bundles = bundles_of(segments);
    std::vector<FaceGroup> groups;  // 450 at most
    std::vector<double> angles;
    const auto off = [&](const Bundle& bundle, std::size_t g) {
        const double between = std::abs(bundle.angle - angles[g]);
        return std::min(between, pi - between);
    };
    for (const Bundle& bundle : bundles) {
        std::size_t g = 0;
        while (g < groups.size() && off(bundle, g) >= same_direction) ++g;
        if (g < groups.size()) continue;
        angles.push_back(bundle.angle);
        groups.push_back({{std::cos(bundle.angle), std::sin(bundle.angle)}, {}});
    }
    for (const Bundle& bundle : bundles) {
        std::size_t nearest = 0;
        for (std::size_t g = 1; g < groups.size(); ++g)
            if (off(bundle, g) < off(bundle, nearest)) nearest = g;
        const Point dir = groups[nearest].dir, normal = turned_left(dir);
        for (std::uint32_t i = bundle.first; i < bundle.end; ++i) {
            const double ua = dot(dir, segments[i].a), ub = dot(dir, segments[i].b);
            const double v = (dot(normal, segments[i].a) + dot(normal, segments[i].b)) / 2;
            groups[nearest].lines.push_back({v, std::min(ua, ub), std::max(ua, ub), segments[i].height});
        }
    }
    for (FaceGroup& group : groups) {
        merge_collinear(group.lines, same_line);
        drop_centre_lines(group.lines, same_line);
    }
    return groups;
}

struct Candidate {
    std::uint32_t group;
    std::uint32_t low;  ///< lines of the group, low.v < high.v
    std::uint32_t high;
    double overlap;
    double score = 0;
};

std::vector<Candidate> candidates(const std::vector<FaceGroup>& groups, const PairLimits& limits) {
    std::vector<Candidate> found;
    for (std::uint32_t g = 0; g < groups.size(); ++g) {
        const std::vector<FaceLine>& lines = groups[g].lines;
        for (std::uint32_t i = 0; i < lines.size(); ++i)
            for (std::uint32_t j = i + 1; j < lines.size() && lines[j].v - lines[i].v <= limits.most; ++j) {
                const double overlap = std::min(lines[i].u1, lines[j].u1) - std::max(lines[i].u0, lines[j].u0);
                if (lines[j].v - lines[i].v < limits.least || overlap < 0.03) continue;
                found.push_back({g, i, j, overlap});
            }
    }
    return found;
}

/// How much wall there would be of each thickness, if every pair of neighbours were one. [bins of `bin`]
std::vector<double> thickness_weights(const std::vector<FaceGroup>& groups, const std::vector<Candidate>& pairs,
                                      const PairLimits& limits) {
    std::vector<double> weight(std::size_t(limits.most / bin) + 3, 0);
    for (const Candidate& pair : pairs) {
        const FaceLine& a = groups[pair.group].lines[pair.low];
        const FaceLine& b = groups[pair.group].lines[pair.high];
        if (pair.overlap < 2 * (b.v - a.v)) continue;  // short pieces say nothing of what is usual
        weight[std::size_t((b.v - a.v) / bin) + 1] += pair.overlap / (0.1 + (b.v - a.v));
    }
    std::vector<double> smooth(weight.size(), 0);
    for (std::size_t k = 1; k + 1 < weight.size(); ++k) smooth[k] = weight[k - 1] + weight[k] + weight[k + 1];
    return smooth;
}

void pair_straight(WallBodies& bodies, const PairLimits& limits) {
    std::vector<Candidate> pairs = candidates(bodies.groups, limits);
    const std::vector<double> weight = thickness_weights(bodies.groups, pairs, limits);
    const auto most = std::max_element(weight.begin(), weight.end());
    const double heaviest = weight.empty() || *most <= 0 ? 1 : *most;
    bodies.usual_thickness = weight.empty() ? 0 : (double(most - weight.begin()) - 0.5) * bin;
    const auto line = [&](std::uint32_t g, std::uint32_t k) -> FaceLine& { return bodies.groups[g].lines[k]; };
    for (Candidate& pair : pairs) {
        const double t = line(pair.group, pair.high).v - line(pair.group, pair.low).v;
        pair.score = pair.overlap * (0.1 + weight[std::size_t(t / bin) + 1] / heaviest) / (0.1 + t);
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Candidate& l, const Candidate& r) { return l.score > r.score; });

    std::vector<std::vector<Intervals>> taken;
    for (const FaceGroup& group : bodies.groups) taken.emplace_back(group.lines.size());
    for (const Candidate& pair : pairs) {
        const FaceLine &a = line(pair.group, pair.low), &b = line(pair.group, pair.high);
        Intervals& taken_a = taken[pair.group][pair.low];
        Intervals& taken_b = taken[pair.group][pair.high];
        Intervals both = taken_a;
        both.insert(both.end(), taken_b.begin(), taken_b.end());
        const double t = b.v - a.v;
        for (const Interval& free : without({std::max(a.u0, b.u0), std::min(a.u1, b.u1)}, both)) {
            if (free.high - free.low < std::max(0.03, 0.3 * t)) continue;
            // Shorter than thick: a piece of wall, if walls are that thick, else a jamb across from some other wall's
            // face.
            if (free.high - free.low < t && weight[std::size_t(t / bin) + 1] < 0.01 * heaviest) continue;
            const std::optional<double> height = a.height ? a.height : b.height;
            bodies.straight.push_back({pair.group, (a.v + b.v) / 2, free.low, free.high, t, height});
            taken_a.push_back(free);
            taken_b.push_back(free);
            bodies.paired_length += 2 * (free.high - free.low);
        }
    }
    for (std::uint32_t g = 0; g < bodies.groups.size(); ++g)
        for (std::uint32_t k = 0; k < bodies.groups[g].lines.size(); ++k) {
            const FaceLine& face = bodies.groups[g].lines[k];
            bodies.total_length += face.u1 - face.u0;
            for (const Interval& free : without({face.u0, face.u1}, taken[g][k]))
                if (free.high - free.low > 0.1)
                    bodies.single.push_back({g, face.v, free.low, free.high, 0, face.height});
        }
}

}  // namespace

std::optional<double> wall_height(const SheetStroke& stroke) {
    if (stroke.rule && stroke.rule->height) return stroke.rule->height;
    if (stroke.role == Role::LowWall) return 1.0;
    return std::nullopt;
}

WallBodies wall_bodies(const std::vector<SheetStroke>& strokes, const PairLimits& limits) {
    WallBodies bodies;
    bodies.groups = face_groups(straight_strokes(strokes), limits.same_line);
    pair_straight(bodies, limits);
    dxf::pair_curved(strokes, limits, bodies);
    return bodies;
}

}  // namespace enfilade::plans

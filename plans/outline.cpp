#include "plans/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <unordered_map>

#include "plans/vector2.h"
#include "plans/wall_joints.h"

namespace enfilade::plans {
namespace {

constexpr double kSameStation = 1e-7;  ///< m

/// Jambs of the openings of one wall, as shares of its axis.
struct Jambs {
    double from = 0;
    double to = 0;
};

std::optional<Jambs> jambs(const Opening& opening, double length) {
    const double from = std::clamp((opening.offset - opening.width / 2) / length, 0.0, 1.0);
    const double to = std::clamp((opening.offset + opening.width / 2) / length, 0.0, 1.0);
    if (!(to - from > kSameStation / length)) return std::nullopt;
    return Jambs{from, to};
}

/// The share of the axis that one facet may span.
double facet_share(const WallAxis& axis, double half, double sagitta) {
    const double outer = axis.radius() + half;
    const double by_sagitta = 2 * std::acos(std::max(0.0, 1 - sagitta / outer));
    const double sweep = std::abs(axis.extent());
    return std::min({by_sagitta, std::numbers::pi / 6, sweep / 2}) / sweep;
}

/// Completes the jambs given to the ascending shares of all vertices. Facets are spread evenly between jambs, so
/// that none is a splinter.
std::vector<double> stations(const WallAxis& axis, double half, std::vector<double> shares, double sagitta) {
    shares.push_back(0);
    shares.push_back(1);
    std::sort(shares.begin(), shares.end());
    const double same = kSameStation / axis.length();
    shares.erase(std::unique(shares.begin(), shares.end(), [&](double l, double r) { return r - l <= same; }),
                 shares.end());
    shares.back() = 1;
    if (axis.straight()) return shares;
    const double most = facet_share(axis, half, sagitta);
    std::vector<double> all;
    for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
        const double span = shares[i + 1] - shares[i];
        const int count = std::max(1, int(std::ceil(span / most - 1e-9)));
        for (int k = 0; k < count; ++k) all.push_back(k == 0 ? shares[i] : shares[i] + span * k / count);
    }
    all.push_back(1);
    return all;
}

/// The vertices of one side from start to end: corners, and the stations between them.
std::vector<OutlinePoint> side(const WallOutline& wall, Point first, Point last, OutlinePart part) {
    const double d = part == OutlinePart::Left ? wall.half : -wall.half;
    const bool straight = wall.axis.straight();
    const double same = kSameStation / wall.axis.length();
    // Corners may lie inward of stations (jambs close to a joint): those have no place on this side.
    const double from = wall.axis.nearest(first) + same;
    const double to = wall.axis.nearest(last) - same;
    std::vector<OutlinePoint> points{{first, part, 0}};
    for (std::size_t k = 1; k + 1 < wall.stations.size(); ++k)
        if (wall.stations[k] > from && wall.stations[k] < to) {
            points.push_back({wall.axis.offset(wall.stations[k], d), part, straight ? 0 : std::uint32_t(k)});
        } else if (wall.stations[k] <= from && !straight) {
            points.front().facet = std::uint32_t(k);
        }
    points.push_back({last, part, 0});
    return points;
}

void append_end(const EndShape& shape, OutlinePart part, std::vector<OutlinePoint>& ring) {
    std::uint32_t facet = 0;
    ring.push_back({shape.left, part, facet});
    for (const Point p : shape.between) ring.push_back({p, part, ++facet});
}

/// Right side, end, left side backwards, start: counter-clockwise.
std::vector<OutlinePoint> wall_ring(const WallOutline& wall, const EndShape& start, const EndShape& end) {
    std::vector<OutlinePoint> ring = side(wall, start.right, end.left, OutlinePart::Right);
    ring.pop_back();
    append_end(end, OutlinePart::End, ring);
    const std::vector<OutlinePoint> left = side(wall, start.left, end.right, OutlinePart::Left);
    for (std::size_t i = left.size() - 1; i > 0; --i) ring.push_back({left[i].at, left[i].part, left[i - 1].facet});
    append_end(start, OutlinePart::Start, ring);
    return ring;
}

/// The strip between two stations of its host, counter-clockwise; beyond the faces where other walls lie there.
std::vector<OutlinePoint> opening_ring(const Opening& opening, const WallOutline& host, Jambs at) {
    const WallAxis& axis = host.axis;
    const double same = kSameStation / axis.length();
    const auto station = [&](double share) {
        return std::size_t(std::lower_bound(host.stations.begin(), host.stations.end(), share - same) -
                           host.stations.begin());
    };
    const std::size_t first = station(at.from);
    const std::size_t last = station(at.to);
    std::vector<OutlinePoint> ring;
    const auto add = [&](std::size_t k, double d, OutlinePart part, std::size_t facet) {
        ring.push_back({axis.offset(host.stations[k], d), part, std::uint32_t(axis.straight() ? 0 : facet)});
    };
    const double right = host.half + opening.depth_right;
    const double left = host.half + opening.depth_left;
    const OutlinePart right_part = opening.depth_right > 0 ? OutlinePart::BeyondRight : OutlinePart::Right;
    const OutlinePart left_part = opening.depth_left > 0 ? OutlinePart::BeyondLeft : OutlinePart::Left;
    for (std::size_t k = first; k < last; ++k) add(k, -right, right_part, k);
    add(last, -right, OutlinePart::End, 0);
    if (opening.depth_right > 0) add(last, -host.half, OutlinePart::End, 0);
    if (opening.depth_left > 0) add(last, host.half, OutlinePart::End, 0);
    for (std::size_t k = last; k > first; --k) add(k, left, left_part, k - 1);
    add(first, left, OutlinePart::Start, 0);
    if (opening.depth_left > 0) add(first, host.half, OutlinePart::Start, 0);
    if (opening.depth_right > 0) add(first, -host.half, OutlinePart::Start, 0);
    return ring;
}

}  // namespace

StoreyOutlines outlines(const Storey& storey, const OutlineOptions& options) {
    const std::size_t wall_count = storey.walls.size();
    std::vector<Point> starts(wall_count);
    std::vector<Point> finishes(wall_count);
    std::vector<bool> skip(wall_count);
    std::vector<std::string> ids(wall_count);
    std::unordered_map<std::string, std::uint32_t> wall_by_id;
    for (std::uint32_t w = 0; w < wall_count; ++w) {
        const Wall& wall = storey.walls[w];
        starts[w] = wall.start - options.origin;
        finishes[w] = wall.end - options.origin;
        skip[w] = !(wall.thickness > 0) || !(distance(wall.start, wall.end) > options.join);
        ids[w] = wall.id;
        wall_by_id.emplace(wall.id, w);
    }
    gather_ends(starts, finishes, skip, options.join);

    StoreyOutlines result;
    result.walls.resize(wall_count);
    std::vector<std::vector<double>> shares(wall_count);
    for (std::size_t w = 0; w < wall_count; ++w) {
        if (starts[w] == finishes[w]) skip[w] = true;
        if (skip[w]) continue;
        result.walls[w].axis = WallAxis(starts[w], finishes[w], storey.walls[w].arc_extent, options.flat);
        result.walls[w].half = storey.walls[w].thickness / 2;
    }
    result.openings.resize(storey.openings.size());
    std::vector<Jambs> cuts(storey.openings.size());
    for (std::size_t o = 0; o < storey.openings.size(); ++o) {
        const auto host = wall_by_id.find(storey.openings[o].wall);
        if (host == wall_by_id.end() || skip[host->second]) continue;
        const auto cut = jambs(storey.openings[o], result.walls[host->second].axis.length());
        if (!cut) continue;
        result.openings[o].wall = host->second;
        cuts[o] = *cut;
        shares[host->second].push_back(cut->from);
        shares[host->second].push_back(cut->to);
    }
    for (std::size_t w = 0; w < wall_count; ++w)
        if (!skip[w])
            result.walls[w].stations =
                stations(result.walls[w].axis, result.walls[w].half, std::move(shares[w]), options.sagitta);

    Joints joints = shape_ends(result.walls, ids, options.join);
    for (std::size_t w = 0; w < wall_count; ++w)
        if (!skip[w]) result.walls[w].ring = wall_ring(result.walls[w], joints.ends[w][0], joints.ends[w][1]);
    for (std::size_t o = 0; o < storey.openings.size(); ++o)
        if (const std::uint32_t host = result.openings[o].wall; host != UINT32_MAX)
            result.openings[o].ring = opening_ring(storey.openings[o], result.walls[host], cuts[o]);
    result.free_ends = std::move(joints.free_ends);
    result.continuations = std::move(joints.continuations);
    return result;
}

}  // namespace enfilade::plans

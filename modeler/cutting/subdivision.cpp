#include "modeler/cutting/subdivision.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "base/check.h"

namespace enfilade::modeler {

using plans::GridPoint;

namespace {

std::int64_t dot(GridPoint o, GridPoint a, GridPoint b) {
    return (std::int64_t(a.x) - o.x) * (std::int64_t(b.x) - o.x) +
           (std::int64_t(a.y) - o.y) * (std::int64_t(b.y) - o.y);
}

/// Whether the direction from o to d lies strictly within the turn, counter-clockwise, from o -> a to o -> b.
bool turns_through(GridPoint o, GridPoint a, GridPoint b, GridPoint d) {
    const std::int64_t turn = orientation(o, a, b);
    if (turn > 0) return orientation(o, a, d) > 0 && orientation(o, d, b) > 0;
    if (turn < 0) return !(orientation(o, b, d) >= 0 && orientation(o, d, a) >= 0);
    return dot(o, a, b) < 0 && orientation(o, a, d) > 0;
}

double distance(GridPoint a, GridPoint b) { return std::hypot(double(b.x) - a.x, double(b.y) - a.y); }

}  // namespace

Subdivision::Subdivision(std::span<const GridPoint> points, std::span<const PolygonSide> sides,
                         std::span<const std::uint32_t> corner_before)
    : points_(points.begin(), points.end()),
      given_point_count_(std::uint32_t(points.size())),
      side_count_(std::uint32_t(sides.size())),
      first_leaving_(points.size(), no_index) {
    tracks_.reserve(2 * sides.size());
    for (std::uint32_t k = 0; k < sides.size(); ++k) {
        tracks_.push_back({k, sides[k].line, {sides[k].from, sides[k].to}, {k}});
        add_half_edge(sides[k].from, k);
    }
    for (std::uint32_t k = 0; k < sides.size(); ++k) join(corner_before[k], k);
}

std::uint32_t Subdivision::add_half_edge(std::uint32_t from, std::uint32_t track) {
    const std::uint32_t h = std::uint32_t(from_.size());
    from_.push_back(from);
    next_.push_back(no_index);
    previous_.push_back(no_index);
    twin_.push_back(no_index);
    track_.push_back(track);
    next_leaving_.push_back(first_leaving_[from]);
    first_leaving_[from] = h;
    return h;
}

void Subdivision::forget_leaving(std::uint32_t h) {
    std::uint32_t* at = &first_leaving_[from_[h]];
    while (*at != h) at = &next_leaving_[*at];
    *at = next_leaving_[h];
    next_[h] = previous_[h] = no_index;
}

std::uint32_t Subdivision::wedge(std::uint32_t p, GridPoint towards) const {
    for (std::uint32_t h = first_leaving_[p]; h != no_index; h = next_leaving_[h])
        if (turns_through(points_[p], points_[to(h)], points_[from_[previous_[h]]], towards)) return h;
    return no_index;
}

/// Before which node of a track a point belongs.
std::size_t Subdivision::place_on(const Track& track, GridPoint p) const {
    const GridPoint a = points_[track.nodes.front()], b = points_[track.nodes.back()];
    // Rounding keeps the order of points along a line, in each coordinate.
    const auto is_before = [&](std::uint32_t node) {
        const GridPoint s = points_[node];
        if (s.x != p.x) return (s.x < p.x) != (b.x < a.x);
        return (s.y < p.y) != (b.y < a.y);
    };
    return std::size_t(std::partition_point(track.nodes.begin() + 1, track.nodes.end() - 1, is_before) -
                       track.nodes.begin());
}

std::uint32_t Subdivision::node_near(std::uint32_t t, GridPoint eye, GridPoint p) const {
    const Track& track = tracks_[t];
    const std::size_t k = place_on(track, p);
    const auto gap = [&](std::uint32_t node) {
        if (dot(p, eye, points_[node]) <= 0) return distance(points_[node], p);
        return std::abs(double(orientation(eye, p, points_[node]))) / distance(eye, p);
    };
    const double before = gap(track.nodes[k - 1]), after = gap(track.nodes[k]);
    if (std::min(before, after) >= least_gap) return no_index;
    return track.nodes[before <= after ? k - 1 : k];
}

bool Subdivision::meets_line_straight(std::uint32_t from, std::uint32_t p, std::uint32_t line) const {
    const auto is_off = [&](std::uint32_t h, std::uint32_t other) {
        return tracks_[track_[h]].line == line && orientation(points_[from], points_[p], points_[other]) != 0;
    };
    for (std::uint32_t h = first_leaving_[p]; h != no_index; h = next_leaving_[h])
        if (is_off(h, to(h)) || is_off(previous_[h], from_[previous_[h]])) return false;
    return true;
}

std::uint32_t Subdivision::add_node(std::uint32_t t, GridPoint p) {
    const Track& track = tracks_[t];
    const std::size_t k = place_on(track, p);
    const std::uint32_t node = std::uint32_t(points_.size());
    points_.push_back(p);
    first_leaving_.push_back(no_index);
    node_track_.push_back(t);
    const std::uint32_t h = track.half_edges[k - 1], g = twin_[h];
    const std::uint32_t onward = add_half_edge(node, t);
    join(onward, next_[h]);
    join(h, onward);
    if (g != no_index) {  // g: next node -> node; back: node -> node before
        const std::uint32_t back = add_half_edge(node, t);
        join(back, next_[g]);
        join(g, back);
        twin_[h] = back, twin_[back] = h;
        twin_[onward] = g, twin_[g] = onward;
    }
    Track& changed = tracks_[t];
    changed.nodes.insert(changed.nodes.begin() + std::ptrdiff_t(k), node);
    changed.half_edges.insert(changed.half_edges.begin() + std::ptrdiff_t(k), onward);
    return node;
}

std::uint32_t Subdivision::connect(std::uint32_t a, std::uint32_t b, std::uint32_t line) {
    const std::uint32_t at_a = wedge(a, points_[b]), at_b = wedge(b, points_[a]);
    if (a == b || at_a == no_index || at_b == no_index) return no_index;
    const std::uint32_t before_a = previous_[at_a], before_b = previous_[at_b];
    const std::uint32_t t = track_count();
    const std::uint32_t h = add_half_edge(a, t), g = add_half_edge(b, t);
    twin_[h] = g, twin_[g] = h;
    join(before_a, h);
    join(h, at_b);
    join(before_b, g);
    join(g, at_a);
    tracks_.push_back({no_index, line, {a, b}, {h}});
    return t;
}

bool Subdivision::is_straight(std::uint32_t in, std::uint32_t out) const {
    return goes_straight(points_[from_[in]], points_[from_[out]], points_[to(out)], line(in), line(out));
}

bool Subdivision::is_removable(std::uint32_t cut) const {
    const std::uint32_t h = tracks_[cut].half_edges[0], g = twin_[h];
    const std::uint32_t before_h = previous_[h], after_h = next_[h], before_g = previous_[g], after_g = next_[g];
    // Chords are those of the rings as they are: runs that only join once the cut is gone make no corner there.
    const auto is_fine = [&](std::uint32_t in, std::uint32_t out) {
        if (is_straight(in, out)) return true;
        std::uint32_t first = in, last = out;
        while (previous_[first] != g && previous_[first] != h && is_straight(previous_[first], first))
            first = previous_[first];
        while (next_[last] != g && next_[last] != h && is_straight(last, next_[last])) last = next_[last];
        return orientation(points_[from_[first]], points_[from_[out]], points_[to(last)]) >= 0;
    };
    if (!is_fine(before_h, after_g) || !is_fine(before_g, after_h)) return false;
    // Together they are a disc only if the cut is all that they share.
    std::unordered_set<std::uint32_t> corners;
    for (std::uint32_t k = after_h; k != h; k = next_[k]) {
        if (k == g) return false;
        corners.insert(from_[k]);
    }
    for (std::uint32_t k = next_[after_g]; k != g; k = next_[k])
        if (corners.count(from_[k])) return false;
    return true;
}

void Subdivision::remove(std::uint32_t cut) {
    const std::uint32_t h = tracks_[cut].half_edges[0], g = twin_[h];
    const std::uint32_t a = from_[h], b = from_[g];
    const std::uint32_t before_h = previous_[h], after_h = next_[h], before_g = previous_[g], after_g = next_[g];
    join(before_h, after_g);
    join(before_g, after_h);
    forget_leaving(h);
    forget_leaving(g);
    tracks_[cut].removed = true;
    drop_node(a);
    drop_node(b);
}

/// A node of a track at which nothing ends any more goes, so that others may be taken out in turn.
void Subdivision::drop_node(std::uint32_t p) {
    if (p < given_point_count_) return;
    Track& track = tracks_[node_track_[p - given_point_count_]];
    for (std::uint32_t h = first_leaving_[p]; h != no_index; h = next_leaving_[h])
        if (&tracks_[track_[h]] != &track) return;
    const auto at = std::find(track.nodes.begin(), track.nodes.end(), p);
    ENFILADE_CHECK(at != track.nodes.end());
    const std::ptrdiff_t k = at - track.nodes.begin();
    const std::uint32_t before = track.half_edges[std::size_t(k - 1)], after = track.half_edges[std::size_t(k)];
    const std::uint32_t back = twin_[before], back_after = twin_[after];
    join(before, next_[after]);
    forget_leaving(after);
    if (back_after != no_index) {
        join(back_after, next_[back]);
        forget_leaving(back);
        twin_[before] = back_after, twin_[back_after] = before;
    }
    track.nodes.erase(track.nodes.begin() + k);
    track.half_edges.erase(track.half_edges.begin() + k);
}

Partition Subdivision::collect(std::span<const PolygonSide> sides) const {
    Partition result;
    result.new_points.assign(points_.begin() + given_point_count_, points_.end());
    std::vector<bool> seen(from_.size(), false);
    for (std::uint32_t start = 0; start < from_.size(); ++start) {
        if (seen[start] || is_removed(start)) continue;
        for (std::uint32_t h = start; !seen[h]; h = next_[h]) {
            seen[h] = true;
            const Track& track = tracks_[track_[h]];
            PolygonSide side{0, 0, track.line, cut_tag};
            if (track.side != no_index) side = sides[track.side];
            side.from = from_[h];
            side.to = to(h);
            result.sides.push_back(side);
        }
        result.first_side.push_back(std::uint32_t(result.sides.size()));
    }
    drop_unused_points(given_point_count_, result);
    return result;
}

}  // namespace enfilade::modeler

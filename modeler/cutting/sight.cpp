#include "modeler/cutting/sight.h"

#include <cmath>
#include <limits>

#include "base/check.h"

namespace enfilade::modeler {

using plans::GridPoint;

namespace {

__extension__ typedef __int128 Int128;

/// floor(n / d + 1/2), d > 0
std::int64_t rounded_quotient(Int128 n, Int128 d) {
    const Int128 twice = 2 * n + d, by = 2 * d;
    return std::int64_t(twice >= 0 ? twice / by : -((-twice + by - 1) / by));
}

}  // namespace

GridPoint rounded_meeting(GridPoint eye, Direction d, GridPoint a, GridPoint b) {
    const Direction along = direction(a, b);
    std::int64_t n = cross(direction(eye, a), along), den = cross(d, along);
    if (den < 0) n = -n, den = -den;
    return {std::int32_t(eye.x + rounded_quotient(Int128(n) * d.x, den)),
            std::int32_t(eye.y + rounded_quotient(Int128(n) * d.y, den))};
}

/// The nearest thing seen so far, at `t` times the direction.
struct Sight::Nearest {
    double t = std::numeric_limits<double>::infinity();
    Hit::At at = Hit::At::Nothing;
    bool moved = false;
    std::uint32_t id = no_index;
};

Sight::Sight(std::span<const GridPoint> points, std::span<const PolygonSide> sides)
    : points_(points), sides_(sides), triangles_(triangulate(points, sides)), along_(sides.size(), no_index) {
    for (std::uint32_t h = 0; h < triangles_.from.size(); ++h)
        if (triangles_.side[h] != no_index) along_[triangles_.side[h]] = h;
    for (const std::uint32_t h : along_) ENFILADE_CHECK(h != no_index);
    first_cut_.assign(triangles_.triangle_count(), no_index);
}

std::vector<std::uint32_t> Sight::corners_before() const {
    std::vector<std::uint32_t> before(sides_.size());
    for (std::uint32_t k = 0; k < sides_.size(); ++k) {
        std::uint32_t h = previous_in_triangle(along_[k]);
        while (triangles_.twin[h] != no_index) h = previous_in_triangle(triangles_.twin[h]);
        before[k] = triangles_.side[h];
    }
    return before;
}

void Sight::meet_point(std::uint32_t p, GridPoint eye, Direction d, Nearest& nearest) const {
    const Direction to = direction(eye, points_[p]);
    const std::int64_t along = dot(to, d), off = cross(d, to);
    if (along <= 0) return;
    const double length = std::hypot(double(d.x), double(d.y));
    if (std::abs(double(off)) >= least_gap * length) return;
    const double t = double(along) / (length * length);
    if (t < nearest.t) nearest = {t, Hit::At::Point, off != 0, p};
}

void Sight::meet_cuts(std::uint32_t triangle, GridPoint eye, Direction d, Nearest& nearest) const {
    for (std::uint32_t e = first_cut_[triangle]; e != no_index; e = entries_[e].next) {
        const Segment& cut = cuts_[entries_[e].cut];
        if (cut.a == eye || cut.b == eye) continue;
        const std::int64_t a = cross(d, direction(eye, cut.a)), b = cross(d, direction(eye, cut.b));
        if ((a > 0) == (b > 0) && a != 0 && b != 0) continue;
        const Direction along = direction(cut.a, cut.b);
        const std::int64_t den = cross(d, along);
        if (den == 0) continue;
        const double t = double(cross(direction(eye, cut.a), along)) / double(den);
        if (t > 0 && t < nearest.t) nearest = {t, Hit::At::Cut, false, entries_[e].cut};
    }
}

/// Whether a cut would lie on a side of its own corner, or on a cut that starts there, but for a unit or two.
bool Sight::is_sliver(std::uint32_t start, std::uint32_t first_triangle, const Hit& hit) const {
    const GridPoint eye = points_[triangles_.from[start]];
    const auto is_near = [&](GridPoint other) {
        const Direction d = direction(eye, hit.point), o = direction(eye, other);
        if (dot(d, o) <= 0) return false;
        const double longest = std::max(std::hypot(double(d.x), double(d.y)), std::hypot(double(o.x), double(o.y)));
        return std::abs(double(cross(d, o))) < least_gap * longest;
    };
    if (hit.length < least_gap && hit.at != Hit::At::Point) return true;
    for (std::uint32_t e = first_cut_[first_triangle]; e != no_index; e = entries_[e].next) {
        const Segment& cut = cuts_[entries_[e].cut];
        if (cut.a == eye && is_near(cut.b)) return true;
        if (cut.b == eye && is_near(cut.a)) return true;
    }
    for (const std::uint32_t k : {3 * first_triangle, 3 * first_triangle + 1, 3 * first_triangle + 2}) {
        if (triangles_.twin[k] != no_index) continue;
        const std::uint32_t to = triangles_.from[next_in_triangle(k)];
        if (triangles_.from[k] == triangles_.from[start] && is_near(points_[to])) return true;
        if (to == triangles_.from[start] && is_near(points_[triangles_.from[k]])) return true;
    }
    return false;
}

Hit Sight::look(std::uint32_t start, Direction d, std::uint32_t limit, std::vector<std::uint32_t>& passed) const {
    passed.clear();
    Hit hit;
    const std::uint32_t eye_id = triangles_.from[start];
    const GridPoint eye = points_[eye_id];
    const auto corner = [&](std::uint32_t h) { return triangles_.from[h]; };
    const auto side_of_ray = [&](std::uint32_t p) { return cross(d, direction(eye, points_[p])); };
    // The triangle of the wedge into which the direction points.
    std::uint32_t h = start;
    while (side_of_ray(corner(previous_in_triangle(h))) < 0 || side_of_ray(corner(next_in_triangle(h))) > 0) {
        h = triangles_.twin[previous_in_triangle(h)];
        if (h == no_index) return hit;
    }
    Nearest nearest;
    const std::uint32_t right = corner(next_in_triangle(h)), left = corner(previous_in_triangle(h));
    // Too near to a side of the corner itself: a sliver.
    meet_point(right, eye, d, nearest);
    if (nearest.at == Hit::At::Point && triangles_.twin[h] == no_index) return hit;
    Nearest beside;
    meet_point(left, eye, d, beside);
    if (beside.at == Hit::At::Point && triangles_.twin[previous_in_triangle(h)] == no_index) return hit;
    if (beside.t < nearest.t) nearest = beside;

    for (std::uint32_t exit = next_in_triangle(h);;) {
        passed.push_back(exit / 3);
        meet_cuts(exit / 3, eye, d, nearest);
        const GridPoint a = points_[corner(exit)], b = points_[corner(next_in_triangle(exit))];
        const Direction along = direction(a, b);
        const std::int64_t den = cross(d, along);
        const double t_exit =
            den != 0 ? double(cross(direction(eye, a), along)) / double(den) : std::numeric_limits<double>::infinity();
        if (nearest.t <= t_exit) break;
        const std::uint32_t entry = triangles_.twin[exit];
        if (entry == no_index) {
            nearest = {t_exit, Hit::At::Side, false, triangles_.side[exit]};
            break;
        }
        if (passed.size() >= limit) return hit;
        const std::uint32_t apex = corner(previous_in_triangle(entry));
        meet_point(apex, eye, d, nearest);
        exit = side_of_ray(apex) > 0 ? next_in_triangle(entry) : previous_in_triangle(entry);
    }
    if (nearest.at == Hit::At::Nothing) return hit;
    hit.at = nearest.at;
    hit.id = nearest.id;
    hit.moved = nearest.moved;
    if (hit.at == Hit::At::Point) hit.point = points_[hit.id];
    else if (hit.at == Hit::At::Side)
        hit.point = rounded_meeting(eye, d, points_[sides_[hit.id].from], points_[sides_[hit.id].to]);
    else hit.point = rounded_meeting(eye, d, cuts_[hit.id].a, cuts_[hit.id].b);
    if (hit.at == Hit::At::Cut) hit.id = cuts_[hit.id].id;
    hit.length = std::hypot(double(hit.point.x) - eye.x, double(hit.point.y) - eye.y);
    if (is_sliver(start, h / 3, hit)) hit.at = Hit::At::Nothing;
    return hit;
}

void Sight::add_cut(std::uint32_t id, GridPoint a, GridPoint b, std::span<const std::uint32_t> passed) {
    const std::uint32_t cut = std::uint32_t(cuts_.size());
    cuts_.push_back({a, b, id});
    for (const std::uint32_t triangle : passed) {
        entries_.push_back({cut, first_cut_[triangle]});
        first_cut_[triangle] = std::uint32_t(entries_.size() - 1);
    }
}

}  // namespace enfilade::modeler

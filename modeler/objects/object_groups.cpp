#include "modeler/objects/object_groups.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "modeler/editing/footprint.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

/// Grid units: boxes of things that touch overlap by as much, because each was rounded outward.
constexpr double touch = 1.75;

/// The convex hull, counter-clockwise, without corners on its sides.
std::vector<GridPoint> hull(std::vector<GridPoint> points) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<GridPoint> ring(2 * points.size());
    std::size_t count = 0;
    const auto add = [&](GridPoint p, std::size_t least) {
        while (count >= least && plans::orientation(ring[count - 2], ring[count - 1], p) <= 0) --count;
        ring[count++] = p;
    };
    for (const GridPoint p : points) add(p, 2);
    const std::size_t lower = count + 1;
    for (std::size_t k = points.size() - 1; k-- > 0;) add(points[k], lower);
    ring.resize(count - 1);
    return ring;
}

/// How far the sides of `a` let `b` in, at the least of them: negative where one parts the two.
double depth_by_sides(const std::vector<GridPoint>& a, const std::vector<GridPoint>& b) {
    double depth = INFINITY;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const GridPoint from = a[k], to = a[(k + 1) % a.size()];
        std::int64_t within = INT64_MIN;
        for (const GridPoint p : b) within = std::max(within, plans::orientation(from, to, p));
        depth = std::min(depth, double(within) / std::hypot(double(to.x) - from.x, double(to.y) - from.y));
    }
    return depth;
}

bool share_a_place(const Box& a, const Box& b) {
    if (a.z_low >= b.z_high || b.z_low >= a.z_high) return false;
    return depth_by_sides(a.footprint, b.footprint) > touch && depth_by_sides(b.footprint, a.footprint) > touch;
}

Box grid_box(const FurnishedObject& object, const plans::GridFrame& frame) {
    Box box;
    box.space = object.space;
    box.id = object.id;
    box.name = object.name;
    box.footprint = rectangle_footprint(frame, object.position[0], object.position[1], object.size[0], object.size[1],
                                        object.angle);
    // What rounding adds to a height is no height.
    constexpr double noise = 1e-3;
    const double low = (object.position[2] - frame.origin_z) / frame.unit, high = low + object.size[2] / frame.unit;
    box.z_low = std::int32_t(std::floor(low + noise));
    box.z_high = std::max(box.z_low + 1, std::int32_t(std::ceil(high - noise)));
    return box;
}

/// `other` into `group`.
void merge(ObjectGroup& group, ObjectGroup& other) {
    std::vector<GridPoint> corners = group.box.footprint;
    corners.insert(corners.end(), other.box.footprint.begin(), other.box.footprint.end());
    group.box.footprint = hull(std::move(corners));
    group.box.z_low = std::min(group.box.z_low, other.box.z_low);
    group.box.z_high = std::max(group.box.z_high, other.box.z_high);
    group.objects.insert(group.objects.end(), other.objects.begin(), other.objects.end());
    other.objects.clear();
}

/// Two of these that share a place become one, until none do.
void merge_all(std::vector<ObjectGroup>& groups) {
    for (bool is_changed = true; is_changed;) {
        is_changed = false;
        for (std::size_t a = 0; a < groups.size(); ++a)
            for (std::size_t b = a + 1; b < groups.size(); ++b) {
                if (groups[a].objects.empty() || groups[b].objects.empty()) continue;
                if (!share_a_place(groups[a].box, groups[b].box)) continue;
                merge(groups[a], groups[b]);
                is_changed = true;
            }
        std::erase_if(groups, [](const ObjectGroup& group) { return group.objects.empty(); });
    }
}

}  // namespace

std::vector<ObjectGroup> group_objects(std::span<const FurnishedObject> all, std::span<const std::uint32_t> objects,
                                       const plans::GridFrame& frame) {
    std::map<std::uint32_t, std::vector<ObjectGroup>> by_room;
    for (const std::uint32_t k : objects) by_room[all[k].space].push_back({grid_box(all[k], frame), {k}});
    std::vector<ObjectGroup> groups;
    for (auto& [room, own] : by_room) {
        merge_all(own);
        std::move(own.begin(), own.end(), std::back_inserter(groups));
    }
    for (ObjectGroup& group : groups) {
        std::sort(group.objects.begin(), group.objects.end());
        const FurnishedObject& first = all[group.objects.front()];
        group.box.id = first.id;
        group.box.name = first.name.empty() ? first.id : first.name;
        if (group.objects.size() > 1) group.box.name += " and " + std::to_string(group.objects.size() - 1) + " more";
    }
    std::sort(groups.begin(), groups.end(),
              [](const ObjectGroup& a, const ObjectGroup& b) { return a.box.id < b.box.id; });
    return groups;
}

}  // namespace enfilade::modeler

#include "plans/room_match.h"

#include <algorithm>
#include <cmath>

namespace enfilade::plans {
namespace {

/// The quadrilateral outside of side a -> b, counter-clockwise where the ring is.
void append_band(GridPoint a, GridPoint b, double width, std::vector<GridPoint>& quad) {
    const double dx = double(b.x) - a.x;
    const double dy = double(b.y) - a.y;
    const double scale = width / std::hypot(dx, dy);
    const auto out = [&](GridPoint p) {
        return GridPoint{std::int32_t(std::lround(p.x + dy * scale)), std::int32_t(std::lround(p.y - dx * scale))};
    };
    quad = {a, out(a), out(b), b};
}

struct Share {
    std::uint32_t polygon;
    std::uint32_t place;
    std::int64_t area2;
};

/// Areas that each polygon has in common with each place, by polygon and place.
std::vector<Share> shares(const RoomOverlay& rooms, RoomMatch& match) {
    const std::vector<std::int64_t> areas2 = face_areas2(rooms.overlay.map);
    const Cover& cover = rooms.overlay.cover;
    std::vector<Share> found;
    for (std::uint32_t f = 1; f < rooms.overlay.map.face_count; ++f) {
        std::uint32_t place = kNone;
        for (std::uint32_t i = cover.first[f]; i < cover.first[f + 1]; ++i) {
            const std::uint32_t region = cover.entries[i].region;
            if (region < rooms.place_count) place = region;
            const std::uint32_t polygon = region - rooms.place_count;
            if (region < rooms.place_count || polygon >= rooms.polygon_count) continue;
            match.polygon_area2[polygon] += areas2[f];
            if (place != kNone) found.push_back({polygon, place, areas2[f]});
        }
    }
    std::sort(found.begin(), found.end(), [](const Share& l, const Share& r) {
        return l.polygon != r.polygon ? l.polygon < r.polygon : l.place < r.place;
    });
    std::vector<Share> sums;
    for (const Share& share : found)
        if (!sums.empty() && sums.back().polygon == share.polygon && sums.back().place == share.place)
            sums.back().area2 += share.area2;
        else sums.push_back(share);
    return sums;
}

}  // namespace

RoomOverlay overlay_rooms(const Overlay& storeys, const Places& places,
                          const std::vector<std::vector<GridPoint>>& polygons, double band) {
    RoomOverlay rooms;
    rooms.place_count = std::uint32_t(places.places.size());
    rooms.polygon_count = std::uint32_t(polygons.size());
    std::vector<Segment> segments;
    const auto add = [&](GridPoint a, GridPoint b, std::uint32_t region, std::uint32_t line) {
        segments.push_back({a, b});
        rooms.tags.push_back({region, line, kNone});
    };
    // The exterior ends at the site box here, so that its outline closes too.
    const auto place_left_of = [&](std::uint32_t half_edge) {
        const std::uint32_t face = storeys.map.face(half_edge);
        return face == 0 ? kNone : places.of_face[face];
    };
    for (std::uint32_t e = 0; e < storeys.graph.edges.size(); ++e) {
        const std::uint32_t left = place_left_of(2 * e);
        const std::uint32_t right = place_left_of(2 * e + 1);
        if (left == right) continue;
        const GridPoint a = storeys.graph.vertices[storeys.graph.edges[e].a];
        const GridPoint b = storeys.graph.vertices[storeys.graph.edges[e].b];
        if (left != kNone) add(a, b, left, kNone);
        if (right != kNone) add(b, a, right, kNone);
    }
    for (std::uint32_t k = 0; k < polygons.size(); ++k)
        for (std::size_t i = 0; i < polygons[k].size(); ++i)
            add(polygons[k][i], polygons[k][(i + 1) % polygons[k].size()], rooms.place_count + k, rooms.side_count++);
    if (band > 0)
        for (std::uint32_t k = 0; k < polygons.size(); ++k)
            for (std::size_t i = 0; i < polygons[k].size(); ++i) {
                std::vector<GridPoint> quad;
                append_band(polygons[k][i], polygons[k][(i + 1) % polygons[k].size()], band, quad);
                for (std::size_t j = 0; j < 4; ++j)
                    add(quad[j], quad[(j + 1) % 4], rooms.place_count + rooms.polygon_count + k, rooms.side_count++);
            }
    rooms.overlay = overlay(segments, rooms.tags);
    return rooms;
}

RoomMatch match_rooms(const RoomOverlay& rooms, const Places& places) {
    RoomMatch match;
    match.polygon_area2.assign(rooms.polygon_count, 0);
    match.exterior_area2.assign(rooms.polygon_count, 0);
    match.place_of_polygon.assign(rooms.polygon_count, kNone);
    match.polygons_of_place.resize(rooms.place_count);
    match.also_covered.resize(rooms.polygon_count);
    const std::vector<Share> all = shares(rooms, match);

    std::vector<std::int64_t> best(rooms.polygon_count, 0);
    for (const Share& share : all) {
        if (places.places[share.place].exterior) {
            match.exterior_area2[share.polygon] = share.area2;
            continue;
        }
        const bool half_of_polygon = 2 * share.area2 >= match.polygon_area2[share.polygon];
        const bool half_of_place = 2 * share.area2 >= places.places[share.place].area2 &&
                                   5 * share.area2 >= match.polygon_area2[share.polygon];
        if ((half_of_polygon || half_of_place) && share.area2 > best[share.polygon]) {
            best[share.polygon] = share.area2;
            match.place_of_polygon[share.polygon] = share.place;
        }
    }
    for (const Share& share : all)
        if (!places.places[share.place].exterior && share.place != match.place_of_polygon[share.polygon] &&
            10 * share.area2 >= 9 * places.places[share.place].area2)
            match.also_covered[share.polygon].push_back(share.place);
    for (std::uint32_t polygon = 0; polygon < rooms.polygon_count; ++polygon)
        if (match.place_of_polygon[polygon] != kNone)
            match.polygons_of_place[match.place_of_polygon[polygon]].push_back(polygon);
    for (auto& polygons : match.polygons_of_place)
        std::stable_sort(polygons.begin(), polygons.end(),
                         [&](std::uint32_t l, std::uint32_t r) { return best[l] > best[r]; });
    return match;
}

}  // namespace enfilade::plans

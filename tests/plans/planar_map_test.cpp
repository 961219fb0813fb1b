#include "plans/planar_map.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

namespace enfilade::plans {
namespace {

void add_ring(std::vector<Segment>& segments, const std::vector<GridPoint>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) segments.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

void add_box(std::vector<Segment>& segments, int x0, int y0, int x1, int y1) {
    add_ring(segments, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

std::vector<std::int64_t> face_areas(const PlanarMap& map) {
    std::vector<std::int64_t> areas(map.face_count, 0);
    for (std::size_t l = 0; l < map.loop_first.size(); ++l) areas[map.face_of_loop[l]] += map.loop_area2[l];
    return areas;
}

std::vector<std::int64_t> sorted_bounded_areas(const std::vector<Segment>& segments) {
    std::vector<std::int64_t> areas = face_areas(planar_map(node(segments)));
    areas.erase(areas.begin());
    std::sort(areas.begin(), areas.end());
    return areas;
}

std::size_t component_count(const NodedGraph& graph) {
    std::vector<std::uint32_t> parent(graph.vertices.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t v) {
        while (parent[v] != v) v = parent[v];
        return v;
    };
    for (const NodedEdge& edge : graph.edges) parent[root(edge.a)] = root(edge.b);
    std::set<std::uint32_t> roots;
    for (std::uint32_t v = 0; v < parent.size(); ++v) roots.insert(root(v));
    return roots.size();
}

/// Winding of a face's loops around a point that lies on none of their edges, by counting crossings to the right.
int winding(const NodedGraph& graph, const PlanarMap& map, std::uint32_t face, double x, double y) {
    int result = 0;
    for (std::uint32_t h = 0; h < map.next.size(); ++h) {
        if (map.face(h) != face) continue;
        const GridPoint a = graph.vertices[origin(graph, h)];
        const GridPoint b = graph.vertices[origin(graph, h ^ 1u)];
        if ((a.y <= y) == (b.y <= y)) continue;
        const double cross_x = a.x + (y - a.y) * (double(b.x) - a.x) / (double(b.y) - a.y);
        if (cross_x > x) result += b.y > a.y ? 1 : -1;
    }
    return result;
}

std::vector<Segment> random_segments(int size, int count) {
    std::vector<Segment> segments;
    const auto coordinate = [&] { return *rc::gen::inRange(-size, size + 1); };
    for (int i = 0; i < count; ++i) segments.push_back({{coordinate(), coordinate()}, {coordinate(), coordinate()}});
    return segments;
}

RC_GTEST_PROP(PlanarMap, FollowsEuler, ()) {
    const NodedGraph graph = node(random_segments(*rc::gen::inRange(3, 40), *rc::gen::inRange(1, 40)));
    RC_PRE(!graph.edges.empty());
    const PlanarMap map = planar_map(graph);
    RC_ASSERT(graph.vertices.size() + map.face_count == graph.edges.size() + component_count(graph) + 1);
}

RC_GTEST_PROP(PlanarMap, LoopsPartitionTheHalfEdges, ()) {
    const NodedGraph graph = node(random_segments(20, *rc::gen::inRange(1, 40)));
    const PlanarMap map = planar_map(graph);
    std::vector<bool> reached(map.next.size(), false);
    for (std::uint32_t h = 0; h < map.next.size(); ++h) {
        RC_ASSERT(origin(graph, map.next[h]) == origin(graph, h ^ 1u));
        RC_ASSERT(map.loop[map.next[h]] == map.loop[h]);
        RC_ASSERT(!reached[map.next[h]]);
        reached[map.next[h]] = true;
    }
}

RC_GTEST_PROP(PlanarMap, BoundedFacesHavePositiveAreaAndFillTheOutline, ()) {
    auto segments = random_segments(20, *rc::gen::inRange(1, 30));
    add_box(segments, -30, -30, 30, 30);
    const std::vector<std::int64_t> areas = face_areas(planar_map(node(segments)));
    for (std::size_t f = 1; f < areas.size(); ++f) RC_ASSERT(areas[f] > 0);
    RC_ASSERT(std::accumulate(areas.begin() + 1, areas.end(), std::int64_t(0)) == 2 * 60 * 60);
}

RC_GTEST_PROP(PlanarMap, EachPlaceLiesInOneFace, ()) {
    const NodedGraph graph = node(random_segments(12, *rc::gen::inRange(1, 25)));
    RC_PRE(!graph.edges.empty());
    const PlanarMap map = planar_map(graph);
    for (int k = 0; k < 5; ++k) {
        // No edge of this grid passes through points with these fractions.
        const double x = *rc::gen::inRange(-13, 14) + 0.41421356237;
        const double y = *rc::gen::inRange(-13, 14) + 0.73205080757;
        int inside = 0;
        for (std::uint32_t f = 1; f < map.face_count; ++f) {
            const int w = winding(graph, map, f, x, y);
            RC_ASSERT(w == 0 || w == 1);
            inside += w;
        }
        RC_ASSERT(inside <= 1);
        RC_ASSERT(winding(graph, map, 0, x, y) == -inside);
    }
}

TEST(PlanarMap, NothingHasTheUnboundedFaceAlone) { EXPECT_EQ(planar_map({}).face_count, 1u); }

TEST(PlanarMap, ALoneEdgeIsAHoleOfTheUnboundedFace) {
    const PlanarMap map = planar_map(node(std::vector<Segment>{{{0, 0}, {5, 7}}}));
    EXPECT_EQ(map.face_count, 1u);
    ASSERT_EQ(map.loop_first.size(), 1u);
    EXPECT_EQ(map.loop_area2[0], 0);
}

TEST(PlanarMap, NestedBoxesAreHolesOfEachOther) {
    std::vector<Segment> segments;
    add_box(segments, 0, 0, 100, 100);
    add_box(segments, 10, 10, 90, 90);
    add_box(segments, 20, 20, 80, 80);
    add_box(segments, 30, 30, 40, 40);
    add_box(segments, 50, 30, 60, 40);
    EXPECT_EQ(sorted_bounded_areas(segments),
              (std::vector<std::int64_t>{200, 200, 2 * (6400 - 3600), 2 * (3600 - 200), 2 * (10000 - 6400)}));
}

TEST(PlanarMap, AHoleMayTouchTheOuterRingInAPoint) {
    std::vector<Segment> segments;
    add_box(segments, 0, 0, 10, 10);
    add_ring(segments, {{0, 5}, {4, 3}, {4, 7}});
    EXPECT_EQ(sorted_bounded_areas(segments), (std::vector<std::int64_t>{16, 184}));
}

TEST(PlanarMap, ComponentsStraightAboveEachOtherFindTheirFaces) {
    // All begin at one x: the sweep meets them from below in one column.
    std::vector<Segment> segments;
    add_box(segments, 0, 0, 10, 100);
    for (int y = 1; y < 90; y += 10) add_box(segments, 1, y, 5, y + 5);
    EXPECT_EQ(sorted_bounded_areas(segments).back(), 2 * (1000 - 9 * 20));
}

}  // namespace
}  // namespace enfilade::plans

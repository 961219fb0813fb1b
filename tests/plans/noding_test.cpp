// Snap rounding against brute force, where the grid is so coarse that rounding bites at every crossing.

#include "plans/noding.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace enfilade::plans {
namespace {

int sign(std::int64_t value) { return (value > 0) - (value < 0); }

/// True where two edges have more in common than an end of both.
bool crosses_or_overlaps(const Segment& s, const Segment& t) {
    const auto inside = [](const Segment& u, GridPoint p) {
        return orientation(u.a, u.b, p) == 0 && std::min(u.a, u.b) < p && p < std::max(u.a, u.b);
    };
    if (inside(s, t.a) || inside(s, t.b) || inside(t, s.a) || inside(t, s.b)) return true;
    if (std::minmax(s.a, s.b) == std::minmax(t.a, t.b)) return true;
    return sign(orientation(s.a, s.b, t.a)) * sign(orientation(s.a, s.b, t.b)) < 0 &&
           sign(orientation(t.a, t.b, s.a)) * sign(orientation(t.a, t.b, s.b)) < 0;
}

Segment edge_segment(const NodedGraph& graph, const NodedEdge& edge) {
    return {graph.vertices[edge.a], graph.vertices[edge.b]};
}

std::size_t count_crossings(const NodedGraph& graph) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < graph.edges.size(); ++i)
        for (std::size_t j = i + 1; j < graph.edges.size(); ++j)
            count += crosses_or_overlaps(edge_segment(graph, graph.edges[i]), edge_segment(graph, graph.edges[j]));
    return count;
}

/// The vertices of one segment's chain from its a to its b; empty where its uses do not form one.
std::vector<GridPoint> chain(const NodedGraph& graph, std::uint32_t segment, GridPoint from) {
    std::map<GridPoint, GridPoint> next;
    for (const NodedEdge& edge : graph.edges)
        for (std::uint32_t u = edge.first_use; u < edge.first_use + edge.use_count; ++u) {
            if (graph.uses[u].segment != segment) continue;
            const Segment s = edge_segment(graph, edge);
            const bool added = graph.uses[u].reversed ? next.emplace(s.b, s.a).second : next.emplace(s.a, s.b).second;
            if (!added) return {};
        }
    std::vector<GridPoint> points{from};
    for (auto step = next.find(from); step != next.end(); step = next.find(from)) {
        from = step->second;
        points.push_back(from);
        next.erase(step);
    }
    return next.empty() ? points : std::vector<GridPoint>{};
}

/// The smallest Chebyshev distance of p from the segment, doubled and exact enough: half a unit is 1.
double doubled_distance(const Segment& s, GridPoint p) {
    double best = HUGE_VAL;
    // Piecewise linear and convex along the segment: its minimum lies at an end or where a piece begins.
    const double ax = s.a.x - p.x, ay = s.a.y - p.y, dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
    const auto at = [&](double t) {
        if (!(t >= 0 && t <= 1)) return;
        best = std::min(best, 2 * std::max(std::abs(ax + t * dx), std::abs(ay + t * dy)));
    };
    at(0);
    at(1);
    if (dx != 0) at(-ax / dx);
    if (dy != 0) at(-ay / dy);
    if (dx != dy) at((ay - ax) / (dx - dy));
    if (dx != -dy) at(-(ay + ax) / (dx + dy));
    return best;
}

std::vector<Segment> random_segments(int size, int count) {
    std::vector<Segment> segments;
    const auto coordinate = [&] { return *rc::gen::inRange(-size, size + 1); };
    for (int i = 0; i < count; ++i) segments.push_back({{coordinate(), coordinate()}, {coordinate(), coordinate()}});
    return segments;
}

/// Edges with the segments that use them, whatever the numbers of the segments.
using Signature = std::vector<std::tuple<GridPoint, GridPoint, std::vector<std::pair<GridPoint, GridPoint>>>>;

Signature signature(const NodedGraph& graph, const std::vector<Segment>& segments) {
    Signature result;
    for (const NodedEdge& edge : graph.edges) {
        std::vector<std::pair<GridPoint, GridPoint>> users;
        for (std::uint32_t u = edge.first_use; u < edge.first_use + edge.use_count; ++u) {
            const Segment& s = segments[graph.uses[u].segment];
            users.push_back(std::minmax(s.a, s.b));
        }
        std::sort(users.begin(), users.end());
        result.emplace_back(graph.vertices[edge.a], graph.vertices[edge.b], users);
    }
    return result;
}

RC_GTEST_PROP(Noding, LeavesNoCrossing, ()) {
    const auto segments = random_segments(*rc::gen::inRange(2, 16), *rc::gen::inRange(1, 60));
    RC_ASSERT(count_crossings(node(segments)) == 0u);
}

RC_GTEST_PROP(Noding, RoutesEachSegmentFromEndToEndWithinHalfAUnit, ()) {
    const auto segments = random_segments(*rc::gen::inRange(2, 16), *rc::gen::inRange(1, 40));
    const NodedGraph graph = node(segments);
    for (std::uint32_t s = 0; s < segments.size(); ++s) {
        if (segments[s].a == segments[s].b) continue;
        const auto points = chain(graph, s, segments[s].a);
        RC_ASSERT(points.size() >= 2u);
        RC_ASSERT(points.back() == segments[s].b);
        for (const GridPoint p : points) RC_ASSERT(doubled_distance(segments[s], p) <= 1 + 1e-12);
    }
}

RC_GTEST_PROP(Noding, IgnoresTheOrderAndDirectionOfSegments, ()) {
    const auto segments = random_segments(12, *rc::gen::inRange(1, 40));
    auto shuffled = segments;
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    for (Segment& s : shuffled)
        if (random() % 2 == 0) std::swap(s.a, s.b);
    const NodedGraph graph = node(segments);
    const NodedGraph other = node(shuffled);
    RC_ASSERT(graph.vertices == other.vertices);
    RC_ASSERT(signature(graph, segments) == signature(other, shuffled));
}

RC_GTEST_PROP(Noding, KeepsItsOwnResultWhereNoEdgePassesAPixel, ()) {
    // Edges between lattice points with steps of at most one unit pass no pixel but those of their ends.
    std::vector<Segment> segments;
    std::set<std::pair<GridPoint, GridPoint>> distinct;
    for (int i = 0; i < 60; ++i) {
        const GridPoint a{*rc::gen::inRange(-6, 7), *rc::gen::inRange(-6, 7)};
        const GridPoint b = *rc::gen::arbitrary<bool>() ? GridPoint{a.x + 1, a.y} : GridPoint{a.x, a.y + 1};
        if (distinct.emplace(a, b).second) segments.push_back({a, b});
    }
    const NodedGraph graph = node(segments);
    RC_ASSERT(graph.edges.size() == segments.size());
    RC_ASSERT(graph.max_deviation == 0.0);
}

RC_GTEST_PROP(Noding, NearParallelSegmentsShareEdgesInsteadOfCrossing, ()) {
    // Hundreds of units long and at most two units apart: they cross at angles where doubles cannot tell.
    std::vector<Segment> segments;
    const int length = *rc::gen::inRange(100, 1 << 24);
    for (int i = 0; i < 12; ++i)
        segments.push_back({{-length + *rc::gen::inRange(-1, 2), *rc::gen::inRange(-2, 3)},
                            {length + *rc::gen::inRange(-1, 2), *rc::gen::inRange(-2, 3)}});
    RC_ASSERT(count_crossings(node(segments)) == 0u);
}

RC_GTEST_PROP(Noding, HoldsAtTheEndsOfItsRange, ()) {
    constexpr int limit = 1 << 25;
    std::vector<Segment> segments;
    for (int i = 0; i < 20; ++i) {
        const auto corner = [&] { return *rc::gen::element(-limit, limit); };
        const auto any = [&] { return *rc::gen::inRange(-limit, limit + 1); };
        segments.push_back({{corner(), any()}, {any(), corner()}});
    }
    RC_ASSERT(count_crossings(node(segments)) == 0u);
}

TEST(Noding, RoundsHalvesUpOnBothAxes) {
    // The diagonals of a unit square cross in its middle, (1/2, 1/2), which belongs to pixel (1, 1).
    const NodedGraph graph = node(std::vector<Segment>{{{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}});
    EXPECT_EQ(graph.vertices, (std::vector<GridPoint>{{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
    ASSERT_EQ(graph.edges.size(), 3u);  // (0,1) and (1,0) now run by way of (1,1)
    EXPECT_NEAR(graph.max_deviation, std::sqrt(0.5), 1e-12);
}

TEST(Noding, SharesTheCommonPartOfCollinearSegments) {
    const NodedGraph graph = node(std::vector<Segment>{{{0, 0}, {10, 0}}, {{14, 0}, {4, 0}}});
    ASSERT_EQ(graph.edges.size(), 3u);
    EXPECT_EQ(graph.edges[1].use_count, 2u);
    EXPECT_FALSE(graph.uses[graph.edges[1].first_use].reversed);
    EXPECT_TRUE(graph.uses[graph.edges[1].first_use + 1].reversed);
}

TEST(Noding, SegmentsWithoutLengthLeaveNothing) {
    const NodedGraph graph = node(std::vector<Segment>{{{3, 3}, {3, 3}}});
    EXPECT_TRUE(graph.vertices.empty());
    EXPECT_TRUE(graph.edges.empty());
}

TEST(Noding, AFallingSegmentVisitsOneColumnFromAbove) {
    // Both hot pixels of column 0 lie on the steep falling segment.
    const NodedGraph graph = node(std::vector<Segment>{{{0, 9}, {1, -9}}, {{-3, 4}, {0, 4}}, {{-3, 2}, {0, 2}}});
    EXPECT_EQ(count_crossings(graph), 0u);
    const auto points = chain(graph, 0, {0, 9});
    ASSERT_GE(points.size(), 4u);
    EXPECT_EQ(points[1], (GridPoint{0, 4}));
    EXPECT_EQ(points[2], (GridPoint{0, 2}));
}

TEST(Noding, ABundleOfEqualLongSegmentsStaysCheap) {
    // Every halving of the bundle leaves all of it on both sides: the walk has to see that and stop.
    std::vector<Segment> segments;
    for (int i = 0; i < 400; ++i) segments.push_back({{-(1 << 24), i % 3}, {1 << 24, i % 5}});
    const NodedGraph graph = node(segments);
    EXPECT_EQ(count_crossings(graph), 0u);
    std::size_t uses = 0;
    for (const NodedEdge& edge : graph.edges) uses += edge.use_count;
    EXPECT_EQ(uses, graph.uses.size());
}

}  // namespace
}  // namespace enfilade::plans

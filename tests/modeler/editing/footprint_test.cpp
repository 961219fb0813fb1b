#include "modeler/editing/footprint.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "modeler/editing/route.h"
#include "plans/planar_map.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

TEST(Footprint, ConvexRingsTurnLeftOnce) {
    EXPECT_TRUE(is_convex_ring(std::vector<GridPoint>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
    EXPECT_TRUE(is_convex_ring(std::vector<GridPoint>{{0, 0}, {2, 0}, {4, 0}, {4, 4}})) << "straight on";
    EXPECT_FALSE(is_convex_ring(std::vector<GridPoint>{{0, 0}, {0, 4}, {4, 4}, {4, 0}})) << "clockwise";
    EXPECT_FALSE(is_convex_ring(std::vector<GridPoint>{{0, 0}, {4, 0}, {1, 1}, {0, 4}})) << "a notch";
    EXPECT_FALSE(is_convex_ring(std::vector<GridPoint>{{0, 0}, {4, 0}, {2, 0}})) << "no area";
    EXPECT_FALSE(is_convex_ring(std::vector<GridPoint>{
        {10, 0}, {3, 9}, {-8, 6}, {-8, -6}, {3, -9}, {10, 0}, {3, 9}, {-8, 6}, {-8, -6}, {3, -9}}))
        << "twice around";
    EXPECT_FALSE(is_convex_ring(std::vector<GridPoint>{{10, 0}, {-8, 6}, {3, -9}, {3, 9}, {-8, -6}})) << "a star";
}

RC_GTEST_PROP(Footprint, OfATurnedRectangleHoldsIt, ()) {
    const plans::GridFrame frame;
    const double x = *rc::gen::inRange(-90000, 90000) / 1000.0, y = *rc::gen::inRange(-90000, 90000) / 1000.0;
    const double width = *rc::gen::inRange(2, 4000) / 1000.0, depth = *rc::gen::inRange(2, 4000) / 1000.0;
    const double angle = *rc::gen::inRange(-3142, 3142) / 1000.0;
    const std::vector<GridPoint> ring = rectangle_footprint(frame, x, y, width, depth, angle);
    RC_ASSERT(is_convex_ring(ring));
    const double c = std::cos(angle), s = std::sin(angle);
    for (const auto& [u, v] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        const double px = (x + u * width / 2 * c - v * depth / 2 * s) / frame.unit;
        const double py = (y + u * width / 2 * s + v * depth / 2 * c) / frame.unit;
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const GridPoint a = ring[k], b = ring[(k + 1) % ring.size()];
            const double side = (double(b.x) - a.x) * (py - a.y) - (double(b.y) - a.y) * (px - a.x);
            RC_ASSERT(side >= -1e-5 * std::hypot(double(b.x) - a.x, double(b.y) - a.y));
        }
    }
    const double area = width * depth / frame.unit / frame.unit;
    const double slack = 6 * (width + depth) / frame.unit + 40;
    RC_ASSERT(thickness(ring) * ((width + depth) / frame.unit) < area + slack);
}

TEST(Footprint, CornersNearAWallGoOntoIt) {
    const std::vector<plans::Segment> wall = {{{0, 0}, {1000, 400}}};
    const std::vector<GridPoint> ring = {{251, 101}, {500, 199}, {300, 700}, {51, 602}};
    const std::vector<GridPoint> on = snapped(ring, wall);
    for (const std::size_t k : {0u, 1u}) {
        const double off = double(std::abs(orientation(wall[0].a, wall[0].b, on[k]))) / std::hypot(1000.0, 400.0);
        EXPECT_LE(off, 0.71) << k;
    }
    EXPECT_EQ(on[2], ring[2]);
    EXPECT_EQ(on[3], ring[3]);
    EXPECT_EQ(snapped(std::vector<GridPoint>{{9, 9}, {90, 9}, {90, 13}, {9, 13}},
                      std::vector<plans::Segment>{{{0, 8}, {99, 8}}})
                  .front(),
              (GridPoint{9, 9}))
        << "thin ones stay";
}

RC_GTEST_PROP(Route, CrossesNothingAndLeavesWhatIsFarAlone, ()) {
    const auto point = [] { return GridPoint{*rc::gen::inRange(0, 60), *rc::gen::inRange(0, 60)}; };
    const std::vector<plans::Segment> fixed = {{{0, 0}, {60, 0}}, {{60, 0}, {60, 60}}, {{60, 60}, {0, 60}},
                                               {{0, 60}, {0, 0}}, {{0, 60}, {30, 20}}, {{30, 20}, {60, 60}}};
    std::vector<plans::Segment> added;
    for (int k = *rc::gen::inRange(1, 6); k > 0; --k) added.push_back({point(), point()});
    const RoutedGraph routed = route(fixed, added);
    std::vector<plans::Segment> edges;
    for (const plans::NodedEdge& edge : routed.graph.edges)
        edges.push_back({routed.graph.vertices[edge.a], routed.graph.vertices[edge.b]});
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            const auto& [a, b] = edges[i];
            const auto& [c, d] = edges[j];
            const bool parts = (orientation(a, b, c) > 0) != (orientation(a, b, d) > 0) && orientation(a, b, c) != 0 &&
                               orientation(a, b, d) != 0 && (orientation(c, d, a) > 0) != (orientation(c, d, b) > 0) &&
                               orientation(c, d, a) != 0 && orientation(c, d, b) != 0;
            RC_ASSERT(!parts);
        }
    for (std::size_t s = 0; s < fixed.size(); ++s) {
        RC_ASSERT(!routed.chains[s].empty());
        RC_ASSERT(routed.graph.vertices[plans::origin(routed.graph, routed.chains[s].front())] == fixed[s].a);
        RC_ASSERT(routed.graph.vertices[plans::origin(routed.graph, routed.chains[s].back() ^ 1)] == fixed[s].b);
    }
}

}  // namespace
}  // namespace enfilade::modeler

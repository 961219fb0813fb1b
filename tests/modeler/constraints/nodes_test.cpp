// D1: the node of a cell lies inside it.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "modeler/cell_node.h"
#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/faults_semantics.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

bool is_strictly_inside(const std::vector<GridPoint>& ring, std::array<double, 2> p) {
    int winding = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const GridPoint a = ring[k], b = ring[(k + 1) % ring.size()];
        const double cross = (double(b.x) - a.x) * (p[1] - a.y) - (double(b.y) - a.y) * (p[0] - a.x);
        if (cross == 0 && p[0] >= std::min(a.x, b.x) && p[0] <= std::max(a.x, b.x) && p[1] >= std::min(a.y, b.y) &&
            p[1] <= std::max(a.y, b.y))
            return false;
        if (a.y <= p[1] && b.y > p[1] && cross > 0) ++winding;
        if (a.y > p[1] && b.y <= p[1] && cross < 0) --winding;
    }
    return winding != 0;
}

TEST(Nodes, FindsEachNodeOutsideItsCell) { testing::expect_found(testing::inject_d1, 20); }

TEST(Nodes, OfConvexRingsAreTheirCentroid) {
    const std::vector<GridPoint> square = {{0, 0}, {100, 0}, {100, 60}, {0, 60}};
    EXPECT_EQ(inner_point(square), (std::array<double, 2>{50, 30}));
}

TEST(Nodes, OfALLieInOneOfItsArms) {
    const std::vector<GridPoint> l = {{0, 0}, {100, 0}, {100, 10}, {10, 10}, {10, 100}, {0, 100}};
    EXPECT_TRUE(is_strictly_inside(l, inner_point(l)));
    std::vector<GridPoint> back(l.rbegin(), l.rend());
    EXPECT_TRUE(is_strictly_inside(l, inner_point(back)));
}

TEST(Nodes, OfACrescentIsNotAtItsEdge) {
    std::vector<GridPoint> crescent;
    for (int x = 0; x <= 1000; x += 100) crescent.push_back({x, x * (1000 - x) / 2500});
    for (int x = 1000; x >= 0; x -= 100) crescent.push_back({x, x * (1000 - x) / 2500 + 70});
    const auto node = inner_point(crescent);
    EXPECT_TRUE(is_strictly_inside(crescent, node));
    EXPECT_TRUE(is_strictly_inside(crescent, {node[0], node[1] + 8}));
    EXPECT_TRUE(is_strictly_inside(crescent, {node[0], node[1] - 8}));
}

TEST(Nodes, OfSliversAreInside) {
    const std::vector<GridPoint> sliver = {{0, 0}, {100000, 1}, {50000, 1}};
    EXPECT_TRUE(is_strictly_inside(sliver, inner_point(sliver)));
}

/// Combs: as many teeth as one likes, of any width.
RC_GTEST_PROP(Nodes, OfAnyCombAreInside, ()) {
    std::vector<GridPoint> comb = {{0, 0}};
    int x = 0;
    std::vector<GridPoint> top;
    const int teeth = *rc::gen::inRange(1, 12);
    for (int k = 0; k < teeth; ++k) {
        const int tooth = *rc::gen::inRange(1, 40), gap = *rc::gen::inRange(1, 40);
        const int height = *rc::gen::inRange(3, 2000), low = *rc::gen::inRange(1, 3);
        top.insert(top.end(), {{x, height}, {x + tooth, height}, {x + tooth, low}, {x + tooth + gap, low}});
        x += tooth + gap;
    }
    comb.push_back({x, 0});
    comb.insert(comb.end(), top.rbegin(), top.rend());
    RC_ASSERT(is_strictly_inside(comb, inner_point(comb)));
}

TEST(Nodes, LieInTheirVolumeHalfWayUp) {
    const Building building = build(testing::ring_room());
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v) {
        const Volume& volume = building.volumes[v];
        if (volume.label != Label::Room) continue;
        EXPECT_NEAR(cell_node(building, v)[2], 1.25, 1e-3);
    }
}

TEST(Nodes, FarFromTheOriginToo) {
    plans::Plan plan = testing::two_rooms();
    for (plans::Wall& wall : plan.storeys[0].walls)
        for (plans::Point* p : {&wall.start, &wall.end}) p->x += 4e6, p->y -= 5e6;
    EXPECT_EQ(check(convexify(build(plan))).count("D1"), 0u);
}

}  // namespace
}  // namespace enfilade::modeler

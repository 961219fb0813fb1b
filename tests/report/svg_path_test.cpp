#include "tools/report/svg_path.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/report/path_rings.h"

namespace enfilade::tools {
namespace {

TEST(SvgPath, ASquareIsShort) {
    SvgPath path;
    path.ring(std::vector<Mm>{{1000, 2000}, {1500, 2000}, {1500, 2500}, {1000, 2500}});
    EXPECT_EQ(path.text(), "m1000 2000h500v500h-500z");
}

TEST(SvgPath, SegmentsThatGoOnAreOneLine) {
    SvgPath path;
    path.segment({0, 0}, {10, 0});
    path.segment({10, 0}, {10, 10});
    path.segment({0, 0}, {5, 5});
    EXPECT_EQ(path.text(), "m0 0h10v10m-10-10l5 5");
}

TEST(SvgPath, ADotIsALineWithoutLength) {
    SvgPath path;
    path.dot({3, 4});
    path.dot({5, 5});
    EXPECT_EQ(path.text(), "m3 4h0m2 1h0");
}

TEST(SvgPath, AnArcTurnsTheWayItIsTold) {
    SvgPath path;
    path.move({900, 0});
    path.arc(900, true, {0, 900});
    EXPECT_EQ(path.text(), "m900 0a900 900 0 0 1-900 900");
}

RC_GTEST_PROP(SvgPath, RingsReadBackAsTheyWere, ()) {
    const auto rings = *rc::gen::container<std::vector<std::vector<std::pair<int, int>>>>(
        rc::gen::container<std::vector<std::pair<int, int>>>(
            rc::gen::pair(rc::gen::inRange(-30, 30), rc::gen::inRange(-30, 30))));
    SvgPath path;
    std::vector<std::vector<Mm>> expected;
    for (const auto& ring : rings) {
        std::vector<Mm> points;
        for (const auto& [x, y] : ring)
            if (points.empty() || !(points.back() == Mm{x, y})) points.push_back({x, y});
        if (points.empty()) continue;
        expected.push_back(points);
        path.ring(points);
    }
    RC_ASSERT(testing::PathReader(path.text()).rings() == expected);
}

}  // namespace
}  // namespace enfilade::tools

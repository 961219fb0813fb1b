// The plan of a beam against the definition: is there a line that crosses all gates between their ends?

#include "accel/beam_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace enfilade::accel {
namespace {

struct Passage {
    BeamSource source;
    std::vector<Gate> gates;
};

/// Whether the gate can bound the same convex cell as the source or the gate before it.
bool follows(const Passage& passage, const Gate& gate) {
    const auto is_left = [](const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) { return turn(a, b, c) > 0; };
    if (passage.gates.empty())
        return std::ranges::all_of(passage.source.corners,
                                   [&](const PlanPoint& p) { return is_left(gate.right, gate.left, p); });
    const Gate& before = passage.gates.back();
    return is_left(before.left, before.right, gate.right) && is_left(before.right, gate.right, gate.left) &&
           is_left(gate.right, gate.left, before.left) && is_left(gate.left, before.left, before.right);
}

/// Gates one above the other, crossed upwards; small numbers, so that ends often lie on one line.
Passage random_passage(std::mt19937_64& random, int gate_count, int corners, int tilt) {
    const auto number = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
    Passage passage;
    std::vector<PlanPoint> points;
    for (int k = 0; k < corners; ++k) points.push_back({number(-6, 6), number(-14, -6)});
    passage.source = {CellId{0}, convex_hull(points), 0, 0};
    while (int(passage.gates.size()) < gate_count) {
        const int k = int(passage.gates.size()), left = number(-8, 5);
        const Gate gate = {{left, 10 * k + number(-tilt, tilt)}, {left + number(3, 9), 10 * k + number(-tilt, tilt)}};
        if (follows(passage, gate)) passage.gates.push_back(gate);
    }
    return passage;
}

/// Whether a line leaves the source upwards and crosses the first `count` gates without touching their ends.
bool is_passable(const Passage& passage, std::size_t count) {
    std::vector<PlanPoint> lefts, rights;
    for (std::size_t k = 0; k < count; ++k) {
        lefts.push_back(passage.gates[k].left);
        rights.push_back(passage.gates[k].right);
    }
    std::vector<PlanPoint> all = passage.source.corners;
    all.insert(all.end(), lefts.begin(), lefts.end());
    all.insert(all.end(), rights.begin(), rights.end());
    // Between two neighbouring slopes the order of all points across the line stays the same: asked in the middle.
    std::vector<std::pair<std::int64_t, std::int64_t>> slopes = {{-1000, 1}, {1000, 1}};
    for (const PlanPoint& a : all)
        for (const PlanPoint& b : all)
            if (a.y > b.y) slopes.push_back({a.x - b.x, a.y - b.y});
    std::sort(slopes.begin(), slopes.end(), [](auto a, auto b) { return a.first * b.second < b.first * a.second; });
    const auto passes = [&](std::int64_t n, std::int64_t d) {
        std::int64_t low = INT64_MIN, high = INT64_MAX;  // across the line: the gates, open
        for (const PlanPoint& p : lefts) low = std::max(low, d * p.x - n * p.y);
        for (const PlanPoint& p : rights) high = std::min(high, d * p.x - n * p.y);
        std::int64_t from = INT64_MAX, to = INT64_MIN;  // the source, closed
        for (const PlanPoint& p : passage.source.corners) {
            from = std::min(from, d * p.x - n * p.y);
            to = std::max(to, d * p.x - n * p.y);
        }
        return low < high && low < to && from < high;
    };
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        if (passes(slopes[k].first, slopes[k].second)) return true;
        if (k + 1 < slopes.size() &&
            passes(slopes[k].first + slopes[k + 1].first, slopes[k].second + slopes[k + 1].second))
            return true;
    }
    return false;
}

/// How many gates the beam crosses.
std::size_t crossed(const Passage& passage, std::int64_t margin = 0) {
    PlanHistory history;
    PlanBeam beam;
    for (std::size_t k = 0; k < passage.gates.size(); ++k) {
        const std::optional<PlanBeam> next = cross(passage.source, beam, passage.gates[k], margin, history);
        if (!next) return k;
        beam = *next;
    }
    return passage.gates.size();
}

class Passages : public testing::TestWithParam<std::pair<int, int>> {};  // corners of the source, tilt of the gates

TEST_P(Passages, AreCrossedAsFarAsALineGoes) {
    std::mt19937_64 random(6);
    std::size_t ends_early = 0, whole = 0;
    for (int round = 0; round < 20000; ++round) {
        const Passage passage = random_passage(random, 6, GetParam().first, GetParam().second);
        std::size_t expected = 0;
        while (expected < passage.gates.size() && is_passable(passage, expected + 1)) ++expected;
        ASSERT_EQ(crossed(passage), expected) << "round " << round;
        (expected < passage.gates.size() ? ends_early : whole) += 1;
    }
    EXPECT_GT(ends_early, 1000u);
    EXPECT_GT(whole, 100u);
}

INSTANTIATE_TEST_SUITE_P(All, Passages,
                         testing::Values(std::pair{1, 0}, std::pair{1, 4}, std::pair{2, 0}, std::pair{2, 4},
                                         std::pair{5, 0}, std::pair{5, 4}));

TEST(Passage, IsNeverShorterWithAMargin) {
    std::mt19937_64 random(7);
    std::size_t longer = 0;
    for (int round = 0; round < 20000; ++round) {
        Passage passage = random_passage(random, 6, 4, 4);
        for (PlanPoint& p : passage.source.corners) p = {16 * p.x, 16 * p.y};
        for (Gate& g : passage.gates) g = {{16 * g.left.x, 16 * g.left.y}, {16 * g.right.x, 16 * g.right.y}};
        const std::size_t exact = crossed(passage), wide = crossed(passage, 1);
        ASSERT_GE(wide, exact);
        longer += wide > exact;
    }
    EXPECT_GT(longer, 100u);
}

TEST(ConvexHull, HasNoCornerTwiceAndNoneOnASide) {
    EXPECT_EQ(convex_hull({{3, 4}, {3, 4}}).size(), 1u);
    EXPECT_EQ(convex_hull({{0, 0}, {2, 2}, {1, 1}, {3, 3}}).size(), 2u);
    EXPECT_EQ(convex_hull({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}, {2, 2}, {4, 0}}),
              (std::vector<PlanPoint>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
}

}  // namespace
}  // namespace enfilade::accel

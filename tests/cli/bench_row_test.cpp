// When a benchmark's goal counts as met.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tools/bench.h"
#include "tools/contest.h"

namespace enfilade::tools {
namespace {

TEST(BenchRow, ComparesTheValueWithItsGoal) {
    EXPECT_EQ((BenchRow{.value = 0.2, .goal = value_at_most(0.3)}.met()), true);
    EXPECT_EQ((BenchRow{.value = 0.4, .goal = value_at_most(0.3)}.met()), false);
    EXPECT_EQ((BenchRow{.value = 2, .goal = value_at_least(1)}.met()), true);
    EXPECT_EQ((BenchRow{.value = 2}.met()), std::nullopt);
}

TEST(BenchRow, ComparesTheRatioOnlyWhereThereIsOne) {
    EXPECT_EQ((BenchRow{.value = 1, .ratio = 4.9, .goal = ratio_at_least(5)}.met()), false);
    EXPECT_EQ((BenchRow{.value = 1, .ratio = 5.1, .goal = ratio_at_least(5)}.met()), true);
    EXPECT_EQ((BenchRow{.value = 99, .goal = ratio_at_least(5)}.met()), std::nullopt);
}

TEST(BenchRow, NaNMeetsNoGoal) {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ((BenchRow{.value = nothing, .goal = value_at_most(1)}.met()), false);
    EXPECT_EQ((BenchRow{.value = nothing, .goal = value_at_least(1)}.met()), false);
}

TEST(Bench, WritesEveryFieldOfARow) {
    const Console console(true, false);
    Bench bench(console, true, "no/folder");
    bench.begin("cells", "");
    bench.add({.row = "primary rays",
               .scene = "office",
               .threads = 1,
               .value = 50,
               .unit = "Mrays/s",
               .reference = "Embree",
               .reference_value = 10.0,
               .ratio = 5.0,
               .goal = ratio_at_least(5),
               .spread = 0.02});
    const nlohmann::json row = nlohmann::json::parse(bench_json(bench).dump())["rows"][0];
    EXPECT_EQ(row, (nlohmann::json{{"bench", "cells"},
                                   {"row", "primary rays"},
                                   {"scene", "office"},
                                   {"threads", 1},
                                   {"value", 50.0},
                                   {"unit", "Mrays/s"},
                                   {"reference", "Embree"},
                                   {"reference_value", 10.0},
                                   {"ratio", 5.0},
                                   {"spread", 0.02},
                                   {"goal", "ratio >= 5"},
                                   {"met", true}}));
}

TEST(Bench, MedianIsTheMiddle) {
    EXPECT_EQ(median({3, 1, 2}), 2);
    EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
    EXPECT_EQ(median({}), 0);
}

TEST(Bench, DuelTakesTheRatioOfNeighbours) {
    int a_calls = 0, b_calls = 0;
    const Duel result = duel(
        3, [&] { ++a_calls; }, [&] { ++b_calls; });
    EXPECT_EQ(a_calls, 4);
    EXPECT_EQ(b_calls, 4);
    EXPECT_GT(result.b_over_a, 0);
}

TEST(Contest, RunsAllInTurnAndComparesThemWithinRounds) {
    std::string order;
    const std::vector<std::function<void()>> competitors = {[&] { order += 'a'; }, [&] { order += 'b'; }};
    const Contest contest(3, competitors, Clock::Wall);
    EXPECT_EQ(order, "ababbaab");
    EXPECT_NEAR(contest.faster(0, 1) * contest.faster(1, 0), 1, 1e-9);
    EXPECT_EQ(contest.faster(0, 0), 1);
    EXPECT_EQ(contest.spread(0, 0), 0);
    EXPECT_GE(contest.spread(0, 1).value(), 0);
    EXPECT_FALSE(Contest(2, competitors).spread(0, 1).has_value());
}

}  // namespace
}  // namespace enfilade::tools

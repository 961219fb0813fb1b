// Whole plans, drawn at random and by other people, cut by every convexifier: sound, and the same on any number of
// threads.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "base/error.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/model_group.h"
#include "plans/generate.h"
#include "plans/random.h"
#include "plans/read.h"
#include "tests/support/random_plan.h"

namespace enfilade::modeler {
namespace {

constexpr Convexifier all_convexifiers[] = {Convexifier::Sah, Convexifier::HertelMehlhorn, Convexifier::Diagonals};

const char* name_of(Convexifier convexifier) {
    switch (convexifier) {
        case Convexifier::Sah: return "sah";
        case Convexifier::HertelMehlhorn: return "hertel-mehlhorn";
        case Convexifier::Diagonals: break;
    }
    return "diagonals";
}

/// Errors of the model's shape and topology: others are about the plan.
std::string model_errors(const Building& building) {
    std::string text;
    for (const Finding& finding : check(building).findings)
        if (finding.severity == Severity::Error && (finding.code[0] == 'G' || finding.code[0] == 'T'))
            text += finding.code + ": " + finding.sentence + "\n";
    return text;
}

/// Floors of 3 to 60 rooms on one to three storeys, up to half of the walls curved, up to half oblique.
plans::Plan random_floors(std::uint64_t seed) {
    plans::Random random{0xF1002, seed};
    plans::GenerateOptions options;
    options.storeys = 1 + random.below(3);
    options.rooms = options.storeys * (3 + random.below(18));
    options.curved = random.uniform(0, 0.5);
    options.oblique = random.uniform(0, 0.5);
    options.seed = random.next();
    return plans::generate(options);
}

bool alike(const PolygonSide& a, const PolygonSide& b) {
    return a.from == b.from && a.to == b.to && a.line == b.line && a.tag == b.tag && a.look == b.look &&
           a.faces == b.faces;
}

void expect_alike(const RegionCut& a, const RegionCut& b) {
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.new_points, b.new_points);
    EXPECT_TRUE(std::equal(a.sides.begin(), a.sides.end(), b.sides.begin(), b.sides.end(), alike));
    EXPECT_EQ(a.first_side, b.first_side);
    EXPECT_EQ(a.disc, b.disc);
    EXPECT_EQ(a.disc_cuts, b.disc_cuts);
    EXPECT_EQ(a.disc_count, b.disc_count);
    EXPECT_EQ(a.moved, b.moved);
    EXPECT_EQ(a.fallen_back, b.fallen_back);
}

void expect_same_bytes(const Building& a, const Building& b) {
    const auto one = model_group(a), other = model_group(b);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
        EXPECT_EQ(one[k].name, other[k].name);
        EXPECT_TRUE(one[k].bytes == other[k].bytes) << one[k].name;
    }
}

/// What is being cut, for the message of a cutter that ends the program.
std::string running;

extern "C" void tell_what_was_running(int signal) {
    std::signal(signal, SIG_DFL);
    std::cerr << running << '\n';
    std::raise(signal);
}

class CutPlans : public ::testing::TestWithParam<Convexifier> {};

TEST_P(CutPlans, GeneratedOnesAreSound) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const Building convex = convexify(build(random_floors(seed)), {GetParam()});
        EXPECT_EQ(model_errors(convex), "") << "seed " << seed;
    }
}

TEST_P(CutPlans, AreTheSameOnOneThreadAndOnSeveral) {
    for (std::uint64_t seed = 100; seed < 108; ++seed) {
        SCOPED_TRACE(seed);
        const Building building = build(random_floors(seed));
        const CutOptions options{true, GetParam(), {}};
        const std::vector<RegionCut> serial = cut_regions(building.stack, options, accel::SerialExecutor()),
                                     spread = cut_regions(building.stack, options, accel::ThreadExecutor(4));
        ASSERT_EQ(serial.size(), spread.size());
        for (std::size_t r = 0; r < serial.size(); ++r) expect_alike(serial[r], spread[r]);
        expect_same_bytes(convexify(building, {GetParam()}, accel::SerialExecutor()),
                          convexify(building, {GetParam()}, accel::ThreadExecutor(3)));
    }
}

/// Homes, drawings and floor plans of other people; files that are no plans are refused.
TEST_P(CutPlans, RealOnesAreSound) {
    const std::filesystem::path data = ENFILADE_SOURCE_DIR "/../shared/data";
    if (!std::filesystem::exists(data)) GTEST_SKIP() << "no real plans beside this checkout (../shared/data)";
    std::vector<std::filesystem::path> files;
    for (const char* folder : {"sh3d", "dxf", "other"})
        for (const auto& entry : std::filesystem::directory_iterator(data / folder))
            if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::uint32_t cut = 0;
    for (const std::filesystem::path& file : files) {
        try {
            const Building convex = convexify(build(plans::read(file)), {GetParam()});
            EXPECT_EQ(model_errors(convex), "") << file.filename();
            ++cut;
        } catch (const InputError& error) {
            std::cout << file.filename() << ": " << error.what() << '\n';
        }
    }
    EXPECT_GE(cut, 20u);
}

INSTANTIATE_TEST_SUITE_P(All, CutPlans, ::testing::ValuesIn(all_convexifiers), [](const auto& convexifier) {
    std::string name = name_of(convexifier.param);
    std::erase(name, '-');
    return name;
});

RC_GTEST_PROP(CutPlans, AnyAreCutSoundOrRefused, ()) {
    for (const int signal : {SIGABRT, SIGSEGV}) std::signal(signal, tell_what_was_running);
    const plans::Plan plan = testing::any_plan();
    try {
        const Building building = build(plan);
        for (const Convexifier convexifier : all_convexifiers) {
            RC_LOG() << plans::write_json(plan) << "\n" << name_of(convexifier) << "\n";
            running = std::string(name_of(convexifier)) + "\n" + plans::write_json(plan);
            RC_ASSERT(model_errors(convexify(building, {convexifier})) == "");
        }
    } catch (const InputError&) {
        RC_TAG("refused");
    }
}

}  // namespace
}  // namespace enfilade::modeler

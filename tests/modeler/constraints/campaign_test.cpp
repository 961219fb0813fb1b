// Random sound buildings, each with one random fault: it is found with its code, at its place, and nothing else is.
// Five a code here; `tools/campaign.sh 1000` runs a thousand and prints the table of docs/checks.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "base/error.h"
#include "modeler/certify.h"
#include "modeler/export_scene.h"
#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/changed_scene.h"
#include "tests/support/faults_geometry.h"
#include "tests/support/faults_semantics.h"
#include "tests/support/faults_topology.h"

namespace enfilade::modeler {
namespace {

using testing::FaultVerdict;
using testing::InjectedFault;

std::uint32_t campaign_size() {
    const char* const asked = std::getenv("ENFILADE_CAMPAIGN");
    const long size = asked ? std::strtol(asked, nullptr, 10) : 0;
    return size > 0 ? std::uint32_t(size) : 5;
}

/// Another series of buildings and faults: what was mended on one is measured on another.
std::uint64_t campaign_series() {
    const char* const asked = std::getenv("ENFILADE_CAMPAIGN_SERIES");
    return asked ? std::strtoull(asked, nullptr, 10) : 0;
}

struct FaultKind {
    const char* code;
    std::optional<InjectedFault> (*inject)(Building&, plans::Random&);
};

class Campaign : public ::testing::TestWithParam<FaultKind> {};

TEST_P(Campaign, FindsEveryFaultAndNothingElse) {
    const auto [code, inject] = GetParam();
    const std::uint32_t wanted = campaign_size();
    std::uint32_t injected = 0, found = 0, other = 0, out_of_place = 0, several = 0, shown = 0;
    for (std::uint64_t seed = 0; injected < wanted && seed < 20ull * wanted; ++seed) {
        plans::Random random{0xCA4, std::uint64_t(code[0]), std::uint64_t(code[1]), seed, campaign_series()};
        Building building = testing::random_building(random);
        const std::optional<InjectedFault> fault = inject(building, random);
        if (!fault) continue;
        ++injected;
        EXPECT_EQ(fault->code, code);
        // Offices are sound by construction: what is found is the fault's (SoundBuildings below).
        const FaultVerdict verdict = testing::judge(CheckReport{}, check(building), *fault);
        found += verdict.found > 0;
        several += verdict.found > 1;
        other += !verdict.other.empty();
        out_of_place += verdict.out_of_place + verdict.unnamed > 0;
        if (!verdict.exact() && ++shown <= 5) ADD_FAILURE() << "seed " << seed << ": " << verdict.text();
    }
    EXPECT_EQ(injected, wanted) << "too few buildings offer a place for this fault";
    std::cout << "campaign | " << code << " | " << injected << " | " << found << " | " << other << " | " << out_of_place
              << " | " << several << " |\n";
}

INSTANTIATE_TEST_SUITE_P(Faults, Campaign,
                         ::testing::Values(FaultKind{"T1", testing::inject_t1}, FaultKind{"T2", testing::inject_t2},
                                           FaultKind{"T3", testing::inject_t3}, FaultKind{"T4", testing::inject_t4},
                                           FaultKind{"T5", testing::inject_t5}, FaultKind{"T6", testing::inject_t6},
                                           FaultKind{"T7", testing::inject_t7}, FaultKind{"T8", testing::inject_t8},
                                           FaultKind{"G1", testing::inject_g1}, FaultKind{"G2", testing::inject_g2},
                                           FaultKind{"G3", testing::inject_g3}, FaultKind{"G4", testing::inject_g4},
                                           FaultKind{"G5", testing::inject_g5}, FaultKind{"G6", testing::inject_g6},
                                           FaultKind{"G7", testing::inject_g7}, FaultKind{"G8", testing::inject_g8},
                                           FaultKind{"G9", testing::inject_g9}, FaultKind{"S1", testing::inject_s1},
                                           FaultKind{"S2", testing::inject_s2}, FaultKind{"S3", testing::inject_s3},
                                           FaultKind{"S4", testing::inject_s4}, FaultKind{"S5", testing::inject_s5},
                                           FaultKind{"S6", testing::inject_s6}, FaultKind{"D1", testing::inject_d1},
                                           FaultKind{"D2", testing::inject_d2}),
                         [](const ::testing::TestParamInfo<FaultKind>& kind) { return std::string(kind.param.code); });

/// One bit of one array of a scene that was checked; all hashes of the file fit again, but not the certificate's.
TEST(ChangedScenes, AreRefusedOrDifferFromTheirModel) {
    const std::uint32_t wanted = campaign_size();
    std::uint32_t refused = 0, found = 0, other = 0, several = 0;
    for (std::uint64_t seed = 0; seed < wanted; ++seed) {
        plans::Random random{0xD3, seed, campaign_series()};
        const Building convex = convexify(build(testing::random_office(random)));
        const accel::Scene scene = export_scene(convex, check(convex), "{}");
        std::vector<accel::SceneArray> arrays;
        for (const accel::SceneArray& array : scene.arrays())
            if (array.group != accel::Group::Certificate && !array.bytes.empty()) arrays.push_back(array);
        const accel::SceneArray& array = arrays[random.below(std::uint32_t(arrays.size()))];
        const std::size_t at = random.below(std::uint32_t(array.bytes.size()));
        const auto flip = std::byte(1u << random.below(8));
        try {
            const Certification certification =
                certify(testing::changed(scene, array.name, [&](std::byte* data, std::size_t) { data[at] ^= flip; }));
            std::uint32_t d3 = 0;
            for (const Finding& finding : certification.report->findings) d3 += finding.code == "D3";
            found += d3 > 0;
            several += d3 > 1;
            // A change of the model is a fault of its own besides; one of the scene is D3 alone.
            const bool alone = d3 == std::size_t(std::count_if(
                                         certification.report->findings.begin(), certification.report->findings.end(),
                                         [](const Finding& f) { return f.severity != Severity::Note; }));
            other += !alone && array.group == accel::Group::Trace;
            EXPECT_EQ(d3, 1u) << "seed " << seed << ", " << array.name << '[' << at << ']';
            EXPECT_TRUE(certification.verdict.starts_with("differs")) << certification.verdict;
        } catch (const InputError&) {
            ++refused;
        }
    }
    EXPECT_EQ(refused + found, wanted);
    EXPECT_EQ(other, 0u);
    std::cout << "campaign | D3 | " << wanted << " | " << found << " and " << refused << " refused | " << other
              << " | not measured | " << several << " |\n";
}

TEST(SoundBuildings, HaveNoFindings) {
    const std::uint32_t count = campaign_size();
    std::uint32_t alarms = 0;
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        plans::Random random{0x50D, seed, campaign_series()};
        const CheckReport report = check(testing::random_building(random));
        std::string text;
        for (const Finding& finding : report.findings)
            if (!finding.code.starts_with('P') || finding.severity == Severity::Error)
                text += finding.code + ": " + finding.sentence + "\n";
        alarms += !text.empty();
        if (!text.empty() && alarms <= 5) ADD_FAILURE() << "seed " << seed << ":\n" << text;
    }
    EXPECT_EQ(alarms, 0u);
    std::cout << "sound | " << count << " | " << alarms << " |\n";
}

}  // namespace
}  // namespace enfilade::modeler

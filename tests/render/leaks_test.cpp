// No ray leaks: 10^7 of every family here, 10^9 by hand (tools/campaign.sh rays).
#include <gtest/gtest.h>

#include <iostream>
#include <mutex>
#include <thread>

#include "accel/assemble.h"
#include "tests/support/campaign_scenes.h"
#include "tests/support/ray_census.h"

namespace enfilade::render {
namespace {

TEST(Leaks, AreNone) {
    constexpr std::uint64_t rows = 14 * 3;  // families and tracers
    const std::uint64_t count = test::asked("ENFILADE_RAYS", 10'000'000);
    const std::uint64_t series = test::asked("ENFILADE_RAYS_SERIES", 0);
    const bool is_campaign = std::getenv("ENFILADE_RAYS") != nullptr;
    const std::vector<test::CampaignScene> all = test::campaign_scenes(is_campaign);
    const std::uint64_t of_each = count / (rows * all.size()) + 1;
    const unsigned thread_count = is_campaign ? std::max(1u, std::thread::hardware_concurrency()) : 1;
    test::RayCensus census;
    std::mutex mutex;
    std::vector<std::thread> threads;
    for (unsigned t = 0; t < thread_count; ++t)
        threads.emplace_back([&, t] {
            for (const test::CampaignScene& one : all) {
                const test::StreamJudge judge(one.scene.view());
                test::RayCensus part;
                test::take_census(one.scene.view(), judge, of_each / thread_count + 1, 17 + t + 1000 * series,
                                  is_campaign ? 500 : 50, part);
                const std::lock_guard lock(mutex);
                for (auto& [key, row] : part)
                    if (!row.fault.empty()) row.fault += ", in " + one.name;
                test::add(census, part);
            }
        });
    for (std::thread& thread : threads) thread.join();
    if (is_campaign) std::cout << test::text_of(census);
    std::uint64_t rays = 0;
    for (const auto& [key, row] : census) {
        EXPECT_EQ(row.leaks, 0u) << key.first << ", " << key.second << ": " << row.fault;
        EXPECT_EQ(row.outside_band, 0u) << key.first << ", " << key.second << ": " << row.fault;
        rays += row.rays;
    }
    EXPECT_GE(rays, count);
}

// A census that finds nothing is none: a scene whose portals lead back to where they come from.
TEST(Leaks, AreCounted) {
    accel::SceneInput input = test::synthetic_corridor(2);
    const accel::Scene sound = accel::assemble(input);
    std::vector<accel::SideFace> faces(sound.view().side_faces.begin(), sound.view().side_faces.end());
    for (accel::SideFace& face : faces)  // every way out of the first room leads into it
        if (!face.target.is_portal()) face.target = accel::Target::portal(accel::PortalKind::Clear, 0);
    accel::SceneView view = sound.view();
    view.side_faces = {faces.data(), faces.size()};
    const test::StreamJudge judge(sound.view());
    test::RayCensus census;
    test::take_census(view, judge, 100, 1, 10, census);
    EXPECT_GT((census[{"random", "scalar"}].leaks), 10u);
    EXPECT_GT((census[{"random", "simd"}].leaks), 10u);
}

}  // namespace
}  // namespace enfilade::render

#include "plans/generate.h"

#include <gtest/gtest.h>

#include <set>

#include "base/error.h"
#include "plans/layout.h"
#include "plans/read.h"

namespace enfilade::plans {
namespace {

std::size_t rooms_in(const Plan& plan) {
    std::size_t count = 0;
    for (const Storey& storey : plan.storeys)
        for (const Room& room : storey.rooms) count += room.kind != "courtyard" && room.kind != "terrace";
    return count;
}

TEST(Generate, TheSameOptionsGiveTheSamePlan) {
    const GenerateOptions options{.rooms = 60, .storeys = 2, .curved = 0.3, .oblique = 0.3, .seed = 9};
    EXPECT_EQ(write_json(generate(options)), write_json(generate(options)));
}

TEST(Generate, AnotherSeedGivesAnotherPlan) {
    EXPECT_NE(write_json(generate({.rooms = 60, .seed = 1})), write_json(generate({.rooms = 60, .seed = 2})));
}

TEST(Generate, MakesAsManyRoomsAsAskedAndAllOfThemAreFound) {
    for (const std::uint32_t rooms : {1u, 2u, 7u, 46u, 135u, 1000u})
        for (const std::uint32_t storeys : {1u, 3u}) {
            if (rooms < storeys) continue;
            const Plan plan =
                generate({.rooms = rooms, .storeys = storeys, .curved = 0.2, .oblique = 0.2, .seed = rooms});
            EXPECT_EQ(rooms_in(plan), rooms) << rooms << " rooms on " << storeys;
            const Plan cleaned = clean(plan);
            EXPECT_TRUE(cleaned.findings.empty()) << cleaned.findings[0].sentence;
            const Layout layout = arrange(cleaned);
            std::size_t found = 0;
            for (const StoreyLayout& storey : layout.storeys) found += storey.rooms.size();
            EXPECT_EQ(found, rooms) << rooms << " rooms on " << storeys;
            for (const Finding& finding : layout.findings)
                EXPECT_EQ(finding.severity, Severity::Note) << finding.sentence;
        }
}

TEST(Generate, CurvesAndTurnsWallsByTheirShares) {
    const Plan plan = generate({.rooms = 400, .curved = 0.5, .oblique = 0.4, .seed = 3});
    std::size_t curved = 0, oblique = 0;
    for (const Wall& wall : plan.storeys[0].walls) {
        curved += wall.arc_extent != 0;
        oblique += wall.arc_extent == 0 && wall.start.x != wall.end.x && wall.start.y != wall.end.y;
    }
    EXPECT_GT(curved, 50u);
    EXPECT_GT(oblique, 50u);
}

TEST(Generate, RefusesToMakeNothing) { EXPECT_THROW((void)generate({.rooms = 0}), InputError); }

}  // namespace
}  // namespace enfilade::plans

#include "tools/report/passages.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/report/faulty_building.h"

namespace enfilade::tools {
namespace {

std::map<PassageKind, int> kinds(const Passages& passages) {
    std::map<PassageKind, int> count;
    for (const Passage& passage : passages.list) ++count[passage.kind];
    return count;
}

std::uint32_t space_of(const modeler::Building& building, const std::string& id) {
    for (std::uint32_t s = 0; s < building.spaces.size(); ++s)
        if (building.spaces[s].id == id) return s;
    ADD_FAILURE() << "no space " << id;
    return 0;
}

TEST(Passages, DoorsAndWindowsJoinWhatTheyStandBetween) {
    const modeler::Building building = testing::cells_of(testing::two_rooms());
    const PlanView view(building);
    const Passages passages = find_passages(view);
    EXPECT_EQ(kinds(passages), (std::map<PassageKind, int>{{PassageKind::Door, 2}, {PassageKind::Window, 1}}));
    for (const Passage& passage : passages.list) {
        const std::string& id = view.space(passage.space).id;
        EXPECT_EQ(passage.from == modeler::exterior_space, id != "inner door") << id;
        EXPECT_EQ(view.space(passage.to).label, modeler::Label::Room) << id;
    }
}

TEST(Passages, RoomsAreAsDeepAsTheDoorsBeforeThem) {
    const modeler::Building building = testing::cells_of(testing::two_rooms());
    const Passages passages = find_passages(PlanView(building));
    std::multiset<std::uint32_t> depths;
    for (std::uint32_t s = 0; s < building.spaces.size(); ++s)
        if (building.spaces[s].label == modeler::Label::Room) depths.insert(passages.depth[s]);
    EXPECT_EQ(depths, (std::multiset<std::uint32_t>{1, 2}));
}

TEST(Passages, AWindowIsNoWayIn) {
    plans::Plan plan = testing::two_rooms();
    std::erase_if(plan.storeys[0].openings, [](const plans::Opening& o) { return o.kind == plans::OpeningKind::Door; });
    const modeler::Building building = testing::cells_of(plan);
    const Passages passages = find_passages(PlanView(building));
    for (std::uint32_t s = 0; s < building.spaces.size(); ++s)
        if (building.spaces[s].label == modeler::Label::Room) {
            EXPECT_EQ(passages.depth[s], unreachable);
        }
}

TEST(Passages, AStairLeadsUpThroughItsSlab) {
    const modeler::Building building = testing::cells_of(testing::two_storeys());
    const PlanView view(building);
    const Passages passages = find_passages(view);
    int stairs = 0;
    for (const Passage& passage : passages.list) {
        if (passage.kind != PassageKind::Stair) continue;
        ++stairs;
        EXPECT_EQ(passage.storey, 0u);
        EXPECT_EQ(passage.from, space_of(building, "stair"));
        EXPECT_EQ(view.space(passage.to).storey, 1u);
    }
    EXPECT_EQ(stairs, 1);
}

TEST(Passages, RoomsWithoutAWallBetweenThemBorder) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].rooms.push_back({"a", "A", "room", {{0, 0}, {2, 0}, {2, 3}, {0, 3}}});
    plan.storeys[0].rooms.push_back({"b", "B", "room", {{2, 0}, {4, 0}, {4, 3}, {2, 3}}});
    const modeler::Building building = testing::cells_of(plan);
    EXPECT_EQ(kinds(find_passages(PlanView(building)))[PassageKind::Border], 1);
}

}  // namespace
}  // namespace enfilade::tools

#include "modeler/lighting/moved_lamps.h"

#include <gtest/gtest.h>

#include <numbers>

namespace enfilade::modeler {
namespace {

Furnishing furnishing(std::vector<FurnishedObject> objects) {
    Furnishing result;
    result.objects = std::move(objects);
    return result;
}

FurnishedObject piece(const std::string& id) { return {.id = id, .position = {1, 2, 0}, .size = {0.4, 0.4, 1.6}}; }

const std::vector<Lamp> lamps = {{.id = "a", .position = {1.1, 2, 1.2}, .carrier = "lamp"},
                                 {.id = "b", .position = {1.1, 2, 1.2}},
                                 {.id = "c", .position = {5, 5, 1}, .carrier = "absent"}};

TEST(MovedLamps, StayWhereNothingMoves) {
    EXPECT_EQ(moved_lamps(lamps, furnishing({piece("lamp")}), furnishing({piece("lamp")})), lamps);
}

TEST(MovedLamps, GoWithTheirPieceAndTurnWithIt) {
    FurnishedObject moved = piece("lamp");
    moved.position = {4, 4, 0.5};
    moved.angle = std::numbers::pi / 2;
    const auto after = moved_lamps(lamps, furnishing({piece("lamp")}), furnishing({moved}));
    ASSERT_EQ(after.size(), 3u);
    EXPECT_NEAR(after[0].position[0], 4, 1e-12);
    EXPECT_NEAR(after[0].position[1], 4.1, 1e-12);
    EXPECT_NEAR(after[0].position[2], 1.7, 1e-12);
    EXPECT_EQ(after[1], lamps[1]);
    EXPECT_EQ(after[2], lamps[2]);
}

TEST(MovedLamps, MirrorAndGrowWithTheirPiece) {
    FurnishedObject changed = piece("lamp");
    changed.mirrored = true;
    changed.size = {0.8, 0.4, 0.8};
    const auto after = moved_lamps(lamps, furnishing({piece("lamp")}), furnishing({changed}));
    EXPECT_NEAR(after[0].position[0], 0.8, 1e-12);
    EXPECT_NEAR(after[0].position[2], 0.6, 1e-12);
    const auto back = moved_lamps(after, furnishing({changed}), furnishing({piece("lamp")}));
    EXPECT_NEAR(back[0].position[0], 1.1, 1e-12);
}

TEST(MovedLamps, LeaveWithTheirPiece) {
    const auto after =
        moved_lamps(lamps, furnishing({piece("lamp"), piece("sofa")}), furnishing({piece("sofa"), piece("bed")}));
    ASSERT_EQ(after.size(), 2u);
    EXPECT_EQ(after[0].id, "b");
    EXPECT_EQ(after[1].id, "c");
}

}  // namespace
}  // namespace enfilade::modeler

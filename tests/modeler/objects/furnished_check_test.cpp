// S6 for objects that a rule has placed.

#include <gtest/gtest.h>

#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/objects/plan_objects.h"
#include "modeler/objects/put_objects.h"
#include "plans/read.h"
#include "tests/support/furnished_scenes.h"

namespace enfilade::modeler {
namespace {

/// Two rooms of 4 m x 5 m side by side, a door between them in the middle of their wall.
Building two_rooms(const std::string& more_walls = "") {
    return convexify(build(plans::read_json(R"({"storeys": [{"id": "g", "elevation": 0, "height": 2.5,
        "walls": [{"id": "s", "start": [0, 0], "end": [8, 0], "thickness": 0.2},
                  {"id": "e", "start": [8, 0], "end": [8, 5], "thickness": 0.2},
                  {"id": "n", "start": [8, 5], "end": [0, 5], "thickness": 0.2},
                  {"id": "w", "start": [0, 5], "end": [0, 0], "thickness": 0.2},
                  {"id": "m", "start": [4, 0], "end": [4, 5], "thickness": 0.2})" +
                                                more_walls +
                                                R"(],
        "openings": [{"id": "door", "kind": "door", "wall": "m", "offset": 2.5, "width": 0.9}],
        "rooms": [{"id": "left", "name": "Left", "polygon": [[0.2, 0.2], [3.8, 0.2], [3.8, 4.8], [0.2, 4.8]]},
                  {"id": "right", "name": "Right", "polygon": [[4.2, 0.2], [7.8, 0.2], [7.8, 4.8], [4.2, 4.8]]}]}]})",
                                            "two rooms")));
}

class FurnishedCheck : public ::testing::Test {
protected:
    FurnishedObject object(const std::string& id, double x, double y, double z = 0) {
        FurnishedObject made;
        made.id = made.name = id;
        made.space = space_at(bare_, 1, 1, 1);
        made.position = {x, y, z};
        made.size = {1, 0.6, 0.8};
        made.by_rule = true;
        return made;
    }

    /// The sentences of errors S6, in either way of knowing objects.
    std::vector<std::string> faults(std::vector<FurnishedObject> objects) {
        std::vector<std::string> both[2];
        for (const ObjectCells cells : {ObjectCells::List, ObjectCells::Cut}) {
            Furnishing furnishing{{test::test_meshes()[0]}, objects, cells};
            std::vector<Finding> findings;
            const CheckReport report = check(put_objects(bare_, furnishing, findings));
            for (const Finding& finding : report.findings) {
                if (finding.severity != Severity::Error) continue;
                EXPECT_EQ(finding.code, "S6") << finding.sentence;
                both[int(cells)].push_back(finding.sentence);
            }
        }
        EXPECT_EQ(both[0], both[1]);
        return both[0];
    }

    Building bare_ = two_rooms();
};

TEST_F(FurnishedCheck, FindsNothingWhereAllStandsWell) {
    FurnishedObject lamp = object("lamp", 1, 1, 0.8);
    lamp.stands_on = "desk";
    FurnishedObject flush = object("flush", 0.6, 4.6);
    EXPECT_TRUE(faults({object("desk", 1, 1), lamp, object("other", 2.2, 1), flush}).empty());
}

TEST_F(FurnishedCheck, LetsPiecesStandOnRugsButNotInTables) {
    FurnishedObject rug = object("rug", 1.2, 1.2), table = object("table", 1.2, 1.2);
    rug.size = {2, 1.6, 0.015};
    EXPECT_TRUE(faults({rug, object("desk", 1, 1)}).empty());
    EXPECT_EQ(faults({table, object("desk", 1, 1)}).size(), 1u);
}

TEST_F(FurnishedCheck, KeepsNothingFreeBeforeADoorThatAnotherWallCloses) {
    const FurnishedObject shelf = object("shelf", 3.2, 2.5);
    EXPECT_EQ(faults({shelf}).size(), 1u);
    bare_ = two_rooms(R"(, {"id": "front", "start": [3.88, 0], "end": [3.88, 5], "thickness": 0.04})");
    EXPECT_TRUE(faults({shelf}).empty());
}

TEST_F(FurnishedCheck, NamesTheWallThatAnObjectStandsIn) {
    const auto found = faults({object("shelf", 1, 0.3)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0], "\"shelf\" leaves the room \"Left\" into the wall \"s\".");
}

TEST_F(FurnishedCheck, NamesTheSlabThatAnObjectStandsIn) {
    const auto found = faults({object("lamp", 1, 1, 2)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].find("\"lamp\" leaves the room \"Left\" into the slab"), std::string::npos) << found[0];
}

TEST_F(FurnishedCheck, NamesBothOfTwoThatOverlap) {
    const auto found = faults({object("desk", 1, 1), object("chair", 1.2, 1.5)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0], "\"desk\" stands 100 mm in \"chair\".");
}

TEST_F(FurnishedCheck, NamesTheDoorInWhoseWayAnObjectStands) {
    const auto found = faults({object("sofa", 3.3, 2.5)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0], "\"sofa\" stands in the way of door \"door\".");
}

TEST_F(FurnishedCheck, WhatThePlanPlacedIsNoFault) {
    FurnishedObject sofa = object("sofa", 3.3, 2.5), shelf = object("shelf", 1, 0.3);
    sofa.by_rule = shelf.by_rule = false;
    EXPECT_TRUE(faults({sofa, shelf}).empty());
    EXPECT_EQ(faults({shelf, object("chair", 1, 0.7)}).size(), 1u) << "but others keep away from it";
}

}  // namespace
}  // namespace enfilade::modeler

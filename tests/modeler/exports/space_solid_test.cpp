// The shells of rooms, walls and doors: closed, and exactly as large as their volumes.

#include "modeler/exports/space_solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/modeler/exports/exports_fixture.h"

namespace enfilade::test {
namespace {

using modeler::Building;
using modeler::Label;
using modeler::SolidFace;
using modeler::SolidFaceKind;
using modeler::SpaceSolid;
using modeler::SpaceSolids;

const std::vector<Label> all_labels = {Label::Room,   Label::Wall,    Label::Slab,  Label::Door,
                                       Label::Window, Label::Opening, Label::Stair, Label::Shaft};

/// Edges that are not run once each way.
std::size_t open_edges(const SpaceSolid& solid) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> runs;
    const auto add = [&](const std::vector<std::uint32_t>& ring) {
        for (std::size_t k = 0; k < ring.size(); ++k) ++runs[{ring[k], ring[(k + 1) % ring.size()]}];
    };
    for (const SolidFace& face : solid.faces) {
        add(face.outer);
        for (const auto& hole : face.holes) add(hole);
    }
    return std::size_t(std::count_if(runs.begin(), runs.end(), [&](const auto& run) {
        const auto back = runs.find({run.first.second, run.first.first});
        return run.second != 1 || back == runs.end() || back->second != 1;
    }));
}

/// Six times the volume, in cubic grid units, by the divergence theorem over fans of the rings.
double volume6(const SpaceSolids& solids, const SpaceSolid& solid) {
    double sum = 0;
    const auto& origin = solids.vertices[solid.faces[0].outer[0]];
    const auto add = [&](const std::vector<std::uint32_t>& ring) {
        for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
            double p[3][3];
            const std::uint32_t corner[3] = {ring[0], ring[k], ring[k + 1]};
            for (int i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j) p[i][j] = double(solids.vertices[corner[i]][j]) - origin[j];
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
                sum += p[0][i] * (p[1][j] * p[2][l] - p[2][j] * p[1][l]);
            }
        }
    };
    for (const SolidFace& face : solid.faces) {
        add(face.outer);
        for (const auto& hole : face.holes) add(hole);
    }
    return sum;
}

void expect_sound(const Building& model) {
    const SpaceSolids solids = modeler::space_solids(model, all_labels);
    EXPECT_GT(solids.solids.size(), 3u);
    for (const SpaceSolid& solid : solids.solids) {
        const modeler::SpacePart& part = solids.parts[solid.part];
        ASSERT_EQ(open_edges(solid), 0u) << model.spaces[part.space].id;
        const double unit = model.frame.unit;
        const double expected = modeler::area_m2(model, part) * (part.z_high - part.z_low) * unit;
        EXPECT_NEAR(volume6(solids, solid) / 6 * unit * unit * unit, expected, 1e-3 * expected)
            << model.spaces[part.space].id;
    }
}

SpaceSolids solids_of(const BuiltPlan& plan, Label label) { return modeler::space_solids(plan.model, {label}); }

TEST(SpaceSolid, ARoomWithADoorHasSixSidesAndTheDoor) {
    const BuiltPlan plan = built(testing::one_room());
    const SpaceSolids solids = solids_of(plan, Label::Room);
    ASSERT_EQ(solids.solids.size(), 1u);
    const SpaceSolid& room = solids.solids[0];
    EXPECT_EQ(room.faces.size(), 7u);
    EXPECT_EQ(std::count_if(room.faces.begin(), room.faces.end(),
                            [](const SolidFace& f) { return f.behind != SolidFace::solid; }),
              1);
    // The wall around the door: its notch has four more corners than a rectangle.
    EXPECT_EQ(
        std::count_if(room.faces.begin(), room.faces.end(), [](const SolidFace& f) { return f.outer.size() == 8; }), 1);
    // Eight corners of the room, four of the door.
    EXPECT_EQ(solids.vertices.size(), 12u);
}

TEST(SpaceSolid, AWindowIsAHoleInItsWall) {
    const BuiltPlan plan = built(testing::two_rooms());
    std::size_t holes = 0;
    for (const SpaceSolid& room : solids_of(plan, Label::Room).solids)
        for (const SolidFace& face : room.faces) {
            if (face.kind != SolidFaceKind::Side) continue;
            holes += face.holes.size();
            for (const auto& hole : face.holes) EXPECT_EQ(hole.size(), 4u);
        }
    EXPECT_EQ(holes, 1u);
}

TEST(SpaceSolid, AColumnIsAHoleInFloorAndCeiling) {
    const BuiltPlan plan = built(testing::ring_room());
    const SpaceSolids solids = solids_of(plan, Label::Room);
    for (const SolidFace& face : solids.solids[0].faces)
        EXPECT_EQ(face.holes.size(), face.kind == SolidFaceKind::Side ? 0u : 1u);
}

TEST(SpaceSolid, AStairwellOpensToTheStoreyAbove) {
    const BuiltPlan plan = built(testing::two_storeys());
    const SpaceSolids solids = solids_of(plan, Label::Stair);
    ASSERT_EQ(solids.solids.size(), 2u) << "the flight and the hole in the slab";
    const SpaceSolid& flight = solids.solids[0];
    for (const SolidFace& face : flight.faces) {
        if (face.kind == SolidFaceKind::Side) continue;
        EXPECT_EQ(face.behind == SolidFace::solid, face.kind == SolidFaceKind::Floor);
    }
}

TEST(SpaceSolid, ShellsOfSmallPlansAreClosed) {
    for (const plans::Plan& plan :
         {testing::one_room(), testing::two_rooms(), testing::ring_room(), testing::two_storeys()})
        expect_sound(built(plan).model);
}

TEST(SpaceSolid, ShellsOfTheTownhouseAreClosed) { expect_sound(built(example("townhouse.json")).model); }
TEST(SpaceSolid, ShellsOfTheOfficeAreClosed) { expect_sound(built(example("office-46.json")).model); }

TEST(SpaceSolid, WholeRoomsAndTheirConvexPiecesHaveTheSameShells) {
    const Building whole = modeler::build(testing::ring_room());
    const Building pieces = modeler::convexify(whole);
    const SpaceSolids a = modeler::space_solids(whole, {Label::Room});
    const SpaceSolids b = modeler::space_solids(pieces, {Label::Room});
    ASSERT_EQ(a.solids.size(), b.solids.size());
    EXPECT_EQ(a.solids[0].faces.size(), b.solids[0].faces.size());
    EXPECT_EQ(a.vertices.size(), b.vertices.size());
}

}  // namespace
}  // namespace enfilade::test

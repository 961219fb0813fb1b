#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "base/error.h"
#include "plans/read.h"
#include "tests/support/random_plan.h"

namespace enfilade::plans {
namespace {

/// A plan of one storey with these members after its id.
std::string storey_with(const std::string& members) {
    return "{\"storeys\": [\n{\"id\": \"g\"" + (members.empty() ? "" : ",\n" + members) + "}]}";
}
const std::string one_wall = R"("walls": [{"id": "w", "start": [0, 0], "end": [4, 0]}])";

InputError refusal(const std::string& text) {
    try {
        (void)read_json(text, "plan.json");
    } catch (const InputError& error) {
        return error;
    }
    return {"none", "", "nothing was refused"};
}

struct Complaint {
    const char* what;
    std::string text;
    const char* code;
    int line;
    const char* says;
};
void PrintTo(const Complaint& complaint, std::ostream* out) { *out << complaint.what; }

class Refused : public ::testing::TestWithParam<Complaint> {};

TEST_P(Refused, WithItsPlace) {
    const Complaint& expected = GetParam();
    const InputError error = refusal(expected.text);
    EXPECT_EQ(error.code, expected.code) << error.what();
    EXPECT_EQ(error.line, expected.line) << error.what();
    EXPECT_GT(error.column, 0);
    EXPECT_EQ(error.file, "plan.json");
    EXPECT_NE(std::string(error.what()).find(expected.says), std::string::npos) << error.what();
}

INSTANTIATE_TEST_SUITE_P(
    JsonPlan, Refused,
    ::testing::Values(
        Complaint{"an unknown key", storey_with(R"("walls": [{"start": [0, 0], "end": [1, 0], "thicknes": 1}])"),
                  "P102", 3, "thickness"},
        Complaint{"a power said twice",
                  storey_with("\"lights\": [{\"position\": [1, 1],\n\"power_lumen\": 5, \"intensity_candela\": 5}]"),
                  "P105", 4, "keep one"},
        Complaint{"a negative power", storey_with(R"("lights": [{"position": [1, 1], "power_lumen": -1}])"), "P105", 3,
                  "power_lumen"},
        Complaint{"more light than there is",
                  storey_with(R"("lights": [{"position": [1, 1], "intensity_candela": 1e9}])"), "P105", 3,
                  "intensity_candela"},
        Complaint{"a texture without a size",
                  storey_with(R"("walls": [{"start": [0, 0], "end": [1, 0], "left_texture": {"picture": "a.png"}}])"),
                  "P104", 3, "width"},
        Complaint{"a text for a number", storey_with(R"("height": "high")"), "P103", 3, "height"},
        Complaint{"a missing key", storey_with(R"("walls": [{"start": [0, 0]}])"), "P104", 3, "end"},
        Complaint{"a negative thickness",
                  storey_with(R"("walls": [{"start": [0, 0], "end": [1, 0], "thickness": -1}])"), "P105", 3,
                  "thickness"},
        Complaint{"a number beyond all measure", storey_with(R"("walls": [{"start": [0, 1e308], "end": [1, 0]}])"),
                  "P105", 3, ""},
        Complaint{
            "the same id twice",
            storey_with(
                R"("walls": [{"id": "w", "start": [0, 0], "end": [1, 0]}, {"id": "w", "start": [0, 0], "end": [1, 1]}])"),
            "P106", 3, "w"},
        Complaint{"a door in no wall", storey_with(R"("openings": [{"wall": "nowhere", "offset": 1}])"), "P107", 3,
                  "nowhere"},
        Complaint{"a text cut short", "{\"storeys\": [\n{\"id\": \"g\",", "P101", 2, ""},
        Complaint{"NaN", storey_with(R"("height": NaN)"), "P101", 3, ""},
        Complaint{"a mesh that is not turned but flattened", storey_with(R"("furniture": [{"position": [0, 0],
"model_rotation": [1, 0, 0, 0, 1, 0, 0, 0, 0]}])"),
                  "P105", 4, "model_rotation"},
        Complaint{"two sizes", storey_with(R"("furniture": [{"position": [0, 0], "model_size": [1, 1]}])"), "P103", 3,
                  "3 numbers"},
        Complaint{"a size of nothing", storey_with(R"("furniture": [{"position": [0, 0], "model_size": [1, 1, 0]}])"),
                  "P105", 3, "model_size"},
        Complaint{"an unknown kind", storey_with(one_wall + R"(,
"openings": [{"wall": "w", "offset": 1, "kind": "gate"}])"),
                  "P105", 4, "kind"}));

TEST(JsonPlan, BoundsItsNesting) {
    const std::string deep(100000, '[');
    EXPECT_EQ(refusal(deep).code, "P101");
}

TEST(JsonPlan, AllowsComments) {
    const Plan plan = read_json("// a house\n{\"storeys\": [ /* one */ {\"id\": \"g\"}]}", "plan.json");
    EXPECT_EQ(plan.storeys.size(), 1u);
}

TEST(JsonPlan, TakesHeightsFromTheStorey) {
    const Plan plan = read_json(storey_with("\"height\": 3,\n" + one_wall), "plan.json");
    EXPECT_EQ(plan.storeys[0].walls[0].height_at_start, 3);
    EXPECT_EQ(plan.storeys[0].walls[0].height_at_end, 3);
}

TEST(JsonPlan, ReadsOtherUnits) {
    const Plan plan = read_json(
        R"({"units": "ft", "storeys": [{"id": "g", "walls": [{"start": [0, 0], "end": [10, 0]}]}]})", "plan.json");
    EXPECT_NEAR(plan.storeys[0].walls[0].end.x, 3.048, 1e-12);
}

TEST(JsonPlan, MakesCirclesPolygons) {
    const Plan plan = read_json(
        storey_with(R"("columns": [{"circle": {"centre": [1, 2], "radius": 0.5, "sides": 16}}])"), "plan.json");
    ASSERT_EQ(plan.storeys[0].columns[0].polygon.size(), 16u);
    for (const Point& corner : plan.storeys[0].columns[0].polygon)
        EXPECT_NEAR(std::hypot(corner.x - 1, corner.y - 2), 0.5, 1e-12);
}

TEST(JsonPlan, ReadsHowFurnitureIsTurned) {
    const Plan plan = read_json(R"({"storeys": [{"elevation": 0, "height": 2.5, "furniture": [
        {"position": [1, 2], "model": "a", "catalogue": "b", "model_rotation": [0, -1, 0, 1, 0, 0, 0, 0, 1],
         "model_size": [1, 2, 3], "pitch_deg": 90, "roll": 0.5, "materials": [{"name": "wood", "colour": [1, 0, 0]}]}]}]})",
                                "");
    const Furniture& piece = plan.storeys.at(0).furniture.at(0);
    EXPECT_EQ(piece.catalogue, "b");
    EXPECT_EQ(piece.model_rotation, (std::array<double, 9>{0, -1, 0, 1, 0, 0, 0, 0, 1}));
    EXPECT_EQ(piece.model_size, (std::array<double, 3>{1, 2, 3}));
    EXPECT_DOUBLE_EQ(piece.pitch, 1.5707963267948966);
    EXPECT_EQ(piece.materials.at(0), (FurnitureMaterial{"wood", {1, 0, 0}}));
    const std::string text = write_json(plan);
    EXPECT_EQ(write_json(read_json(text, "")), text);
}

TEST(JsonPlan, ReadsTexturesOfWallsAndRooms) {
    const Plan plan = read_json(storey_with(R"("walls": [{"id": "w", "start": [0, 0], "end": [400, 0], "right_texture":
                       {"picture": "wood/oak.jpg", "width": 60, "height": 40, "angle_deg": 90, "offset": [0.5, -0.25]}}],
                       "rooms": [{"id": "r", "polygon": [[0, 0], [400, 0], [400, 400]],
                       "floor_texture": {"picture": "tiles.png", "width": 30, "height": 30}}])")
                                    .insert(1, R"("units": "cm", )"),
                                "plan.json");
    const Storey& storey = plan.storeys.at(0);
    const SurfaceTexture oak = storey.walls.at(0).right_texture.value();
    EXPECT_EQ(oak.picture, "wood/oak.jpg");
    EXPECT_DOUBLE_EQ(oak.width, 0.6);
    EXPECT_DOUBLE_EQ(oak.height, 0.4);
    EXPECT_NEAR(oak.angle, std::numbers::pi / 2, 1e-12);
    EXPECT_DOUBLE_EQ(oak.offset_x, 0.5);
    EXPECT_DOUBLE_EQ(oak.offset_y, -0.25);
    EXPECT_FALSE(storey.walls.at(0).left_texture);
    EXPECT_EQ(storey.rooms.at(0).floor_texture, (SurfaceTexture{"tiles.png", 0.3, 0.3}));
    const Plan again = read_json(write_json(plan), "again.json");
    EXPECT_EQ(again.storeys.at(0).walls.at(0).right_texture, oak);
    EXPECT_EQ(again.storeys.at(0).rooms.at(0).floor_texture, storey.rooms.at(0).floor_texture);
}

TEST(JsonPlan, ExamplesRoundTrip) {
    for (const char* name : {"townhouse", "office-46", "office-135"}) {
        std::ifstream file(std::string(ENFILADE_SOURCE_DIR "/plans/examples/") + name + ".json");
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const std::string once = write_json(read_json(text, name));
        EXPECT_EQ(write_json(read_json(once, name)), once) << name;
    }
}

TEST(JsonPlan, TheExampleOfItsPageIsRead) {
    std::ifstream file(ENFILADE_SOURCE_DIR "/docs/plan.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    const std::size_t begin = page.find("```json\n") + 8;
    const Plan plan = clean(read_json(page.substr(begin, page.find("```", begin) - begin), "plan.md"));
    EXPECT_EQ(plan.storeys[0].walls.size(), 4u);
    EXPECT_TRUE(plan.findings.empty());
}

RC_GTEST_PROP(JsonPlan, AnyPlanRoundTrips, ()) {
    const std::string once = write_json(enfilade::testing::any_plan());
    RC_ASSERT(write_json(read_json(once, "again")) == once);
}

RC_GTEST_PROP(JsonPlan, DamagedTextIsReadOrRefused, ()) {
    std::string text = write_json(enfilade::testing::any_plan());
    const int changes = *rc::gen::inRange(1, 6);
    for (int k = 0; k < changes; ++k)
        text[*rc::gen::inRange<std::size_t>(0, text.size())] = *rc::gen::arbitrary<char>();
    try {
        (void)read_json(text, "damaged");
    } catch (const InputError& error) {
        RC_ASSERT(error.line > 0);
    }
}

TEST(JsonPlan, ReadsTheLightOfLampsInLumenOrCandela) {
    const Plan plan = read_json(storey_with(R"("lights": [
        {"position": [1, 2]},
        {"position": [1, 2], "elevation": 2, "power_lumen": 1250, "colour": "#ff0000"},
        {"position": [-9, 2], "intensity_candela": 100, "radius": 0.25, "furniture": "lamp-1"}])"),
                                "plan.json");
    const auto& lights = plan.storeys.at(0).lights;
    ASSERT_EQ(lights.size(), 3u);
    EXPECT_EQ(lights[0].power_lumen, 800);
    EXPECT_EQ(lights[0].radius, 0);
    EXPECT_EQ(lights[1].power_lumen, 1250);
    EXPECT_EQ(lights[1].colour, (Colour{1, 0, 0}));
    EXPECT_DOUBLE_EQ(lights[2].power_lumen, 400 * std::numbers::pi);
    EXPECT_EQ(lights[2].radius, 0.25);
    EXPECT_EQ(lights[2].furniture, "lamp-1");
    const std::string written = write_json(plan);
    EXPECT_EQ(write_json(read_json(written, "plan.json")), written);
    EXPECT_EQ(read_json(written, "plan.json").storeys[0].lights[2].power_lumen, lights[2].power_lumen);
}

}  // namespace
}  // namespace enfilade::plans

// Drawings made from plans give the plans back.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <filesystem>

#include "plans/generate.h"
#include "tests/plans/dxf/sheet_of_plan.h"

namespace enfilade::plans {
namespace {

using namespace dxf_text;

const Finding* finding_in(const Plan& plan, const std::string& code) {
    for (const Finding& finding : plan.findings)
        if (finding.code == code) return &finding;
    return nullptr;
}

void expect_comes_back(const Plan& plan, const SheetNames& names = {}) {
    const Contents wanted = contents_of(plan);
    const Plan again = read_dxf(sheet_of(plan, names), "sheet.dxf");
    const Contents got = contents_of(again);
    EXPECT_EQ(got, wanted);
    EXPECT_NEAR(got.room_area, wanted.room_area, 0.01 * wanted.room_area);
}

TEST(ReadDxf, GivesGeneratedOfficesBack) {
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
        SCOPED_TRACE(seed);
        expect_comes_back(generate({.rooms = 30, .seed = seed}));
    }
}

TEST(ReadDxf, GivesAnOfficeWithTurnedWallsBack) {
    expect_comes_back(generate({.rooms = 24, .oblique = 0.3, .seed = 7}));
}

TEST(ReadDxf, GivesTheExamplesBackWithTheNamesOfTheirRooms) {
    SheetNames names;
    names.text = "A-AREA-IDEN";
    const Plan plan = read(std::filesystem::path(ENFILADE_SOURCE_DIR) / "plans/examples/office-46.json");
    expect_comes_back(plan, names);
    const Plan again = read_dxf(sheet_of(plan, names), "sheet.dxf");
    const std::vector<Room>& wanted = plan.storeys[0].rooms;
    EXPECT_EQ(again.storeys[0].rooms.size(), wanted.size());
    for (const Room& room : wanted) {
        const auto same = [&](const Room& found) {
            return found.name == room.name && (found.kind == "courtyard") == (room.kind == "courtyard");
        };
        EXPECT_TRUE(std::any_of(again.storeys[0].rooms.begin(), again.storeys[0].rooms.end(), same)) << room.name;
    }
}

TEST(ReadDxf, GivesCurvedWallsDrawnAsFacetsBack) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        SCOPED_TRACE(seed);
        expect_comes_back(generate({.rooms = 24, .curved = 0.3, .seed = seed}));
    }
}

TEST(ReadDxf, GivesAnyOfficeBack) {
    EXPECT_TRUE(rc::check([] {
        const auto rooms = std::uint32_t(*rc::gen::inRange(4, 80));
        const double oblique = *rc::gen::element(0.0, 0.3, 0.6);
        const auto seed = std::uint64_t(*rc::gen::inRange(0, 1000));
        const Plan plan = generate({.rooms = rooms, .oblique = oblique, .seed = seed});
        SheetNames names;
        names.text = "A-AREA-IDEN";
        const Contents found = contents_of(read_dxf(sheet_of(plan, names), "sheet.dxf")), wanted = contents_of(plan);
        RC_LOG() << "found " << found << ", of " << wanted;
        RC_ASSERT(found == wanted);
    }));
}

TEST(ReadDxf, FindsTheUnitWhateverTheFileSays) {
    const Plan plan = generate({.rooms = 20});
    struct Case {
        double scale;
        int insunits;
        const char* code;
    };
    // Millimetres, centimetres, metres, inches: declared rightly (no word about it), not at all, and as millimetres.
    for (const Case& c :
         {Case{1000, 4, ""}, Case{100, 5, ""}, Case{1, 6, ""}, Case{1 / 0.0254, 1, ""}, Case{1000, 0, "P724"},
          Case{1 / 0.0254, 0, "P724"}, Case{1 / 0.0254, 4, "P723"}, Case{1, 4, "P723"}}) {
        SCOPED_TRACE(std::to_string(c.scale) + " units a metre, $INSUNITS " + std::to_string(c.insunits));
        SheetNames names;
        names.scale = c.scale;
        names.insunits = c.insunits;
        expect_comes_back(plan, names);
        const Plan again = read_dxf(sheet_of(plan, names), "sheet.dxf");
        for (const char* code : {"P723", "P724"})
            EXPECT_EQ(finding_in(again, code) != nullptr, std::string(code) == c.code) << code;
    }
}

TEST(ReadDxf, TheUnitOfTheUserOverrulesAll) {
    const Plan plan = generate({.rooms = 6});
    const Plan again = read_dxf(sheet_of(plan), "sheet.dxf", {.unit = Unit::Centimetre});
    ASSERT_FALSE(again.storeys[0].walls.empty());
    // Ten times too large, and no walls of 10 cm any more: what was 5 cm thick is 50.
    EXPECT_EQ(finding_in(again, "P723"), nullptr);
}

TEST(ReadDxf, KnowsTheLayersOfOtherLanguages) {
    const Plan plan = generate({.rooms = 12});
    for (const auto& [wall, door, window] : std::initializer_list<std::array<const char*, 3>>{
             {"Wände", "Türen", "Fenster"},
             {"MURS", "Portes", "Fenêtres"},
             {"xref-house$0$A-WALL", "xref-house$0$A-DOOR", "xref-house$0$A-GLAZ"},
             {"Стены", "Двери", "Окна"},
             {"墙体", "门", "窗"}}) {
        SCOPED_TRACE(wall);
        SheetNames names;
        names.wall = wall;
        names.door = door;
        names.window = window;
        std::string text = sheet_of(plan, names);
        text.insert(0, pairs({{0, "SECTION"}, {2, "HEADER"}, {9, "$ACADVER"}, {1, "AC1021"}, {0, "ENDSEC"}}));
        EXPECT_EQ(contents_of(read_dxf(text, "sheet.dxf")), contents_of(plan));
    }
}

TEST(ReadDxf, FindsTheWallsOnALayerThatIsNotCalledSo) {
    SheetNames names;
    names.wall = "0";
    const Plan plan = generate({.rooms = 12});
    const Plan again = read_dxf(sheet_of(plan, names), "sheet.dxf");
    EXPECT_EQ(contents_of(again), contents_of(plan));
    ASSERT_NE(finding_in(again, "P722"), nullptr);
    EXPECT_NE(finding_in(again, "P722")->sentence.find("\"0\""), std::string::npos);
}

TEST(ReadDxf, RefusesADrawingWithoutWallsAndNamesItsLayers) {
    const std::string text = File{line(0, 0, 100, 0, "trees") + line(0, 50, 30, 80, "trees")}.text();
    try {
        (void)read_dxf(text, "garden.dxf");
        FAIL() << "was read";
    } catch (const InputError& error) {
        EXPECT_EQ(error.code, "P721");
        EXPECT_NE(std::string(error.what()).find("\"trees\" (2)"), std::string::npos) << error.what();
    }
}

TEST(ReadDxf, NamesRoomsByTheTextsInThem) {
    Plan plan = generate({.rooms = 8});
    const Layout layout = arrange(clean(plan));
    std::string text = sheet_of(plan);
    const Room& room = plan.storeys[0].rooms.at(1);
    Point middle{0, 0};
    for (const Point p : room.polygon) middle = middle + p * (1000.0 / double(room.polygon.size()));
    const std::string written =
        entity("TEXT", {{8, "A-NOTE"}, {10, middle.x}, {20, middle.y}, {40, 100}, {1, "Meeting room"}});
    const std::string note =
        entity("TEXT", {{8, "A-NOTE"}, {10, middle.x}, {20, middle.y - 900}, {40, 100}, {1, "see detail"}});
    text.insert(text.rfind("  0\nENDSEC"), written + note);
    const Plan again = read_dxf(text, "sheet.dxf");
    ASSERT_EQ(again.storeys[0].rooms.size(), 1u);
    EXPECT_EQ(again.storeys[0].rooms[0].name, "Meeting room");
}

TEST(ReadDxf, AWindowOnALowWallStandsOnAParapet) {
    // A low wall of 6 m, panes over its middle third, full walls at its ends.
    const std::string text = File{line(0, 0, 6000, 0, "low wall") + line(0, 300, 6000, 300, "low wall") +
                                  line(2000, 100, 4000, 100, "A-GLAZ") + line(2000, 200, 4000, 200, "A-GLAZ") +
                                  line(-300, -3000, -300, 3000, "A-WALL") + line(0, -3000, 0, 3000, "A-WALL") +
                                  line(6000, -3000, 6000, 3000, "A-WALL") + line(6300, -3000, 6300, 3000, "A-WALL")}
                                 .text();
    const Plan plan = read_dxf(text, "terrace.dxf", {.unit = Unit::Millimetre});
    std::size_t low = 0, high = 0;
    for (const Wall& wall : plan.storeys[0].walls) (wall.height_at_start < 2 ? low : high)++;
    EXPECT_EQ(low, 2u);
    EXPECT_EQ(high, 3u);
    ASSERT_EQ(plan.storeys[0].openings.size(), 1u);
    const Opening& window = plan.storeys[0].openings[0];
    EXPECT_EQ(window.kind, OpeningKind::Window);
    EXPECT_NEAR(window.sill, 1.0, 1e-9);
    EXPECT_NEAR(window.head, 2.1, 1e-9);
    EXPECT_NEAR(window.width, 2.0, 1e-6);
}

TEST(ReadDxf, LeavesNoLineUnmentioned) {
    const Plan plan = generate({.rooms = 6});
    std::string text = sheet_of(plan);
    text.insert(text.rfind("  0\nENDSEC"),
                line(-5000, -5000, -9000, -5000, "A-WALL") + line(0, 0, 100, 100, "A-FLOR-STRS"));
    const Plan again = read_dxf(text, "sheet.dxf");
    ASSERT_NE(finding_in(again, "P725"), nullptr);
    EXPECT_NE(finding_in(again, "P725")->sentence.find("1 piece, 4.0 m in all"), std::string::npos);
    ASSERT_TRUE(finding_in(again, "P725")->point.has_value());
    EXPECT_NEAR((*finding_in(again, "P725")->point)[0], -7, 0.01);
    ASSERT_NE(finding_in(again, "P726"), nullptr);
    EXPECT_NE(finding_in(again, "P726")->sentence.find("1 of stairs"), std::string::npos);
}

struct RealDrawing {
    const char* file;
    ReadOptions options;
    std::size_t rooms;
    std::size_t doors;
    std::size_t windows;
};

TEST(ReadDxf, FindsInRealDrawingsAtLeastWhatItFoundOnce) {
    const std::filesystem::path folder = std::filesystem::path(ENFILADE_SOURCE_DIR) / "../shared/data/dxf";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "there is no " << folder;
    // docs/inputs.md says what is there to find.
    for (const RealDrawing& drawing :
         {RealDrawing{"skymakerolof_floorplan.dxf", {}, 17, 19, 8},
          RealDrawing{"ConstructIQ_house_plan.dxf", {.crop = DrawingBox{0, 540, 780, 1100}}, 7, 11, 2},
          RealDrawing{"skymakerolof_Ceco.NET-Architecture-Tm-53.dxf", {}, 2, 2, 9}}) {
        SCOPED_TRACE(drawing.file);
        const Contents found = contents_of(read(folder / drawing.file, drawing.options));
        EXPECT_GE(found.rooms, drawing.rooms) << found;
        EXPECT_GE(found.doors, drawing.doors) << found;
        EXPECT_GE(found.windows, drawing.windows) << found;
    }
}

}  // namespace
}  // namespace enfilade::plans

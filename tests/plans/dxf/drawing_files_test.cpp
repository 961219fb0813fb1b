// Drawings that people made, against what another reader counts in them: the tables come from ezdxf 0.18, insertions
// carried out where "exploded" stands.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/plans/dxf/dxf_text.h"

namespace enfilade::plans {
namespace {

using namespace dxf_text;

const std::filesystem::path data = std::filesystem::path(ENFILADE_SOURCE_DIR) / ".." / "shared" / "data" / "dxf";

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    return bytes.str();
}

/// LINE, ARC and INSERT of one layer, in model space.
struct Row {
    std::string layer;
    int lines = 0;
    int arcs = 0;
    int insertions = 0;
    friend bool operator==(const Row&, const Row&) = default;
};

void PrintTo(const Row& row, std::ostream* out) {
    *out << row.layer << ": " << row.lines << ", " << row.arcs << ", " << row.insertions;
}

std::vector<Row> model_space(const Drawing& drawing) {
    std::map<std::string, Row> rows;
    for (const Shape& shape : drawing.shapes) {
        if (shape.block != UINT32_MAX) continue;
        Row& row = rows[drawing.layers.at(shape.layer).name];
        row.lines += shape.kind == ShapeKind::Line;
        row.arcs += shape.kind == ShapeKind::Arc;
    }
    for (const Insertion& insertion : drawing.insertions)
        if (insertion.parent == UINT32_MAX) ++rows[drawing.layers.at(insertion.layer).name].insertions;
    std::vector<Row> list;
    for (auto& [name, row] : rows) {
        row.layer = name;
        if (row.lines + row.arcs + row.insertions > 0) list.push_back(row);
    }
    return list;
}

std::map<ShapeKind, int> kinds_of(const Drawing& drawing) {
    std::map<ShapeKind, int> kinds;
    for (const Shape& shape : drawing.shapes) ++kinds[shape.kind];
    return kinds;
}

using Kinds = std::map<ShapeKind, int>;

class DrawingFiles : public testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::is_directory(data)) GTEST_SKIP() << data << " is not there";
    }
    static Drawing of(const char* name) { return read_drawing(bytes_of(data / name), name); }
};

TEST_F(DrawingFiles, HouseInMillimetresThatAreInches) {
    const Drawing drawing = of("skymakerolof_floorplan.dxf");
    const std::string x = "xref-Bishop-Overland-08$0$";
    EXPECT_EQ(model_space(drawing), (std::vector<Row>{{"A-DIMS-1", 21, 0, 0},
                                                      {"A-NOTE", 123, 0, 0},
                                                      {"ANNTEXT", 40, 0, 0},
                                                      {x + "A-CASE-1", 45, 9, 10},
                                                      {x + "A-FOOTPRINT", 1, 0, 0},
                                                      {x + "A-OPENING", 145, 11, 0},
                                                      {x + "A-WALL", 170, 0, 0},
                                                      {x + "S-FOOTER", 59, 0, 0},
                                                      {x + "S-SLAB", 1, 0, 0},
                                                      {x + "S-STEM-WALL", 16, 0, 0},
                                                      {x + "TEMP", 3, 0, 0}}));
    EXPECT_EQ(kinds_of(drawing), (Kinds{{ShapeKind::Line, 685},
                                        {ShapeKind::Polyline, 124},
                                        {ShapeKind::Arc, 84},
                                        {ShapeKind::Circle, 27}}));  // exploded
    EXPECT_EQ(drawing.layers.size(), 24u);
    EXPECT_EQ(drawing.texts.size(), 98u);
    EXPECT_EQ(drawing.dimensions.size(), 63u);
    EXPECT_EQ(drawing.declared_unit, Unit::Millimetre);
    EXPECT_EQ(sentence_of(drawing, "P713"), "3 entities of paper space (title blocks, views) left out.");
    EXPECT_EQ(sentence_of(drawing, "P715"), "Entities that make no lines left out: 13 HATCH, 6 LEADER.");
    EXPECT_FALSE(has_errors(drawing.findings));
    // Its header says millimetres; the pictures of its dimensions are in feet and inches.
    const auto longest = std::max_element(drawing.dimensions.begin(), drawing.dimensions.end(),
                                          [](const Dimension& a, const Dimension& b) { return a.length < b.length; });
    EXPECT_EQ(longest->written, "58'-0\"");
    EXPECT_EQ(longest->text, "");
    EXPECT_NEAR(longest->length, 58 * 12, 0.01);
}

TEST_F(DrawingFiles, HouseInMetres) {
    const Drawing drawing = of("skymakerolof_Ceco.NET-Architecture-Tm-53.dxf");
    EXPECT_EQ(model_space(drawing), (std::vector<Row>{{"0", 0, 0, 1},
                                                      {"Ceco.NET 53", 21, 0, 0},
                                                      {"doorswindows", 47, 0, 3},
                                                      {"equipment", 22, 0, 0},
                                                      {"nivel", 53, 0, 0},
                                                      {"plants", 0, 0, 11},
                                                      {"projection", 84, 7, 0},
                                                      {"texture", 3, 0, 14},
                                                      {"topography", 207, 0, 0},
                                                      {"wall high", 99, 0, 0},
                                                      {"wall low", 92, 2, 0}}));
    EXPECT_EQ(
        kinds_of(drawing),
        (Kinds{{ShapeKind::Line, 7340}, {ShapeKind::Polyline, 1}, {ShapeKind::Arc, 52}, {ShapeKind::Circle, 18}}));
    EXPECT_EQ(drawing.layers.size(), 13u);
    EXPECT_EQ(drawing.texts.size(), 12u);
    EXPECT_EQ(drawing.declared_unit, Unit::Metre);
    EXPECT_FALSE(has_errors(drawing.findings));
}

TEST_F(DrawingFiles, HackerspaceInCentimetres) {
    const Drawing drawing = of("raumzeitlabor_floorplan.dxf");
    EXPECT_EQ(model_space(drawing), (std::vector<Row>{{"0", 73, 0, 0},
                                                      {"Base", 10, 0, 0},
                                                      {"Couch/Benches", 9, 0, 0},
                                                      {"Doors/Windows", 1, 1, 0},
                                                      {"Querbalken", 1, 0, 0},
                                                      {"Shelves", 26, 0, 0},
                                                      {"Stahltraeger", 8, 0, 0},
                                                      {"Table", 4, 0, 0},
                                                      {"Wand (neu)", 28, 0, 0}}));
    EXPECT_EQ(drawing.declared_unit, Unit::Centimetre);
    EXPECT_FALSE(has_errors(drawing.findings));
}

TEST_F(DrawingFiles, HouseInInchesWithTwoPlans) {
    const Drawing drawing = of("ConstructIQ_house_plan.dxf");
    EXPECT_EQ(model_space(drawing),
              (std::vector<Row>{
                  {"0", 44, 12, 0},           {"1X10", 12, 0, 0},  {"2X10", 32, 0, 0},       {"2X6", 203, 0, 0},
                  {"2X8", 279, 0, 0},         {"3X4", 141, 0, 0},  {"ANNOBJ", 18, 18, 2},    {"BORDERLINE", 5, 0, 0},
                  {"CEILOBJ", 0, 0, 2},       {"COLD", 1, 0, 11},  {"DASHED", 113, 0, 4},    {"DIMLINE", 1, 0, 0},
                  {"DJAMB", 0, 0, 12},        {"DOOR", 272, 0, 6}, {"ELEC-PLAN", 143, 0, 0}, {"ELIGHTCLG", 0, 0, 27},
                  {"ELIGHTWALL", 0, 0, 4},    {"ELINE", 6, 37, 0}, {"EPOWER", 0, 0, 22},     {"ESWITCH", 0, 0, 18},
                  {"HOT", 1, 0, 7},           {"JAMB", 0, 0, 32},  {"OPENING", 0, 0, 4},     {"PLUMBING", 2, 28, 4},
                  {"TEXT-ELEC-KEY", 8, 0, 0}, {"THIN", 108, 0, 0}, {"TILE", 8, 0, 0},        {"W14X22", 1, 0, 0},
                  {"WALL", 126, 0, 0},        {"WALLS", 3, 0, 0}}));
    // Exploded; faces are 204 3DFACE and 25 SOLID.
    EXPECT_EQ(kinds_of(drawing), (Kinds{{ShapeKind::Line, 2276},
                                        {ShapeKind::Polyline, 247},
                                        {ShapeKind::Arc, 133},
                                        {ShapeKind::Circle, 86},
                                        {ShapeKind::Face, 229}}));
    EXPECT_EQ(drawing.layers.size(), 60u);
    EXPECT_EQ(drawing.declared_unit, Unit::Inch);
    EXPECT_EQ(drawing.linear_format, 4);
    EXPECT_FALSE(drawing.metric);
    EXPECT_NE(finding_of(drawing, "P714"), nullptr);
    EXPECT_FALSE(has_errors(drawing.findings));
}

TEST_F(DrawingFiles, FurnitureOfLibreCad) {
    Kinds kinds;
    std::size_t insertions = 0;
    std::size_t texts = 0;
    int files = 0;
    for (const auto& file : std::filesystem::directory_iterator(data / "blocks_librecad")) {
        const Drawing drawing = read_drawing(bytes_of(file.path()), file.path().string());
        for (const auto& [kind, count] : kinds_of(drawing)) kinds[kind] += count;
        insertions += drawing.insertions.size();
        texts += drawing.texts.size();
        EXPECT_FALSE(has_errors(drawing.findings)) << file.path();
        EXPECT_EQ(finding_of(drawing, "P717"), nullptr) << file.path();
        ++files;
    }
    EXPECT_EQ(files, 35);
    EXPECT_EQ(kinds, (Kinds{{ShapeKind::Line, 558},
                            {ShapeKind::Polyline, 9},
                            {ShapeKind::Arc, 191},
                            {ShapeKind::Circle, 26},
                            {ShapeKind::Ellipse, 10}}));
    EXPECT_EQ(insertions, 29u);
    EXPECT_EQ(texts, 26u);
}

}  // namespace
}  // namespace enfilade::plans

// The plan's own pieces: as Sweet Home 3D shows them, in their rooms, with the meshes that can be had.

#include "modeler/objects/plan_objects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "accel/assemble.h"
#include "modeler/build.h"
#include "modeler/catalogue/own_pieces.h"
#include "modeler/certify.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "modeler/objects/object_box.h"
#include "modeler/objects/put_objects.h"
#include "plans/random.h"
#include "plans/read.h"
#include "tests/plans/home_file.h"

namespace enfilade::modeler {
namespace {

using Point = std::array<double, 3>;
using Points = std::vector<Point>;

/// One room of 10 m x 8 m, y down in the file.
std::string room_xml() {
    using testing::wall_xml;
    return "<level id='l' name='Ground' elevation='0' height='280' floorThickness='12'/>" +
           wall_xml("a", 0, 0, 1000, 0, "level='l' height='280' thickness='20'") +
           wall_xml("b", 1000, 0, 1000, 800, "level='l' height='280' thickness='20'") +
           wall_xml("c", 1000, 800, 0, 800, "level='l' height='280' thickness='20'") +
           wall_xml("d", 0, 800, 0, 0, "level='l' height='280' thickness='20'");
}

Building building_of(const std::string& pieces) { return convexify(build(testing::read_home(room_xml() + pieces))); }

/// How Sweet Home 3D places a model, in its own axes: x to the right, y up, z to the front.
struct HomePiece {
    double x = 0, y = 0, elevation = 0;  // centimetres; y of the plan
    double width = 100, depth = 100, height = 100;
    double angle = 0, pitch = 0, roll = 0;
    bool mirrored = false;
    std::array<double, 9> rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1};

    [[nodiscard]] std::string xml(const std::string& id, const std::string& model) const {
        std::string rows;
        for (const double number : rotation) rows += (rows.empty() ? "" : " ") + std::to_string(number);
        const auto text = [](const char* key, double value) {
            return std::string(" ") + key + "='" + std::to_string(value) + "'";
        };
        return "<pieceOfFurniture level='l' id='" + id + "' name='" + id + "' model='" + model + "'" + text("x", x) +
               text("y", y) + text("elevation", elevation) + text("width", width) + text("depth", depth) +
               text("height", height) + text("angle", angle) + text("pitch", pitch) + text("roll", roll) +
               (mirrored ? " modelMirrored='true'" : "") + " modelRotation='" + rows + "'/>";
    }
};

void bounds_of(const Points& points, Point& low, Point& high) {
    low = {1e9, 1e9, 1e9};
    high = {-1e9, -1e9, -1e9};
    for (const Point& p : points)
        for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
}

void turn(Points& points, std::size_t axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (Point& p : points) {
        const double a = p[u], b = p[v];
        p[u] = c * a - s * b;
        p[v] = s * a + c * b;
    }
}

/// Vertices where they stand, in our axes and metres.
Points placed(const HomePiece& piece, const ObjectMesh& mesh) {
    Points points;
    for (const auto& v : mesh.vertices) {
        const Point at = {v[0], v[2], -double(v[1])};
        Point turned{};
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t k = 0; k < 3; ++k) turned[r] += piece.rotation[3 * r + k] * at[k];
        points.push_back(turned);
    }
    Point low, high;
    bounds_of(points, low, high);
    const Point size = {piece.mirrored ? -piece.width : piece.width, piece.height, piece.depth};
    for (Point& p : points)
        for (std::size_t k = 0; k < 3; ++k) p[k] = (p[k] - (low[k] + high[k]) / 2) / (high[k] - low[k]) * size[k];
    if (piece.pitch != 0) turn(points, 0, -piece.pitch);
    else turn(points, 2, -piece.roll);
    bounds_of(points, low, high);
    const double height = high[1] - low[1];
    for (Point& p : points)
        for (std::size_t k = 0; k < 3; ++k) p[k] -= (low[k] + high[k]) / 2;
    turn(points, 1, -piece.angle);
    for (Point& p : points) {
        const Point moved = {p[0] + piece.x, p[1] + piece.elevation + height / 2, p[2] + piece.y};
        p = {moved[0] / 100, -moved[2] / 100, moved[1] / 100};
    }
    return points;
}

TEST(PlanObjects, StandAsSweetHome3DPlacesThem) {
    const Catalogue catalogue;
    plans::Random random{8};
    std::vector<HomePiece> pieces;
    std::vector<const OwnPiece*> models;
    std::string xml;
    const std::array<double, 9> turns[] = {{1, 0, 0, 0, 1, 0, 0, 0, 1},
                                           {0, 0, -1, 0, 1, 0, 1, 0, 0},
                                           {0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1},
                                           {1, 0, 0, 0, 0, -1, 0, 1, 0}};
    for (int k = 0; k < 24; ++k) {
        HomePiece piece;
        piece.x = random.uniform(250, 750);
        piece.y = random.uniform(250, 550);
        piece.elevation = random.uniform(0, 50);
        piece.width = random.uniform(20, 120);
        piece.depth = random.uniform(20, 120);
        piece.height = random.uniform(20, 120);
        piece.angle = random.uniform(-4, 4);
        if (k % 3 == 1) piece.pitch = random.uniform(-1.5, 1.5);
        if (k % 3 == 2) piece.roll = random.uniform(-1.5, 1.5);
        piece.mirrored = random.chance(0.5);
        piece.rotation = turns[k % 4];
        pieces.push_back(piece);
        const auto own = own_pieces();
        models.push_back(&own[random.below(std::uint32_t(own.size()))]);
        xml += piece.xml("piece-" + std::to_string(100 + k), models.back()->entry.id);
    }
    const Building building = building_of(xml);
    std::vector<Finding> findings;
    const Furnishing furnishing = plan_objects(building, catalogue, {}, findings);
    EXPECT_TRUE(findings.empty());
    ASSERT_EQ(furnishing.objects.size(), pieces.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const FurnishedObject& object = furnishing.objects[k];
        const ObjectMesh& mesh = *furnishing.meshes[object.mesh];
        EXPECT_EQ(object.model, models[k]->entry.id);
        const Points expected = placed(pieces[k], mesh);
        const std::array<double, 12> rows = plan_from_mesh(object, mesh);
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
            for (std::size_t r = 0; r < 3; ++r) {
                double at = rows[4 * r + 3];
                for (std::size_t c = 0; c < 3; ++c) at += rows[4 * r + c] * mesh.vertices[v][c];
                ASSERT_NEAR(at, expected[v][r], 1e-5) << object.id << " of " << object.model;
            }
        // Its box holds it.
        const ObjectBox box = box_of(object);
        Point low, high;
        bounds_of(expected, low, high);
        EXPECT_NEAR(box.z_low, low[2], 1e-5);
        EXPECT_NEAR(box.z_high, high[2], 1e-5);
    }
}

TEST(PlanObjects, UnknownModelsTakeOursOrABox) {
    const Building building = building_of(
        "<pieceOfFurniture level='l' id='p' name='Office chair' model='7/x.obj' x='300' y='300' width='60' depth='60' "
        "height='90'/>"
        "<pieceOfFurniture level='l' id='q' name='Xyzzy' model='7/x.obj' x='500' y='300' width='60' depth='60' "
        "height='90'><material name='m' color='FFFF0000'/></pieceOfFurniture>"
        "<pieceOfFurniture level='l' id='r' name='Pipe' model='7/x.obj' x='500' y='0' width='6' depth='6' "
        "height='90'/>");
    std::vector<Finding> findings;
    const Furnishing furnishing = plan_objects(building, Catalogue(), {}, findings);
    ASSERT_EQ(furnishing.objects.size(), 2u);
    EXPECT_EQ(furnishing.objects[0].model.substr(0, 4), "own/");
    EXPECT_EQ(furnishing.objects[1].model, "box");
    EXPECT_EQ(furnishing.meshes[furnishing.objects[1].mesh]->triangles.size(), 12u);
    ASSERT_EQ(findings.size(), 3u);
    EXPECT_EQ(findings[0].code, "P510");
    EXPECT_EQ(findings[1].code, "P510");
    EXPECT_EQ(findings[2].code, "P511");
    EXPECT_EQ(findings[2].elements.at(0).id, "r");
}

TEST(PlanObjects, OtherColoursAreOtherMeshes) {
    const std::string model = own_pieces()[0].entry.id;
    const std::string material = own_pieces()[0].make(1).materials.at(0).name;
    const auto piece = [&](const std::string& id, const std::string& inside) {
        return "<pieceOfFurniture level='l' id='" + id + "' model='" + model +
               "' x='300' y='300' width='60' depth='60' height='90'>" + inside + "</pieceOfFurniture>";
    };
    const std::string red = "<material name='" + material + "' color='FFFF0000'/>";
    const Building building = building_of(piece("a", "") + piece("b", red) + piece("c", red) + piece("d", ""));
    std::vector<Finding> findings;
    const Furnishing furnishing = plan_objects(building, Catalogue(), {}, findings);
    ASSERT_EQ(furnishing.objects.size(), 4u);
    ASSERT_EQ(furnishing.meshes.size(), 2u);
    EXPECT_EQ(furnishing.objects[0].mesh, furnishing.objects[3].mesh);
    EXPECT_EQ(furnishing.objects[1].mesh, furnishing.objects[2].mesh);
    EXPECT_EQ(furnishing.meshes[furnishing.objects[1].mesh]->materials[0].colour, (std::array<float, 3>{1, 0, 0}));
}

TEST(PlanObjects, OnlyWhatStandsInTheRoomsAskedFor) {
    const Building building = building_of(
        "<pieceOfFurniture level='l' id='in' name='Chair' x='300' y='300' width='60' depth='60' height='90'/>"
        "<pieceOfFurniture level='l' id='out' name='Chair' x='1300' y='300' width='60' depth='60' height='90'/>");
    std::vector<Finding> findings;
    const Furnishing all = plan_objects(building, Catalogue(), {}, findings);
    ASSERT_EQ(all.objects.size(), 2u);
    EXPECT_EQ(all.objects[1].space, exterior_space);
    const std::uint32_t room = space_at(building, 3, -3, 0.5);
    EXPECT_EQ(all.objects[0].space, room);
    EXPECT_EQ(building.spaces.at(room).label, Label::Room);
    EXPECT_EQ(space_at(building, 13, -3, 0.5), exterior_space);
    EXPECT_EQ(space_at(building, 0, -3, 0.5), UINT32_MAX) << "in a wall";
    const std::vector<std::uint32_t> only = {room};
    const Furnishing some = plan_objects(building, Catalogue(), only, findings);
    ASSERT_EQ(some.objects.size(), 1u);
    EXPECT_EQ(some.objects[0].id, "in");
}

TEST(PlanObjects, RealHomesAreFurnishedAndCertified) {
    namespace fs = std::filesystem;
    const fs::path folder = ENFILADE_SOURCE_DIR "/../shared/data/sh3d";
    if (!fs::exists(folder)) GTEST_SKIP() << "../shared/data is not here";
    for (const char* name : {"andijcr_ristrutturazione_default.sh3d", "jonwilliams84_furnished_kitchen.sh3d"}) {
        Building building = convexify(build(plans::read(folder / name)));
        Catalogue catalogue;
        catalogue.add(folder / name);
        std::vector<Finding> findings;
        Furnishing furnishing = plan_objects(building, catalogue, {}, findings);
        std::size_t pieces = 0, left_out = 0;
        for (const plans::Storey& storey : plans::read_json(building.plan_json, "").storeys)
            pieces += storey.furniture.size();
        for (const Finding& finding : findings)
            if (finding.code == "P511") left_out += finding.elements.size();
        EXPECT_EQ(furnishing.objects.size() + left_out, pieces) << name;
        EXPECT_LT(left_out, pieces / 4);
        for (const ObjectCells cells : {ObjectCells::List, ObjectCells::Cut}) {
            furnishing.cells = cells;
            const Building full = put_objects(building, furnishing, findings);
            const CheckReport report = check(full);
            for (const Finding& finding : report.findings)
                EXPECT_NE(finding.severity, Severity::Error) << name << finding.code << ' ' << finding.sentence;
            EXPECT_EQ(certify(export_scene(full, report, "{}")).verdict, "certified") << name;
        }
    }
}

}  // namespace
}  // namespace enfilade::modeler

#include "modeler/export_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "accel/certificate.h"
#include "accel/scene_file.h"
#include "base/error.h"
#include "modeler/build.h"
#include "modeler/convexify.h"
#include "modeler/model_group.h"
#include "tests/support/small_plans.h"

namespace enfilade::modeler {
namespace {

accel::Scene scene_of(const plans::Plan& plan, const BuildOptions& options = {}) {
    const Building convex = convexify(build(plan, options));
    return export_scene(convex, check(convex), "{}");
}

/// Area of the source faces that a kind of space sees, by surface, in square metres.
std::map<accel::Surface, double> areas(const accel::Scene& scene, Label label) {
    std::map<accel::Surface, double> sum;
    const accel::SceneView& view = scene.view();
    for (std::size_t f = 0; f < view.source_face_count(); ++f) {
        const accel::SourceFace& face = view.source_faces[f];
        if (view.spaces[index(face.space)].label != label) continue;
        double normal[3] = {0, 0, 0};
        const std::uint32_t begin = face.first_vertex, end = view.source_faces[f + 1].first_vertex;
        for (std::uint32_t k = begin; k < end; ++k) {
            const accel::Vertex &o = view.vertices[begin], &a = view.vertices[k],
                                &b = view.vertices[k + 1 < end ? k + 1 : begin];
            const double u[3] = {double(a.x) - o.x, double(a.y) - o.y, double(a.z) - o.z};
            const double v[3] = {double(b.x) - o.x, double(b.y) - o.y, double(b.z) - o.z};
            for (int i = 0; i < 3; ++i)
                normal[i] += (u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]) / 2;
        }
        sum[face.surface] += std::hypot(normal[0], normal[1], normal[2]);
    }
    return sum;
}

TEST(ExportScene, EachVolumeThatCarriesLightIsACellInOrder) {
    const Building convex = convexify(build(testing::two_rooms()));
    const accel::Scene scene = export_scene(convex, check(convex), "{}");
    std::size_t cell = 0;
    for (std::uint32_t v = 0; v < convex.volumes.size(); ++v) {
        if (!carries_light(convex.volumes[v].label)) continue;
        ASSERT_LT(cell, scene.view().cells.size());
        EXPECT_EQ(scene.view().cells[cell].volume, v);
        EXPECT_EQ(scene.view().cells[cell].label, convex.volumes[v].label);
        ++cell;
    }
    EXPECT_EQ(cell, scene.view().cells.size());
}

TEST(ExportScene, SolidFacesOfARoomHaveTheAreaOfItsWalls) {
    const auto area = areas(scene_of(testing::one_room()), Label::Room);
    EXPECT_NEAR(area.at(accel::Surface::Floor), 3.75 * 2.75, 1e-6);
    EXPECT_NEAR(area.at(accel::Surface::Ceiling), 3.75 * 2.75, 1e-6);
    EXPECT_NEAR(area.at(accel::Surface::WallPaper), 2 * (3.75 + 2.75) * 2.5 - 1 * 2, 1e-6);
}

TEST(ExportScene, CutsDoNotShowInSourceFaces) {
    // The ring room is cut into several cells, and still has one floor, cut in two discs only.
    const accel::Scene scene = scene_of(testing::ring_room());
    std::size_t floors = 0, cells = 0;
    for (std::size_t f = 0; f < scene.view().source_face_count(); ++f)
        floors += scene.view().source_faces[f].surface == accel::Surface::Floor &&
                  scene.view().spaces[index(scene.view().source_faces[f].space)].label == Label::Room;
    for (std::size_t c = 0; c < scene.view().cells.size(); ++c) cells += scene.view().cells[c].label == Label::Room;
    EXPECT_EQ(floors, 2u);
    EXPECT_GE(cells, 4u);
}

TEST(ExportScene, AWindowHasOneGlassPortalTowardsTheOutside) {
    const accel::Scene scene = scene_of(testing::two_rooms());
    int glass = 0;
    for (std::size_t p = 0; p < scene.view().portals.size(); ++p) {
        const accel::Portal& portal = scene.view().portals[p];
        if (portal.kind() != accel::PortalKind::Glass) continue;
        ++glass;
        const Label front = scene.view().cells[index(portal.front)].label,
                    back = scene.view().cells[index(portal.back)].label;
        EXPECT_TRUE(front == Label::Exterior || back == Label::Exterior);
        EXPECT_TRUE(front == Label::Window || back == Label::Window);
    }
    EXPECT_EQ(glass, 1);
}

TEST(ExportScene, OpaqueGlassIsASolidPane) {
    BuildOptions options;
    options.opaque_glass = true;
    const accel::Scene scene = scene_of(testing::two_rooms(), options);
    for (std::size_t p = 0; p < scene.view().portals.size(); ++p)
        EXPECT_NE(scene.view().portals[p].kind(), accel::PortalKind::Glass);
    EXPECT_NEAR(areas(scene, Label::Window).at(accel::Surface::Pane), 1.0, 1e-6);
    EXPECT_NEAR(areas(scene, Label::Exterior).at(accel::Surface::Pane), 1.0, 1e-6);
}

TEST(ExportScene, AShutDoorHasALeafTowardsItsRoom) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].openings[0].open_angle = 0;
    const accel::Scene scene = scene_of(plan);
    EXPECT_NEAR(areas(scene, Label::Room).at(accel::Surface::Leaf), 1 * 2, 1e-6);
    EXPECT_NEAR(areas(scene, Label::Door).at(accel::Surface::Leaf), 1 * 2, 1e-6);
}

TEST(ExportScene, TheSkyClosesTheSite) {
    const accel::Scene scene = scene_of(testing::one_room());
    const auto area = areas(scene, Label::Exterior);
    const Building building = build(testing::one_room());
    const double u = building.frame.unit;
    const double w = u * (building.site_max[0] - building.site_min[0]),
                 d = u * (building.site_max[1] - building.site_min[1]);
    const double h = u * (building.site_max[2] - building.storeys[0].z_floor);
    EXPECT_NEAR(area.at(accel::Surface::Sky), w * d + 2 * (w + d) * h, 1e-3);
}

TEST(ExportScene, TheSamePlanGivesTheSameBytes) {
    const accel::Scene once = scene_of(testing::two_storeys()), twice = scene_of(testing::two_storeys());
    EXPECT_TRUE(std::ranges::equal(once.bytes(), twice.bytes()));
}

TEST(ModelGroup, ReadsBackTheBuildingThatWasWritten) {
    const Building convex = convexify(build(testing::two_storeys()));
    const CheckReport report = check(convex);
    const accel::Scene scene = export_scene(convex, report, "{}");
    const Building again = read_model(scene);
    EXPECT_EQ(again.map.arrays().alpha, convex.map.arrays().alpha);
    EXPECT_EQ(again.vertices, convex.vertices);
    EXPECT_EQ(again.plan_json, convex.plan_json);
    const CheckReport second = check(again);
    EXPECT_TRUE(second.sound());
    EXPECT_EQ(second.findings.size(), report.findings.size());
    const accel::Scene exported = export_scene(again, second, "{}");
    EXPECT_TRUE(std::ranges::equal(scene.bytes(), exported.bytes()));
}

TEST(ModelGroup, StrippedScenesSaySo) {
    const accel::Scene stripped = accel::strip(scene_of(testing::one_room()));
    EXPECT_THROW((void)read_model(stripped), InputError);
}

TEST(ModelGroup, TheCertificateNamesWhatWasChecked) {
    const auto certificate = accel::certificate(scene_of(testing::one_room()));
    ASSERT_TRUE(certificate.has_value());
    std::vector<std::string> codes;
    for (const auto& [code, count] : certificate->code_counts) codes.push_back(code);
    EXPECT_EQ(codes, check(convexify(build(testing::one_room()))).codes_checked);
    for (const auto& [code, count] : certificate->code_counts) EXPECT_EQ(count, 0u) << code;
}

}  // namespace
}  // namespace enfilade::modeler

// Pictures from a scope are those of the full scene, byte by byte.

#include <gtest/gtest.h>

#include <algorithm>

#include "accel/assemble.h"
#include "modeler/export_scene.h"
#include "modeler/objects/put_objects.h"
#include "modeler/objects/scope.h"
#include "render/trace.h"
#include "tests/render/walk_paths.h"
#include "tests/support/furnished_scenes.h"

namespace enfilade::modeler {
namespace {

using accel::CellId;
using accel::SceneView;
using test::FurnishedHouse;

/// The building with those of its objects that cells of the scope list.
Building within(const Building& full, const SceneView& scene, const Scope& scope) {
    std::vector<char> is_kept(scene.objects.size());
    for (const CellId cell : scope.cells)
        for (std::uint32_t k = scene.cell_object_offsets[index(cell)]; k < scene.cell_object_offsets[index(cell) + 1];
             ++k)
            is_kept[index(scene.cell_objects[k])] = 1;
    Furnishing kept = full.furnishing;
    kept.objects.clear();
    for (std::size_t k = 0; k < is_kept.size(); ++k)
        if (is_kept[k] != 0) kept.objects.push_back(full.furnishing.objects[k]);
    std::vector<Finding> findings;
    return put_objects(full, std::move(kept), findings);
}

std::vector<render::Image> pictures(const SceneView& scene, const render::Vec3d& eye, double angle) {
    render::Camera camera;
    camera.eye = eye;
    camera.target = eye + render::Vec3d{std::cos(angle), std::sin(angle), -0.2};
    camera.fov_deg = 100;
    camera.width = camera.height = 96;
    std::vector<render::Image> made;
    for (const float mirror : {0.0f, 0.4f})
        for (const render::Shading shading : {render::Shading::Lambert, render::Shading::Look}) {
            render::TraceOptions options;
            options.shading = shading;
            options.mirror_floor = mirror;
            options.samples_per_pixel = shading == render::Shading::Look ? 4 : 1;
            made.push_back(render::trace(scene, camera, options));
        }
    return made;
}

class ScopePictures : public testing::TestWithParam<FurnishedHouse> {};

TEST_P(ScopePictures, AreThoseOfTheFullScene) {
    const Building full = test::furnished(test::house(GetParam()), 11, 250, ObjectCells::List);
    const accel::Scene scene = accel::assemble(scene_input(full));
    const SceneView& view = scene.view();
    const render::Look look;
    const ScopeLight light = {
        {look.sun_direction.x, look.sun_direction.y, look.sun_direction.z}, double{look.ambient_reach}, {}, true};
    std::mt19937_64 random(5);
    std::size_t kept = 0, all = 0, seen = 0;
    for (int k = 0; k < 5; ++k) {
        std::uint32_t cell = 0;
        do cell = std::uint32_t(random() % view.cells.size());
        while (view.cells[cell].label != accel::Label::Room);
        const render::Vec3d eye = test::random_point(view, cell, random);
        const Scope scope = scope_of(view, {{}, {{CellId{cell}, {eye.x, eye.y, eye.z}}}}, light);
        const Building part = within(full, view, scope);
        kept += part.furnishing.objects.size();
        all += full.furnishing.objects.size();
        const accel::Scene scoped = accel::assemble(scene_input(part));
        Building bare = full;
        bare.furnishing = {};
        const accel::Scene without = accel::assemble(scene_input(bare));
        const double angle = double(random() % 628) / 100;
        const std::vector<render::Image> expected = pictures(view, eye, angle),
                                         got = pictures(scoped.view(), eye, angle);
        const std::vector<render::Image> empty = pictures(without.view(), eye, angle);
        for (std::size_t p = 0; p < expected.size(); ++p) {
            EXPECT_EQ(got[p].rgb, expected[p].rgb) << "picture " << p << " from cell " << cell;
            seen += empty[p].rgb != expected[p].rgb;
        }
    }
    EXPECT_LT(kept, all) << "or the scope was everything";
    EXPECT_GT(seen, 10u) << "or there was nothing to be seen";
}

INSTANTIATE_TEST_SUITE_P(Houses, ScopePictures,
                         testing::Values(FurnishedHouse::Townhouse, FurnishedHouse::Office, FurnishedHouse::Curved));

}  // namespace
}  // namespace enfilade::modeler

// Furnished rooms lit by lamps: every tracer shows the shadows that the scalar one does, and so do walks to each lamp.

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "accel/lights/light_trees.h"
#include "render/trace.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/lit_judge.h"
#include "tests/support/object_scenes.h"
#include "tests/support/picture_judge.h"
#include "tests/support/tracer_variants.h"
#include "tests/support/trying_cameras.h"

namespace enfilade::render {
namespace {

using test::LitVerdict;
using test::TracerVariant;
using test::TryingCamera;

struct Case {
    const char* name;
    test::FurnishedOptions furniture;
    bool is_cut_off;  ///< cells know only two of three objects in them: the rest is cut off at their walls
};

constexpr std::array cases = {
    Case{"office", {.seed = 1}, false},
    Case{"crowded", {.seed = 2, .objects = 150, .turn = 0.4}, false},
    Case{"cutoff", {.seed = 3, .objects = 120, .turn = 0.1}, true},
};

/// The objects that cells know of, shared by views of the scene.
struct ObjectLists {
    std::vector<std::uint32_t> offsets;
    std::vector<accel::ObjectId> objects;

    ObjectLists(const accel::SceneView& scene, bool is_cut_off) {
        for (std::uint32_t c = 0; c < scene.cells.size(); ++c) {
            offsets.push_back(static_cast<std::uint32_t>(objects.size()));
            for (std::uint32_t k = scene.cell_object_offsets[c]; k < scene.cell_object_offsets[c + 1]; ++k)
                if (!is_cut_off || (c + index(scene.cell_objects[k])) % 3 != 0)
                    objects.push_back(scene.cell_objects[k]);
        }
        offsets.push_back(static_cast<std::uint32_t>(objects.size()));
    }
};

/// A lamp in every cell, not always under its ceiling.
std::vector<accel::Light> lamps_in(const accel::SceneView& scene) {
    std::vector<accel::Light> lights;
    for (std::uint32_t c = 0; c < scene.cells.size(); ++c) {
        const accel::Cell& cell = scene.cells[c];
        float x = 0, y = 0;
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
            x += scene.section_x[s] / float(cell.section_count);
            y += scene.section_y[s] / float(cell.section_count);
        }
        accel::Light light = {};
        light.position = {x, y, cell.z_ceiling - (c % 2 == 0 ? 0.1f : 1.0f)};
        if (light.position[2] < cell.z_floor) continue;
        light.intensity = {20, 18.0f + float(c % 3), 15.0f + float(c % 7)};
        light.cell = static_cast<accel::CellId>(c);
        light.carrier = none<accel::ObjectId>;
        lights.push_back(light);
    }
    return lights;
}

class LitFurniture : public testing::TestWithParam<std::tuple<Case, test::InstructionSet>> {
protected:
    LitFurniture()
        : set_(std::get<1>(GetParam())),
          scene_(test::furnished_office(std::get<0>(GetParam()).furniture)),
          lists_(scene_.view(), std::get<0>(GetParam()).is_cut_off),
          lights_(lamps_in(scene_.view())),
          view_(scene_.view()) {
        view_.lights = {lights_.data(), lights_.size()};
        view_.cell_object_offsets = {lists_.offsets.data(), lists_.offsets.size()};
        view_.cell_objects = {lists_.objects.data(), lists_.objects.size()};
        trees_ = accel::build_light_trees(view_, {}, accel::SerialExecutor());
        accel_ = build_object_accel(view_, ObjectAccelKind::Octree, accel::SerialExecutor());
        objects_ = accel_->tracer();
    }

    Framebuffer picture(const Camera& camera, const TracerVariant& variant, LampSearch search, float mirror_floor) {
        const CameraFrame frame = make_frame(camera);
        const Lamps lamps = {trees_.view(), search, 0.3f};
        LambertOptions options;
        options.tracer = variant.tracer;
        options.packets = variant.packets;
        options.mirror_floor = mirror_floor;
        options.objects = &objects_;
        options.lamps = &lamps;
        Framebuffer framebuffer(camera.width, camera.height);
        trace_lambert(view_, frame, start_cell(view_, frame), options, accel::SerialExecutor(), framebuffer);
        return framebuffer;
    }

    /// Judges the variants' pictures against the scalar walk to each lamp of the building.
    void expect_the_truth(std::uint64_t seed, LampSearch search, float mirror_floor, std::size_t step) {
        LitVerdict all;
        const std::vector<TryingCamera> cameras = test::trying_cameras(view_, seed);
        for (std::size_t k = seed % step; k < cameras.size(); k += step) {
            const Camera& camera = cameras[k].camera;
            if (cameras[k].on_border) continue;
            const Framebuffer expected = picture(camera, scalar, LampSearch::Naive, mirror_floor);
            for (const TracerVariant& variant : test::tracer_variants) {
                const LitVerdict verdict = test::compare(expected, picture(camera, variant, search, mirror_floor));
                EXPECT_LE(double(verdict.unexplained), 2 + 0.0005 * double(verdict.pixels))
                    << variant.name << ", camera " << cameras[k].name << ", "
                    << test::text_of(make_frame(camera), camera.width, camera.height) << ": " << verdict.text();
                all.add(verdict);
            }
        }
        EXPECT_GT(all.bright, all.pixels / 20);
        EXPECT_LE(double(all.differing), 8 + 0.003 * double(all.pixels)) << all.text();
    }

    static constexpr TracerVariant scalar = {"scalar", Tracer::Scalar, {64, 8}};
    test::UsingInstructionSet set_;
    accel::Scene scene_;
    ObjectLists lists_;
    std::vector<accel::Light> lights_;
    accel::SceneView view_;
    accel::LightTrees trees_;
    std::unique_ptr<ObjectAccel> accel_;
    ObjectTracer objects_;
};

TEST_P(LitFurniture, ThrowsTheShadowsOfWalks) { expect_the_truth(21, LampSearch::Tree, 0, 3); }

TEST_P(LitFurniture, ThrowsThemOverFloorsThatMirror) { expect_the_truth(22, LampSearch::Tree, 0.3f, 4); }

TEST_P(LitFurniture, ThrowsThemWithoutTrees) { expect_the_truth(23, LampSearch::Pvs, 0, 4); }

INSTANTIATE_TEST_SUITE_P(Offices, LitFurniture,
                         testing::Combine(testing::ValuesIn(cases), testing::ValuesIn(test::instruction_sets())),
                         [](const auto& one) {
                             return std::string(std::get<0>(one.param).name) + "_" + std::get<1>(one.param).name;
                         });

}  // namespace
}  // namespace enfilade::render

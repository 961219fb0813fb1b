// Pictures lit by lamps: every tracer, with every instruction set, shows what the scalar one does.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "accel/assemble.h"
#include "accel/lights/light_trees.h"
#include "render/trace.h"
#include "tests/support/coloured_scene.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/lit_judge.h"
#include "tests/support/picture_judge.h"
#include "tests/support/synthetic_scene.h"
#include "tests/support/tracer_variants.h"
#include "tests/support/trying_cameras.h"

namespace enfilade::render {
namespace {

using test::LitVerdict;
using test::TracerVariant;
using test::TryingCamera;

enum class Lamps { White, Coloured, Many };

struct Case {
    const char* name;
    test::SyntheticOptions office;
    Lamps lamps;
};

const std::array cases = {
    Case{"white", {.rooms_per_row = 3, .rows = 4}, Lamps::White},
    Case{"coloured", {.rooms_per_row = 3, .rows = 2, .storeys = 2, .turn = 0.3}, Lamps::Coloured},
    Case{"many", {.rooms_per_row = 2, .rows = 2, .turn = 0.7853981}, Lamps::Many},
};

accel::InputLight lamp_at(std::size_t number, double x, double y, double z, std::array<float, 3> intensity) {
    accel::InputLight light;
    light.id = "lamp-" + std::to_string(10000 + number);
    light.position = {x, y, z};
    light.intensity = intensity;
    return light;
}

/// Lamps in every cell: off its middle, two of them at one place, one at its border; and one outdoors.
accel::SceneInput lit_office(const Case& which) {
    accel::SceneInput input = test::with_own_colours(test::synthetic_office(which.office));
    const accel::Scene bare = accel::assemble(accel::SceneInput(input));
    const accel::SceneView& view = bare.view();
    std::size_t number = 0;
    for (std::uint32_t c = 0; c < view.cells.size(); ++c) {
        const accel::Cell& cell = view.cells[c];
        double x = 0, y = 0;
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
            x += double{view.section_x[s]} / cell.section_count;
            y += double{view.section_y[s]} / cell.section_count;
        }
        const double z = cell.label == accel::Label::Exterior ? 2 : cell.z_ceiling - 0.15;
        const std::size_t count = which.lamps == Lamps::Many ? 100 : 1 + c % 3;
        for (std::size_t k = 0; k < count; ++k) {
            const auto at = static_cast<double>(k / 2);  // two at one place
            std::array<float, 3> intensity = {20, 20, 20};
            if (which.lamps == Lamps::Coloured) intensity = {10.0f + float(c % 4) * 8, 24, 30.0f - float(c % 5) * 5};
            input.lights.push_back(lamp_at(number++, x + 0.4 * std::sin(at * 2.4), y + 0.4 * std::cos(at * 1.7),
                                           z - 0.01 * at, intensity));
        }
    }
    const accel::Cell& room = view.cells[0];
    input.lights.push_back(lamp_at(number++, view.section_x[room.first_section], view.section_y[room.first_section],
                                   0.5 * (room.z_floor + room.z_ceiling), {9, 9, 9}));
    return input;
}

class LitTracers : public testing::TestWithParam<std::tuple<Case, test::InstructionSet>> {
protected:
    LitTracers()
        : set_(std::get<1>(GetParam())),
          scene_(accel::assemble(lit_office(std::get<0>(GetParam())))),
          trees_(accel::build_light_trees(scene_.view(), {}, accel::SerialExecutor())) {}

    Framebuffer picture(const Camera& camera, const TracerVariant& variant, float mirror_floor, LampSearch search) {
        const CameraFrame frame = make_frame(camera);
        const render::Lamps lamps = {trees_.view(), search, exposure};
        LambertOptions options;
        options.tracer = variant.tracer;
        options.packets = variant.packets;
        options.mirror_floor = mirror_floor;
        options.lamps = &lamps;
        Framebuffer framebuffer(camera.width, camera.height);
        trace_lambert(scene_.view(), frame, start_cell(scene_.view(), frame), options, accel::SerialExecutor(),
                      framebuffer);
        return framebuffer;
    }

    Image float_picture(const Camera& camera, const TracerVariant& variant, float mirror_floor) {
        const accel::SerialExecutor executor;
        TraceOptions options;
        options.shading = Shading::Lambert;
        options.tracer = variant.tracer;
        options.packets = variant.packets;
        options.mirror_floor = mirror_floor;
        options.executor = &executor;
        options.lamps = LampOptions{LampSearch::Tree, exposure, trees_.view()};
        return trace(scene_.view(), camera, options);
    }

    void expect_the_scalar_picture(float mirror_floor, LampSearch search) {
        LitVerdict all;
        for (const TryingCamera& trying : cameras(5)) {
            const Camera& camera = trying.camera;
            const Framebuffer expected = picture(camera, scalar, mirror_floor, search);
            for (const TracerVariant& variant : test::tracer_variants) {
                const LitVerdict verdict = test::compare(expected, picture(camera, variant, mirror_floor, search));
                // From borders of cells rays may see what lies on either side.
                if (trying.on_border) continue;
                EXPECT_LE(verdict.unexplained, most_unexplained)
                    << variant.name << ", camera " << trying.name << ", "
                    << test::text_of(make_frame(camera), camera.width, camera.height) << ": " << verdict.text();
                all.add(verdict);
            }
        }
        EXPECT_GT(all.bright, all.pixels / 10);
        EXPECT_LE(double(all.differing), 8 + 0.001 * double(all.pixels)) << all.text();
    }

    /// All, or of many lamps a few.
    [[nodiscard]] std::vector<TryingCamera> cameras(std::uint64_t seed) const {
        std::vector<TryingCamera> all = test::trying_cameras(scene_.view(), seed);
        if (std::get<0>(GetParam()).lamps != Lamps::Many) return all;
        std::vector<TryingCamera> some;
        for (std::size_t k = 0; k < all.size(); k += 5) some.push_back(all[k]);
        return some;
    }

    /// Rays through a corner may show any of its faces, one that nothing else around shows.
    static constexpr std::uint64_t most_unexplained = 1;
    static constexpr float exposure = 0.3f;
    static constexpr TracerVariant scalar = {"scalar", Tracer::Scalar, {64, 8}};
    test::UsingInstructionSet set_;
    accel::Scene scene_;
    accel::LightTrees trees_;
};

TEST_P(LitTracers, ShowTheScalarPicture) { expect_the_scalar_picture(0, LampSearch::Tree); }

TEST_P(LitTracers, ShowTheScalarPictureOverFloorsThatMirror) { expect_the_scalar_picture(0.4f, LampSearch::Tree); }

TEST_P(LitTracers, ShowTheScalarPictureWithoutTrees) { expect_the_scalar_picture(0, LampSearch::Pvs); }

TEST_P(LitTracers, ShowTheScalarPictureInFloats) {
    LitVerdict all;
    for (const TryingCamera& trying : cameras(6)) {
        const Image expected = float_picture(trying.camera, scalar, 0);
        for (const TracerVariant& variant : test::tracer_variants) {
            const LitVerdict verdict = test::compare(expected, float_picture(trying.camera, variant, 0));
            if (trying.on_border) continue;
            EXPECT_LE(verdict.unexplained, most_unexplained)
                << variant.name << ", camera " << trying.name << ": " << verdict.text();
            all.add(verdict);
        }
    }
    EXPECT_LE(double(all.differing), 8 + 0.001 * double(all.pixels)) << all.text();
}

INSTANTIATE_TEST_SUITE_P(Offices, LitTracers,
                         testing::Combine(testing::ValuesIn(cases), testing::ValuesIn(test::instruction_sets())),
                         [](const auto& one) {
                             return std::string(std::get<0>(one.param).name) + "_" + std::get<1>(one.param).name;
                         });

}  // namespace
}  // namespace enfilade::render

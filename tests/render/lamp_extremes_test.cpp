// Lamps at places and of intensities where other renderers fall over: every picture is finite, and the same however it
// is found out which lamps a place sees.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "base/error.h"
#include "render/trace.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

using Place = std::array<double, 3>;

accel::InputLight lamp_at(std::size_t number, Place place, float candela = 100) {
    accel::InputLight light;
    light.id = "lamp-" + std::to_string(1000000 + number);
    light.position = place;
    light.intensity = {candela, candela, candela};
    return light;
}

/// Six rooms and their corridor, on an axis of coordinates or turned.
accel::SceneInput office(double turn = 0) {
    return test::synthetic_office({.rooms_per_row = 3, .rows = 2, .turn = turn});
}

/// Corners of the cell on its floor.
std::vector<Place> corners(const accel::SceneView& view, const accel::Cell& cell) {
    std::vector<Place> all;
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s)
        all.push_back({view.section_x[s], view.section_y[s], cell.z_floor});
    return all;
}

Place middle(const accel::SceneView& view, const accel::Cell& cell) {
    Place sum = {0, 0, (double{cell.z_floor} + double{cell.z_ceiling}) / 2};
    for (const Place& p : corners(view, cell))
        for (std::size_t k = 0; k < 2; ++k) sum[k] += p[k] / cell.section_count;
    return sum;
}

/// The n-th cell of that label.
const accel::Cell& cell_of(const accel::SceneView& view, accel::Label label, int n = 0) {
    for (const accel::Cell& cell : view.cells)
        if (cell.label == label && n-- == 0) return cell;
    throw std::logic_error("no such cell");
}

Camera looking(const Place& eye, const Place& target, int side = 48) {
    Camera camera;
    camera.eye = {eye[0], eye[1], eye[2]};
    camera.target = {target[0], target[1], target[2]};
    camera.fov_deg = 100;
    camera.width = camera.height = side;
    return camera;
}

TraceOptions lit_by(LampSearch search, float exposure = 0.05f) {
    TraceOptions options;
    options.tracer = Tracer::Scalar;
    options.shading = Shading::Lambert;
    options.look.sky_zenith = options.look.sky_horizon = {0, 0, 0};
    options.lamps = LampOptions{.search = search, .exposure = exposure};
    return options;
}

void expect_finite(const Image& image, const std::string& what) {
    for (const float v : image.rgb) ASSERT_TRUE(std::isfinite(v) && v >= 0) << what << ": " << v;
}

/// The picture, after it was seen to be finite and the same by every search but for `share` of its numbers, on borders.
Image agreed_picture(const accel::SceneView& view, const Camera& camera, double share = 0.01) {
    const Image truth = trace(view, camera, lit_by(LampSearch::Naive));
    expect_finite(truth, "naive");
    for (const LampSearch search : {LampSearch::Pvs, LampSearch::Tree}) {
        const Image image = trace(view, camera, lit_by(search));
        expect_finite(image, "others");
        std::size_t others = 0;
        for (std::size_t i = 0; i < image.rgb.size(); ++i)
            others += std::abs(image.rgb[i] - truth.rgb[i]) > 1e-3f * truth.rgb[i] + 1e-5f ? 1 : 0;
        EXPECT_LE(double(others), share * double(image.rgb.size())) << "search " << int(search);
        TraceOptions evening = lit_by(search);
        evening.shading = Shading::Look;
        expect_finite(trace(view, camera, evening), "in the evening");
    }
    return truth;
}

double sum(const Image& image) {
    double all = 0;
    for (const float v : image.rgb) all += double{v};
    return all;
}

/// Puts the lamp into the office, and looks from the first room across it.
Image office_with(const std::vector<accel::InputLight>& lamps, double share = 0.01) {
    accel::SceneInput input = office();
    input.lights = lamps;
    const accel::Scene scene = accel::assemble(input);
    const accel::SceneView& view = scene.view();
    const accel::Cell& room = cell_of(view, accel::Label::Room);
    Place target = middle(view, room);
    target[2] = room.z_floor;
    Place eye = middle(view, room);
    const Place corner = corners(view, room).front();
    for (std::size_t k = 0; k < 2; ++k) eye[k] += 0.8 * (corner[k] - eye[k]);
    return agreed_picture(view, looking(eye, target), share);
}

struct Geometry {
    accel::Scene scene = accel::assemble(office());
    const accel::SceneView& view = scene.view();
    const accel::Cell& room = cell_of(view, accel::Label::Room);
};

TEST(LampExtremes, OnFloorsCeilingsWallsCornersAndVerticalLines) {
    const Geometry g;
    const Place m = middle(g.view, g.room);
    const std::vector<Place> at = corners(g.view, g.room);
    const double floor = g.room.z_floor, ceiling = g.room.z_ceiling;
    std::vector<Place> places = {{m[0], m[1], floor}, {m[0], m[1], ceiling}};
    std::vector<Place> edges;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const Place& p = at[i];
        const Place& q = at[(i + 1) % at.size()];
        for (const double z : {floor, 1.1, ceiling}) {
            (z == 1.1 ? edges : places).push_back({p[0], p[1], z});
            places.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, z});
        }
    }
    for (const Place& place : places) {
        SCOPED_TRACE(testing::PrintToString(place));
        (void)office_with({lamp_at(0, place)});
    }
    for (const Place& place : edges) {
        SCOPED_TRACE(testing::PrintToString(place));
        // On the edge of a jamb, at the very end of its opening: whether light passes there is a tie, which walks break
        // by their vanishing shift, and planes in favour of light.
        (void)office_with({lamp_at(0, place)}, 0.1);
    }
}

TEST(LampExtremes, AHairFromAWallOrInIt) {
    const Geometry g;
    const std::vector<Place> at = corners(g.view, g.room);
    const Place m = middle(g.view, g.room);
    for (const double hair : {1e-6, 1e-4, -1e-6, -1e-4, -0.05})
        for (std::size_t i = 0; i < at.size(); ++i) {
            const Place& p = at[i];
            const Place& q = at[(i + 1) % at.size()];
            Place place = {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, 2};
            const double way = std::hypot(m[0] - place[0], m[1] - place[1]);
            for (std::size_t k = 0; k < 2; ++k) place[k] += hair * (m[k] - place[k]) / way;
            (void)office_with({lamp_at(0, place)});
        }
}

TEST(LampExtremes, InWallsAndBeyondTheSiteTheyLightNothing) {
    const Geometry g;
    const std::vector<Place> at = corners(g.view, g.room);
    const auto low = g.view.locator_nodes[0].low;
    for (const Place& place : {Place{at[0][0] - 0.05, at[0][1] - 0.05, 1}, Place{low[0] - 1.0, low[1] - 1.0, 1},
                               Place{1e9, 0, 0}, Place{0, 0, -50}}) {
        accel::SceneInput input = office();
        input.lights = {lamp_at(0, place)};
        const accel::Scene scene = accel::assemble(input);
        EXPECT_EQ(scene.view().lights[0].cell, none<accel::CellId>) << place[0];
        EXPECT_EQ(sum(office_with({lamp_at(0, place)})), 0) << place[0];
    }
}

TEST(LampExtremes, TwoAtOnePlaceGiveTwiceTheLight) {
    const Geometry g;
    const Place m = middle(g.view, g.room);
    const double one = sum(office_with({lamp_at(0, m)}));
    EXPECT_GT(one, 0);
    EXPECT_NEAR(sum(office_with({lamp_at(0, m), lamp_at(1, m)})) / one, 2, 1e-4);
}

TEST(LampExtremes, NoLampAndLampsWithoutLightAreBlack) {
    const Geometry g;
    EXPECT_EQ(sum(office_with({})), 0);
    EXPECT_EQ(sum(office_with({lamp_at(0, middle(g.view, g.room), 0)})), 0);
    EXPECT_EQ(sum(office_with({lamp_at(0, middle(g.view, g.room), 1e-45f)})), 0);
}

TEST(LampExtremes, OfAnyIntensityThePictureIsFinite) {
    const Geometry g;
    const Place m = middle(g.view, g.room);
    for (const float candela : {1e-30f, 1e10f, 1e18f}) {
        (void)office_with({lamp_at(0, m, candela)});
        (void)office_with({lamp_at(0, {m[0], m[1], g.room.z_floor + 1e-6}, candela), lamp_at(1, m, candela)});
    }
}

TEST(LampExtremes, WhatIsNoLampIsRefused) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    for (const float v : {nan, inf, -1.0f, 1e30f}) {
        accel::SceneInput input = office();
        input.lights = {lamp_at(0, {0, 0, 1})};
        input.lights[0].intensity[1] = v;
        EXPECT_THROW((void)accel::assemble(input), std::exception) << v;
        input.lights[0].intensity[1] = 1;
        input.lights[0].radius = double{v};
        EXPECT_THROW((void)accel::assemble(input), std::exception) << v;
    }
    for (const double v : {double{nan}, double{inf}}) {
        accel::SceneInput input = office();
        input.lights = {lamp_at(0, {0, v, 1})};
        EXPECT_THROW((void)accel::assemble(input), std::exception) << v;
    }
}

TEST(LampExtremes, SeenByACameraThatIsAtTheLamp) {
    const Geometry g;
    const Place m = middle(g.view, g.room);
    accel::SceneInput input = office();
    input.lights = {lamp_at(0, m)};
    const accel::Scene scene = accel::assemble(input);
    EXPECT_GT(sum(agreed_picture(scene.view(), looking(m, {m[0] + 1, m[1], m[2]}), 0)), 0)
        << "nothing that the camera sees is in shadow";
}

/// The lamp lies on the floor or a hair above it, and a camera looks straight down on it from 1 mm to 2 m.
TEST(LampExtremes, APlaceAtTheLampItselfIsLitByNoInfinity) {
    const Geometry g;
    const Place m = middle(g.view, g.room);
    for (const double hair : {0.0, 1e-30, 1e-20, 1e-12, 1e-6, 1e-3})
        for (const double height : {1e-3, 0.1, 2.0}) {
            accel::SceneInput input = office();
            input.lights = {lamp_at(0, {m[0], m[1], g.room.z_floor + hair}, 1e6f)};
            const accel::Scene scene = accel::assemble(input);
            Camera camera = looking({m[0], m[1], g.room.z_floor + height}, {m[0], m[1], g.room.z_floor});
            camera.up = {0, 1, 0};
            camera.width = camera.height = 31;
            const Image image = agreed_picture(scene.view(), camera);
            // The inverse square at a micrometre: 10^6 candela make 10^18 lux.
            if (hair == 1e-6 && height == 2.0) {
                EXPECT_GT(*std::ranges::max_element(image.rgb), 1e14f);
            }
        }
}

TEST(LampExtremes, InEveryDoorwayExactlyOnThePortal) {
    for (const double turn : {0.0, 0.3}) {
        const accel::Scene scene = accel::assemble(office(turn));
        const accel::SceneView& view = scene.view();
        int doors = 0;
        for (std::uint32_t c = 0; c < view.cells.size() && doors < 12; ++c) {
            const accel::Cell& cell = view.cells[c];
            if (cell.label != accel::Label::Room) continue;
            const std::vector<Place> at = corners(view, cell);
            for (std::uint32_t i = 0; i < cell.section_count; ++i) {
                const std::uint32_t s = cell.first_section + i;
                bool is_door = false;
                for (std::uint32_t f = view.section_tails[s].first_face; f < view.section_tails[s + 1].first_face; ++f)
                    is_door = is_door || view.side_faces[f].target.is_portal();
                if (!is_door) continue;
                ++doors;
                const Place& p = at[i];
                const Place& q = at[(i + 1) % at.size()];
                const Place lamp = {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, 1};
                accel::SceneInput input = office(turn);
                input.lights = {lamp_at(0, lamp)};
                const accel::Scene lit = accel::assemble(input);
                EXPECT_GT(sum(agreed_picture(lit.view(), looking(middle(view, cell), lamp))), 0);
            }
        }
        EXPECT_GE(doors, 6);
    }
}

TEST(LampExtremes, ManyOutsideLightAnInteriorThroughItsWindows) {
    accel::SceneInput input = office();
    const accel::Scene bare = accel::assemble(input);
    const auto &low = bare.view().locator_nodes[0].low, &high = bare.view().locator_nodes[0].high;
    std::size_t number = 0;
    for (int i = 0; i < 20; ++i)
        for (int k = 0; k < 20; ++k) {
            const Place place = {low[0] + (i + 0.5) / 20 * (high[0] - low[0]),
                                 low[1] + (k + 0.5) / 20 * (high[1] - low[1]), 1.7};
            const auto cell = accel::locate(bare.view(), place);
            if (cell && bare.view().cells[index(*cell)].label == accel::Label::Exterior)
                input.lights.push_back(lamp_at(number++, place));
        }
    ASSERT_GT(number, 100u);
    const accel::Scene scene = accel::assemble(input);
    const accel::Cell& room = cell_of(scene.view(), accel::Label::Room);
    const Place m = middle(scene.view(), room);
    EXPECT_GT(sum(agreed_picture(scene.view(), looking(m, {m[0] + 1, m[1] + 0.3, 0.5}, 32), 0.03)), 0);
}

/// Light that comes through ten thousand doors in a row.
TEST(LampExtremes, AtTheEndOfTenThousandDoorsInARow) {
    accel::SceneInput input = test::synthetic_corridor(10000);
    const accel::Scene bare = accel::assemble(input);
    const auto &low = bare.view().locator_nodes[0].low, &high = bare.view().locator_nodes[0].high;
    input.lights = {lamp_at(0, {double{high[0]} - 0.125, 0.05, 1}, 1e8f)};
    const accel::Scene scene = accel::assemble(input);
    const Place eye = {double{low[0]} + 0.25, 0, 1};
    EXPECT_GT(sum(agreed_picture(scene.view(), looking(eye, {double{low[0]}, 0, 1}, 10), 0.03)), 0)
        << "the wall at the other end is lit";
}

TEST(LampExtremes, AHundredThousandInABuilding) {
    accel::SceneInput input = test::synthetic_office({.rooms_per_row = 30, .rows = 30, .doors = false});
    const accel::Scene bare = accel::assemble(input);
    const auto &low = bare.view().locator_nodes[0].low, &high = bare.view().locator_nodes[0].high;
    std::size_t number = 0;
    for (int i = 0; i < 340; ++i)
        for (int k = 0; k < 340; ++k) {
            const Place place = {low[0] + (i + 0.5) / 340 * (high[0] - low[0]),
                                 low[1] + (k + 0.5) / 340 * (high[1] - low[1]), 2};
            const auto cell = accel::locate(bare.view(), place);
            if (cell && bare.view().cells[index(*cell)].label == accel::Label::Room)
                input.lights.push_back(lamp_at(number++, place));
        }
    ASSERT_GT(number, 50000u);
    while (number < 100000) {
        accel::InputLight twin = input.lights[number % 50000];
        twin.id = lamp_at(number++, {}).id;
        input.lights.push_back(twin);
    }
    const accel::Scene scene = accel::assemble(input);
    const accel::Cell& room = cell_of(scene.view(), accel::Label::Room, 450);
    const Place m = middle(scene.view(), room);
    const Camera camera = looking(m, {m[0] + 1, m[1] + 0.3, 0.5}, 12);
    const Image truth = trace(scene.view(), camera, lit_by(LampSearch::Pvs));
    const Image image = trace(scene.view(), camera, lit_by(LampSearch::Tree));
    EXPECT_GT(sum(truth), 0);
    expect_finite(image, "tree");
    EXPECT_NEAR(sum(image) / sum(truth), 1, 1e-3);
}

TEST(LampExtremes, MirrorsAndColouredGlassKeepEverySearchAgreed) {
    accel::SceneInput input = office();
    for (accel::InputPortal& portal : input.portals) {
        portal.kind = accel::PortalKind::Glass;
        portal.tint = {1, 0.5f, 0};
    }
    // In the reveal of the room's window, behind the pane.
    input.lights = {lamp_at(0, {2.2, 0.1, 1.5})};
    const accel::Scene scene = accel::assemble(input);
    const accel::Cell& hall = cell_of(scene.view(), accel::Label::Room, 0);
    const Place m = middle(scene.view(), hall);
    for (const float mirror : {0.0f, 1.0f}) {
        double truth = 0;
        for (const LampSearch search : {LampSearch::Naive, LampSearch::Pvs, LampSearch::Tree}) {
            TraceOptions options = lit_by(search);
            options.mirror_floor = mirror;
            const Image image = trace(scene.view(), looking(m, {m[0] + 1, m[1] + 1, 0}), options);
            expect_finite(image, "mirror");
            for (std::size_t i = 0; i < image.rgb.size(); i += 3)
                ASSERT_LE(image.rgb[i + 2], image.rgb[i] + 1e-6f) << "what comes through glass has no blue";
            if (search == LampSearch::Naive) truth = sum(image);
            EXPECT_GT(truth, 0);
            EXPECT_NEAR(sum(image) / truth, 1, 0.01);
        }
    }
}

}  // namespace
}  // namespace enfilade::render

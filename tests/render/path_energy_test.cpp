// Light by paths where it is known exactly: what lamps emit is what surfaces absorb; white surfaces in an even light
// are as bright as it; direct light of points and balls.

#include <gtest/gtest.h>

#include <cmath>

#include "accel/assemble.h"
#include "render/path_trace.h"
#include "tests/support/lit_rooms.h"
#include "tests/support/object_scenes.h"
#include "tests/support/surface_places.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

constexpr double pi = 3.14159265358979323846;

struct Estimate {
    double value = 0, error = 0;
};

/// What all surfaces of that reflectance absorb, lumen of one colour. From places all over them.
Estimate absorbed(const accel::SceneView& scene, double reflectance, const PathOptions& options, std::size_t colour) {
    const test::SurfacePlaces places = test::surface_places(scene, 6000, 7);
    const std::vector<PlaceLight> light = measure_light(scene, places.view(), options);
    double sum = 0, squares = 0;
    for (const PlaceLight& one : light) {
        const double lux = colour == 0 ? one.lux.x : colour == 1 ? one.lux.y : one.lux.z;
        sum += lux;
        squares += lux * lux;
    }
    const double n = static_cast<double>(light.size()), mean = sum / n, scale = places.area * (1 - reflectance);
    return {scale * mean, scale * std::sqrt((squares / n - mean * mean) / n)};
}

void expect_near(const Estimate& estimate, double truth, double most_relative_error) {
    EXPECT_LT(estimate.error, most_relative_error * truth);
    EXPECT_NEAR(estimate.value, truth, 4 * estimate.error);
}

PathOptions furnace_options() {
    PathOptions options;
    options.samples_per_pixel = 16;
    options.most_bounces = 1000;
    options.sky = options.sun = 0;
    return options;
}

TEST(PathEnergy, WhatALampEmitsIsWhatAClosedRoomAbsorbs) {
    for (const float reflectance : {0.0f, 0.5f, 0.9f}) {
        accel::SceneInput input = test::closed_room();
        test::paint(input, {reflectance, reflectance, reflectance});
        test::hang(input, {2.1, 1.7, 1.9}, {100, 50, 200});
        const accel::Scene scene = accel::assemble(input);
        expect_near(absorbed(scene.view(), double{reflectance}, furnace_options(), 0), 4 * pi * 100, 0.02);
        expect_near(absorbed(scene.view(), double{reflectance}, furnace_options(), 2), 4 * pi * 200, 0.02);
    }
}

TEST(PathEnergy, StaysInRoomsBehindDoors) {
    for (const double turn : {0.0, 0.4}) {
        accel::SceneInput input = test::closed_rooms(turn);
        test::paint(input, {0.7f, 0.7f, 0.7f});
        test::hang(input, {turn == 0 ? 1.2 : 0.6, 1.7, 1.9}, {100, 100, 100});
        const accel::Scene scene = accel::assemble(input);
        ASSERT_NE(scene.view().lights[0].cell, none<accel::CellId>);
        for (const LampSearch search : {LampSearch::Naive, LampSearch::Tree}) {
            PathOptions options = furnace_options();
            options.search = search;
            expect_near(absorbed(scene.view(), 0.7, options, 1), 4 * pi * 100, 0.03);
        }
    }
}

TEST(PathEnergy, OfBallsIsThatOfPoints) {
    accel::SceneInput input = test::closed_room();
    test::paint(input, {0.6f, 0.6f, 0.6f});
    test::hang(input, {2.1, 1.7, 1.5}, {100, 100, 100}, 0.4);
    const accel::Scene scene = accel::assemble(input);
    expect_near(absorbed(scene.view(), 0.6, furnace_options(), 1), 4 * pi * 100, 0.02);
}

TEST(PathEnergy, OfManyLampsIsFoundByAskingAFew) {
    accel::SceneInput input = test::closed_rooms();
    test::paint(input, {0.5f, 0.5f, 0.5f});
    for (int i = 0; i < 12; ++i) test::hang(input, {0.4 + 0.27 * i, 0.5 + 0.15 * i, 2.1}, {20, 20, 20}, i % 2 * 0.1);
    const accel::Scene scene = accel::assemble(input);
    for (const int few : {1, 3}) {
        PathOptions options = furnace_options();
        options.lamps_per_bounce = few;
        expect_near(absorbed(scene.view(), 0.5, options, 1), 12 * 4 * pi * 20, 0.05);
    }
}

/// Light of 1 from everywhere.
PathOptions even_light() {
    PathOptions options;
    options.samples_per_pixel = 4;
    options.most_bounces = 1000;
    options.lamps = false;
    options.sun = 0;
    options.look.sky_zenith = options.look.sky_horizon = {1, 1, 1};
    return options;
}

TEST(WhiteFurnace, RoomsOfWhiteSurfacesAreAsBrightAsTheSky) {
    accel::SceneInput input = test::synthetic_office({.rooms_per_row = 2, .rows = 2, .turn = 0.2});
    test::paint(input, {1, 1, 1});
    for (accel::InputPortal& portal : input.portals) portal.tint = {1, 1, 1};
    const accel::Scene scene = accel::assemble(input);
    const test::SurfacePlaces places = test::surface_places(scene.view(), 500, 3);
    RayStats stats;
    PathOptions options = even_light();
    options.stats = &stats;
    const std::vector<PlaceLight> light = measure_light(scene.view(), places.view(), options);
    std::size_t dark = 0;
    for (const PlaceLight& one : light) dark += std::abs(one.lux.x / pi - 1) > 1e-3 ? 1u : 0u;
    EXPECT_EQ(dark, 0u);
    EXPECT_GT(stats.rays, 20u * places.points.size());  // light came a long way
    EXPECT_EQ(stats.leaks, 0u);
}

/// Lux of one lamp at a place of the floor with that normal, and its standard error.
PlaceLight direct_light(const accel::SceneInput& input, Vec3f point, Vec3f normal, int samples) {
    const accel::Scene scene = accel::assemble(input);
    PathOptions options;
    options.sky = options.sun = 0;
    options.most_bounces = 0;
    options.samples_per_pixel = samples;
    const accel::CellId cell = scene.view().lights[0].cell;
    return measure_light(scene.view(), {{&point, 1}, {&normal, 1}, {&cell, 1}}, options)[0];
}

TEST(PathDirectLight, OfAPointIsThatOfTheInverseSquare) {
    accel::SceneInput input = test::closed_room();
    test::hang(input, {2, 2, 2.5}, {120, 60, 30});
    const PlaceLight light = direct_light(input, {3, 1, 0}, {0, 0, 1}, 4);
    const double d2 = 1 + 1 + 2.5 * 2.5, expected = 120 * 2.5 / (d2 * std::sqrt(d2));
    EXPECT_NEAR(light.lux.x, expected, 1e-5 * expected);
    EXPECT_NEAR(light.lux.z, expected / 4, 1e-5 * expected);
    EXPECT_LT(light.standard_error, 1e-6);
}

TEST(PathDirectLight, OfABallAboveTheHorizonIsThatOfItsCentre) {
    accel::SceneInput input = test::closed_room();
    test::hang(input, {2, 2, 2.5}, {120, 60, 30}, 0.45);
    const PlaceLight light = direct_light(input, {3, 1, 0}, {0, 0, 1}, 4096);
    const double d2 = 1 + 1 + 2.5 * 2.5, expected = 120 * 2.5 / (d2 * std::sqrt(d2));
    EXPECT_NEAR(light.lux.x, expected, 1e-4 * expected);
    EXPECT_LT(light.standard_error, 1e-4 * expected);
}

/// Form factor of a ball, its centre in the plane of the surface (Howell's catalogue): distance h of its radii.
TEST(PathDirectLight, OfABallHalfBelowTheHorizonIsItsFormFactor) {
    accel::SceneInput input = test::closed_room();
    const double radius = 0.5, distance = 1.25, h = distance / radius;
    test::hang(input, {3, 2, 1.5}, {100, 100, 100}, radius);
    const PlaceLight light = direct_light(input, {3.0f - 1.25f, 2, 1.5f}, {0, 0, 1}, 16384);
    const double factor = (std::atan(1 / std::sqrt(h * h - 1)) - std::sqrt(h * h - 1) / (h * h)) / pi;
    const double expected = 100 / (radius * radius) * factor;  // radiance I / (pi r2), times pi
    EXPECT_NEAR(light.lux.x, expected, 3e-4 * expected);
}

}  // namespace
}  // namespace enfilade::render

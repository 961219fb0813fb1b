// Rays through cells and walls alike, against every face of the building and against themselves reversed.

#include "render/crossings.h"

#include <gtest/gtest.h>

#include <random>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "render/oracle.h"
#include "tests/render/every_face.h"
#include "tests/render/walk_paths.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

using accel::Label;
using accel::Surface;

constexpr double infinite = std::numeric_limits<double>::infinity();

accel::Scene office(double turn, bool doors = true) {
    return accel::assemble(
        test::synthetic_office({.rooms_per_row = 4, .rows = 4, .storeys = 2, .doors = doors, .turn = turn}));
}

/// A point that only rounding gives to a cell counts as one in the wall beside it.
RayQuery segment(const accel::SceneView& scene, Vec3d p, Vec3d q) {
    const auto cell = accel::locate(scene, {p.x, p.y, p.z});
    const bool is_inside = cell && accel::contains(scene, *cell, {p.x, p.y, p.z});
    return {p, q - p, is_inside ? *cell : none<accel::CellId>, length(q - p)};
}

struct Passages {
    std::vector<Passage> passages;
    PassagesEnd end;
};

Passages pass(const accel::SceneView& scene, const RayQuery& ray) {
    PassageTable table = all_crossings(scene, {&ray, 1});
    EXPECT_EQ(table.offsets.front(), 0u);
    EXPECT_EQ(table.offsets.back(), table.passages.size());
    return {std::move(table.passages), table.ends[0]};
}

/// No gap, no overlap, no end before its beginning, borders and faces that fit together.
void expect_whole(const Passages& ray, double limit) {
    double at = 0;
    for (std::size_t i = 0; i < ray.passages.size(); ++i) {
        const Passage& p = ray.passages[i];
        ASSERT_EQ(p.enter, at);
        ASSERT_GE(p.leave, p.enter);
        ASSERT_EQ(p.entered == Border::End, i == 0);
        if (i > 0) {
            const Passage& before = ray.passages[i - 1];
            ASSERT_EQ(before.left, p.entered);
            ASSERT_EQ(before.face_out, p.face_in);
            // Where a line meets two cells at one point of their edges, no face may lie between them.
            if (before.length() > 0) {
                ASSERT_EQ(before.left == Border::Face, before.face_out != none<accel::SourceFaceId>);
            }
            ASSERT_FALSE(before.is_solid() && p.is_solid());  // without solids' names
        }
        at = p.leave;
    }
    if (limit < infinite) {
        ASSERT_FALSE(ray.passages.empty());
        ASSERT_NEAR(at, limit, 1e-12 * limit);
        ASSERT_EQ(ray.passages.back().left, Border::End);
    }
}

class Crossings : public testing::TestWithParam<double> {};

TEST_P(Crossings, MeetTheFacesThatBruteForceMeets) {
    const accel::Scene scene = office(GetParam());
    const accel::SceneView& view = scene.view();
    const Oracle oracle(view);
    const double band = error_band(view);
    std::mt19937_64 random(31);
    int compared = 0, solids = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto cell = std::uint32_t(random() % view.cells.size());
        const Vec3d p = test::random_point(view, cell, random);
        const Vec3d d = test::random_direction(random);
        const Passages ray = pass(view, {p, d, accel::CellId(cell)});
        expect_whole(ray, infinite);
        ASSERT_TRUE(ray.end == PassagesEnd::Left || ray.end == PassagesEnd::Buried);
        if (oracle.edge_distance(p, d, 200) <= band) continue;
        ++compared;
        std::vector<test::FaceMet> found;
        for (const Passage& passage : ray.passages) {
            if (passage.is_solid()) {
                found.push_back({passage.enter, std::uint32_t(passage.face_in), true});
                if (passage.left == Border::Face)
                    found.push_back({passage.leave, std::uint32_t(passage.face_out), false});
                ++solids;
            } else if (&passage == &ray.passages.back()) {
                found.push_back({passage.leave, std::uint32_t(passage.face_out), true});
            }
        }
        const std::vector<test::FaceMet> expected = test::faces_met(view, p, d, infinite);
        ASSERT_EQ(found.size(), expected.size()) << "ray " << i;
        for (std::size_t k = 0; k < found.size(); ++k) {
            ASSERT_EQ(found[k].face, expected[k].face) << "ray " << i;
            ASSERT_EQ(found[k].ends_light, expected[k].ends_light);
            ASSERT_NEAR(found[k].distance, expected[k].distance, 1e-6);
        }
    }
    EXPECT_GT(compared, 2500);
    EXPECT_GT(solids, 3000);
}

void expect_reversed(const accel::SceneView& view, Vec3d p, Vec3d q) {
    const Passages there = pass(view, segment(view, p, q)), back = pass(view, segment(view, q, p));
    const double distance = length(q - p);
    expect_whole(there, distance);
    expect_whole(back, distance);
    ASSERT_EQ(there.passages.size(), back.passages.size());
    for (std::size_t i = 0; i < there.passages.size(); ++i) {
        const Passage& a = there.passages[i];
        const Passage& b = back.passages[back.passages.size() - 1 - i];
        ASSERT_EQ(a.cell, b.cell);
        ASSERT_EQ(a.label, b.label);
        ASSERT_NEAR(a.length(), b.length(), 1e-6);
        ASSERT_EQ(a.entered, b.left);
        ASSERT_EQ(a.face_in != none<accel::SourceFaceId>, b.face_out != none<accel::SourceFaceId>);
        if (a.label != Label::Outside) {
            ASSERT_EQ(a.is_solid() ? a.face_in : none<accel::SourceFaceId>,
                      b.is_solid() ? b.face_out : none<accel::SourceFaceId>);
        }
    }
}

TEST_P(Crossings, OfReversedSegmentsAreReversed) {
    const accel::Scene scene = office(GetParam());
    const accel::SceneView& view = scene.view();
    std::mt19937_64 random(32);
    for (int i = 0; i < 5000; ++i) {
        const Vec3d p = test::random_point(view, std::uint32_t(random() % view.cells.size()), random);
        const Vec3d q = test::random_point(view, std::uint32_t(random() % view.cells.size()), random);
        expect_reversed(view, p, q);
    }
}

INSTANTIATE_TEST_SUITE_P(Turns, Crossings, testing::Values(0.0, 0.1, 0.7));

// On lines of the grid every product is exact, so ties are met, and met from both sides.
// Upright lines in the planes of walls.
TEST(DegenerateCrossings, UprightInWallsAreReversed) {
    const accel::Scene scene = office(0);
    const accel::SceneView& view = scene.view();
    std::mt19937_64 random(36);
    int through_solids = 0;
    for (int i = 0; i < 2000; ++i) {
        const accel::Cell& cell = view.cells[random() % view.cells.size()];
        const std::uint32_t k = std::uint32_t(random() % cell.section_count);
        const std::uint32_t a = cell.first_section + k, b = cell.first_section + (k + 1) % cell.section_count;
        const double s = double(1 + random() % 7) / 8;
        const double x = (1 - s) * view.section_x[a] + s * view.section_x[b];
        const double y = (1 - s) * view.section_y[a] + s * view.section_y[b];
        expect_reversed(view, {x, y, 0.25}, {x, y, 9.75});
        for (const Passage& passage : pass(view, segment(view, {x, y, 0.25}, {x, y, 9.75})).passages)
            through_solids += passage.is_solid();
    }
    EXPECT_GT(through_solids, 1000);
}

TEST(DegenerateCrossings, AlongAxesThroughVerticesAndWallsAreReversed) {
    const accel::Scene scene = office(0);
    const accel::SceneView& view = scene.view();
    std::mt19937_64 random(33);
    const auto below = [&](std::uint64_t n) { return random() % n; };
    int through_solids = 0;
    for (int i = 0; i < 4000; ++i) {
        // A line along one axis through a corner of some face: in walls' planes, in floors, through vertical lines.
        const accel::Vertex& v = view.vertices[below(view.vertices.size())];
        const int axis = int(below(3));
        Vec3d p = {v.x, v.y, v.z}, q = p;
        double& from = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
        double& to = axis == 0 ? q.x : axis == 1 ? q.y : q.z;
        from = view.locator_nodes[0].low[axis] + 0.25;
        to = view.locator_nodes[0].high[axis] - 0.25;
        expect_reversed(view, p, q);
        for (const Passage& passage : pass(view, segment(view, p, q)).passages) through_solids += passage.is_solid();
    }
    EXPECT_GT(through_solids, 2000);
}

TEST(DegenerateCrossings, AimedFromCornerToCornerCoverTheirLength) {
    const accel::Scene scene = office(0.3);
    const accel::SceneView& view = scene.view();
    std::mt19937_64 random(34);
    for (int i = 0; i < 20000; ++i) {
        const accel::Vertex& a = view.vertices[random() % view.vertices.size()];
        const accel::Vertex& b = view.vertices[random() % view.vertices.size()];
        const Vec3d p = {a.x, a.y, a.z}, q = {b.x, b.y, b.z};
        if (p == q) continue;
        const Passages ray = pass(view, segment(view, p, q));
        ASSERT_NE(ray.end, PassagesEnd::Leak);
        expect_whole(ray, length(q - p));
        ASSERT_LT(ray.passages.size(), 200u);
    }
}

TEST(CrossingsThrough, SlabsAreVertical) {
    const accel::Scene scene = office(0);
    const accel::SceneView& view = scene.view();
    const auto start = accel::locate(view, {2, 3, 1});
    ASSERT_TRUE(start);
    const Passages up = pass(view, {{2, 3, 1}, {0, 0, 5}, *start});
    ASSERT_EQ(up.passages.size(), 5u);  // room, slab, room, roof, exterior
    const std::array labels = {Label::Room, Label::Slab, Label::Room, Label::Slab, Label::Exterior};
    for (std::size_t i = 0; i < labels.size(); ++i) EXPECT_EQ(up.passages[i].label, labels[i]) << i;
    EXPECT_NEAR(up.passages[1].length(), 0.3, 1e-3);
    EXPECT_EQ(up.passages[1].surface_in, std::uint8_t(Surface::Ceiling));
    EXPECT_EQ(up.passages[1].surface_out, std::uint8_t(Surface::Floor));
    EXPECT_EQ(up.end, PassagesEnd::Left);
    const Passages down = pass(view, {{2, 3, 1}, {0, 0, -1}, *start});
    EXPECT_EQ(down.end, PassagesEnd::Buried);
    EXPECT_EQ(down.passages.back().leave, infinite);
}

TEST(CrossingsThrough, WallsHaveTheirThickness) {
    const accel::Scene scene = office(0, false);
    const accel::SceneView& view = scene.view();
    const Passages ray = pass(view, segment(view, {2, 3, 1}, {6, 3, 1}));
    ASSERT_EQ(ray.passages.size(), 3u);
    EXPECT_EQ(ray.passages[1].label, Label::Wall);
    EXPECT_GT(ray.passages[1].length(), 0.05);
    EXPECT_LT(ray.passages[1].length(), 0.5);
    EXPECT_EQ(ray.passages[1].surface_in, std::uint8_t(Surface::WallPaper));
    EXPECT_NE(ray.passages[1].material_in, none<accel::MaterialId>);
    EXPECT_EQ(ray.end, PassagesEnd::Reached);
}

TEST(CrossingsFrom, InsideAWallBeginInTheWall) {
    const accel::Scene scene = office(0);
    const accel::SceneView& view = scene.view();
    ASSERT_FALSE(accel::locate(view, {0.1, 3, 1}));
    const Passages ray = pass(view, segment(view, {0.1, 3, 1}, {2, 3, 1}));
    ASSERT_EQ(ray.passages.size(), 2u);
    EXPECT_TRUE(ray.passages[0].is_solid());
    EXPECT_EQ(ray.passages[0].label, Label::Wall);
    EXPECT_EQ(ray.passages[0].face_in, none<accel::SourceFaceId>);
    EXPECT_EQ(ray.passages[0].left, Border::Face);
    expect_whole(ray, 1.9);
    // Not out of it again: all that is known is where it ends.
    const Passages inside = pass(view, segment(view, {0.1, 3, 1}, {0.1, 3, 1.5}));
    ASSERT_EQ(inside.passages.size(), 1u);
    EXPECT_EQ(inside.passages[0].label, Label::Wall);
}

TEST(CrossingsFrom, FarOutsideReachTheSite) {
    const accel::Scene scene = office(0);
    const accel::SceneView& view = scene.view();
    const RayQuery far = {{-100000, 3, 1}, {1, 0, 0}, none<accel::CellId>};
    const Passages ray = pass(view, far);
    ASSERT_GT(ray.passages.size(), 4u);
    EXPECT_EQ(ray.passages[0].label, Label::Outside);
    EXPECT_GT(ray.passages[0].length(), 99900);
    EXPECT_EQ(ray.passages[0].surface_out, std::uint8_t(Surface::Sky));
    EXPECT_EQ(ray.passages[1].label, Label::Exterior);
    EXPECT_EQ(ray.end, PassagesEnd::Left);
    const Passages past = pass(view, {{-100000, 3, 1}, {-1, 0, 0}, none<accel::CellId>});
    EXPECT_TRUE(past.passages.empty());
    EXPECT_EQ(past.end, PassagesEnd::Left);
    const Passages limited = pass(view, {{-100000, 3, 1}, {-1, 0, 0}, none<accel::CellId>, 5});
    ASSERT_EQ(limited.passages.size(), 1u);
    EXPECT_EQ(limited.passages[0].label, Label::Outside);
}

TEST(CrossingsOf, WhatIsNoRayAreRefused) {
    const accel::Scene scene = office(0);
    const accel::SceneView& view = scene.view();
    const auto start = *accel::locate(view, {2, 3, 1});
    const double nan = std::nan("");
    const std::vector<RayQuery> rays = {{{2, 3, 1}, {0, 0, 0}, start},        {{nan, 3, 1}, {1, 0, 0}, start},
                                        {{2, 3, 1}, {1, infinite, 0}, start}, {{2, 3, 1}, {1, 0, 0}, start, nan},
                                        {{2, 3, 1}, {1, 0, 0}, start, -1},    {{2, 3, 1}, {1, 0, 0}, start, 1}};
    const PassageTable table = all_crossings(view, rays);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(table.ends[i], PassagesEnd::Refused) << i;
        EXPECT_EQ(table.offsets[i + 1], 0u);
    }
    EXPECT_EQ(table.ends[5], PassagesEnd::Reached);
}

TEST(CrossingsOf, ManyRaysDoNotDependOnTheThreads) {
    const accel::Scene scene = office(0.1);
    const accel::SceneView& view = scene.view();
    std::mt19937_64 random(35);
    std::vector<RayQuery> rays;
    for (int i = 0; i < 5000; ++i) {
        const auto cell = std::uint32_t(random() % view.cells.size());
        rays.push_back({test::random_point(view, cell, random), test::random_direction(random), accel::CellId(cell)});
    }
    const accel::ThreadExecutor threads(4);
    const PassageTable one = all_crossings(view, rays), many = all_crossings(view, rays, {.executor = &threads});
    EXPECT_EQ(one.offsets, many.offsets);
    ASSERT_EQ(one.passages.size(), many.passages.size());
    for (std::size_t i = 0; i < one.passages.size(); ++i) ASSERT_EQ(one.passages[i].leave, many.passages[i].leave);
    RayStats stats;
    (void)all_crossings(view, rays, {.stats = &stats});
    EXPECT_EQ(stats.leaks, 0u);
    EXPECT_GT(stats.cells, rays.size());
}

TEST(FirstEntry, SaysHowFarBehindAFaceARayStarts) {
    const accel::Scene scene = office(0);
    const accel::SceneView& view = scene.view();
    FirstEntry entry;
    ASSERT_TRUE(first_entry(view, {0.1, 3, 1}, {3, 0, 0}, entry));
    const Passages ray = pass(view, segment(view, {0.1, 3, 1}, {2, 3, 1}));
    EXPECT_EQ(entry.cell, ray.passages[1].cell);
    EXPECT_NEAR(entry.distance, ray.passages[1].enter, 1e-12);
    EXPECT_NEAR(entry.depth, entry.distance, 1e-12);
    EXPECT_FALSE(entry.through_sky);
    ASSERT_TRUE(first_entry(view, {-1000, 3, 1}, {3, 0, 0}, entry));
    EXPECT_TRUE(entry.through_sky);
    EXPECT_FALSE(first_entry(view, {-1000, 3, 1}, {-3, 0, 0}, entry));
    EXPECT_FALSE(first_entry(view, {-1000, 3, 1}, {0, 0, 0}, entry));
}

}  // namespace
}  // namespace enfilade::render

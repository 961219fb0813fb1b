// Shadow rays: what lies between two points, against the oracle and against themselves exchanged.
#include <gtest/gtest.h>

#include <limits>

#include "accel/assemble.h"
#include "render/oracle.h"
#include "render/ray_stream.h"
#include "render/trace_rays.h"
#include "tests/render/walk_paths.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

constexpr StreamOptions scalar = {.tracer = Tracer::Scalar};

/// Segments as a program keeps them.
struct Segments {
    std::vector<float> from[3], to[3];
    std::vector<accel::CellId> from_cell, to_cell;

    void add(Vec3d p, std::uint32_t p_cell, Vec3d q, std::uint32_t q_cell) {
        const float a[3] = {float(p.x), float(p.y), float(p.z)}, b[3] = {float(q.x), float(q.y), float(q.z)};
        for (int k = 0; k < 3; ++k) {
            from[k].push_back(a[k]);
            to[k].push_back(b[k]);
        }
        from_cell.push_back(static_cast<accel::CellId>(p_cell));
        to_cell.push_back(static_cast<accel::CellId>(q_cell));
    }
    [[nodiscard]] std::size_t count() const { return from_cell.size(); }
    [[nodiscard]] Vec3d p(std::size_t i) const { return {from[0][i], from[1][i], from[2][i]}; }
    [[nodiscard]] Vec3d q(std::size_t i) const { return {to[0][i], to[1][i], to[2][i]}; }
    [[nodiscard]] Segments exchanged() const {
        return {{to[0], to[1], to[2]}, {from[0], from[1], from[2]}, to_cell, from_cell};
    }
    [[nodiscard]] std::vector<std::uint8_t> seen(const accel::SceneView& scene, bool cells_known,
                                                 const StreamOptions& options = scalar) const {
        std::vector<std::uint8_t> answers(count(), 77);
        SegmentColumns columns = {from[0], from[1], from[2], to[0], to[1], to[2], from_cell, {}};
        if (cells_known) columns.to_cell = to_cell;
        visible(scene, columns, answers, options);
        return answers;
    }
};

std::uint32_t number(accel::CellId cell) { return static_cast<std::uint32_t>(cell); }

bool seen(const accel::SceneView& scene, Vec3d p, std::uint32_t p_cell, Vec3d q, std::uint32_t q_cell = no_cell) {
    Segments one;
    one.add(p, p_cell, q, q_cell);
    return one.seen(scene, q_cell != no_cell)[0] != 0;
}

/// Pairs of points of cells that are not far from each other: about half of them see each other.
Segments random_segments(const accel::SceneView& scene, std::size_t count) {
    std::mt19937_64 random(11);
    Segments segments;
    while (segments.count() < count) {
        const auto a = static_cast<std::uint32_t>(random() % scene.cells.size());
        const Vec3d p = test::random_point(scene, a, random);
        for (int tries = 0; tries < 6; ++tries) {
            const auto b = static_cast<std::uint32_t>(random() % scene.cells.size());
            const Vec3d q = test::random_point(scene, b, random);
            if (length(q - p) > 9 && tries < 5) continue;
            segments.add(p, a, q, b);
            break;
        }
    }
    return segments;
}

/// Whether the segment passes an edge within the band, so that rounding may decide.
bool is_doubtful(const Oracle& oracle, Vec3d p, Vec3d q, double band) {
    return oracle.edge_distance(p, q - p, length(q - p) + band) <= band;
}

class Visible : public testing::TestWithParam<double> {
protected:
    accel::Scene scene_ =
        accel::assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 4, .storeys = 2, .turn = GetParam()}));
};

TEST_P(Visible, IsWhatTheOracleSees) {
    const accel::SceneView& view = scene_.view();
    const Oracle oracle(view);
    const double band = error_band(view);
    const Segments segments = random_segments(view, 20000);
    std::size_t pairs_that_see = 0, doubtful = 0;
    for (const bool cells_known : {false, true}) {
        const std::vector<std::uint8_t> answers = segments.seen(view, cells_known);
        for (std::size_t i = 0; i < segments.count(); ++i) {
            const Vec3d p = segments.p(i), q = segments.q(i);
            const auto hit = oracle.trace(p, q - p);
            const bool expected = !hit || hit->distance > length(q - p);
            pairs_that_see += answers[i];
            if ((answers[i] != 0) == expected) continue;
            ++doubtful;
            EXPECT_TRUE(is_doubtful(oracle, p, q, band)) << "segment " << i << " cells known: " << cells_known;
        }
    }
    EXPECT_GT(pairs_that_see, 4000u);
    EXPECT_LT(pairs_that_see, 36000u);
    EXPECT_LT(doubtful, 40u);
}

TEST_P(Visible, IsTheSameFromTheOtherEnd) {
    const accel::SceneView& view = scene_.view();
    const Oracle oracle(view);
    const double band = error_band(view);
    const Segments segments = random_segments(view, 100000);
    for (const bool cells_known : {false, true}) {
        const std::vector<std::uint8_t> there = segments.seen(view, cells_known);
        const std::vector<std::uint8_t> back = segments.exchanged().seen(view, cells_known);
        std::size_t differ = 0;
        for (std::size_t i = 0; i < segments.count(); ++i) {
            if (there[i] == back[i]) continue;
            ++differ;
            EXPECT_TRUE(is_doubtful(oracle, segments.p(i), segments.q(i), band)) << "segment " << i;
        }
        EXPECT_LT(differ, 40u) << "of 100000";
    }
}

TEST_P(Visible, DoesNotDependOnOrderOrKnownCells) {
    const accel::SceneView& view = scene_.view();
    const Oracle oracle(view);
    const Segments segments = random_segments(view, 50000);
    StreamOptions sorted = scalar;
    sorted.order = StreamOrder::Any;
    const std::vector<std::uint8_t> known = segments.seen(view, true);
    EXPECT_EQ(segments.seen(view, true, sorted), known);
    const std::vector<std::uint8_t> unknown = segments.seen(view, false);
    EXPECT_EQ(segments.seen(view, false, sorted), unknown);
    for (std::size_t i = 0; i < segments.count(); ++i)
        EXPECT_TRUE(known[i] == unknown[i] || is_doubtful(oracle, segments.p(i), segments.q(i), error_band(view)))
            << "segment " << i;
}

// A lamp's ray to a point of a surface is not stopped by that surface: where the cell is known, never; on levels also
// where it is not, since their arithmetic is exact.
TEST_P(Visible, ReachesPointsOnTheFacesOfTheirCell) {
    const accel::SceneView& view = scene_.view();
    std::mt19937_64 random(13);
    int levels = 0, walls = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto cell = static_cast<std::uint32_t>(random() % view.cells.size());
        const Vec3d p = test::random_point(view, cell, random);
        const Vec3d d = vec_cast<double>(vec_cast<float>(test::random_direction(random)));
        const RayHit hit = trace_ray(view, {p, d, static_cast<accel::CellId>(cell)});
        ASSERT_EQ(hit.status, WalkStatus::Hit);
        Vec3d q = p + (hit.distance / length(d)) * d;
        const accel::Cell& last = view.cells[index(hit.cell)];
        // A point of a level that is near its cell's border may round across it: so may a ray.
        if (hit.exit == Exit::Floor) q.z = last.z_floor;
        if (hit.exit == Exit::Ceiling) q.z = last.z_ceiling;
        if (hit.exit != Exit::Side) {
            const Vec3d centre = test::centre_of(view, number(hit.cell));
            q = {q.x + 1e-3 * (centre.x - q.x), q.y + 1e-3 * (centre.y - q.y), q.z};
            if (hit.cell != static_cast<accel::CellId>(cell)) continue;
            ++levels;
            EXPECT_TRUE(seen(view, p, cell, q)) << i;
        } else if (hit.cell != static_cast<accel::CellId>(cell)) {
            ++walls;
            EXPECT_TRUE(seen(view, p, cell, q, number(hit.cell))) << i;
        }
        EXPECT_TRUE(seen(view, q, number(hit.cell), p, cell)) << i;
    }
    EXPECT_GT(levels, 1000);
    EXPECT_GT(walls, 1000);
}

TEST_P(Visible, EndsOnBordersOfCells) {
    const accel::SceneView& view = scene_.view();
    // The middle of every portal is seen from both of its cells' centres, whichever of them it is said to lie in.
    int portals = 0;
    for (std::uint32_t c = 0; c < view.cells.size(); ++c) {
        const accel::Cell& cell = view.cells[c];
        for (std::uint32_t i = 0; i < cell.section_count; ++i) {
            const std::uint32_t a = cell.first_section + i, b = cell.first_section + (i + 1) % cell.section_count;
            float below = cell.z_floor;
            for (std::uint32_t f = view.section_tails[a].first_face; f < view.section_tails[a + 1].first_face; ++f) {
                const float top = view.side_faces[f].z_top;
                const accel::Target target = view.side_faces[f].target;
                const Vec3d q = {0.5f * (view.section_x[a] + view.section_x[b]),
                                 0.5f * (view.section_y[a] + view.section_y[b]), 0.5f * (below + top)};
                below = top;
                if (!target.is_portal()) continue;
                ++portals;
                const Vec3d p = test::centre_of(view, c);
                EXPECT_TRUE(seen(view, p, c, q));
                EXPECT_TRUE(seen(view, p, c, q, c));
                EXPECT_TRUE(seen(view, p, c, q, number(target.neighbour())));
                EXPECT_TRUE(seen(view, q, c, p));
                EXPECT_TRUE(seen(view, q, number(target.neighbour()), p, c));
            }
        }
    }
    EXPECT_GT(portals, 100);
}

INSTANTIATE_TEST_SUITE_P(Turned, Visible, testing::Values(0.0, 0.3));

TEST(VisibleThrough, GlassButNotWalls) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2}));
    const accel::SceneView& view = scene.view();
    std::uint32_t window = 0;
    while (view.cells[window].label != accel::Label::Window) ++window;
    const Vec3d glass = test::centre_of(view, window);
    const RayHit out = trace_ray(view, {glass, {0, -1, 0}, static_cast<accel::CellId>(window)});
    const RayHit in = trace_ray(view, {glass, {0, 1, 0}, static_cast<accel::CellId>(window)});
    ASSERT_NE(out.throughput, (Vec3f{1, 1, 1})) << "the window's pane is tinted";
    const Vec3d outside = glass - Vec3d{0, 0.9 * out.distance, 0}, inside = glass + Vec3d{0, 0.5 * in.distance, 0};
    EXPECT_TRUE(seen(view, inside, number(in.cell), outside));
    EXPECT_TRUE(seen(view, outside, number(out.cell), inside));
    EXPECT_TRUE(seen(view, outside, number(out.cell), inside, number(in.cell)));
    // Under the sill the wall is in the way.
    const Vec3d low = {inside.x, inside.y, double{view.cells[index(in.cell)].z_floor} + 0.25};
    const Vec3d low_outside = {outside.x, outside.y, low.z};
    EXPECT_FALSE(seen(view, low, number(in.cell), low_outside));
    EXPECT_FALSE(seen(view, low_outside, number(out.cell), low, number(in.cell)));
}

TEST(VisiblePoints, ThatAreEqualSeeEachOtherAndThatAreNoneSeeNothing) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2}));
    const accel::SceneView& view = scene.view();
    const Vec3d p = test::centre_of(view, 0);
    EXPECT_TRUE(seen(view, p, 0, p));
    EXPECT_TRUE(seen(view, p, 0, p, 0));
    Vec3d near = p;
    near.x = std::nextafter(float(p.x), 1e9f);
    EXPECT_TRUE(seen(view, p, 0, near));
    EXPECT_TRUE(seen(view, near, 0, p));
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()})
        for (const Vec3d q : {Vec3d{bad, p.y, p.z}, {p.x, bad, p.z}, {p.x, p.y, bad}})
            for (const std::uint32_t cell : {no_cell, 0u}) {
                EXPECT_FALSE(seen(view, p, 0, q, cell));
                EXPECT_FALSE(seen(view, q, 0, p, cell));
                EXPECT_FALSE(seen(view, q, 0, q, cell));
            }
}

}  // namespace
}  // namespace enfilade::render

// Every instruction set that the machine has answers streams of rays, and draws pictures, like the loops for any
// machine, which walk one ray after the other: bit for bit, rare cases included.
#include <gtest/gtest.h>

#include <limits>

#include "accel/assemble.h"
#include "render/kernel.h"
#include "render/trace.h"
#include "tests/render/walk_paths.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

/// Corridors of it have more lines than any instruction takes at once.
accel::Scene office(double turn) {
    return accel::assemble(test::synthetic_office({.rooms_per_row = 24, .rows = 4, .storeys = 2, .turn = turn}));
}

/// Rays, or segments: `way` is a direction or the other end.
struct Columns {
    std::vector<float> from[3], way[3], limit;
    std::vector<accel::CellId> cell, to_cell;

    void add(Vec3d origin, Vec3d direction, std::uint32_t in, float metres = 1e30f, std::uint32_t to = 0) {
        const Vec3f o = vec_cast<float>(origin), d = vec_cast<float>(direction);
        const float a[3] = {o.x, o.y, o.z}, b[3] = {d.x, d.y, d.z};
        for (int k = 0; k < 3; ++k) {
            from[k].push_back(a[k]);
            way[k].push_back(b[k]);
        }
        limit.push_back(metres);
        cell.push_back(static_cast<accel::CellId>(in));
        to_cell.push_back(static_cast<accel::CellId>(to));
    }
};

struct Answers {
    std::vector<float> distance;
    std::vector<accel::SourceFaceId> face;
    std::vector<accel::CellId> cell;
    std::vector<WalkStatus> status;

    explicit Answers(std::size_t n) : distance(n), face(n), cell(n), status(n) {}
};

std::vector<std::uint32_t> shuffled(std::size_t count) {
    std::vector<std::uint32_t> order(count);
    for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<std::uint32_t>((i * 7919 + 13) % count);
    return order;
}

Answers nearest_by(const detail::Kernels& set, const accel::SceneView& scene, const Columns& rays, bool limited,
                   const std::vector<std::uint32_t>& order = {}) {
    Answers answers(rays.cell.size());
    detail::StreamJob job = {};
    job.scene = &scene;
    for (int k = 0; k < 3; ++k) {
        job.origin[k] = rays.from[k].data();
        job.direction[k] = rays.way[k].data();
    }
    job.start = rays.cell.data();
    job.max_distance = limited ? rays.limit.data() : nullptr;
    job.distance = answers.distance.data();
    job.source_face = answers.face.data();
    job.cell = answers.cell.data();
    job.status = answers.status.data();
    job.order = order.empty() ? nullptr : order.data();
    job.end = rays.cell.size();
    set.nearest(job);
    return answers;
}

void expect_equal(const Answers& a, const Answers& b) {
    for (std::size_t i = 0; i < a.status.size(); ++i) {
        ASSERT_EQ(a.status[i], b.status[i]) << i;
        ASSERT_EQ(bits_of(a.distance[i]), bits_of(b.distance[i])) << i << " " << a.distance[i] << " " << b.distance[i];
        ASSERT_EQ(a.face[i], b.face[i]) << i;
        ASSERT_EQ(a.cell[i], b.cell[i]) << i;
    }
}

/// Random ones, and what the paper leaves open: through vertical lines and corners, along sides and levels, upright,
/// with zeros of either sign, and what is no ray.
Columns trying_rays(const accel::SceneView& scene, std::size_t random_count) {
    std::mt19937_64 random(99);
    std::uniform_real_distribution<float> metres(0.0f, 15);
    Columns rays;
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < random_count; ++i) {
        const auto c = static_cast<std::uint32_t>(random() % scene.cells.size());
        Vec3d d = test::random_direction(random);
        if (i % 3 == 0) d.z = 0;
        if (i % 5 == 0) d = 1e-41 * d;
        rays.add(test::random_point(scene, c, random), d, c, i % 7 == 0 ? 3e38f : metres(random));
    }
    const auto on_grid = [&](double v) { return std::floor(v / scene.unit) * scene.unit; };
    for (std::uint32_t c = 0; c < scene.cells.size(); ++c) {
        const accel::Cell& cell = scene.cells[c];
        Vec3d p = test::centre_of(scene, c);
        p = {on_grid(p.x), on_grid(p.y), on_grid(p.z)};
        for (std::uint32_t i = 0; i < cell.section_count; ++i) {
            const std::uint32_t a = cell.first_section + i, b = cell.first_section + (i + 1) % cell.section_count;
            const Vec3d from = {scene.section_x[a], scene.section_y[a], p.z};
            const Vec3d to = {scene.section_x[b], scene.section_y[b], p.z};
            for (const double dz : {0.0, 0.25, -0.25}) rays.add(p, from - p + Vec3d{0, 0, dz}, c, metres(random));
            rays.add(p, Vec3d{from.x, from.y, cell.z_floor} - p, c);
            rays.add(0.5 * (from + to), to - from, c);
            rays.add(0.5 * (from + to), from - to, c, metres(random));
        }
        for (const double zero : {0.0, -0.0})
            for (const double one : {1.0, -1.0}) {
                rays.add(p, {one, zero, zero}, c);
                rays.add(p, {zero, one, -zero}, c, metres(random));
                rays.add(p, {zero, -zero, one}, c);
                rays.add({p.x, p.y, cell.z_floor}, {one, one, zero}, c);
                rays.add({p.x, p.y, cell.z_ceiling}, {one, zero, zero}, c);
            }
        rays.add(p, {nan, 0, 1}, c);
        rays.add(p, {0, inf, 1}, c);
        rays.add({p.x, -inf, 0}, {1, 1, 1}, c);
        rays.add(p, {0, 0, -0.0}, c);
        rays.add(p, {1, 1, 1}, c, nan);
        rays.add(p, {1, 1, 1}, c, -1.0f);
    }
    return rays;
}

class KernelSets : public testing::TestWithParam<double> {
protected:
    accel::Scene scene_ = office(GetParam());
};

TEST_P(KernelSets, AnswerStreamsBitForBit) {
    const Columns rays = trying_rays(scene_.view(), 60000);
    const std::vector<std::uint32_t> order = shuffled(rays.cell.size());
    for (const bool limited : {false, true}) {
        const Answers expected = nearest_by(detail::portable_kernel_set(), scene_.view(), rays, limited);
        for (const detail::Kernels* set : detail::kernel_sets()) {
            SCOPED_TRACE(set->name);
            expect_equal(nearest_by(*set, scene_.view(), rays, limited), expected);
            expect_equal(nearest_by(*set, scene_.view(), rays, limited, order), expected);
        }
    }
}

TEST_P(KernelSets, SeeTheSamePoints) {
    const accel::SceneView& view = scene_.view();
    std::mt19937_64 random(7);
    Columns segments;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    while (segments.cell.size() < 60000) {
        const auto a = static_cast<std::uint32_t>(random() % view.cells.size());
        const auto b = static_cast<std::uint32_t>(random() % view.cells.size());
        const Vec3d p = test::random_point(view, a, random), q = test::random_point(view, b, random);
        if (length(q - p) > 12 && random() % 8 != 0) continue;
        segments.add(p, q, a, 0, b);
        if (random() % 16 == 0) segments.add(p, p, a, 0, a);
        if (random() % 16 == 0) segments.add(p, {q.x, q.y, nan}, a, 0, a);
        if (random() % 4 == 0) segments.add(p, {q.x, q.y, view.cells[b].z_floor}, a, 0, b);
        if (random() % 4 == 0) segments.add(p, {p.x, p.y, view.cells[a].z_ceiling}, a, 0, b);
    }
    const std::vector<std::uint32_t> order = shuffled(segments.cell.size());
    const auto seen_by = [&](const detail::Kernels& set, bool cells_known, bool ordered) {
        std::vector<std::uint8_t> seen(segments.cell.size(), 9);
        detail::SegmentJob job = {};
        job.scene = &view;
        for (int k = 0; k < 3; ++k) {
            job.from[k] = segments.from[k].data();
            job.to[k] = segments.way[k].data();
        }
        job.from_cell = segments.cell.data();
        job.to_cell = cells_known ? segments.to_cell.data() : nullptr;
        job.visible = seen.data();
        job.order = ordered ? order.data() : nullptr;
        job.end = seen.size();
        set.visible(job);
        return seen;
    };
    for (const bool known : {false, true}) {
        const std::vector<std::uint8_t> expected = seen_by(detail::portable_kernel_set(), known, false);
        for (const detail::Kernels* set : detail::kernel_sets())
            for (const bool ordered : {false, true}) EXPECT_EQ(seen_by(*set, known, ordered), expected) << set->name;
    }
}

TEST_P(KernelSets, DrawTheSamePixels) {
    const accel::SceneView& view = scene_.view();
    const Look look;
    // Odd sizes: tiles and rows that fill no block.
    constexpr int width = 149, height = 83;
    std::mt19937_64 random(3);
    for (int i = 0; i < 12; ++i) {
        Camera camera;
        const auto c = static_cast<std::uint32_t>(random() % view.cells.size());
        camera.eye = test::centre_of(view, c);
        camera.target = camera.eye + Vec3d{std::cos(i), std::sin(i), 0.2 * std::sin(7.0 * i)};
        if (i >= 8) camera.target = camera.eye + Vec3d{i % 2 == 0 ? 1.0 : 0.0, i % 2 == 0 ? 0.0 : -1.0, 0};
        camera.width = width;
        camera.height = height;
        const CameraFrame frame = make_frame(camera);
        const auto picture_by = [&](const detail::Kernels& set, bool is_rgb, RayStats* stats) {
            std::vector<float> rgb(3 * width * height, -1.0f);
            std::vector<std::uint32_t> rgba(width * height, 0);
            detail::TileJob job = {};
            job.scene = &view;
            job.camera = &frame;
            job.look = &look;
            if (is_rgb) job.rgb = rgb.data();
            else job.rgba = rgba.data();
            job.width = width;
            job.x0 = 5;
            job.y0 = 2;
            job.x1 = width - 1;
            job.y1 = height - 3;
            job.samples_a_side = 1;
            job.start_cell = c;
            job.stats = stats;
            job.mirror_floor = i % 2 == 0 ? 0.0f : 0.4f;
            set.lambert_tile(job);
            for (const float channel : rgb) rgba.push_back(bits_of(channel));
            return rgba;
        };
        for (const bool is_rgb : {false, true}) {
            const std::vector<std::uint32_t> expected = picture_by(detail::portable_kernel_set(), is_rgb, nullptr);
            for (const detail::Kernels* set : detail::kernel_sets()) {
                RayStats stats;
                EXPECT_EQ(picture_by(*set, is_rgb, nullptr), expected) << set->name << ", picture " << i;
                EXPECT_EQ(picture_by(*set, is_rgb, &stats), expected) << set->name << ", counted, picture " << i;
                EXPECT_GE(stats.rays, (width - 6u) * (height - 5u));
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Turned, KernelSets, testing::Values(0.0, 0.3));

TEST(KernelSetsOf, ThisMachineEndWithThoseOfAnyMachine) {
    const auto sets = detail::kernel_sets();
    ASSERT_FALSE(sets.empty());
    EXPECT_EQ(sets.front(), &detail::kernels());
    EXPECT_EQ(sets.back(), &detail::portable_kernel_set());
#if defined(__x86_64__)
    EXPECT_EQ(sets.size() > 1, __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2"));
#endif
}

}  // namespace
}  // namespace enfilade::render

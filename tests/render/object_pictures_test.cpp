// Pictures of furnished rooms by the scalar loops: every instruction set alike, lamps and cuts as they should be.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <memory>
#include <vector>

#include "accel/assemble.h"
#include "render/executor.h"
#include "render/kernel.h"
#include "render/oracle.h"
#include "render/trace.h"
#include "tests/support/object_scenes.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

std::unique_ptr<ObjectAccel> accel_of(const accel::Scene& scene) {
    return build_object_accel(scene.view(), ObjectAccelKind::Plain, *make_executor());
}

/// An 8 m x 8 m x 4 m room about (0, 0) with objects of one colour, and what traces it.
struct Furnished {
    accel::Scene scene;
    std::unique_ptr<ObjectAccel> accel;
    ObjectTracer tracer;

    explicit Furnished(accel::Scene made) : scene(std::move(made)), accel(accel_of(scene)), tracer(accel->tracer()) {}
};

Camera camera_at(Vec3d eye, Vec3d target, int width = 64, int height = 48) {
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    camera.width = width;
    camera.height = height;
    return camera;
}

TEST(ObjectPictures, AreTheSameByEveryInstructionSet) {
    const Furnished f(test::furnished_office({.seed = 5, .objects = 120, .turn = 0.2}));
    const accel::SceneView& view = f.scene.view();
    constexpr int width = 90, height = 70;
    for (int i = 0; i < 8; ++i) {
        const auto cell = static_cast<std::uint32_t>((static_cast<std::size_t>(i) * 7) % view.cells.size());
        const accel::Cell& c = view.cells[cell];
        Vec3d eye = {0, 0, 0.5 * (c.z_floor + c.z_ceiling)};
        for (std::uint32_t s = c.first_section; s < c.first_section + c.section_count; ++s)
            eye = eye + (1.0 / c.section_count) * Vec3d{view.section_x[s], view.section_y[s], 0};
        const CameraFrame frame =
            make_frame(camera_at(eye, eye + Vec3d{std::cos(i), std::sin(i), -0.3}, width, height));
        Look look;
        look.ambient_samples = 2;
        const auto picture_by = [&](const detail::Kernels& set, bool is_look, RayStats* stats) {
            std::vector<float> rgb(std::size_t{3} * width * height, -1.0f);
            detail::TileJob job = {};
            job.scene = &view;
            job.camera = &frame;
            job.look = &look;
            job.rgb = rgb.data();
            job.width = width;
            job.x1 = width;
            job.y1 = height;
            job.samples_a_side = is_look ? 2 : 1;
            job.start_cell = cell;
            job.stats = stats;
            job.mirror_floor = i % 2 == 0 ? 0.0f : 0.4f;
            job.objects = &f.tracer;
            (is_look ? set.look_tile : set.lambert_tile)(job);
            std::vector<std::uint32_t> bits;
            for (const float channel : rgb) bits.push_back(std::bit_cast<std::uint32_t>(channel));
            return bits;
        };
        for (const bool is_look : {false, true}) {
            RayStats stats;
            const auto expected = picture_by(detail::portable_kernel_set(), is_look, &stats);
            EXPECT_EQ(stats.leaks, 0u);
            for (const detail::Kernels* set : detail::kernel_sets())
                EXPECT_EQ(picture_by(*set, is_look, nullptr), expected) << set->name << ", picture " << i;
        }
    }
}

TEST(ObjectPictures, AgreeWithTheOracle) {
    const Furnished f(test::room_of_meshes({test::ball_mesh(10, 0.9f), test::box_mesh({-2, 1, 0}, {2, 2, 1})}));
    const Camera camera = camera_at({-1.5, -3.5, 2.2}, {0.25, 0.5, 0.5}, 80, 60);
    TraceOptions options;
    options.shading = Shading::Lambert;
    options.tracer = Tracer::Scalar;
    options.objects = &f.tracer;
    const Image picture = trace(f.scene.view(), camera, options);
    const CameraFrame frame = make_frame(camera);
    int hits = 0;
    for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
            const Vec3d d =
                vec_cast<double>(frame.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
            std::optional<test::BruteHit> nearest;
            Vec3d normal = {0, 0, 0};
            for (std::uint32_t m = 0; m < 2; ++m) {
                const auto hit =
                    test::brute_nearest(f.scene.view(), static_cast<accel::MeshId>(m), camera.eye, d, 0, 1e9);
                if (!hit || (nearest && nearest->t < hit->t)) continue;
                nearest = hit;
                const accel::ObjectMesh& mesh = f.scene.view().meshes[m];
                Vec3d p[3];
                for (std::size_t k = 0; k < 3; ++k) {
                    const auto corner = f.scene.view().mesh_triangles[mesh.first_triangle + hit->triangle].corners[k];
                    const accel::Vertex& v = f.scene.view().mesh_vertices[mesh.first_vertex + corner];
                    p[k] = {v.x, v.y, v.z};
                }
                normal = cross(p[1] - p[0], p[2] - p[0]);
            }
            if (!nearest || nearest->margin < 1e-3 || (camera.eye + nearest->t * d).z < 1e-3) continue;
            ++hits;
            const double cosine = std::abs(dot(normal, d)) / (length(normal) * length(d));
            const auto& colour = f.scene.view().materials[0].colour;
            const float* pixel =
                picture.rgb.data() + 3 * (static_cast<std::size_t>(y) * 80 + static_cast<std::size_t>(x));
            for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(pixel[k], cosine * colour[k], 1e-4) << x << ", " << y;
        }
    }
    EXPECT_GT(hits, 500);
}

TEST(ObjectPictures, OfBareScenesNeedNoObjects) {
    const accel::Scene bare = accel::assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2}));
    const Furnished f(test::furnished_office({.objects = 1}));
    Camera camera = camera_at({2, 2, 1.5}, {3, 4, 1});
    TraceOptions options;
    options.tracer = Tracer::Scalar;
    options.look.ambient_samples = 1;
    const Image without = trace(bare.view(), camera, options);
    options.objects = &f.tracer;  // of another scene: nobody asks it
    EXPECT_EQ(trace(bare.view(), camera, options).rgb, without.rgb);
}

/// The colour in the middle of a picture from straight above, with the building cut at that height.
Vec3f seen_in_cut(const Furnished& f, double x, double y, double cut_z) {
    Camera camera = camera_at({x, y - 0.001, 30}, {x, y, 0}, 9, 9);
    camera.fov_deg = 0.05;
    TraceOptions options;
    options.cut_z = cut_z;
    options.objects = &f.tracer;
    options.look.ambient_samples = 0;
    options.look.sun = {0, 0, 0};
    const Image picture = trace(f.scene.view(), camera, options);
    const float* p = picture.rgb.data() + 3 * 40;
    return {p[0], p[1], p[2]};
}

TEST(Dollhouse, ShowsCutObjectsInTheirColour) {
    // A box with another inside, a box above the cut, a low one; the room's walls are of material 0, too.
    const Furnished f(test::room_of_meshes(
        {test::box_mesh({-2, -1, 0}, {-1, 1, 2}), test::box_mesh({-1.8f, -0.5f, 0.25f}, {-1.2f, 0.5f, 0.75f}),
         test::box_mesh({1, -1, 2}, {2, 1, 3}), test::box_mesh({1, 2, 0}, {2, 3, 0.5f})}));
    const Vec3f inside = seen_in_cut(f, -1.5, 0, 1.5), floor = seen_in_cut(f, 0, 0, 1.5);
    const Look look;
    const auto& colour = f.scene.view().materials[0].colour;
    const float light = look.ambient.x + look.headlight;
    EXPECT_NEAR(inside.x, light * colour[0], 0.02);
    EXPECT_NEAR(seen_in_cut(f, -1.5, 0.75, 1.5).x, inside.x, 1e-3);
    // What hangs above is cut off: the floor below it is as bright as elsewhere.
    EXPECT_NEAR(seen_in_cut(f, 1.5, 0, 1.5).x, floor.x, 1e-3);
    // Between the inner box and the outer one the cut goes through the outer one alone.
    EXPECT_NEAR(seen_in_cut(f, -1.5, 0.75, 0.5).x, inside.x, 1e-3);
    EXPECT_NEAR(seen_in_cut(f, 1.5, 2.5, 1.5).x, floor.x, 0.05);
}

TEST(ObjectLook, ObjectsDarkenTheCornersAndShadeTheSun) {
    const Furnished f(test::room_of_meshes({test::box_mesh({-1, -1, 0}, {1, 1, 1})}));
    const auto brightness_at = [&](const ObjectTracer* objects, double x) {
        Camera camera = camera_at({x, 0.001, 3.5}, {x, 0, 0}, 5, 5);
        camera.fov_deg = 0.05;
        TraceOptions options;
        options.objects = objects;
        options.samples_per_pixel = 16;
        options.look.ambient_samples = 64;
        return trace(f.scene.view(), camera, options).rgb[3 * 12];
    };
    // On the floor right beside the box half of the hemisphere is the box.
    EXPECT_LT(brightness_at(&f.tracer, 1.02), 0.85f * brightness_at(&f.tracer, 3));
    // The top of the box does not shade itself.
    EXPECT_GT(brightness_at(&f.tracer, 0), 0.9f * brightness_at(&f.tracer, 2.5));
}

}  // namespace
}  // namespace enfilade::render

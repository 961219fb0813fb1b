#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "render/embree_reference.h"
#include "render/oracle.h"
#include "render/trace.h"
#include "tests/render/walk_paths.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

TEST(Embree, MeetsTheSameFacesOutsideTheBand) {
    const accel::Scene scene =
        accel::assemble(test::synthetic_office({.rooms_per_row = 6, .rows = 4, .storeys = 2, .turn = 0.3}));
    const accel::SceneView& view = scene.view();
    const EmbreeReference embree(view);
    const Oracle oracle(view);
    const double band = error_band(view);
    std::mt19937_64 random(17);
    std::vector<RayQuery> rays;
    for (int i = 0; i < 300000; ++i) {
        const auto cell = static_cast<std::uint32_t>(random() % view.cells.size());
        rays.push_back({test::random_point(view, cell, random),
                        vec_cast<double>(vec_cast<float>(test::random_direction(random))),
                        static_cast<accel::CellId>(cell)});
    }
    std::vector<RayHit> cells(rays.size()), reference(rays.size());
    trace_rays(view, rays, cells);
    embree.trace(rays, reference);
    int inside = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(cells[i].status, WalkStatus::Hit);
        if (reference[i].status == WalkStatus::Hit && cells[i].source_face == reference[i].source_face) continue;
        EXPECT_LE(oracle.edge_distance(rays[i].origin, rays[i].direction,
                                       std::max(cells[i].distance, reference[i].distance) + band),
                  band)
            << "ray " << i;
        ++inside;
    }
    EXPECT_LT(inside, 200);
}

TEST(Embree, DrawsTheSamePicture) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 4, .doors = true}));
    Camera camera;
    camera.eye = {2, 6.4, 1.6};
    camera.target = {10, 6, 1.4};
    camera.width = camera.height = 128;
    const CameraFrame frame = make_frame(camera);
    Framebuffer cells(128, 128), single(128, 128), packets(128, 128);
    trace_lambert(scene.view(), frame, start_cell(scene.view(), frame), {.tracer = Tracer::Scalar},
                  accel::SerialExecutor(), cells);
    const EmbreeReference embree(scene.view());
    embree.trace_lambert(frame, single);
    embree.trace_lambert_packets(frame, packets);
    int different = 0;
    for (std::size_t i = 0; i < cells.rgba.size(); ++i) {
        const int red = int(cells.rgba[i] & 255u), other = int(single.rgba[i] & 255u);
        // What is seen through a pane is tinted by the walk alone.
        different += std::abs(red - other) > 1 && !(red >= other * 0.86 && red < other);
        different += std::abs(int(packets.rgba[i] & 255u) - other) > 1;
    }
    EXPECT_LE(different, 12);
}

}  // namespace
}  // namespace enfilade::render

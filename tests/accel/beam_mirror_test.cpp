// Beams whose rays may rise and fall: what level mirrors throw back enters no cell that they do not get to.

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "accel/beam.h"
#include "render/mirror.h"
#include "tests/render/walk_paths.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::accel {
namespace {

using render::Vec3d;

/// The ray, and what the floor that it meets throws back.
test::Path mirrored_path(const SceneView& view, const render::Ray<double>& ray, std::uint32_t cell) {
    test::WalkedPath<double> walked = test::follow(view, ray, cell);
    if (!render::is_mirror_hit(view, walked.end)) return walked.path;
    const auto image = render::mirrored(ray, double{view.cells[walked.end.cell].z_floor});
    const test::WalkedPath<double> back = test::follow(view, image, walked.end.cell);
    walked.path.cells.insert(walked.path.cells.end(), back.path.cells.begin(), back.path.cells.end());
    return walked.path;
}

TEST(BeamsOfAnyHeight, MissNoCellOfAMirroredRay) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 5, .rows = 4, .storeys = 2, .turn = 0.1}));
    const SceneView& view = scene.view();
    std::mt19937_64 random{20261122};
    std::size_t misses = 0, only_by_mirrors = 0;
    for (int k = 0; k < 100; ++k) {
        const auto cell = static_cast<std::uint32_t>(random() % view.cells.size());
        const BeamSource source = source_of_cell(view, CellId{cell});
        const std::vector<CellId> reached = reachable_cells(view, source, {.max_beams = 16, .any_height = true});
        const std::vector<CellId> straight = reachable_cells(view, source);
        for (int r = 0; r < 2000; ++r) {
            Vec3d direction = test::random_direction(random);
            direction.z *= r % 2 == 0 ? 1 : 0.1;
            render::Ray<double> ray;
            if (!render::make_ray(test::random_point(view, cell, random), direction, ray)) continue;
            for (const std::uint32_t c : mirrored_path(view, ray, cell).cells) {
                misses += !std::ranges::binary_search(reached, CellId{c});
                only_by_mirrors += !std::ranges::binary_search(straight, CellId{c});
            }
        }
    }
    EXPECT_EQ(misses, 0u);
    EXPECT_GT(only_by_mirrors, 0u) << "or the straight beams would have been enough";
}

}  // namespace
}  // namespace enfilade::accel

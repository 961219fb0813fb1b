// What orders and schedules are for, counted without a card: lanes that work, and cells that a warp reads at a time.
// ENFILADE_STREAM_FIGURES=FILE.enf prints the table of render/cuda/README.md, for that scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string>

#include "accel/assemble.h"
#include "accel/scene_file.h"
#include "render/camera.h"
#include "render/cuda/ray_order.h"
#include "render/cuda/streams_rays.h"
#include "tests/render/cuda/warp_counts.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render::cuda {
namespace {

/// Diffuse rays of an office, on the host.
class StreamDivergence : public testing::Test {
protected:
    StreamDivergence()
        : scene_(is_figure() ? accel::open(std::getenv("ENFILADE_STREAM_FIGURES"))
                             : accel::assemble(test::synthetic_office({.rooms_per_row = 15, .rows = 9, .turn = 0.3}))) {
        Rays given;
        for (const RayPicture& picture : pictures()) given.add(bounce_rays(*device_, scene_.view(), picture, 1));
        count(given, "as given");
        Rays strangers;
        for (std::uint32_t i = 0; i < given.size(); ++i)
            strangers.add(given, shuffled_place(i, static_cast<std::uint32_t>(given.size())));
        count(strangers, "shuffled");
    }

    static bool is_figure() { return std::getenv("ENFILADE_STREAM_FIGURES") != nullptr; }

    struct Figures {
        test::WarpCounts each, fetching;
    };

    /// [given 0, shuffled 1][order]
    [[nodiscard]] const Figures& of(std::size_t stream, RayOrder order) const {
        return figures_[3 * stream + static_cast<std::size_t>(order)];
    }

private:
    struct Rays {
        std::vector<float> column[6];
        std::vector<accel::CellId> cell;

        void add(const RayBuffers& rays) {
            const DeviceRays view = rays.view();
            for (std::size_t k = 0; k < 6; ++k) {
                const float* from = k < 3 ? view.origin[k] : view.direction[k - 3];
                column[k].insert(column[k].end(), from, from + rays.size());
            }
            cell.insert(cell.end(), view.cell, view.cell + rays.size());
        }
        void add(const Rays& rays, std::size_t i) {
            for (std::size_t k = 0; k < 6; ++k) column[k].push_back(rays.column[k][i]);
            cell.push_back(rays.cell[i]);
        }
        [[nodiscard]] std::size_t size() const { return cell.size(); }
        [[nodiscard]] DeviceRays view() const {
            const auto at = [&](std::size_t k) { return column[k].data(); };
            return {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}, cell.data(), nullptr, size()};
        }
    };

    /// From the middle of cells all over the building, past its doors and windows.
    [[nodiscard]] std::vector<RayPicture> pictures() const {
        std::vector<RayPicture> all;
        const accel::SceneView& scene = scene_.view();
        std::size_t rooms = 0;
        for (std::size_t i = 0; i < scene.cells.size(); ++i) {
            const accel::Cell& cell = scene.cells[i];
            if (cell.label != accel::Label::Room || rooms++ % 17 != 0) continue;
            Vec3d middle = {0, 0, cell.z_floor + 1.6};
            for (std::uint32_t k = 0; k < cell.section_count; ++k) {
                middle.x += double(scene.section_x[cell.first_section + k]) / cell.section_count;
                middle.y += double(scene.section_y[cell.first_section + k]) / cell.section_count;
            }
            Camera camera;
            camera.eye = middle;
            const double turn = 2.4 * double(all.size());
            camera.target = middle + Vec3d{std::cos(turn), std::sin(turn), -0.1};
            camera.width = camera.height = is_figure() ? 256 : 64;
            const CameraFrame frame = make_frame(camera);
            all.push_back({frame, start_cell(scene, frame), camera.width, camera.height});
        }
        return all;
    }

    void count(const Rays& rays, const char* name) {
        const DeviceRays view = rays.view();
        rays_ = rays.size();
        std::vector<test::CellPath> paths;
        for (std::size_t i = 0; i < rays.size(); ++i)
            paths.push_back(test::path_of(scene_.view(), {view.origin[0][i], view.origin[1][i], view.origin[2][i]},
                                          {view.direction[0][i], view.direction[1][i], view.direction[2][i]},
                                          static_cast<std::uint32_t>(view.cell[i])));
        for (const RayOrder order : {RayOrder::AsGiven, RayOrder::Morton, RayOrder::ByCell}) {
            const OrderedColumns columns = {{view.origin[0], view.origin[1], view.origin[2]},
                                            {view.direction[0], view.direction[1], view.direction[2]},
                                            false,
                                            view.cell};
            std::vector<std::uint32_t> places(rays.size());
            std::iota(places.begin(), places.end(), 0u);
            const std::uint32_t* sorted =
                order_rays(*device_, sorter_, order_frame(scene_.view()), order, columns, rays.size());
            if (sorted != nullptr) places.assign(sorted, sorted + rays.size());
            figures_.push_back({test::count_warps(scene_.view(), paths, places, 32),
                                test::count_warps(scene_.view(), paths, places, 12)});
            if (is_figure()) print(name, order);
        }
    }
    void print(const char* name, RayOrder order) const {
        const char* names[] = {"none", "Morton", "by cell"};
        for (const bool fetches : {false, true}) {
            const test::WarpCounts& c = fetches ? figures_.back().fetching : figures_.back().each;
            if (order == RayOrder::AsGiven && !fetches)
                std::printf("%.2f cells a ray, %.1f lines a cell\n", double(c.cells) / double(rays_),
                            double(c.lines) / double(c.cells));
            std::printf("| %s | %s | %s | %.0f %% | %.0f %% | %.0f %% | %.1f |\n", name,
                        names[static_cast<std::size_t>(order)], fetches ? "Persistent" : "Deferred",
                        100 * c.lanes_beginning(), 100 * c.lanes_busy(), 100 * c.lines_busy(), c.cells_a_step());
        }
    }

    accel::SerialExecutor one_;
    std::unique_ptr<Device> device_ = open_host(one_);
    KeySorter sorter_{*device_};
    accel::Scene scene_;
    std::vector<Figures> figures_;
    std::size_t rays_ = 0;
};

TEST_F(StreamDivergence, IsWhatOrdersAndFetchingTakeAway) {
    const Figures& given = of(0, RayOrder::AsGiven);
    const Figures& strangers = of(1, RayOrder::AsGiven);
    EXPECT_GT(given.each.cells, 30'000u);
    // Nobody walks more or less than before.
    for (const std::size_t stream : {0u, 1u})
        for (const RayOrder order : {RayOrder::AsGiven, RayOrder::Morton, RayOrder::ByCell}) {
            EXPECT_EQ(of(stream, order).each.cells, given.each.cells);
            EXPECT_EQ(of(stream, order).fetching.lines, given.each.lines);
            EXPECT_GT(of(stream, order).fetching.lanes_busy(), of(stream, order).each.lanes_busy());
        }
    // A thread a ray begins with all lanes; who fetches as lanes fall idle begins with those.
    EXPECT_GT(given.each.lanes_beginning(), 0.99);
    EXPECT_LT(given.fetching.lanes_beginning(), 0.99);
    // Sorted strangers read fewer cells at a time, and tests wait less for the cell with most lines.
    for (const RayOrder order : {RayOrder::Morton, RayOrder::ByCell}) {
        EXPECT_LT(of(1, order).each.cells_a_step(), 0.8 * strangers.each.cells_a_step());
        EXPECT_GT(of(1, order).each.lines_busy(), strangers.each.lines_busy());
    }
}

}  // namespace
}  // namespace enfilade::render::cuda

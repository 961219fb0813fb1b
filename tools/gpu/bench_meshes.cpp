#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string_view>

#include "tools/gpu/bench.h"
#include "tools/gpu/device_contest.h"
#include "tools/gpu/mesh_ways.h"

namespace enfilade::tools::gpu {

namespace {

/// Millions of rays a second on a GeForce GTX 980 at 1024 x 1024: the second paper's table 2, its own octree and the
/// fastest of the others.
struct PaperFigure {
    std::string_view mesh;
    int octree, best_bvh;
};
constexpr std::array paper = {PaperFigure{"mesh-bunny", 700, 850}, PaperFigure{"mesh-armadillo", 570, 760},
                              PaperFigure{"mesh-dragon", 530, 730}};

std::string paper_rates(const std::string& mesh) {
    for (const PaperFigure& figure : paper)
        if (figure.mesh == mesh) return std::to_string(figure.octree) + " / " + std::to_string(figure.best_bvh);
    return "-";
}

struct Entry {
    const MeshWay* way;
    std::unique_ptr<MeshMaker> maker;
};

/// One batch by all ways; `times` over, so that a round is long enough. Adds its goal where `least` is not 0.
void bench_rays(render::cuda::Device& device, const std::string& scene, const std::string& what, MeshRays& rays,
                int times, double least, const std::string& papers, const std::vector<Entry>& entries,
                const BenchOptions& options, MarkdownTable& table, Report& report) {
    if (options.is_late(report, scene + ", " + what)) return;
    report.progress("rays at " + scene + ": " + what);
    std::vector<std::function<void()>> competitors;
    for (const Entry& entry : entries)
        competitors.push_back([&] {
            for (int i = 0; i < times; ++i) entry.maker->nearest(rays);
        });
    const DeviceContest contest(device, options.rounds, competitors, 2);
    std::size_t best[2] = {entries.size(), entries.size()};  // of the baselines, of ours
    for (std::size_t k = 0; k < entries.size(); ++k) {
        std::size_t& first = best[entries[k].way->is_ours ? 1 : 0];
        if (contest.seconds(k) && (first == entries.size() || *contest.seconds(k) < *contest.seconds(first))) first = k;
    }
    for (std::size_t k = 0; k < entries.size(); ++k) {
        std::optional<double> rate, ratio;
        if (const auto seconds = contest.seconds(k))
            rate = 1e-6 * times * static_cast<double>(rays.batch.size()) / *seconds;
        if (best[0] < entries.size()) ratio = contest.faster(k, best[0]);
        table.add({scene, what, entries[k].way->name, grouped(rays.batch.size()), measured(rate), measured(ratio),
                   bytes_text(entries[k].maker->bytes()), papers});
    }
    if (least == 0) return;
    GoalRow goal = {"single mesh, " + what + ", " + scene, least, std::nullopt, "-"};
    if (best[0] < entries.size() && best[1] < entries.size()) {
        goal.ratio = contest.faster(best[1], best[0]);
        goal.of = entries[best[1]].way->name + " against " + entries[best[0]].way->name;
    }
    report.add_goal(std::move(goal));
}

void bench_mesh(render::cuda::Device& device, const TriedScene& scene, const BenchOptions& options,
                const accel::Executor& executor, MarkdownTable& table, Report& report) {
    const MeshOnHost mesh(scene.view(), executor);
    std::vector<Entry> entries;
    for (const MeshWay& way : mesh_ways()) entries.push_back({&way, way.open(device, mesh)});
    const auto count = [](int side) { return render::cuda::TiledPixels{side, side}.count(); };
    const std::string small = std::to_string(options.side) + " x " + std::to_string(options.side);
    {
        MeshRays frame(device, count(options.side), false);
        frame.batch.primary(scene.views[0].frame(options.side), options.side, options.side);
        frame.copy(device);
        bench_rays(device, scene.name, "primary, " + small, frame, 8, 0, paper_rates(scene.name), entries, options,
                   table, report);
    }
    const auto root = static_cast<int>(std::sqrt(static_cast<double>(options.rays)));
    const int side = std::max(8, root / 8 * 8);
    MeshRays diffuse(device, count(side), false);
    {
        MeshRays primary(device, count(side), true);
        primary.batch.primary(scene.views[0].frame(side), side, side);
        const render::cuda::DeviceOctree tree(device, upload_octree(device, mesh.linked(MeshTree::Ours)), {});
        primary.batch.nearest(tree, {});
        diffuse.batch.diffuse(primary.batch, tree, 1);
        primary.copy(device);
        bench_rays(device, scene.name, "primary", primary, 1, 1.0, "-", entries, options, table, report);
    }
    diffuse.copy(device);
    bench_rays(device, scene.name, "diffuse", diffuse, 1, 0.8, "-", entries, options, table, report);
}

}  // namespace

void bench_meshes(render::cuda::Device& device, const std::vector<TriedScene>& scenes, const BenchOptions& options,
                  const accel::Executor& executor, Report& report) {
    MarkdownTable table({"mesh", "rays", "by", "how many", "Mrays/s", "against the best baseline", "memory",
                         "paper's octree / best BVH (GTX 980)"});
    for (const TriedScene& scene : scenes)
        if (scene.is_single_mesh())
            report.guarded(scene.name, [&] { bench_mesh(device, scene, options, executor, table, report); });
    if (table.is_empty()) return;
    report.section("Single meshes",
                   "Rays that lie in the card's memory, and the nearest triangle of each that is left there. Diffuse "
                   "rays are as many as the primary ones; where those missed the mesh they ask for nothing.");
    report.table(table);
}

}  // namespace enfilade::tools::gpu

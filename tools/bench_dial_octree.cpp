// What each option of octrees costs in time and memory, on one mesh, and whether any of them changes an answer.

#include <bit>
#include <functional>
#include <memory>
#include <vector>

#include "render/executor.h"
#include "tools/bench_cells.h"
#include "tools/bench_dial.h"
#include "tools/bench_octree.h"

namespace enfilade::tools {

namespace {

struct OctreeSetting {
    std::string name;
    accel::OctreeOptions options;
};

std::vector<OctreeSetting> settings(bool is_quick) {
    std::vector<OctreeSetting> all;
    const auto add = [&](std::string name, const std::function<void(accel::OctreeOptions&)>& change) {
        OctreeSetting setting{std::move(name), {}};
        change(setting.options);
        all.push_back(std::move(setting));
    };
    for (const std::uint32_t depth : {4u, 5u, 6u, 7u, 8u, 9u, 10u})
        if (!is_quick || depth % 3 == 0)
            add("octree-depth " + std::to_string(depth), [&](auto& options) { options.depth = depth; });
    add("octree-depth automatic", [](auto&) {});
    for (const std::uint32_t size : {4u, 8u, 16u, 32u, 64u})
        if (!is_quick || size == 16)
            add("octree-leaf " + std::to_string(size), [&](auto& options) { options.leaf_size = size; });
    add("octree-leaf automatic", [](auto&) {});
    add("octree-balance no", [](auto&) {});
    add("octree-balance yes", [](auto& options) { options.is_balanced = true; });
    add("octree-layout linked", [](auto&) {});
    add("octree-layout ropes", [](auto& options) { options.layout = accel::OctreeLayout::Ropes; });
    add("octree-layout stored", [](auto& options) {
        options.layout = accel::OctreeLayout::Ropes;
        options.has_stored_boxes = true;
    });
    add("octree-real float", [](auto& options) { options.layout = accel::OctreeLayout::Ropes; });
    add("octree-real double", [](auto& options) {
        options.layout = accel::OctreeLayout::Ropes;
        options.walks_in_double = true;
    });
    return all;
}

/// The scan that lies with other people's plans, else a ball of as many triangles.
BenchMesh dial_mesh(Bench& bench) {
    for (const MeshSource& source : mesh_sources())
        if (source.name == "bunny")
            if (std::optional<BenchMesh> mesh = mesh_of(source, bench)) return std::move(*mesh);
    return std::move(*mesh_of({.name = "ball", .kind = MeshKind::Compact, .triangles = 70'000}, bench));
}

double others_per_million(const std::vector<MeshAnswer>& a, const std::vector<MeshAnswer>& b) {
    std::size_t others = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        others += a[i].triangle == b[i].triangle &&
                          std::bit_cast<std::uint32_t>(a[i].distance) == std::bit_cast<std::uint32_t>(b[i].distance)
                      ? 0
                      : 1;
    return 1e6 * double(others) / double(a.size());
}

}  // namespace

void dial_octrees(Bench& bench) {
    const BenchMesh mesh = dial_mesh(bench);
    const accel::SerialExecutor one;
    const auto made = [&](const accel::OctreeOptions& options) {
        return render::build_object_accel(mesh.view(), render::ObjectAccelKind::Octree, one, options);
    };
    const auto usual = made({});
    const RayStream coherent(view_rays(bench.quick() ? 32 : 96));
    const RayStream apart(apart_rays(coherent.rays, usual->tracer(), coherent.size()));
    const std::vector<MeshAnswer> answers = answers_of(usual->tracer(), RayCase::OneApart, apart);
    std::size_t hits = 0;
    for (const OctreeSetting& setting : settings(bench.quick())) {
        std::unique_ptr<render::ObjectAccel> own;
        const double seconds = seconds_of([&] { own = made(setting.options); });
        const auto row = [&](const char* what, double value, const char* unit) {
            bench.add({.row = setting.name + ": " + what, .scene = mesh.title(), .value = value, .unit = unit});
        };
        row("time", seconds, "s");
        row("memory", double(own->bytes()) / 1e6, "MB");
        for (const auto& [what, name] :
             {std::pair{RayCase::OneApart, "speed"}, std::pair{RayCase::SixteenCoherent, "speed, 16 coherent"}}) {
            const RayStream& stream = is_coherent(what) ? coherent : apart;
            const RayContest contest(bench.quick() ? 1 : 3, double(stream.size()),
                                     {{setting.name, [&] { hits += ask(own->tracer(), what, stream); }},
                                      {"default", [&] { hits += ask(usual->tracer(), what, stream); }}},
                                     Clock::Thread);
            BenchRow speed = contest.row(setting.name + ": " + name, 0, 1);
            speed.scene = mesh.title();
            bench.add(std::move(speed));
        }
        row("other answers", others_per_million(answers, answers_of(own->tracer(), RayCase::OneApart, apart)),
            "per million");
    }
}

}  // namespace enfilade::tools

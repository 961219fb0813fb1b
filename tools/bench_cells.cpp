// One ray at a time through the cells of an empty floor, against Embree on the same rays in the same run; and whether
// both see the same faces, and the oracle too.

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/generate.h"
#include "render/embree_reference.h"
#include "render/executor.h"
#include "render/oracle.h"
#include "render/trace.h"
#include "tools/bench.h"
#include "tools/floor_views.h"
#include "tools/random_rays.h"

namespace enfilade::tools {

namespace {

constexpr int side = 1024;
constexpr std::size_t view_count = 8;

accel::Scene office_floor(std::uint32_t rooms) {
    const modeler::Building building = modeler::convexify(modeler::build(plans::generate({.rooms = rooms})));
    return modeler::export_scene(building, modeler::check(building), "{}");
}

void bench_pictures(Bench& bench, const accel::SceneView& scene, const std::string& name) {
    const std::vector<PreparedView> views = prepared(scene, floor_views(scene, view_count, side));
    const render::EmbreeReference embree(scene);
    const accel::SerialExecutor one_thread;
    render::Framebuffer image(side, side);
    const auto cells = [&] {
        for (const PreparedView& view : views)
            render::trace_lambert(scene, view.frame, view.start, {.tracer = render::Tracer::Scalar}, one_thread, image);
    };
    const auto single = [&] {
        for (const PreparedView& view : views) embree.trace_lambert(view.frame, {.lanes = 1}, one_thread, image);
    };
    const auto packets = [&] {
        for (const PreparedView& view : views) embree.trace_lambert(view.frame, {.lanes = 16}, one_thread, image);
    };
    const int runs = bench.quick() ? 3 : 9;
    const double rays = double(side) * side * double(view_count);
    const Duel against_single = duel(runs, cells, single);
    const Duel against_packets = duel(runs, cells, packets);
    bench.add({.row = "scalar walk, primary rays and Lambert, 1024x1024, 8 views",
               .scene = name,
               .value = rays / against_single.a_seconds / 1e6,
               .unit = "Mrays/s",
               .reference = "Embree rtcIntersect1",
               .reference_value = rays / against_single.b_seconds / 1e6,
               .ratio = against_single.b_over_a,
               .goal = ratio_at_least(5)});
    bench.add({.row = "scalar walk, the same",
               .scene = name,
               .value = rays / against_packets.a_seconds / 1e6,
               .unit = "Mrays/s",
               .reference = "Embree rtcIntersect16",
               .reference_value = rays / against_packets.b_seconds / 1e6,
               .ratio = against_packets.b_over_a});
    const std::unique_ptr<accel::Executor> all = render::make_executor();
    const double seconds = median_seconds(runs, [&] {
        for (const PreparedView& view : views)
            render::trace_lambert(scene, view.frame, view.start, {.tracer = render::Tracer::Scalar}, *all, image);
    });
    bench.add({.row = "scalar walk, the same, all cores",
               .scene = name,
               .threads = std::max(1u, std::thread::hardware_concurrency()),
               .value = rays / seconds / 1e6,
               .unit = "Mrays/s"});
}

/// What became of the rays of one family.
struct Tally {
    std::uint64_t rays = 0;
    std::uint64_t leaks = 0;
    std::uint64_t differ = 0;        ///< another face than Embree's
    std::uint64_t outside_band = 0;  ///< of these: another one than the oracle's, and no edge near
};

/// Traces `count` rays of a family by cells and by Embree; where they differ the oracle decides who is right.
Tally compare_family(const accel::SceneView& scene, const render::EmbreeReference& embree, const render::Oracle& oracle,
                     RayFamily family, std::size_t count) {
    constexpr std::size_t chunk = 1 << 14;
    const double band = render::error_band(scene);
    const std::unique_ptr<accel::Executor> cores = render::make_executor();
    Tally tally;
    std::mutex mutex;
    cores->run((count + chunk - 1) / chunk, [&](std::size_t k) {
        const std::vector<render::RayQuery> rays =
            RandomRays(scene, 1000 * std::uint64_t(family) + k).take(std::min(chunk, count - k * chunk), family);
        std::vector<render::RayHit> hits(rays.size());
        std::vector<render::RayHit> others(rays.size());
        render::trace_rays(scene, rays, hits);
        embree.trace(rays, others);
        Tally part{.rays = rays.size()};
        std::vector<render::RayQuery> doubtful;
        std::vector<render::RayHit> answers;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (hits[i].status != render::WalkStatus::Hit) ++part.leaks;
            if (hits[i].status == others[i].status && hits[i].source_face == others[i].source_face) continue;
            ++part.differ;
            doubtful.push_back(rays[i]);
            answers.push_back(hits[i]);
        }
        part.outside_band = render::compare(oracle, doubtful, answers, band).differing_outside_band;
        const std::lock_guard lock(mutex);
        tally.rays += part.rays;
        tally.leaks += part.leaks;
        tally.differ += part.differ;
        tally.outside_band += part.outside_band;
    });
    return tally;
}

void bench_agreement(Bench& bench, const accel::SceneView& scene, const std::string& name) {
    const render::EmbreeReference embree(scene);
    const render::Oracle oracle(scene);
    const unsigned threads = std::max(1u, std::thread::hardware_concurrency());
    Tally all;
    for (const RayFamily family : ray_families) {
        // Rays that seek trouble find it: each one on which Embree differs costs a pass over all faces.
        const std::size_t most = family == RayFamily::Random ? 92'000'000 : 2'000'000;
        const Tally tally = compare_family(scene, embree, oracle, family, bench.quick() ? most / 100 : most);
        const double per_million = 1e6 / double(tally.rays);
        bench.add({.row = std::string(name_of(family)) + " rays: other face than Embree's",
                   .scene = name,
                   .threads = threads,
                   .value = double(tally.differ) * per_million,
                   .unit = "per million"});
        bench.add({.row = std::string(name_of(family)) + " rays: other than the oracle's, no edge near",
                   .scene = name,
                   .threads = threads,
                   .value = double(tally.outside_band),
                   .unit = "of " + grouped(tally.rays),
                   .goal = value_at_most(0)});
        all.rays += tally.rays;
        all.leaks += tally.leaks;
    }
    bench.add({.row = "leaks",
               .scene = name,
               .threads = threads,
               .value = double(all.leaks),
               .unit = "of " + grouped(all.rays),
               .goal = value_at_most(0)});
}

/// Without Embree's help: every ray against every face.
void bench_oracle(Bench& bench, const accel::SceneView& scene, const std::string& name) {
    const render::Oracle oracle(scene);
    const std::vector<render::RayQuery> rays = RandomRays(scene, 7).take(bench.quick() ? 20'000 : 400'000);
    std::vector<render::RayHit> hits(rays.size());
    render::trace_rays(scene, rays, hits);
    const render::Agreement agreement = render::compare(oracle, rays, hits, render::error_band(scene));
    const std::string unit = "of " + grouped(agreement.rays);
    bench.add({.row = "oracle on every ray: other face, no edge near",
               .scene = name,
               .value = double(agreement.differing_outside_band),
               .unit = unit,
               .goal = value_at_most(0)});
    bench.add({.row = "oracle on every ray: other face, inside the band",
               .scene = name,
               .value = double(agreement.differing_inside_band),
               .unit = unit});
    bench.add({.row = "oracle on every ray: largest error of the distance",
               .scene = name,
               .value = agreement.largest_distance_error * 1000,
               .unit = "mm"});
}

}  // namespace

void bench_cells(Bench& bench) {
    const accel::Scene floor = office_floor(135);
    const std::string name = "135 rooms, empty";
    bench_pictures(bench, floor.view(), name);
    bench_agreement(bench, floor.view(), name);
    bench_oracle(bench, floor.view(), name);
}

}  // namespace enfilade::tools

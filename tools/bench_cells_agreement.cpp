// Whether every tracer sees the same faces as Embree and as the oracle; leaks.

#include <algorithm>
#include <cmath>
#include <mutex>
#include <thread>

#include "render/executor.h"
#include "render/oracle.h"
#include "render/trace.h"
#include "tools/bench_cells.h"
#include "tools/random_rays.h"

namespace enfilade::tools {

namespace {

using render::Vec3d;

/// What became of the rays of one family under one tracer.
struct Tally {
    std::uint64_t rays = 0;
    std::uint64_t leaks = 0;
    std::uint64_t differ = 0;        ///< another face than Embree's
    std::uint64_t outside_band = 0;  ///< of these: another one than the oracle's, and no edge near

    Tally& operator+=(const Tally& other) {
        rays += other.rays;
        leaks += other.leaks;
        differ += other.differ;
        outside_band += other.outside_band;
        return *this;
    }
};
using Tallies = std::array<Tally, tracers.size()>;

/// Queries as columns, and the columns of their answers.
struct Stream {
    std::vector<float> origin[3], direction[3], distance;
    std::vector<accel::CellId> start, end;
    std::vector<accel::SourceFaceId> face;
    std::vector<render::WalkStatus> status;

    explicit Stream(std::span<const render::RayQuery> rays)
        : distance(rays.size()), end(rays.size()), face(rays.size()), status(rays.size()) {
        for (const render::RayQuery& ray : rays) {
            start.push_back(ray.cell);
            const std::array from = {ray.origin.x, ray.origin.y, ray.origin.z};
            const std::array along = {ray.direction.x, ray.direction.y, ray.direction.z};
            for (std::size_t k = 0; k < 3; ++k) {
                origin[k].push_back(float(from[k]));
                direction[k].push_back(float(along[k]));
            }
        }
    }
    [[nodiscard]] render::RayColumns rays() const {
        return {origin[0], origin[1], origin[2], direction[0], direction[1], direction[2], start, {}};
    }
    [[nodiscard]] render::HitColumns hits() { return {distance, face, end, status}; }
};

/// A tracer's answers against Embree's; where they differ the oracle decides who is right.
Tally compare_stream(const accel::SceneView& scene, const render::Oracle& oracle, render::Tracer tracer,
                     std::span<const render::RayQuery> rays, std::span<const render::RayHit> others) {
    Stream stream(rays);
    render::nearest(
        scene, stream.rays(), stream.hits(),
        {.tracer = tracer,
         .order = tracer == render::Tracer::Packet ? render::StreamOrder::Any : render::StreamOrder::Coherent});
    Tally tally{.rays = rays.size()};
    std::vector<render::RayQuery> doubtful;
    std::vector<render::RayHit> answers;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (stream.status[i] != render::WalkStatus::Hit) ++tally.leaks;
        if (stream.status[i] == others[i].status && stream.face[i] == others[i].source_face) continue;
        ++tally.differ;
        doubtful.push_back(rays[i]);
        render::RayHit answer = {};
        answer.status = stream.status[i];
        answer.source_face = stream.face[i];
        answer.cell = stream.end[i];
        answer.distance = double(stream.distance[i]);
        answers.push_back(answer);
    }
    tally.outside_band = render::compare(oracle, doubtful, answers, render::error_band(scene)).differing_outside_band;
    return tally;
}

Tallies compare_family(const TracedBuilding& building, const render::Oracle& oracle, RayFamily family,
                       std::size_t count) {
    constexpr std::size_t chunk = 1 << 14;
    const accel::SceneView& scene = building.scene.view();
    const std::unique_ptr<accel::Executor> cores = render::make_executor();
    Tallies tallies;
    std::mutex mutex;
    cores->run((count + chunk - 1) / chunk, [&](std::size_t k) {
        const std::vector<render::RayQuery> rays =
            RandomRays(scene, 1000 * std::uint64_t(family) + k).take(std::min(chunk, count - k * chunk), family);
        std::vector<render::RayHit> others(rays.size());
        building.embree.trace(rays, others);
        Tallies parts;
        for (std::size_t t = 0; t < tracers.size(); ++t)
            parts[t] = compare_stream(scene, oracle, tracers[t], rays, others);
        const std::lock_guard lock(mutex);
        for (std::size_t t = 0; t < tracers.size(); ++t) tallies[t] += parts[t];
    });
    return tallies;
}

void bench_families(Bench& bench, const TracedBuilding& building, const render::Oracle& oracle) {
    const unsigned threads = std::max(1u, std::thread::hardware_concurrency());
    Tallies all;
    for (const RayFamily family : ray_families) {
        // Rays that seek trouble find it: each one on which Embree differs costs a pass over all faces.
        const std::size_t most = family == RayFamily::Random ? 20'000'000 : 500'000;
        const Tallies tallies = compare_family(building, oracle, family, bench.quick() ? most / 100 : most);
        for (std::size_t t = 0; t < tracers.size(); ++t) {
            const Tally& tally = tallies[t];
            const std::string who = name_of(tracers[t]) + std::string(", ") + name_of(family) + " rays: ";
            bench.add({.row = who + "other face than Embree's",
                       .scene = building.name,
                       .threads = threads,
                       .value = 1e6 * double(tally.differ) / double(tally.rays),
                       .unit = "per million"});
            bench.add({.row = who + "other than the oracle's, no edge near",
                       .scene = building.name,
                       .threads = threads,
                       .value = double(tally.outside_band),
                       .unit = "of " + grouped(tally.rays),
                       .goal = value_at_most(0)});
            all[t] += tally;
        }
    }
    for (std::size_t t = 0; t < tracers.size(); ++t)
        bench.add({.row = std::string(name_of(tracers[t])) + ", leaks",
                   .scene = building.name,
                   .threads = threads,
                   .value = double(all[t].leaks),
                   .unit = "of " + grouped(all[t].rays),
                   .goal = value_at_most(0)});
}

/// Without Embree's help: every ray against every face.
void bench_oracle(Bench& bench, const TracedBuilding& building, const render::Oracle& oracle) {
    const accel::SceneView& scene = building.scene.view();
    const std::vector<render::RayQuery> rays = RandomRays(scene, 7).take(bench.quick() ? 20'000 : 200'000);
    std::vector<render::RayHit> hits(rays.size());
    render::trace_rays(scene, rays, hits);
    const render::Agreement agreement = render::compare(oracle, rays, hits, render::error_band(scene));
    const auto add = [&](const char* what, double value, std::string unit, std::optional<Goal> goal) {
        bench.add({.row = std::string("oracle on every ray: ") + what,
                   .scene = building.name,
                   .value = value,
                   .unit = std::move(unit),
                   .goal = goal});
    };
    const std::string of_rays = "of " + grouped(agreement.rays);
    add("other face, no edge near", double(agreement.differing_outside_band), of_rays, value_at_most(0));
    add("other face, inside the band", double(agreement.differing_inside_band), of_rays, {});
    add("largest error of the distance", agreement.largest_distance_error * 1000, "mm", {});
}

bool is_near(std::uint32_t a, std::uint32_t b) {
    for (int shift = 0; shift < 24; shift += 8)
        if (std::abs(int(a >> shift & 255u) - int(b >> shift & 255u)) > 1) return false;
    return true;
}

/// Pixels that another tracer paints otherwise than the scalar one, and those of them that see no edge.
void bench_pictures(Bench& bench, const TracedBuilding& building, const render::Oracle& oracle) {
    constexpr int side = 1024;
    const accel::SceneView& scene = building.scene.view();
    const std::vector<PreparedView> views = prepared(scene, floor_views(scene, bench.quick() ? 2 : 8, side));
    const double band = render::error_band(scene);
    const accel::SerialExecutor one;
    for (const render::Tracer tracer : {render::Tracer::Simd, render::Tracer::Packet}) {
        std::uint64_t differ = 0, without_edge = 0;
        for (const PreparedView& view : views) {
            render::Framebuffer scalar(side, side), image(side, side);
            render::trace_lambert(scene, view.frame, view.start, {.tracer = render::Tracer::Scalar}, one, scalar);
            render::trace_lambert(scene, view.frame, view.start, {.tracer = tracer}, one, image);
            for (int pixel = 0; pixel < side * side; ++pixel) {
                if (is_near(scalar.rgba[std::size_t(pixel)], image.rgba[std::size_t(pixel)])) continue;
                ++differ;
                const Vec3d direction = render::vec_cast<double>(
                    view.frame.direction(float(pixel % side) + 0.5f, float(pixel / side) + 0.5f));
                const Vec3d origin = render::vec_cast<double>(view.frame.origin);
                const auto hit = oracle.trace(origin, direction);
                if (!hit || oracle.edge_distance(origin, direction, hit->distance + band) > band) ++without_edge;
            }
        }
        const double pixels = double(side) * side * double(views.size());
        const std::string who = name_of(tracer) + std::string(", pictures: ");
        bench.add({.row = who + "pixels unlike the scalar ones",
                   .scene = building.name,
                   .value = 1e6 * double(differ) / pixels,
                   .unit = "per million"});
        bench.add({.row = who + "of these, no edge near",
                   .scene = building.name,
                   .value = double(without_edge),
                   .unit = "of " + grouped(std::uint64_t(pixels)),
                   .goal = value_at_most(0)});
    }
}

}  // namespace

void bench_agreement(Bench& bench, const TracedBuilding& building) {
    const render::Oracle oracle(building.scene.view());
    bench_pictures(bench, building, oracle);
    bench_families(bench, building, oracle);
    bench_oracle(bench, building, oracle);
}

}  // namespace enfilade::tools

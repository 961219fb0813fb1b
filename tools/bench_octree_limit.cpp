// What a walk through an octree would cost if memory answered at once: what rays do, counted, against the time that
// they take where everything they touch lies in the caches, and where it does not.

#include <cstdio>
#include <functional>
#include <random>

#include "render/executor.h"
#include "render/octree_walk.h"
#include "tools/bench_octree.h"
#include "tools/contest.h"
#include "tools/counted_instructions.h"

namespace enfilade::tools {

namespace {

constexpr accel::MeshId the_mesh{0};
constexpr std::size_t bunch = 32;  ///< rays whose leaves lie in a core's own cache together
constexpr std::size_t again = 16;  ///< times that a ray is asked

/// What one ray at a time does, on the average.
struct Work {
    double leaves = 0, empty = 0, levels = 0, blocks = 0, triangles = 0;

    void entered_leaf(std::uint32_t, std::uint32_t count) {
        ++leaves;
        empty += count == 0 ? 1 : 0;
        blocks += accel::OctreeCost::blocks(count);
        triangles += count;
    }
    void descended(std::uint32_t count) { levels += count; }
};

Work work_of(const BenchMesh& mesh, const std::vector<BenchRay>& rays) {
    const accel::SerialExecutor one;
    const accel::LinkedOctree tree(accel::build_octree(mesh.part(), {}, one), mesh.part(), one);
    Work work;
    for (const BenchRay& ray : rays) {
        render::ObjectRay asked = object_ray(ray);
        render::octree_walk<false>(tree.view(), asked, work);
    }
    for (double* sum : {&work.leaves, &work.empty, &work.levels, &work.blocks, &work.triangles})
        *sum /= double(rays.size());
    return work;
}

/// Nanoseconds a ray.
struct Times {
    double stream = 0;   ///< all rays of a stream, once: leaves come from wherever they lie
    double bunches = 0;  ///< few rays in random order again and again: leaves lie near, branches are still guessed
    double same = 0;     ///< each ray again and again: leaves lie near, and branches are known
};

/// Of the whole stream, at random.
std::vector<BenchRay> some_of(const RayStream& stream, std::size_t count) {
    std::mt19937_64 random(9);
    std::vector<BenchRay> rays(count);
    for (BenchRay& ray : rays) ray = stream.rays[std::size_t(random() % stream.size())];
    return rays;
}

std::size_t ask_one(const render::ObjectTracer& tracer, const BenchRay& ray) {
    render::ObjectRay asked = object_ray(ray);
    tracer.nearest(tracer.state, the_mesh, asked);
    return asked.triangle != render::no_triangle ? 1 : 0;
}

Times times_of(const render::ObjectTracer& tracer, const RayStream& stream, std::size_t sample, int rounds) {
    std::size_t hits = 0;
    const std::vector<BenchRay> chosen = some_of(stream, sample);
    std::vector<std::uint8_t> order;
    std::mt19937_64 random(5);
    for (std::size_t i = 0; i < bunch * again; ++i) order.push_back(std::uint8_t(random() % bunch));
    const std::vector<std::function<void()>> works = {[&] { hits += ask(tracer, RayCase::OneApart, stream); },
                                                      [&] {
                                                          for (std::size_t first = 0; first + bunch <= chosen.size();
                                                               first += bunch) {
                                                              for (std::size_t i = 0; i < bunch; ++i)
                                                                  hits += ask_one(tracer, chosen[first + i]);
                                                              for (const std::uint8_t i : order)
                                                                  hits += ask_one(tracer, chosen[first + i]);
                                                          }
                                                      },
                                                      [&] {
                                                          for (const BenchRay& ray : chosen)
                                                              for (std::size_t k = 0; k < again; ++k)
                                                                  hits += ask_one(tracer, ray);
                                                      }};
    const Contest contest(rounds, works);
    const double whole = double(stream.size()), many = double(chosen.size());
    return {1e9 * contest.median_of(0) / whole, 1e9 * contest.median_of(1) / (many * (again + 1)),
            1e9 * contest.median_of(2) / (many * again)};
}

/// Some rays, instruction by instruction, and the time that the same rays take when they are asked again and again.
struct Stepped {
    double instructions = 0;  ///< a ray
    double nanoseconds = 0;   ///< a ray
};

std::optional<Stepped> stepped(const render::ObjectTracer& tracer, const RayStream& stream, std::size_t count) {
    constexpr std::size_t often = 512;
    std::size_t hits = 0;
    const std::vector<BenchRay> chosen = some_of(stream, count);
    const auto all = counted_instructions([&] {
        for (const BenchRay& ray : chosen) hits += ask_one(tracer, ray);
    });
    if (!all) return std::nullopt;
    std::vector<double> seconds;
    for (int round = 0; round < 3; ++round)
        seconds.push_back(busy_seconds_of([&] {
            for (const BenchRay& ray : chosen)
                for (std::size_t k = 0; k < often; ++k) hits += ask_one(tracer, ray);
        }));
    return Stepped{double(*all) / double(count), 1e9 * median(std::move(seconds)) / double(count * often)};
}

class LimitRows {
public:
    LimitRows(Bench& bench, const BenchMesh& mesh) : bench_(&bench), mesh_(&mesh) {}

    void add(const std::string& who, const std::string& rays, const RayStream& stream,
             const render::ObjectTracer& tracer, const Work* work) {
        const std::string start = "limit, " + who + ", " + rays + ": ";
        if (work != nullptr) {
            add_row(start + "leaves", work->leaves, "a ray");
            add_row(start + "leaves without triangles", work->empty, "a ray");
            add_row(start + "levels descended", work->levels, "a ray");
            add_row(start + "blocks of triangles", work->blocks, "a ray");
            add_row(start + "triangles", work->triangles, "a ray");
        }
        const std::optional<Stepped> steps = stepped(tracer, stream, bench_->quick() ? 8 : 24);
        if (steps) {
            add_row(start + "instructions", steps->instructions, "a ray");
            add_row(start + "instructions a ns, leaves and branches known", steps->instructions / steps->nanoseconds,
                    "a ns");
        }
        const Times times = times_of(tracer, stream, bench_->quick() ? 512 : 2048, bench_->quick() ? 1 : 3);
        add_row(start + "time", times.stream, "ns");
        add_row(start + "time, leaves in caches", times.bunches, "ns");
        add_row(start + "time, branches known as well", times.same, "ns");
        say(who + ", " + rays, times, steps, work);
    }

private:
    void add_row(std::string row, double value, std::string unit) {
        bench_->add_silently({.row = std::move(row), .scene = mesh_->title(), .value = value, .unit = std::move(unit)});
    }

    void say(const std::string& what, const Times& times, const std::optional<Stepped>& steps, const Work* work) {
        const double waiting = std::max(0.0, times.stream - times.bunches);
        char text[512];
        int length = std::snprintf(text, sizeof text,
                                   "%s: %s rays: %.0f ns each; %.0f ns where all they touch lies in the caches, so "
                                   "%.0f %% of the time is waiting for memory; %.0f ns where the processor has learnt "
                                   "their branches, too.",
                                   mesh_->title().c_str(), what.c_str(), times.stream, times.bunches,
                                   100 * waiting / times.stream, times.same);
        if (work != nullptr && length > 0 && std::size_t(length) < sizeof text)
            length += std::snprintf(text + length, sizeof text - std::size_t(length),
                                    " A ray enters %.1f leaves and tests %.1f blocks of up to 16 triangles.",
                                    work->leaves, work->blocks);
        if (steps && length > 0 && std::size_t(length) < sizeof text)
            std::snprintf(text + length, sizeof text - std::size_t(length),
                          " They take %.0f instructions each (counted on some), %.1f a nanosecond at best.",
                          steps->instructions, steps->instructions / steps->nanoseconds);
        bench_->remark(text);
    }

    Bench* bench_;
    const BenchMesh* mesh_;
};

}  // namespace

void bench_octree_limit(Bench& bench, const BenchMesh& mesh) {
    const std::unique_ptr<accel::Executor> cores = render::make_executor();
    const auto octree = render::build_object_accel(mesh.view(), render::ObjectAccelKind::Octree, *cores);
    const EmbreeMesh embree(mesh.view(), EmbreeMesh::Quality::Medium);
    const RayStream coherent(view_rays(bench.quick() ? 64 : 128));
    const RayStream apart(apart_rays(coherent.rays, embree.tracer(), coherent.size()));
    LimitRows rows(bench, mesh);
    for (const RayStream* stream : {&coherent, &apart}) {
        const std::string rays = stream == &coherent ? "coherent" : "incoherent";
        const Work work = work_of(mesh, stream->rays);
        rows.add("octree", rays, *stream, octree->tracer(), &work);
        rows.add("Embree", rays, *stream, embree.tracer(), nullptr);
    }
}

}  // namespace enfilade::tools

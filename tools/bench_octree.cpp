// Octrees over single meshes against Embree on the same rays: building, memory, and every way to ask.

#include "tools/bench_octree.h"

#include <algorithm>
#include <functional>

#include "accel/octree/octree.h"
#include "render/executor.h"
#include "tools/bench_cells.h"

namespace enfilade::tools {

namespace {

/// What the issue asks.
constexpr double most_dragon_seconds = 2;
constexpr double most_references = 2.5;
constexpr double most_bytes = 120;
std::optional<Goal> goal_of(RayCase what) {
    switch (what) {
        case RayCase::OneCoherent: return ratio_at_least(1.3);
        case RayCase::OneApart: return ratio_at_least(0.7);
        case RayCase::SixteenCoherent: return ratio_at_least(0.6);
        default: return std::nullopt;
    }
}

/// A mesh with its structures, ours with the options that are the default.
class Rivals {
public:
    Rivals(Bench& bench, const BenchMesh& mesh) : bench_(&bench), mesh_(&mesh) {
        const Cores& all = one_and_all_cores().back();
        seconds_ = seconds_of(
            [&] { octree_ = render::build_object_accel(mesh.view(), render::ObjectAccelKind::Octree, *all.executor); });
        for (const EmbreeMesh::Quality quality : {EmbreeMesh::Quality::Medium, EmbreeMesh::Quality::High})
            embree_.push_back(std::make_unique<EmbreeMesh>(mesh.view(), quality));
    }

    void add_build() {
        const unsigned threads = one_and_all_cores().back().threads;
        const double triangles = double(mesh_->triangle_count());
        BenchRow build{.row = "build",
                       .threads = threads,
                       .value = seconds_,
                       .unit = "s",
                       .reference = "Embree",
                       .reference_value = embree_.front()->build_seconds(),
                       .ratio = embree_.front()->build_seconds() / seconds_};
        if (mesh_->name() == "dragon") build.goal = value_at_most(most_dragon_seconds);
        add(std::move(build));
        add({.row = "structure",
             .value = double(octree_->bytes()) / triangles,
             .unit = "B a triangle",
             .reference = "Embree",
             .reference_value = double(embree_.front()->bytes()) / triangles,
             .goal = value_at_most(most_bytes)});
        const Cores& all = one_and_all_cores().back();
        for (const bool is_balanced : {false, true}) {
            accel::OctreeOptions options;
            options.is_balanced = is_balanced;
            const accel::Octree tree = accel::build_octree(mesh_->part(), options, *all.executor);
            add({.row = is_balanced ? "leaves, balanced" : "leaves",
                 .value = double(tree.leaves.size()),
                 .unit = "leaves"});
            if (is_balanced) continue;
            add({.row = "references",
                 .value = double(tree.references.size()) / triangles,
                 .unit = "a triangle",
                 .goal = value_at_most(most_references)});
            add({.row = "depth", .value = double(tree.frame.depth), .unit = "levels"});
        }
    }

    void add_rays() {
        const int side = bench_->quick() ? 64 : 144;
        const RayStream coherent(view_rays(side));
        const RayStream apart(apart_rays(coherent.rays, embree_.front()->tracer(), coherent.size()));
        for (const RayCase what : ray_cases) add_case(what, is_coherent(what) ? coherent : apart);
        add_verdict(coherent, apart);
    }

private:
    void add(BenchRow row) {
        row.scene = mesh_->title();
        bench_->add(std::move(row));
    }

    void add_case(RayCase what, const RayStream& stream) {
        const render::ObjectTracer ours = octree_->tracer();
        // Spatial splits pay on some meshes and some rays: the faster of both trees is what counts.
        std::vector<std::function<void()>> both;
        for (const auto& tree : embree_)
            both.push_back([&, &tree = *tree] { hits_ += ask(tree.tracer(), what, stream); });
        const Contest trees(1, both);
        const std::size_t best = trees.least_of(1) < trees.least_of(0) ? 1 : 0;
        const std::string reference = best == 1 ? "Embree, split" : "Embree";
        const RayContest contest(bench_->quick() ? 3 : 5, double(stream.size()),
                                 {{"octree", [&] { hits_ += ask(ours, what, stream); }}, {reference, both[best]}},
                                 Clock::Thread);
        BenchRow row = contest.row(name_of(what), 0, 1);
        row.goal = goal_of(what);
        add(std::move(row));
    }

    void add_verdict(const RayStream& coherent, const RayStream& apart) {
        const Verdict verdict = judged(*mesh_, octree_->tracer(), embree_.front()->tracer(), coherent, apart,
                                       bench_->quick() ? 20'000'000 : 100'000'000);
        add({.row = "other answers than Embree's",
             .value = 1e6 * double(verdict.unlike) / double(verdict.rays),
             .unit = "per million"});
        add({.row = "16 and any hit: other answers than one ray",
             .value = double(verdict.disagree),
             .unit = "rays",
             .goal = value_at_most(0)});
        add({.row = "wrong by brute force, of " + std::to_string(verdict.judged) + " rays",
             .value = double(verdict.wrong),
             .unit = "rays",
             .goal = value_at_most(0)});
    }

    Bench* bench_;
    const BenchMesh* mesh_;
    double seconds_ = 0;
    std::unique_ptr<render::ObjectAccel> octree_;
    std::vector<std::unique_ptr<EmbreeMesh>> embree_;
    std::size_t hits_ = 0;  ///< so that nothing is left out as unused
};

}  // namespace

void bench_octree(Bench& bench) {
    bench.remark(
        "Ratios say how many times as fast as Embree ours is: above 1, ours is faster. Embree is asked by "
        "rtcIntersect1, rtcOccluded1 (any hit) or rtcIntersect16, in the faster of two trees: of its medium "
        "quality, and of its highest, which splits triangles (\"split\").");
    for (const MeshSource& source : mesh_sources()) {
        if (bench.quick() && !source.is_quick) continue;
        const std::optional<BenchMesh> mesh = mesh_of(source, bench);
        if (!mesh) continue;
        {
            Rivals rivals(bench, *mesh);
            rivals.add_build();
            rivals.add_rays();
        }
        if (source.is_studied && (!bench.quick() || source.kind == MeshKind::Thin)) bench_octree_study(bench, *mesh);
        if (source.is_papers) bench_octree_paper(bench, *mesh);
        if (source.has_limit && (!bench.quick() || source.kind == MeshKind::Thin)) bench_octree_limit(bench, *mesh);
    }
    bench_octree_exits(bench);
}

}  // namespace enfilade::tools

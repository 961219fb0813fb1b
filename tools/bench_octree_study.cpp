// Depth and leaf size against time, memory and answers.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <memory>

#include "render/executor.h"
#include "tools/bench_cells.h"
#include "tools/bench_octree.h"

namespace enfilade::tools {

namespace {

/// What one setting makes of a mesh.
struct Setting {
    std::string name;
    double seconds = 0;
    double bytes = 0;  ///< a triangle
    std::unique_ptr<render::ObjectAccel> accel;
};

/// All settings of one mesh, each against the default on the same rays.
class OctreeStudy {
public:
    OctreeStudy(Bench& bench, const BenchMesh& mesh)
        : bench_(&bench),
          mesh_(&mesh),
          cores_(render::make_executor()),
          default_(made("default", {})),
          coherent_(view_rays(bench.quick() ? 32 : 48)),
          apart_(apart_rays(coherent_.rays, default_.accel->tracer(), coherent_.size())),
          answers_(answers_of(default_.accel->tracer(), RayCase::OneApart, apart_)) {}

    void run() {
        const accel::Octree tree = accel::build_octree(mesh_->part(), {}, *cores_);
        const std::uint32_t depth = tree.frame.depth;
        const std::size_t full = std::size_t(
            std::ranges::count_if(tree.leaves, [](const accel::OctreeLeaf& leaf) { return leaf.count > 0; }));
        add("default: depth", double(depth), "levels");
        add("default: triangles a leaf", double(tree.references.size()) / double(std::max<std::size_t>(1, full)),
            "triangles");
        add("default: build", default_.seconds, "s");
        add("default: structure", default_.bytes, "B a triangle");
        for (std::uint32_t d = depth > 3 ? depth - 3 : 1; d <= depth + (bench_->quick() ? 1 : 2); ++d) {
            accel::OctreeOptions options;
            options.depth = d;
            measure(made("depth " + std::to_string(d), options));
        }
        for (const std::uint32_t size : {4u, 8u, 16u, 32u, 64u, 128u}) {
            if (bench_->quick() && size != 8 && size != 32) continue;
            accel::OctreeOptions options;
            options.leaf_size = size;
            measure(made("leaf size " + std::to_string(size), options));
        }
        bench_->add_silently({.row = "depth and leaf size: other answers in all",
                              .scene = mesh_->title(),
                              .value = double(others_),
                              .unit = "rays",
                              .goal = value_at_most(0)});
        say();
    }

private:
    [[nodiscard]] Setting made(std::string name, const accel::OctreeOptions& options) const {
        Setting setting{.name = std::move(name)};
        setting.seconds = seconds_of([&] {
            setting.accel =
                render::build_object_accel(mesh_->view(), render::ObjectAccelKind::Octree, *cores_, options);
        });
        setting.bytes = double(setting.accel->bytes()) / double(mesh_->triangle_count());
        return setting;
    }

    void measure(const Setting& setting) {
        add(setting.name + ": build", setting.seconds, "s");
        add(setting.name + ": structure", setting.bytes, "B a triangle");
        const render::ObjectTracer own = setting.accel->tracer(), reference = default_.accel->tracer();
        for (const RayCase what : {RayCase::OneApart, RayCase::SixteenCoherent}) {
            const RayStream& stream = is_coherent(what) ? coherent_ : apart_;
            const RayContest contest(3, double(stream.size()),
                                     {{setting.name, [&] { hits_ += ask(own, what, stream); }},
                                      {"default", [&] { hits_ += ask(reference, what, stream); }}},
                                     Clock::Thread);
            BenchRow row = contest.row(setting.name + ": " + name_of(what), 0, 1);
            row.scene = mesh_->title();
            auto& best = best_[is_coherent(what) ? 1 : 0];
            if (*row.ratio > best.ratio) best = {setting.name, *row.ratio};
            bench_->add_silently(std::move(row));
        }
        const std::vector<MeshAnswer> answers = answers_of(own, RayCase::OneApart, apart_);
        std::size_t others = 0;
        for (std::size_t i = 0; i < answers.size(); ++i)
            others +=
                answers[i].triangle == answers_[i].triangle && std::bit_cast<std::uint32_t>(answers[i].distance) ==
                                                                   std::bit_cast<std::uint32_t>(answers_[i].distance)
                    ? 0
                    : 1;
        others_ += others;
        BenchRow row{.row = setting.name + ": other answers than the default's",
                     .scene = mesh_->title(),
                     .value = 1e6 * double(others) / double(answers.size()),
                     .unit = "per million"};
        bench_->add_silently(std::move(row));
    }

    void add(std::string row, double value, std::string unit) {
        bench_->add_silently({.row = std::move(row), .scene = mesh_->title(), .value = value, .unit = std::move(unit)});
    }

    void say() {
        char text[320];
        std::snprintf(
            text, sizeof text,
            "%s, depths and leaf sizes: the fastest for one incoherent ray is %s, %.2f times as fast as the "
            "default; for 16 coherent rays %s, %.2f times. %zu rays were answered otherwise than by the default.",
            mesh_->title().c_str(), best_[0].setting.c_str(), best_[0].ratio, best_[1].setting.c_str(), best_[1].ratio,
            others_);
        bench_->remark(text);
    }

    struct Best {
        std::string setting;
        double ratio = 0;
    };

    Bench* bench_;
    const BenchMesh* mesh_;
    std::unique_ptr<accel::Executor> cores_;
    Setting default_;
    RayStream coherent_, apart_;
    std::vector<MeshAnswer> answers_;  ///< of the default, to `apart_`
    std::array<Best, 2> best_;         ///< apart, coherent
    std::size_t others_ = 0;
    std::size_t hits_ = 0;  ///< so that nothing is left out as unused
};

}  // namespace

void bench_octree_study(Bench& bench, const BenchMesh& mesh) { OctreeStudy(bench, mesh).run(); }

}  // namespace enfilade::tools

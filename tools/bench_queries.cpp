// Files of rays: the whole of `enfilade trace` against tracing alone, points located at once against one by one, and
// rays that go on through walls.

#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <functional>
#include <random>
#include <system_error>

#include "accel/point_grid.h"
#include "base/error.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/generate.h"
#include "render/crossings.h"
#include "render/ray_stream.h"
#include "tools/bench.h"
#include "tools/contest.h"
#include "tools/even_rays.h"
#include "tools/query_rays.h"
#include "tools/scene_solids.h"

namespace enfilade::tools {

namespace {

namespace fs = std::filesystem;

/// A folder that is gone with its owner.
class Scratch {
public:
    Scratch() { fs::create_directories(path_); }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    [[nodiscard]] fs::path file(const std::string& name) const { return path_ / name; }

private:
    fs::path path_ = fs::temp_directory_path() / ("enfilade-bench-queries-" + std::to_string(getpid()));
};

using Queries = std::vector<render::RayQuery>;

/// A hundred sources, and from each of them rays in all directions, one after the other: sound, heat, a lidar.
Queries from_sources(const Queries& scattered) {
    Queries rays = scattered;
    const std::size_t each = std::max<std::size_t>(1, rays.size() / 100);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        rays[i].origin = scattered[i / each * each].origin;
        rays[i].cell = scattered[i / each * each].cell;
    }
    return rays;
}

void write_rays(const accel::SceneView& scene, const Queries& rays, const fs::path& file) {
    // As numpy.save writes float64 of shape (n, 6).
    std::string head = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(rays.size()) + ", 6), }";
    head.resize(117, ' ');
    head = std::string("\x93NUMPY\x01\x00\x76\x00", 10) + head + '\n';
    std::vector<double> numbers;
    for (const render::RayQuery& ray : rays)
        for (const double number : {ray.origin.x + scene.origin[0], ray.origin.y + scene.origin[1],
                                    ray.origin.z + scene.origin[2], ray.direction.x, ray.direction.y, ray.direction.z})
            numbers.push_back(number);
    FILE* stream = std::fopen(file.c_str(), "wb");
    if (stream == nullptr) throw IoError(file.string() + " cannot be written.");
    std::fwrite(head.data(), 1, head.size(), stream);
    std::fwrite(numbers.data(), sizeof(double), numbers.size(), stream);
    std::fclose(stream);
}

/// `nearest` alone, on columns that are there already.
class NearestAlone {
public:
    NearestAlone(const accel::SceneView& scene, const Queries& rays, render::StreamOrder order)
        : scene_(scene), order_(order) {
        for (const render::RayQuery& ray : rays) {
            const std::array<double, 6> row = {ray.origin.x,    ray.origin.y,    ray.origin.z,
                                               ray.direction.x, ray.direction.y, ray.direction.z};
            for (std::size_t k = 0; k < 6; ++k) columns_[k].push_back(float(row[k]));
            cells_.push_back(ray.cell);
        }
        distance_.resize(rays.size());
        face_.resize(rays.size());
    }
    void operator()() {
        const auto& c = columns_;
        render::nearest(scene_, {c[0], c[1], c[2], c[3], c[4], c[5], cells_, {}}, {distance_, face_, {}, {}},
                        {.order = order_});
    }

private:
    const accel::SceneView& scene_;
    render::StreamOrder order_;
    std::array<std::vector<float>, 6> columns_;
    std::vector<accel::CellId> cells_;
    std::vector<float> distance_;
    std::vector<accel::SourceFaceId> face_;
};

class QueryBench {
public:
    QueryBench(Bench& bench, const accel::Scene& scene, std::string name)
        : bench_(bench), scene_(scene), name_(std::move(name)), rounds_(bench.quick() ? 3 : 7) {}

    void run() {
        const Queries scattered = even_rays(scene_.view(), bench_.quick() ? 300'000 : 1'000'000, 5);
        whole_command("from 100 sources", from_sources(scattered), render::StreamOrder::Coherent);
        whole_command("scattered", scattered, render::StreamOrder::Any);
        locating("from 100 sources", from_sources(scattered));
        locating("scattered", scattered);
        passing(scattered);
    }

private:
    void whole_command(const std::string& kind, const Queries& rays, render::StreamOrder order) {
        const accel::SceneView& view = scene_.view();
        write_rays(view, rays, scratch_.file("rays.npy"));
        NearestAlone alone(view, rays, order);
        QueryTimes busy;
        const auto command = [&] {
            const RayFile file(scratch_.file("rays.npy"));
            const std::vector<NpyField> fields = hit_fields();
            NpyWriter hits(scratch_.file("hits.npy"), fields, sizeof(HitRecord));
            const QueryReport report = query_nearest(view, file, hits, {});
            hits.finish(report.rays);
            busy = report.busy;
        };
        const std::array<std::function<void()>, 2> competitors = {command, std::ref(alone)};
        const Contest contest(rounds_, competitors);
        const double rays_count = double(rays.size()) / 1e6;
        bench_.add({.row = "read, locate, trace, write: " + kind,
                    .scene = name_,
                    .value = rays_count / contest.median_of(0),
                    .unit = "Mrays/s",
                    .reference = "nearest() alone",
                    .reference_value = rays_count / contest.median_of(1),
                    .ratio = contest.faster(0, 1)});
        const double all = busy.read + busy.locate + busy.trace + busy.write;
        for (const auto& [part, seconds] : {std::pair("reading", busy.read), std::pair("locating", busy.locate),
                                            std::pair("tracing", busy.trace), std::pair("writing", busy.write)})
            bench_.add({.row = std::string("of that ") + part + ": " + kind,
                        .scene = name_,
                        .value = 100 * seconds / all,
                        .unit = "%"});
    }

    void locating(const std::string& kind, const Queries& rays) {
        const accel::SceneView& view = scene_.view();
        std::vector<std::array<double, 3>> points;
        for (const render::RayQuery& ray : rays) points.push_back({ray.origin.x, ray.origin.y, ray.origin.z});
        std::vector<accel::CellId> cells(points.size());
        const auto at_once = [&] { accel::locate(view, points, cells); };
        const auto one_by_one = [&] {
            for (std::size_t i = 0; i < points.size(); ++i)
                cells[i] = accel::locate(view, points[i]).value_or(none<accel::CellId>);
        };
        const std::array<std::function<void()>, 2> competitors = {at_once, one_by_one};
        const Contest contest(rounds_, competitors);
        bench_.add({.row = "locate points: " + kind,
                    .scene = name_,
                    .value = 1e9 * contest.median_of(0) / double(points.size()),
                    .unit = "ns",
                    .reference = "one by one",
                    .reference_value = 1e9 * contest.median_of(1) / double(points.size()),
                    .ratio = contest.faster(0, 1)});
    }

    void passing(const Queries& scattered) {
        const accel::SceneView& view = scene_.view();
        const Queries rays(scattered.begin(), scattered.begin() + std::ptrdiff_t(scattered.size() / 10));
        const render::Solids solids = solids_of(scene_);
        std::size_t passages = 0;
        const auto named = [&] { passages = all_crossings(view, rays, {.solids = &solids}).passages.size(); };
        const auto nameless = [&] { passages = all_crossings(view, rays).passages.size(); };
        const std::array<std::function<void()>, 2> competitors = {named, nameless};
        const Contest contest(rounds_, competitors);
        for (const std::size_t k : {0u, 1u}) {
            competitors[k]();
            bench_.add({.row = k == 0 ? "all crossings, solids by name" : "all crossings, solids by their faces",
                        .scene = name_,
                        .value = double(passages) / contest.median_of(k) / 1e6,
                        .unit = "Mpassages/s"});
        }
    }

    Bench& bench_;
    const accel::Scene& scene_;
    std::string name_;
    int rounds_;
    Scratch scratch_;
};

}  // namespace

void bench_queries(Bench& bench) {
    for (const std::uint32_t rooms : {135u, 1000u}) {
        const modeler::Building building =
            modeler::convexify(modeler::build(plans::generate({.rooms = rooms, .storeys = 3})));
        const accel::Scene scene = modeler::export_scene(building, modeler::CheckReport{}, "{}");
        QueryBench(bench, scene, std::to_string(rooms) + " rooms").run();
    }
}

}  // namespace enfilade::tools

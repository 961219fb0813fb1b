// Furnished floors: what they take, how fast they are made, and tracing them against Embree's instances.

#include "tools/bench_furnished.h"

#include <unistd.h>

#include <filesystem>
#include <optional>

#include "plans/generate.h"
#include "render/executor.h"
#include "tools/examples.h"
#include "tools/output_file.h"

namespace enfilade::tools {

namespace {

/// What the issue asks of the structure inside objects, and of the rooms around them.
constexpr double most_bytes_a_triangle = 60;
constexpr double most_octree_bytes_a_triangle = 120;
constexpr double most_room_megabytes = 5;
constexpr double least_unique_triangles = 480'000;
constexpr double most_build_seconds = 10;

void add_sizes(Bench& bench, const TracedFloor& traced, const TracedFloor& octrees, bool has_goals) {
    const FurnishedFloor& floor = *traced.floor;
    const auto add = [&](const char* row, double value, const char* unit, std::optional<Goal> goal) {
        bench.add(
            {.row = row, .scene = floor.name, .value = value, .unit = unit, .goal = has_goals ? goal : std::nullopt});
    };
    const double unique = double(floor.unique_triangles());
    add("objects", double(traced.scene().objects.size()), "objects", {});
    add("triangles of all meshes", unique, "triangles", value_at_least(least_unique_triangles));
    add("triangles of all objects", double(floor.instanced_triangles()) / 1e6, "million", {});
    add("structure inside objects", double(traced.accel->bytes()) / unique, "B a triangle",
        value_at_most(most_bytes_a_triangle));
    add("octrees inside objects", double(octrees.accel->bytes()) / unique, "B a triangle",
        value_at_most(most_octree_bytes_a_triangle));
    add("octrees inside objects, build", octrees.accel_seconds, "s", {});
    add("meshes and objects in the scene", double(floor.object_bytes()) / unique, "B a triangle", {});
    add("scene without objects", double(floor.room_bytes()) / 1e6, "MB", value_at_most(most_room_megabytes));
    add("structure inside objects, build", traced.accel_seconds, "s", {});
    add("Embree instanced, all it holds", double(traced.embree->bytes()) / unique, "B a triangle", {});
    add("Embree instanced, build", traced.embree_seconds, "s", {});
}

/// From the plan to the file.
void add_build(Bench& bench, const FurnishedFloor& floor, bool has_goal) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("enfilade-bench-" + std::to_string(getpid()) + ".enf");
    const double writing = seconds_of([&] {
        const auto bytes = floor.scene.bytes();
        write_text(file, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    });
    std::filesystem::remove(file);
    const auto add = [&](const char* row, double seconds, std::optional<Goal> goal) {
        bench.add({.row = row,
                   .scene = floor.name,
                   .threads = one_and_all_cores().back().threads,
                   .value = seconds,
                   .unit = "s",
                   .goal = goal});
    };
    add("from plan to file", floor.times.all() + writing,
        has_goal ? std::optional(value_at_most(most_build_seconds)) : std::nullopt);
    add("of that, opening the catalogue", floor.times.catalogue, {});
    add("of that, placing by rule", floor.times.placing, {});
    add("of that, objects into cells", floor.times.putting, {});
}

}  // namespace

TracedFloor::TracedFloor(const FurnishedFloor& floor_, bool has_embree, render::ObjectAccelKind kind) : floor(&floor_) {
    const std::unique_ptr<accel::Executor> cores = render::make_executor();
    accel_seconds = seconds_of([&] { accel = render::build_object_accel(scene(), kind, *cores); });
    objects = accel->tracer();
    if (!has_embree) return;
    embree_seconds = seconds_of(
        [&] { embree = std::make_unique<render::EmbreeInstances>(scene(), render::EmbreeObjects::Instanced); });
}

bool is_sixteen_coherent(render::EmbreeWay way) { return way.lanes == 16 && way.coherent; }

void bench_furnished(Bench& bench) {
    struct Example {
        const char* name;
        std::uint32_t rooms;
        bool is_large;
    };
    constexpr std::array examples = {Example{"8 rooms", 8, false}, Example{"office-46", 46, false},
                                     Example{"office-135", 135, true}};
    for (const Example& example : examples) {
        if (bench.quick() && !example.is_large) continue;
        // No example has eight rooms.
        const ExamplePlan named = example.rooms == 8
                                      ? ExamplePlan{example.name, plans::generate({.rooms = example.rooms})}
                                      : example_plan(bench, example.name, example.rooms);
        const FurnishedFloor floor = furnished_floor(named.name, named.plan, {});
        const TracedFloor traced(floor, true);
        const TracedFloor octrees(floor, false, render::ObjectAccelKind::Octree);
        add_sizes(bench, traced, octrees, example.is_large);
        add_build(bench, floor, example.is_large);
        std::optional<FurnishedFloor> cut_floor;
        std::optional<TracedFloor> cut;
        if (!bench.quick()) {
            cut_floor = furnished_floor(named.name, named.plan, {.cells = modeler::ObjectCells::Cut});
            cut.emplace(*cut_floor, false);
        }
        bench_furnished_pictures(bench, traced, octrees, cut ? &*cut : nullptr);
        bench_furnished_streams(bench, traced, octrees);
    }
}

}  // namespace enfilade::tools

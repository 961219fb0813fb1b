// Placing by rule: how long it takes, how much of what rules ask for finds a place, and whether what is guaranteed
// holds, told by a verifier that shares no code with the placing.

#include <algorithm>
#include <array>

#include "accel/sha256.h"
#include "modeler/build.h"
#include "modeler/catalogue/catalogue.h"
#include "modeler/convexify.h"
#include "modeler/furnishing/furnish.h"
#include "modeler/furnishing/rules.h"
#include "modeler/furnishing/verify_furnished.h"
#include "plans/generate.h"
#include "render/executor.h"
#include "tools/bench.h"
#include "tools/bench_cells.h"
#include "tools/examples.h"
#include "tools/furnished_floor.h"

namespace enfilade::tools {

namespace {

constexpr double most_seconds = 2;

struct Placed {
    std::uint64_t rooms = 0;
    std::uint64_t furnished_rooms = 0;  ///< that rules know
    std::uint64_t requested = 0;
    std::uint64_t placed = 0;
    double seconds = 0;
    std::array<std::uint64_t, 5> faults = {};  ///< by FurnishingFault

    void count(const modeler::Furnished& furnished) {
        for (const modeler::RoomFurnished& room : furnished.rooms) {
            ++rooms;
            furnished_rooms += room.kind.empty() ? 0 : 1;
            requested += room.requested;
            placed += room.placed;
        }
    }
    void count(const std::vector<modeler::FurnishingViolation>& violations) {
        for (const modeler::FurnishingViolation& violation : violations) ++faults[std::size_t(violation.fault)];
    }
};

/// Where everything stands: the same text for the same placing.
std::array<std::uint8_t, 32> hash_of(const modeler::Furnishing& furnishing) {
    std::vector<std::byte> bytes;
    const auto add = [&](const void* from, std::size_t size) {
        const auto* first = static_cast<const std::byte*>(from);
        bytes.insert(bytes.end(), first, first + size);
    };
    for (const modeler::FurnishedObject& object : furnishing.objects) {
        add(object.id.data(), object.id.size());
        add(object.model.data(), object.model.size());
        add(object.position.data(), sizeof object.position);
        add(&object.angle, sizeof object.angle);
        add(object.size.data(), sizeof object.size);
    }
    return accel::sha256(bytes);
}

void add_guarantees(Bench& bench, const std::string& scene, const Placed& placed) {
    using modeler::FurnishingFault;
    const auto add = [&](const char* row, FurnishingFault fault) {
        bench.add({.row = row,
                   .scene = scene,
                   .value = double(placed.faults[std::size_t(fault)]),
                   .unit = "of " + grouped(placed.placed) + " objects",
                   .goal = value_at_most(0)});
    };
    add("overlaps", FurnishingFault::Overlap);
    add("outside of their room", FurnishingFault::Outside);
    add("doors blocked", FurnishingFault::DoorBlocked);
    add("windows blocked", FurnishingFault::WindowBlocked);
    bench.add({.row = "rooms whose doors all reach each other as before",
               .scene = scene,
               .value = 100 * (1 - double(placed.faults[std::size_t(FurnishingFault::Unreachable)]) /
                                       double(std::max<std::uint64_t>(1, placed.rooms))),
               .unit = "%",
               .goal = value_at_least(100)});
    bench.add({.row = "placed of what rules ask for",
               .scene = scene,
               .value = 100 * double(placed.placed) / double(std::max<std::uint64_t>(1, placed.requested)),
               .unit = "%"});
    bench.add({.row = "rooms that rules know",
               .scene = scene,
               .value = 100 * double(placed.furnished_rooms) / double(std::max<std::uint64_t>(1, placed.rooms)),
               .unit = "%"});
}

void bench_example(Bench& bench, const modeler::Catalogue& catalogue) {
    const ExamplePlan example = example_plan(bench, "office-135", 135);
    const modeler::Building building = modeler::convexify(modeler::build(example.plan));
    const Cores& all = one_and_all_cores().back();
    Placed placed;
    modeler::Furnished furnished;
    for (const Cores& cores : one_and_all_cores()) {
        const double seconds = median_seconds(bench.quick() ? 1 : 5, [&] {
            furnished = modeler::furnish(building, modeler::own_rules(), catalogue, {.seed = 1}, *cores.executor);
        });
        bench.add({.row = "placing by rule",
                   .scene = example.name,
                   .threads = cores.threads,
                   .value = seconds,
                   .unit = "s",
                   .goal = value_at_most(most_seconds)});
        placed.seconds = seconds;
    }
    placed.count(furnished);
    placed.count(modeler::verify_furnished(building, furnished.furnishing));
    bench.add({.row = "time an object",
               .scene = example.name,
               .threads = all.threads,
               .value = 1e6 * placed.seconds / double(std::max<std::uint64_t>(1, placed.placed)),
               .unit = "us"});
    add_guarantees(bench, example.name, placed);
    const accel::SerialExecutor one;
    const modeler::Furnished again = modeler::furnish(building, modeler::own_rules(), catalogue, {.seed = 1}, one);
    const modeler::Furnished other = modeler::furnish(building, modeler::own_rules(), catalogue, {.seed = 2}, one);
    const auto hash = hash_of(furnished.furnishing);
    bench.add({.row = "the same seed, on one thread and on all: the same objects",
               .scene = example.name,
               .value = hash == hash_of(again.furnishing) ? 1.0 : 0.0,
               .unit = "yes",
               .goal = value_at_least(1)});
    bench.add({.row = "another seed: other objects",
               .scene = example.name,
               .value = hash != hash_of(other.furnishing) ? 1.0 : 0.0,
               .unit = "yes",
               .goal = value_at_least(1)});
}

/// Rooms with straight, oblique and curved walls.
void bench_random_rooms(Bench& bench, const modeler::Catalogue& catalogue) {
    constexpr std::uint32_t rooms_a_plan = 50;
    const std::uint64_t plan_count = bench.quick() ? 4 : 20;
    const Cores& all = one_and_all_cores().back();
    Placed placed;
    for (std::uint64_t k = 0; k < plan_count; ++k) {
        const double share = double(k % 5) / 8;
        const plans::Plan plan = plans::generate(
            {.rooms = rooms_a_plan, .curved = share, .oblique = k % 2 == 0 ? share : 0.5 - share, .seed = 100 + k});
        const modeler::Building building = modeler::convexify(modeler::build(plan));
        modeler::Furnished furnished;
        placed.seconds += seconds_of([&] {
            furnished = modeler::furnish(building, modeler::own_rules(), catalogue, {.seed = k}, *all.executor);
        });
        placed.count(furnished);
        placed.count(modeler::verify_furnished(building, furnished.furnishing));
    }
    const std::string scene = grouped(rooms_a_plan * plan_count) + " random rooms";
    bench.add({.row = "placing by rule", .scene = scene, .threads = all.threads, .value = placed.seconds, .unit = "s"});
    bench.add({.row = "time an object",
               .scene = scene,
               .threads = all.threads,
               .value = 1e6 * placed.seconds / double(std::max<std::uint64_t>(1, placed.placed)),
               .unit = "us"});
    add_guarantees(bench, scene, placed);
}

}  // namespace

void bench_furniture(Bench& bench) {
    const modeler::Catalogue catalogue;
    bench_example(bench, catalogue);
    bench_random_rooms(bench, catalogue);
}

}  // namespace enfilade::tools

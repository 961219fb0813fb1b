// Cutting one room of ever more corners.

#include "modeler/cutting/delaunay_partition.h"
#include "modeler/cutting/diagonal_partition.h"
#include "modeler/cutting/sah_partition.h"
#include "tools/bench_convexify.h"
#include "tools/contest.h"
#include "tools/convexifiers.h"
#include "tools/room_shapes.h"

namespace enfilade::tools {

namespace {

using modeler::Convexifier;

std::uint32_t cut(const ShapedRoom& room, Convexifier method) {
    switch (method) {
        case Convexifier::Sah:
            return sah_partition(room.points, room.sides, modeler::PartitionGoal::Convex, {}).piece_count();
        case Convexifier::Diagonals: return diagonal_partition(room.points, room.sides).piece_count();
        case Convexifier::HertelMehlhorn: break;
    }
    return delaunay_partition(room.points, room.sides, modeler::PartitionGoal::Convex).piece_count();
}

/// What 10,000 corners may take. Where fewer take longer, larger rooms are left out, and the goal is missed there.
constexpr double most_seconds = 2;

void measure(Bench& bench, RoomShape shape, const NamedConvexifier& method) {
    std::vector<std::uint32_t> sizes = {100, 300, 1000, 3000, 10000};
    std::vector<std::array<double, 2>> points;
    double before = 0;
    for (const std::uint32_t size : sizes) {
        if (before > most_seconds) {
            bench.remark(std::string(method.name) + " is left out on a " + name_of(shape) + " of " + grouped(size) +
                         " corners: it would take too long.");
            break;
        }
        const ShapedRoom room = shaped_room(shape, size);
        const double corners = double(room.points.size());
        std::uint32_t pieces = 0;
        const std::array<std::function<void()>, 1> work = {[&] { pieces = cut(room, method.convexifier); }};
        double seconds = busy_seconds_of(work[0]);
        if (seconds < 0.5) seconds = Contest(seconds < 0.02 && !bench.quick() ? 9 : 3, work).median_of(0);
        before = seconds;
        points.push_back({corners, seconds});
        const std::string scene = std::string(name_of(shape)) + ", " + grouped(room.points.size()) + " corners";
        BenchRow row{.row = std::string(method.name) + ": one room", .scene = scene, .value = seconds, .unit = "s"};
        if (method.convexifier == Convexifier::Sah && (size == sizes.back() || seconds > most_seconds))
            row.goal = value_at_most(most_seconds);
        bench.add(row);
        bench.add_silently({.row = std::string(method.name) + ": one room, a corner",
                            .scene = scene,
                            .value = seconds / corners * 1e6,
                            .unit = "us"});
        bench.add_silently({.row = std::string(method.name) + ": one room, pieces",
                            .scene = scene,
                            .value = double(pieces),
                            .unit = "1"});
    }
    BenchRow exponent{.row = std::string(method.name) + ": exponent of growth",
                      .scene = std::string(name_of(shape)) + ", " + grouped(std::uint64_t(points.front()[0])) + "-" +
                               grouped(std::uint64_t(points.back()[0])) + " corners",
                      .value = growth_exponent(points),
                      .unit = "1"};
    if (method.convexifier == Convexifier::Sah) exponent.goal = value_at_most(1.15);
    bench.add(exponent);
}

}  // namespace

void bench_cut_growth(Bench& bench) {
    for (const RoomShape shape : {RoomShape::Comb, RoomShape::Star, RoomShape::Arcs})
        for (const NamedConvexifier& method : named_convexifiers) measure(bench, shape, method);
}

}  // namespace enfilade::tools

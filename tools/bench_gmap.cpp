// The topological kernel: memory and validation a dart, on a lattice of cubes and on a building.

#include <string>

#include "gmap/cell_tuples.h"
#include "gmap/validate.h"
#include "modeler/build.h"
#include "plans/generate.h"
#include "tools/bench.h"
#ifdef ENFILADE_HAS_CGAL_MAPS
#include "tools/cgal_reference.h"
#endif

namespace enfilade::tools {

namespace {

/// side^3 cubes face to face, and one volume around them all.
gmap::CellTuples cube_lattice(std::uint32_t side) {
    const std::uint32_t corners = side + 1;
    const auto vertex = [corners](const std::array<std::uint32_t, 3>& at) {
        return (at[2] * corners + at[1]) * corners + at[0];
    };
    const auto volume = [side](const std::array<std::uint32_t, 3>& at) {
        return (at[2] * side + at[1]) * side + at[0];
    };
    gmap::CellTuples tuples;
    tuples.vertex_count = corners * corners * corners;
    tuples.volume_count = side * side * side + 1;
    const std::uint32_t outside = tuples.volume_count - 1;
    tuples.ring_first = {0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        std::array<std::uint32_t, 3> at;
        for (at[axis] = 0; at[axis] <= side; ++at[axis])
            for (at[u] = 0; at[u] < side; ++at[u])
                for (at[v] = 0; at[v] < side; ++at[v]) {
                    for (const auto& [du, dv] : {std::array{0u, 0u}, {1u, 0u}, {1u, 1u}, {0u, 1u}}) {
                        std::array<std::uint32_t, 3> corner = at;
                        corner[u] += du;
                        corner[v] += dv;
                        tuples.ring.push_back(vertex(corner));
                    }
                    tuples.ring_first.push_back(std::uint32_t(tuples.ring.size()));
                    std::array<std::uint32_t, 3> below = at;
                    if (at[axis] > 0) --below[axis];
                    tuples.face_volumes.push_back(
                        {at[axis] == side ? outside : volume(at), at[axis] == 0 ? outside : volume(below)});
                }
    }
    return tuples;
}

void measure(Bench& bench, const std::string& scene, const gmap::Map& map) {
    const double darts = double(map.dart_count());
    BenchRow memory{.row = "memory, cell ids included",
                    .scene = scene,
                    .value = double(map.memory_bytes()) / darts,
                    .unit = "B/dart",
                    .goal = value_at_most(32)};
    bool sound = true;
    const double seconds =
        median_seconds(bench.quick() ? 3 : 7, [&] { sound = gmap::validate(map).is_sound() && sound; });
    if (!sound) bench.remark("The map of " + scene + " is not sound: its time says nothing.");
    BenchRow validation{.row = "validate T1-T7, scaled to 1 M darts",
                        .scene = scene,
                        .value = seconds / darts * 1e6,
                        .unit = "s",
                        .goal = value_at_most(0.1)};
#ifdef ENFILADE_HAS_CGAL_MAPS
    // CGAL's is_valid() looks at the involutions and attributes alone (T1), not at T2 to T7.
    const CgalFigures cgal = measure_cgal(map, bench.quick() ? 1 : 3);
    memory.reference = validation.reference = "CGAL 3-G-map";
    memory.reference_value = cgal.bytes_per_dart;
    memory.ratio = cgal.bytes_per_dart / memory.value;
    validation.reference_value = cgal.validate_seconds / darts * 1e6;
    validation.ratio = cgal.validate_seconds / seconds;
    if (!cgal.is_valid) bench.remark("CGAL calls the map of " + scene + " invalid.");
#else
    bench.remark("Built without CGAL's maps: no reference.");
#endif
    bench.add(std::move(memory));
    bench.add(std::move(validation));
}

}  // namespace

void bench_gmap(Bench& bench) {
    const OneCore one_core;
    {
        const gmap::CellTuples tuples = cube_lattice(28);
        std::vector<gmap::Defect> defects;
        gmap::Map map;
        const double seconds = seconds_of([&] { map = gmap::build_map(tuples, defects); });
        const std::string scene = grouped(map.dart_count() / 1000) + "k darts, cubes";
        bench.add({.row = "build from cell tuples, scaled to 1 M darts",
                   .scene = scene,
                   .value = seconds / double(map.dart_count()) * 1e6,
                   .unit = "s"});
        measure(bench, scene, map);
    }
    const modeler::Building building = modeler::build(plans::generate({.rooms = bench.quick() ? 500u : 2000u}));
    measure(bench, grouped(building.map.dart_count() / 1000) + "k darts, offices", building.map);
}

}  // namespace enfilade::tools

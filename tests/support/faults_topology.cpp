// T1-T6: the arrays of the map, behind its back.

#include "tests/support/faults_topology.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/disjoint_sets.h"
#include "gmap/insert.h"
#include "gmap/remove.h"

namespace enfilade::testing {
namespace {

using modeler::Building;

/// Somewhere in the box around these vertices.
InjectedFault fault_at_vertices(const Building& building, std::string code,
                                const std::vector<std::uint32_t>& vertices) {
    InjectedFault fault{.code = std::move(code)};
    std::array<double, 3> low = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const std::uint32_t v : vertices) {
        const auto& p = building.vertices[v];
        const std::array<double, 3> at = {building.frame.world_x(p[0]), building.frame.world_y(p[1]),
                                          building.frame.world_z(p[2])};
        for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], at[i]), high[i] = std::max(high[i], at[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) fault.point[i] = (low[i] + high[i]) / 2;
    fault.reach = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2 + 1e-6;
    return fault;
}

/// The vertices of all darts for which `has(dart)`.
template <class Has>
std::vector<std::uint32_t> vertices_of(const gmap::MapArrays& arrays, Has has) {
    std::set<std::uint32_t> found;
    for (std::uint32_t d = 0; d < arrays.alpha[0].size(); ++d)
        if (has(d)) found.insert(arrays.cell_id[0][d]);
    return {found.begin(), found.end()};
}

std::uint32_t any_dart(const gmap::MapArrays& arrays, plans::Random& random) {
    return random.below(std::uint32_t(arrays.alpha[0].size()));
}

/// Gives all darts of cell `from` the id `to`.
void rename(gmap::MapArrays& arrays, std::size_t dimension, std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t& id : arrays.cell_id[dimension])
        if (id == from) id = to;
}

/// Makes ids of vertices and edges fit the orbits again where links have joined some: the lowest id for all.
void merge_ids(gmap::MapArrays& arrays) {
    for (const std::size_t dimension : {0, 1}) {
        DisjointSets cells(arrays.cell_bound[dimension]);
        std::vector<std::uint32_t>& ids = arrays.cell_id[dimension];
        for (std::size_t i = 0; i < 4; ++i)
            for (std::uint32_t d = 0; i != dimension && d < ids.size(); ++d)
                cells.join(ids[d], ids[arrays.alpha[i][d]]);
        for (std::uint32_t& id : ids) id = cells.find(id);
    }
}

}  // namespace

std::optional<InjectedFault> inject_t1(Building& building, plans::Random& random) {
    gmap::MapArrays arrays = building.map.arrays();
    const std::size_t i = random.below(4);
    const std::uint32_t d = any_dart(arrays, random), e = any_dart(arrays, random), before = arrays.alpha[i][d];
    InjectedFault fault;
    if (random.chance(0.3)) {
        if (arrays.cell_id[i][d] == arrays.cell_id[i][e]) return std::nullopt;
        // Both the cell that the dart has left and the one that it says it is of are the place.
        const std::uint32_t was = arrays.cell_id[i][d], is = arrays.cell_id[i][e];
        fault = fault_at_vertices(building, "T1", vertices_of(arrays, [&](std::uint32_t x) {
                                      return arrays.cell_id[i][x] == was || arrays.cell_id[i][x] == is;
                                  }));
        arrays.cell_id[i][d] = is;
    } else {
        if (e == before || e == d) return std::nullopt;
        fault = fault_at_vertices(building, "T1", vertices_of(arrays, [&](std::uint32_t x) {
                                      return x == d || x == e || x == before || x == arrays.alpha[i][e];
                                  }));
        arrays.alpha[i][d] = e;
    }
    building.map = gmap::Map(std::move(arrays));
    return fault;
}

std::optional<InjectedFault> inject_t2(Building& building, plans::Random& random) {
    gmap::MapArrays arrays = building.map.arrays();
    const std::uint32_t d = any_dart(arrays, random);
    const std::size_t i = 1 + random.below(3);
    std::vector<std::uint32_t> freed;
    if (i == 3) {
        for (std::uint32_t e = 0; e < arrays.alpha[3].size(); ++e)
            if (arrays.cell_id[2][e] == arrays.cell_id[2][d]) freed.push_back(e);
    } else {
        // What alpha_i has to commute with goes along: the other end of the edge, or the other side of the face.
        const std::size_t along = i == 2 ? 0 : 3;
        for (const std::uint32_t e : {d, arrays.alpha[i][d]}) {
            freed.push_back(e);
            freed.push_back(arrays.alpha[along][e]);
        }
    }
    // A face, or a whole shell, is open: the place is anywhere on it.
    const std::size_t open = i == 2 ? 3 : 2;
    InjectedFault fault = fault_at_vertices(building, "T2", vertices_of(arrays, [&](std::uint32_t x) {
                                                return arrays.cell_id[open][x] == arrays.cell_id[open][d];
                                            }));
    for (const std::uint32_t e : freed) arrays.alpha[i][e] = e;
    building.map = gmap::Map(std::move(arrays));
    return fault;
}

std::optional<InjectedFault> inject_t3(Building& building, plans::Random& random) {
    gmap::MapArrays arrays = building.map.arrays();
    const std::uint32_t first = any_dart(arrays, random);
    if (arrays.cell_id[3][first] == arrays.cell_id[3][arrays.alpha[3][first]]) return std::nullopt;
    // The mirror that turns the first edge round, dart by dart along the ring.
    std::vector<std::array<std::uint32_t, 2>> links;
    std::uint32_t d = first, mirrored = arrays.alpha[0][first];
    std::size_t i = 0;
    do {
        links.push_back({d, arrays.alpha[3][mirrored]});
        d = arrays.alpha[i][d];
        mirrored = arrays.alpha[i][mirrored];
        i = 1 - i;
    } while (d != first);
    for (const auto& [a, b] : links) arrays.alpha[3][a] = b, arrays.alpha[3][b] = a;
    merge_ids(arrays);
    // Where a shell meets its mirror image is a matter of where one begins to look.
    InjectedFault fault =
        fault_at_vertices(building, "T3", vertices_of(building.map.arrays(), [](std::uint32_t) { return true; }));
    building.map = gmap::Map(std::move(arrays));
    return fault;
}

std::optional<InjectedFault> inject_t4(Building& building, plans::Random& random) {
    gmap::MapArrays arrays = building.map.arrays();
    const std::size_t dimension = 1 + random.below(2);
    const std::uint32_t a = arrays.cell_id[dimension][any_dart(arrays, random)],
                        b = arrays.cell_id[dimension][any_dart(arrays, random)];
    const auto vertices = vertices_of(arrays, [&](std::uint32_t x) {
        return arrays.cell_id[dimension][x] == a || arrays.cell_id[dimension][x] == b;
    });
    if (a == b) return std::nullopt;
    InjectedFault fault = fault_at_vertices(building, "T4", vertices);
    rename(arrays, dimension, a, b);
    building.map = gmap::Map(std::move(arrays));
    return fault;
}

std::optional<InjectedFault> inject_t5(Building& building, plans::Random& random) {
    gmap::MapArrays arrays = building.map.arrays();
    const std::uint32_t a = arrays.cell_id[0][any_dart(arrays, random)],
                        b = arrays.cell_id[0][any_dart(arrays, random)];
    if (a == b) return std::nullopt;
    // Ends of one edge would make it a loop, corners of one face would make that touch itself.
    std::set<std::uint32_t> faces;
    for (std::uint32_t d = 0; d < arrays.alpha[0].size(); ++d)
        if (arrays.cell_id[0][d] == a) faces.insert(arrays.cell_id[2][d]);
    for (std::uint32_t d = 0; d < arrays.alpha[0].size(); ++d)
        if (arrays.cell_id[0][d] == b && faces.contains(arrays.cell_id[2][d])) return std::nullopt;
    InjectedFault fault = fault_at_vertices(building, "T5", {a, b});
    rename(arrays, 0, a, b);
    building.map = gmap::Map(std::move(arrays));
    return fault;
}

std::optional<InjectedFault> inject_t6(Building& building, plans::Random& random) {
    const gmap::MapArrays& arrays = building.map.arrays();
    const gmap::DartId d{any_dart(arrays, random)};
    const std::uint32_t face = arrays.cell_id[2][gmap::index(d)];
    InjectedFault fault = fault_at_vertices(
        building, "T6", vertices_of(arrays, [&](std::uint32_t x) { return arrays.cell_id[2][x] == face; }));
    const modeler::Face row = building.faces[face];
    if (random.chance(0.5)) {  // two edges between the same corners
        if (!gmap::insert_edge(building.map, d, building.map.alpha<0>(d))) return std::nullopt;
        building.faces.push_back(row);
        return fault;
    }
    const gmap::Map before = building.map;
    const auto edge = gmap::insert_edge(building.map, d, building.map.alpha<0, 1, 0>(d));
    if (!edge) return std::nullopt;
    const auto& from = building.vertices[gmap::index(building.map.vertex(edge->dart))];
    const auto& to = building.vertices[gmap::index(building.map.vertex(building.map.alpha<0>(edge->dart)))];
    std::array<std::int32_t, 3> middle;
    for (std::size_t i = 0; i < 3; ++i) middle[i] = from[i] + (to[i] - from[i]) / 2;
    // Corners on one line may have another vertex in their middle.
    const bool is_free = std::count(building.vertices.begin(), building.vertices.end(), middle) == 0;
    if (!is_free || !gmap::insert_vertex(building.map, edge->dart) || !gmap::remove_edge(building.map, edge->dart)) {
        building.map = before;
        return std::nullopt;
    }
    building.vertices.push_back(middle);
    while (building.faces.size() < building.map.cell_bound<2>()) building.faces.push_back(row);
    return fault;
}

}  // namespace enfilade::testing

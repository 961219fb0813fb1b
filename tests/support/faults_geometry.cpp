// G1-G3: one vertex is moved.

#include "tests/support/faults_geometry.h"

#include <algorithm>
#include <cmath>

#include "tests/support/face_oracle.h"

namespace enfilade::testing {
namespace {

using modeler::Building;
using Place = std::array<std::int32_t, 3>;

constexpr int tries = 200;

/// Where a vertex is, and the elements of all that holds it.
InjectedFault fault_at_vertex(const Building& building, const FaceOracle& oracle, std::string code,
                              std::uint32_t vertex) {
    InjectedFault fault{.code = std::move(code)};
    fault.point = oracle.world(vertex);
    fault.reach = building.frame.unit / 2;
    for (const std::uint32_t f : oracle.faces_at(vertex))
        for (const std::uint32_t v : oracle.faces()[f].volumes) {
            const modeler::Space& space = building.spaces[building.volumes[v].space];
            fault.elements.push_back({"", space.id, space.name});
        }
    return fault;
}

/// Vertices that an edge joins to this one.
std::vector<std::uint32_t> neighbours(const FaceOracle& oracle, std::uint32_t vertex) {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t f : oracle.faces_at(vertex)) {
        const auto& ring = oracle.faces()[f].ring;
        for (std::size_t k = 0; k < ring.size(); ++k)
            if (ring[k] == vertex) {
                found.push_back(ring[(k + 1) % ring.size()]);
                found.push_back(ring[(k + ring.size() - 1) % ring.size()]);
            }
    }
    return found;
}

/// Length of the shortest edge at a vertex, in grid units.
double shortest_edge(const Building& building, const FaceOracle& oracle, std::uint32_t vertex) {
    double shortest = HUGE_VAL;
    const Place& p = building.vertices[vertex];
    for (const std::uint32_t n : neighbours(oracle, vertex)) {
        const Place& q = building.vertices[n];
        shortest = std::min(shortest, std::hypot(double(p[0]) - q[0], double(p[1]) - q[1], double(p[2]) - q[2]));
    }
    return shortest;
}

Place moved(const Place& p, plans::Random& random, double most) {
    const double length = std::exp(random.uniform(0, std::log(std::max(1.0, most))));
    std::array<double, 3> way = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (random.chance(0.3)) way[0] = way[1] = 0;
    else if (random.chance(0.4)) way[2] = 0;
    const double norm = std::hypot(way[0], way[1], way[2]);
    Place result = p;
    for (std::size_t i = 0; i < 3; ++i) result[i] += std::int32_t(std::lround(way[i] / norm * length));
    return result;
}

}  // namespace

std::optional<InjectedFault> inject_g1(Building& building, plans::Random& random) {
    const FaceOracle oracle(building);
    const std::uint32_t count = std::uint32_t(building.vertices.size());
    const std::uint32_t from = random.below(count);
    std::vector<std::uint32_t> onto = neighbours(oracle, from);
    if (random.chance(0.3)) onto = {random.below(count)};
    const std::uint32_t to = onto[random.below(std::uint32_t(onto.size()))];
    if (to == from) return std::nullopt;
    building.vertices[from] = building.vertices[to];
    return fault_at_vertex(building, oracle, "G1", to);
}

std::optional<InjectedFault> inject_g2(Building& building, plans::Random& random) {
    const FaceOracle oracle(building);
    for (int k = 0; k < tries; ++k) {
        const std::uint32_t f = random.below(std::uint32_t(oracle.faces().size()));
        const auto& ring = oracle.faces()[f].ring;
        const std::size_t n = ring.size();
        if (n < 4 || !oracle.is_level(f)) continue;
        const std::size_t corner = random.below(std::uint32_t(n));
        const std::size_t side = (corner + 1 + random.below(std::uint32_t(n) - 2)) % n;
        const Place before = building.vertices[ring[corner]];
        // Through the middle of a side that does not end in the corner, and a little on.
        Place& p = building.vertices[ring[corner]];
        const double beyond = random.uniform(1.001, 1.2);
        for (std::size_t i = 0; i < 2; ++i) {
            const double middle =
                (double(building.vertices[ring[side]][i]) + building.vertices[ring[(side + 1) % n]][i]) / 2;
            p[i] = std::int32_t(std::lround(p[i] + beyond * (middle - p[i])));
        }
        if (!oracle.is_simple(f) && oracle.is_alone(ring[corner]))
            return fault_at_vertex(building, oracle, "G2", ring[corner]);
        p = before;
    }
    return std::nullopt;
}

std::optional<InjectedFault> inject_g3(Building& building, plans::Random& random) {
    const FaceOracle oracle(building);
    for (int k = 0; k < tries; ++k) {
        const std::uint32_t v = random.below(std::uint32_t(building.vertices.size()));
        if (oracle.faces_at(v).empty()) continue;
        const Place before = building.vertices[v];
        const double most = std::min(0.3 * shortest_edge(building, oracle, v), 0.05 / building.frame.unit);
        building.vertices[v] = moved(before, random, most);
        const auto& faces = oracle.faces_at(v);
        const bool bends = std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) { return !oracle.is_flat(f); });
        const bool crosses = std::any_of(faces.begin(), faces.end(),
                                         [&](std::uint32_t f) { return oracle.is_flat(f) && !oracle.is_simple(f); });
        if (bends && !crosses && oracle.is_alone(v)) return fault_at_vertex(building, oracle, "G3", v);
        building.vertices[v] = before;
    }
    return std::nullopt;
}

}  // namespace enfilade::testing

// G4 and G7: several vertices are moved, so that all faces stay flat and simple.

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/support/face_oracle.h"
#include "tests/support/faults_geometry.h"
#include "tests/support/map_surgery.h"

namespace enfilade::testing {
namespace {

using modeler::Building;
using modeler::Label;
using Place = std::array<std::int32_t, 3>;

constexpr int tries = 60;

std::set<std::uint32_t> faces_at(const FaceOracle& oracle, const std::vector<std::uint32_t>& vertices) {
    std::set<std::uint32_t> faces;
    for (const std::uint32_t v : vertices) faces.insert(oracle.faces_at(v).begin(), oracle.faces_at(v).end());
    return faces;
}

/// Whether nothing but what is meant is wrong after a move: faces flat and simple, vertices apart.
bool keeps_faces(const FaceOracle& oracle, const std::vector<std::uint32_t>& moved) {
    for (const std::uint32_t f : faces_at(oracle, moved))
        if (!oracle.is_flat(f) || !oracle.is_simple(f)) return false;
    return std::all_of(moved.begin(), moved.end(), [&](std::uint32_t v) { return oracle.is_alone(v); });
}

/// A hull that is no box is G5's.
bool touches_hull(const Building& building, const FaceOracle& oracle, const std::vector<std::uint32_t>& vertices) {
    for (const std::uint32_t f : faces_at(oracle, vertices))
        for (const std::uint32_t v : oracle.faces()[f].volumes)
            if (building.volumes[v].label == Label::Outside) return true;
    return false;
}

/// The vertices of all faces that lean after a move.
std::vector<std::uint32_t> tilted_rings(const FaceOracle& oracle, const std::vector<std::uint32_t>& moved) {
    std::vector<std::uint32_t> all;
    for (const std::uint32_t f : faces_at(oracle, moved))
        if (!oracle.is_level(f) && !oracle.is_upright(f))
            all.insert(all.end(), oracle.faces()[f].ring.begin(), oracle.faces()[f].ring.end());
    return all;
}

/// Anywhere in the box around the vertices, and all elements that have them.
InjectedFault fault_around(const Building& building, const FaceOracle& oracle, std::string code,
                           const std::vector<std::uint32_t>& vertices, double margin) {
    InjectedFault fault{.code = std::move(code)};
    std::array<double, 3> low = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const std::uint32_t v : vertices)
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], oracle.world(v)[i]);
            high[i] = std::max(high[i], oracle.world(v)[i]);
        }
    for (std::size_t i = 0; i < 3; ++i) fault.point[i] = (low[i] + high[i]) / 2;
    fault.reach = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2 + margin;
    for (const std::uint32_t f : faces_at(oracle, vertices))
        for (const std::uint32_t v : oracle.faces()[f].volumes) {
            const modeler::Space& space = building.spaces[building.volumes[v].space];
            fault.elements.push_back({"", space.id, space.name});
        }
    return fault;
}

std::array<double, 3> middle(const Building& building, const std::vector<std::uint32_t>& ring) {
    std::array<double, 3> sum = {};
    for (const std::uint32_t v : ring)
        for (std::size_t i = 0; i < 3; ++i) sum[i] += double(building.vertices[v][i]) / double(ring.size());
    return sum;
}

/// Distance of a point from the plane of a ring, in grid units, to either side.
double height_over(const Building& building, const std::vector<std::uint32_t>& ring, const std::array<double, 3>& p) {
    std::array<double, 3> normal = {};
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Place &a = building.vertices[ring[k]], &b = building.vertices[ring[(k + 1) % ring.size()]];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t u = (i + 1) % 3, w = (i + 2) % 3;
            normal[i] += (double(a[u]) - b[u]) * (double(a[w]) + b[w]);
        }
    }
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    double height = 0;
    for (std::size_t i = 0; i < 3; ++i) height += normal[i] / length * (p[i] - building.vertices[ring[0]][i]);
    return height;
}

/// Convex, seen along its steepest axis: its middle lies inside.
bool is_convex(const Building& building, const std::vector<std::uint32_t>& ring) {
    for (std::size_t u = 0; u < 3; ++u)
        for (std::size_t w = u + 1; w < 3; ++w) {
            int left = 0, right = 0;
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const Place &a = building.vertices[ring[k]], &b = building.vertices[ring[(k + 1) % ring.size()]],
                            &c = building.vertices[ring[(k + 2) % ring.size()]];
                const std::int64_t area = (std::int64_t(b[u]) - a[u]) * (std::int64_t(c[w]) - b[w]) -
                                          (std::int64_t(b[w]) - a[w]) * (std::int64_t(c[u]) - b[u]);
                left += area > 0;
                right += area < 0;
            }
            if (left > 0 && right > 0) return false;
        }
    return true;
}

}  // namespace

std::optional<InjectedFault> inject_g4(Building& building, plans::Random& random) {
    const FaceOracle oracle(building);
    for (int k = 0; k < 20 * tries; ++k) {
        const std::uint32_t through = random.below(std::uint32_t(oracle.faces().size()));
        const OracleFace& goal = oracle.faces()[through];
        if (goal.ring.empty() || !is_convex(building, goal.ring)) continue;
        const std::uint32_t volume = goal.volumes[random.below(2)];
        if (!accel::carries_light(building.volumes[volume].label)) continue;
        // Another face of the volume, which shares no vertex with the goal.
        std::vector<std::uint32_t> bases;
        for (std::uint32_t f = 0; f < oracle.faces().size(); ++f) {
            const OracleFace& face = oracle.faces()[f];
            if (face.ring.empty() || (face.volumes[0] != volume && face.volumes[1] != volume)) continue;
            if (std::find_first_of(face.ring.begin(), face.ring.end(), goal.ring.begin(), goal.ring.end()) ==
                face.ring.end())
                bases.push_back(f);
        }
        if (bases.empty()) continue;
        const std::uint32_t base = bases[random.below(std::uint32_t(bases.size()))];
        // From the middle of the base through that of the goal, and on by up to half a metre.
        const std::array<double, 3> from = middle(building, oracle.faces()[base].ring),
                                    to = middle(building, goal.ring);
        const double length = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
        const double beyond = std::exp(random.uniform(std::log(3.0), std::log(0.5 / building.frame.unit)));
        Place apex;
        for (std::size_t i = 0; i < 3; ++i)
            apex[i] = std::int32_t(std::lround(to[i] + (to[i] - from[i]) * beyond / length));
        if (std::count(building.vertices.begin(), building.vertices.end(), apex) > 0) continue;
        const std::array<double, 3> tip = {double(apex[0]), double(apex[1]), double(apex[2])};
        if (height_over(building, goal.ring, from) * height_over(building, goal.ring, tip) > -4) continue;
        std::vector<std::uint32_t> all = oracle.faces()[base].ring;
        all.insert(all.end(), goal.ring.begin(), goal.ring.end());
        InjectedFault fault = fault_around(building, oracle, "G4", all, 1);
        raise_spike(building, base, apex);
        return fault;
    }
    return std::nullopt;
}

std::optional<InjectedFault> inject_g7(Building& building, plans::Random& random) {
    const FaceOracle oracle(building);
    const auto is_tilted = [&](std::uint32_t f) { return !oracle.is_level(f) && !oracle.is_upright(f); };
    for (int k = 0; k < 20 * tries; ++k) {
        const std::uint32_t f = random.below(std::uint32_t(oracle.faces().size()));
        const auto& ring = oracle.faces()[f].ring;
        if (ring.empty()) continue;
        // All vertices on the line of one side of the face, along the face's normal.
        const std::size_t side = random.below(std::uint32_t(ring.size()));
        const Place a = building.vertices[ring[side]], b = building.vertices[ring[(side + 1) % ring.size()]];
        std::vector<std::uint32_t> moved;
        for (const std::uint32_t v : ring) {
            const Place& p = building.vertices[v];
            std::array<__int128, 3> u, w;
            for (std::size_t i = 0; i < 3; ++i) u[i] = b[i] - a[i], w[i] = p[i] - a[i];
            if (u[1] * w[2] == u[2] * w[1] && u[2] * w[0] == u[0] * w[2] && u[0] * w[1] == u[1] * w[0])
                moved.push_back(v);
        }
        const double most = std::log(0.03 / building.frame.unit);
        const std::int32_t step = std::int32_t(std::exp(random.uniform(0, most))) * (random.chance(0.5) ? 1 : -1);
        Place way = {0, 0, 0};
        if (oracle.is_level(f)) way[2] = step;
        else if (a[2] != b[2]) continue;
        else if (a[0] == b[0]) way[0] = step;
        else if (a[1] == b[1]) way[1] = step;
        else continue;
        std::vector<Place> before;
        for (const std::uint32_t v : moved) {
            before.push_back(building.vertices[v]);
            for (std::size_t i = 0; i < 3; ++i) building.vertices[v][i] += way[i];
        }
        if (is_tilted(f) && keeps_faces(oracle, moved) && !touches_hull(building, oracle, moved))
            return fault_around(building, oracle, "G7", tilted_rings(oracle, moved), building.frame.unit);
        for (std::size_t n = 0; n < moved.size(); ++n) building.vertices[moved[n]] = before[n];
    }
    return std::nullopt;
}

}  // namespace enfilade::testing

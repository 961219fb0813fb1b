// T7, G5, G8: volumes with a hole, a hull that is no box, tables that measure otherwise than the map.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "tests/support/fault_place.h"
#include "tests/support/faults_topology.h"
#include "tests/support/map_surgery.h"

namespace enfilade::testing {
namespace {

using modeler::Building;
using modeler::Label;

/// V - E + F of what these volumes are together, without the faces between them.
std::int64_t euler(const gmap::CellTuples& tuples, const std::set<std::uint32_t>& group) {
    std::set<std::uint32_t> vertices;
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::int64_t faces = 0;
    for (std::size_t f = 0; f < tuples.face_count(); ++f) {
        if (group.contains(tuples.face_volumes[f][0]) == group.contains(tuples.face_volumes[f][1])) continue;
        ++faces;
        const std::uint32_t first = tuples.ring_first[f], count = tuples.ring_first[f + 1] - first;
        for (std::uint32_t k = 0; k < count; ++k) {
            vertices.insert(tuples.ring[first + k]);
            edges.insert(std::minmax(tuples.ring[first + k], tuples.ring[first + (k + 1) % count]));
        }
    }
    return std::int64_t(vertices.size()) - std::int64_t(edges.size()) + faces;
}

/// Makes one volume of several, in the map and the tables.
void unite(Building& building, const gmap::CellTuples& before, const std::set<std::uint32_t>& group) {
    std::vector<std::uint32_t> renamed;
    std::vector<modeler::Volume> volumes;
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v) {
        const bool goes = group.contains(v) && v != *group.begin();
        renamed.push_back(goes ? renamed[*group.begin()] : std::uint32_t(volumes.size()));
        if (!goes) volumes.push_back(building.volumes[v]);
    }
    gmap::CellTuples after;
    after.vertex_count = before.vertex_count;
    after.volume_count = std::uint32_t(volumes.size());
    after.ring_first.push_back(0);
    std::vector<modeler::Face> faces;
    for (std::size_t f = 0; f < before.face_count(); ++f) {
        const std::uint32_t a = renamed[before.face_volumes[f][0]], b = renamed[before.face_volumes[f][1]];
        if (a == b) continue;
        after.ring.insert(after.ring.end(), before.ring.begin() + before.ring_first[f],
                          before.ring.begin() + before.ring_first[f + 1]);
        after.ring_first.push_back(std::uint32_t(after.ring.size()));
        after.face_volumes.push_back({a, b});
        modeler::Face face = building.faces[f];
        face.front = renamed[face.front];
        face.back = renamed[face.back];
        faces.push_back(face);
    }
    building.volumes = std::move(volumes);
    building.faces = std::move(faces);
    rebuild(building, after);
}

}  // namespace

std::optional<InjectedFault> inject_t7(Building& building, plans::Random& random) {
    const gmap::CellTuples tuples = tuples_of(building);
    std::map<std::tuple<std::uint32_t, std::int32_t, std::int32_t>, std::set<std::uint32_t>> groups;
    std::map<std::tuple<std::uint32_t, std::int32_t, std::int32_t>, std::set<std::uint32_t>> standing;
    for (std::uint32_t v = 0; v + 1 < building.volumes.size(); ++v) {
        const modeler::Volume& volume = building.volumes[v];
        if (!accel::carries_light(volume.label) && volume.label != Label::Ground) continue;
        groups[{volume.space, volume.z_low, volume.z_high}].insert(v);
        groups[{volume.space, volume.z_low, 0}].insert(v);
    }
    std::vector<std::set<std::uint32_t>> rings;
    for (const auto& [key, group] : groups)
        if (group.size() > 1 && euler(tuples, group) == 0) rings.push_back(group);
    if (rings.empty()) return std::nullopt;
    const std::set<std::uint32_t>& ring = rings[random.below(std::uint32_t(rings.size()))];
    InjectedFault fault{.code = "T7"};
    const modeler::Space& space = building.spaces[building.volumes[*ring.begin()].space];
    fault.elements = {{"", space.id, space.name}};
    fault.reach = site_diagonal(building);
    unite(building, tuples, ring);
    return fault;
}

std::optional<InjectedFault> inject_g5(Building& building, plans::Random& random) {
    const std::size_t axis = random.below(3);
    const bool is_high = random.chance(0.5), is_table = random.chance(0.5);
    std::array<std::int32_t, 3>& corner = is_high ? building.site_max : building.site_min;
    const std::int32_t side = corner[axis];
    const std::int32_t by = std::int32_t(std::exp(random.uniform(0, std::log(0.5 / building.frame.unit))));
    const std::int32_t moved = side + (random.chance(0.5) ? by : -by);
    if (is_table) {
        corner[axis] = moved;
    } else {
        for (auto& p : building.vertices)
            if (p[axis] == side) p[axis] = moved;
    }
    InjectedFault fault{.code = "G5"};
    std::array<double, 3> middle;
    for (std::size_t i = 0; i < 3; ++i) middle[i] = (double(building.site_min[i]) + building.site_max[i]) / 2;
    middle[axis] = is_table ? side : moved;
    const plans::GridFrame& frame = building.frame;
    fault.point = {frame.origin_x + frame.unit * middle[0], frame.origin_y + frame.unit * middle[1],
                   frame.origin_z + frame.unit * middle[2]};
    fault.reach = frame.unit * by;
    return fault;
}

std::optional<InjectedFault> inject_g8(Building& building, plans::Random& random) {
    if (!building.convex) return std::nullopt;
    if (random.chance(0.5)) {
        const auto volume = pick(building, random, [&](std::uint32_t v) { return v + 1 < building.volumes.size(); });
        InjectedFault fault = fault_at(building, "G8", *volume);
        const std::int32_t by = 1 + std::int32_t(random.below(1000));
        (random.chance(0.5) ? building.volumes[*volume].z_high : building.volumes[*volume].z_low) +=
            random.chance(0.5) ? by : -by;
        fault.reach += building.frame.unit * by;
        return fault;
    }
    // A cell with the middle of its neighbours' chord, and a little more, for a corner.
    for (int k = 0; k < 50; ++k) {
        const auto volume = pick(building, random, [&](std::uint32_t v) {
            const modeler::Volume& row = building.volumes[v];
            return accel::carries_light(row.label) && building.pieces[row.piece].corner_count > 3;
        });
        if (!volume) return std::nullopt;
        const modeler::Piece& piece = building.pieces[building.volumes[*volume].piece];
        const std::uint32_t n = piece.corner_count, c = random.below(n);
        const auto at = [&](std::uint32_t i) {
            return building.points[building.corners[piece.first_corner + i % n].vertex];
        };
        const plans::GridPoint a = at(c + n - 1), b = at(c), next = at(c + 1), across = at(c + 2);
        modeler::Corner& corner = building.corners[piece.first_corner + c];
        if (orientation(a, b, next) <= 0 || orientation(a, across, next) >= 0) continue;
        InjectedFault fault = fault_at(building, "G8", *volume);
        fault.reach += building.frame.unit * (double(building.site_max[2]) - building.site_min[2]);  // any storey's
        building.points.push_back({std::int32_t((2 * std::int64_t(a.x) + 2 * next.x + across.x) / 5),
                                   std::int32_t((2 * std::int64_t(a.y) + 2 * next.y + across.y) / 5)});
        corner.vertex = std::uint32_t(building.points.size() - 1);
        return fault;
    }
    return std::nullopt;
}

}  // namespace enfilade::testing

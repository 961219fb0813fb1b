#include "tests/support/map_surgery.h"

#include "tests/support/face_oracle.h"

namespace enfilade::testing {

gmap::CellTuples tuples_of(const modeler::Building& building) {
    const FaceOracle oracle(building);
    gmap::CellTuples tuples;
    tuples.vertex_count = std::uint32_t(building.vertices.size());
    tuples.volume_count = std::uint32_t(building.volumes.size());
    tuples.ring_first.push_back(0);
    for (const OracleFace& face : oracle.faces()) {
        tuples.ring.insert(tuples.ring.end(), face.ring.begin(), face.ring.end());
        tuples.ring_first.push_back(std::uint32_t(tuples.ring.size()));
        tuples.face_volumes.push_back(face.volumes);
    }
    return tuples;
}

void rebuild(modeler::Building& building, const gmap::CellTuples& tuples, std::uint32_t like) {
    building.map = gmap::build_map(tuples, building.map_defects);
    const modeler::Face row = building.faces[like];
    while (building.faces.size() < tuples.face_count()) building.faces.push_back(row);
}

std::uint32_t raise_spike(modeler::Building& building, std::uint32_t face, const std::array<std::int32_t, 3>& apex) {
    const gmap::CellTuples before = tuples_of(building);
    gmap::CellTuples after;
    const std::uint32_t top = before.vertex_count;
    after.vertex_count = top + 1;
    after.volume_count = before.volume_count;
    after.ring_first.push_back(0);
    const auto add = [&](std::vector<std::uint32_t> ring, std::size_t f) {
        after.ring.insert(after.ring.end(), ring.begin(), ring.end());
        after.ring_first.push_back(std::uint32_t(after.ring.size()));
        after.face_volumes.push_back(before.face_volumes[f]);
    };
    const auto corner = [&](std::size_t f, std::size_t k) {
        const std::uint32_t first = before.ring_first[f], count = before.ring_first[f + 1] - first;
        return before.ring[first + k % count];
    };
    for (std::size_t f = 0; f < before.face_count(); ++f) {
        if (f == face) add({corner(f, 0), corner(f, 1), top}, f);
        else add({before.ring.begin() + before.ring_first[f], before.ring.begin() + before.ring_first[f + 1]}, f);
    }
    for (std::size_t k = 1; k < before.ring_first[face + 1] - before.ring_first[face]; ++k)
        add({corner(face, k), corner(face, k + 1), top}, face);
    building.vertices.push_back(apex);
    rebuild(building, after, face);
    return top;
}

}  // namespace enfilade::testing

#pragma once
// Maps to test with, and ways to break them.

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "gmap/cell_tuples.h"
#include "gmap/map.h"
#include "gmap/orbit.h"
#include "gmap/primitives.h"
#include "gmap/remove.h"
#include "gmap/validate.h"

namespace enfilade::gmap {

inline Map built(const CellTuples& tuples) {
    std::vector<Defect> defects;
    Map map = build_map(tuples, defects);
    EXPECT_TRUE(defects.empty()) << defects.front().sentence;
    return map;
}

inline Map cube() { return built(hexahedron_tuples()); }
inline Map grid(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz) { return built(grid_tuples(nx, ny, nz)); }

/// The same map with its arrays changed behind its back.
inline Map edited(const Map& map, const std::function<void(MapArrays&)>& edit) {
    MapArrays arrays = map.arrays();
    edit(arrays);
    return Map(std::move(arrays));
}

inline std::string text_of(const Validation& found) {
    std::string text;
    for (const Defect& defect : found.defects) text += defect.code + " " + defect.sentence + "\n";
    return text + "suppressed: " + std::to_string(found.suppressed) + "\n";
}

inline std::vector<std::string> codes_of(const Validation& found) {
    std::vector<std::string> codes;
    for (const Defect& defect : found.defects) codes.push_back(defect.code);
    return codes;
}

/// Each orbit of dimension I carries one id and each id one orbit, by a count of its own.
template <int I>
testing::AssertionResult ids_are_orbits(const Map& map) {
    std::set<DartId> left;
    for (const DartId d : map.darts()) left.insert(d);
    std::set<CellId<I>> ids;
    while (!left.empty()) {
        const CellId<I> id = map.cell_id<I>(*left.begin());
        if (!ids.insert(id).second)
            return testing::AssertionFailure() << I << "-cell " << index(id) << " has two orbits";
        std::vector<DartId> queue{*left.begin()};
        left.erase(left.begin());
        while (!queue.empty()) {
            const DartId d = queue.back();
            queue.pop_back();
            if (map.cell_id<I>(d) != id)
                return testing::AssertionFailure() << I << "-cell " << index(id) << " shares an orbit";
            for (int i = 0; i < 4; ++i)
                if (i != I && left.erase(map.alpha(i, d)) > 0) queue.push_back(map.alpha(i, d));
        }
    }
    if (ids.size() != map.cell_count<I>())
        return testing::AssertionFailure() << ids.size() << " " << I << "-cells, counted " << map.cell_count<I>();
    return testing::AssertionSuccess();
}

inline testing::AssertionResult all_ids_are_orbits(const Map& map) {
    if (auto result = ids_are_orbits<0>(map); !result) return result;
    if (auto result = ids_are_orbits<1>(map); !result) return result;
    if (auto result = ids_are_orbits<2>(map); !result) return result;
    return ids_are_orbits<3>(map);
}

inline std::vector<std::size_t> cell_counts(const Map& map) {
    return {map.vertex_count(), map.edge_count(), map.face_count(), map.volume_count()};
}

/// A dart of the face between two volumes, on the side of the first.
inline DartId dart_between(const Map& map, std::uint32_t a, std::uint32_t b) {
    for (const DartId d : map.darts())
        if (map.volume(d) == VolumeId{a} && map.volume(map.alpha<3>(d)) == VolumeId{b}) return d;
    ADD_FAILURE() << "no face between volumes " << a << " and " << b;
    return none<DartId>;
}

/// The darts that lead around the side of a face of `d`: from dart to dart by alpha0, then alpha1.
inline std::vector<DartId> face_path(const Map& map, DartId d) {
    std::vector<DartId> path;
    DartId x = d;
    do {
        path.push_back(x);
        x = map.alpha<0, 1>(x);
    } while (x != d);
    return path;
}

}  // namespace enfilade::gmap

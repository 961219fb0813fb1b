#pragma once
// One random operation on a map, drawn in a way that shrinks: numbers that pick among what is there.

#include <rapidcheck.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "gmap/insert.h"
#include "gmap/remove.h"
#include "maps.h"

namespace enfilade::gmap {

inline constexpr int kind_count = 6;

struct Step {
    std::uint32_t kind = 0;  ///< mod 6: insert vertex, edge, face; remove vertex, edge, face
    std::uint32_t where = 0;
    std::uint32_t how = 0;
    bool keeps_sizes = false;  ///< no face of fewer than three edges, no volume of fewer than four faces
};

inline std::ostream& operator<<(std::ostream& out, const Step& step) {
    return out << "Step{" << step.kind % kind_count << ", " << step.where << ", " << step.how << "}";
}

inline Map random_start() {
    const auto kind = *rc::gen::inRange(0, 3);
    if (kind == 0) return built(prism_tuples(*rc::gen::inRange(3u, 9u)));
    if (kind == 1) return grid(*rc::gen::inRange(1u, 4u), *rc::gen::inRange(1u, 4u), *rc::gen::inRange(1u, 3u));
    return built(wrapped_grid_tuples(3, 3, *rc::gen::inRange(3u, 5u)));
}

inline DartId picked(const Map& map, std::uint32_t number) {
    std::uint32_t d = static_cast<std::uint32_t>(number % map.dart_bound());
    while (!map.contains(DartId{d})) d = static_cast<std::uint32_t>((d + 1) % map.dart_bound());
    return DartId{d};
}

/// The path around a patch of `size` faces of one shell, grown from the face of `d`; empty where it bounds no disc in
/// one run.
inline std::vector<DartId> around_patch(const Map& map, DartId d, std::size_t size) {
    std::set<DartId> inside;
    std::vector<DartId> starts{d};
    std::size_t faces = 0;
    for (std::size_t next = 0; next < starts.size() && faces < size; ++next) {
        if (inside.contains(starts[next])) continue;
        ++faces;
        for (const DartId x : orbit<0, 1>(map, starts[next])) {
            inside.insert(x);
            starts.push_back(map.alpha<2>(x));
        }
    }
    const auto is_rim = [&](DartId x) { return !inside.contains(map.alpha<2>(x)); };
    const auto first = std::find_if(inside.begin(), inside.end(), is_rim);
    if (first == inside.end()) return {};
    std::vector<DartId> path;
    DartId x = *first;
    do {
        path.push_back(x);
        x = map.alpha<0, 1>(x);
        while (!is_rim(x)) x = map.alpha<2, 1>(x);
    } while (x != *first && path.size() <= inside.size());
    return path;
}

inline std::size_t face_total(const Map& map, DartId d) { return incident_cells<2, 3>(map, d).size(); }

/// What was done, or nothing where the step does not fit the map, which is unchanged then.
inline std::optional<Changes> apply(Map& map, const Step& step) {
    const DartId d = picked(map, step.where);
    const std::uint32_t sizes = step.keeps_sizes ? 2 : 1;
    switch (step.kind % kind_count) {
        case 0: return insert_vertex(map, d);
        case 1: {
            const std::vector<DartId> corners = face_path(map, d);
            const auto last = static_cast<std::uint32_t>(corners.size());
            if (last < 2 * sizes) return std::nullopt;
            const std::uint32_t to = sizes + step.how % (last - 2 * sizes + 1);
            return insert_edge(map, d, corners[to % last]);
        }
        case 2: {
            const std::size_t size = 3 + step.how % 3;
            const std::vector<DartId> path = around_patch(map, d, size);
            if (!step.keeps_sizes) return insert_face(map, path);
            // A patch may surround a small rest, so that only the result tells.
            Map trial = map;
            auto done = insert_face(trial, path);
            if (!done || path.size() < 3 || face_total(trial, done->dart) < 4 ||
                face_total(trial, trial.alpha<3>(done->dart)) < 4)
                return std::nullopt;
            map = std::move(trial);
            return done;
        }
        case 3: return remove_vertex(map, d);
        case 4: return remove_edge(map, d);
        default: return remove_face(map, d);
    }
}

/// Takes an insertion back.
inline std::optional<Changes> undo(Map& map, const Step& step, const Changes& done) {
    switch (step.kind % kind_count) {
        case 0: return remove_vertex(map, done.dart);
        case 1: return remove_edge(map, done.dart);
        default: return remove_face(map, done.dart);
    }
}

}  // namespace enfilade::gmap

namespace rc {
template <>
struct Arbitrary<enfilade::gmap::Step> {
    static Gen<enfilade::gmap::Step> arbitrary() {
        return gen::build<enfilade::gmap::Step>(gen::set(&enfilade::gmap::Step::kind, gen::inRange(0u, 6u)),
                                                gen::set(&enfilade::gmap::Step::where, gen::inRange(0u, 1u << 20)),
                                                gen::set(&enfilade::gmap::Step::how, gen::inRange(0u, 1u << 10)));
    }
};
}  // namespace rc

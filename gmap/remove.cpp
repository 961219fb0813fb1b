#include "gmap/remove.h"

#include <array>
#include <utility>
#include <vector>

#include "gmap/access.h"
#include "gmap/orbit.h"
#include "gmap/update.h"

namespace enfilade::gmap {

using detail::IdSet;
using detail::MapAccess;

namespace {

constexpr std::uint32_t raw(DartId d) { return static_cast<std::uint32_t>(d); }

/// An i-cell and its rim: the darts that alpha_i leads to from it, with the dart each will be linked to instead.
/// (Damiand and Lienhardt, Combinatorial Maps, removal: alpha_i' = (alpha_i alpha_i+1)^k alpha_i.)
struct Removal {
    std::vector<DartId> darts;
    std::vector<std::pair<DartId, DartId>> rim;
};

Removal plan_removal(const Map& map, int i, DartId d) {
    Removal plan;
    IdSet inside;
    for (const DartId x : Orbit(map, d, detail::cell_generators(i))) {
        plan.darts.push_back(x);
        inside.insert(raw(x));
    }
    for (const DartId c : plan.darts) {
        const DartId rim = map.alpha(i, c);
        if (inside.contains(raw(rim))) continue;
        DartId partner = rim;
        if (i < 3) {
            DartId x = c;
            do {
                x = map.alpha(i, map.alpha(i + 1, x));
            } while (inside.contains(raw(x)));
            partner = x;
        }
        plan.rim.emplace_back(rim, partner);
    }
    return plan;
}

bool leaves_nothing_free(const Removal& plan) {
    for (const auto& [rim, partner] : plan.rim)
        if (rim == partner) return false;
    return !plan.rim.empty();
}

/// Whether removing an i-cell can merge, split or take away j-cells. What it cannot: the neighbours of a vertex or an
/// edge are linked anew within their volumes, and those of a vertex within their faces too. That saves a walk around
/// them.
constexpr bool may_change(int i, int j) { return i == j || (i == 0 ? j == 1 : i == 1 ? j != 3 : true); }

Changes remove_cell(Map& map, int i, const Removal& plan) {
    std::array<std::vector<std::uint32_t>, 4> lost;
    for (int j = 0; j < 4; ++j)
        for (const DartId x : plan.darts) {
            const std::uint32_t id = MapAccess::cell(map, j, x);
            auto& ids = lost[static_cast<std::size_t>(j)];
            if (ids.empty() || ids.back() != id) ids.push_back(id);
        }
    std::vector<DartId> touched;
    for (const auto& [rim, partner] : plan.rim) {
        MapAccess::alpha(map, i, rim) = raw(partner);
        touched.push_back(rim);
    }
    for (const DartId x : plan.darts) MapAccess::erase_dart(map, x);
    Changes changes;
    for (int j = 0; j < 4; ++j) {
        if (!may_change(i, j)) continue;
        if (j == i) detail::update_cells(map, j, {}, changes, lost[static_cast<std::size_t>(j)]);
        else detail::update_cells(map, j, touched, changes, lost[static_cast<std::size_t>(j)]);
    }
    return changes;
}

/// Whether exactly two cells of the next dimension meet: their involutions commute on all darts, and do not coincide,
/// as they would at the tip of a dangling cell.
bool joins_two(const Map& map, const Removal& plan, int first, int second) {
    for (const DartId x : plan.darts) {
        if (map.alpha(first, x) == map.alpha(second, x)) return false;
        if (map.alpha(first, map.alpha(second, x)) != map.alpha(second, map.alpha(first, x))) return false;
    }
    return true;
}

/// Whether an end of the edge has no other edge on this shell.
bool is_dangling_edge(const Map& map, DartId d) {
    for (const DartId x : {d, map.alpha<0>(d)})
        if (map.alpha<1>(x) == map.alpha<2>(x)) return true;
    return false;
}

/// Whether the face hangs in one volume by a single run of edges and has free ones: edges where no other face is.
bool is_fin(const Map& map, DartId d) {
    std::size_t runs = 0;
    const auto is_attached = [&](DartId x) { return map.alpha<2>(x) != map.alpha<3>(x); };
    for (DartId x = d;;) {
        const DartId next = map.alpha<0, 1>(x);
        if (is_attached(x) && !is_attached(next)) ++runs;
        x = next;
        if (x == d) return runs == 1;
    }
}

}  // namespace

std::optional<Changes> remove_vertex(Map& map, DartId d) {
    if (!map.contains(d)) return std::nullopt;
    const Removal plan = plan_removal(map, 0, d);
    if (!joins_two(map, plan, 1, 2) || !leaves_nothing_free(plan)) return std::nullopt;
    return remove_cell(map, 0, plan);
}

std::optional<Changes> remove_edge(Map& map, DartId d) {
    if (!map.contains(d)) return std::nullopt;
    const Removal plan = plan_removal(map, 1, d);
    if (!joins_two(map, plan, 2, 3) || !leaves_nothing_free(plan)) return std::nullopt;
    if (map.face(d) == map.face(map.alpha<2>(d)) && !is_dangling_edge(map, d)) return std::nullopt;
    return remove_cell(map, 1, plan);
}

std::optional<Changes> remove_face(Map& map, DartId d) {
    if (!map.contains(d)) return std::nullopt;
    const Removal plan = plan_removal(map, 2, d);
    if (!leaves_nothing_free(plan)) return std::nullopt;
    if (map.volume(d) == map.volume(map.alpha<3>(d)) && !is_fin(map, d)) return std::nullopt;
    return remove_cell(map, 2, plan);
}

std::optional<Changes> remove_volume(Map& map, DartId d) {
    if (!map.contains(d)) return std::nullopt;
    return remove_cell(map, 3, plan_removal(map, 3, d));
}

}  // namespace enfilade::gmap

#include "gmap/update.h"

#include <algorithm>
#include <vector>

#include "gmap/access.h"
#include "gmap/orbit.h"

namespace enfilade::gmap::detail {

namespace {

struct TouchedOrbit {
    DartId dart;
    std::vector<std::uint32_t> ids;  ///< that its darts carry, ascending
    std::uint32_t kept = none_u32;
    bool is_uniform = true;  ///< all darts carry one and the same id
};

void insert_sorted(std::vector<std::uint32_t>& ids, std::uint32_t id) {
    const auto place = std::lower_bound(ids.begin(), ids.end(), id);
    if (place == ids.end() || *place != id) ids.insert(place, id);
}

std::vector<TouchedOrbit> find_orbits(const Map& map, int i, std::span<const DartId> touched) {
    std::vector<TouchedOrbit> orbits;
    IdSet visited;
    for (const DartId start : touched) {
        if (visited.contains(static_cast<std::uint32_t>(start))) continue;
        TouchedOrbit found{start, {}};
        const std::uint32_t first_id = map.arrays().cell_id[static_cast<std::size_t>(i)][index(start)];
        for (const DartId d : Orbit(map, start, cell_generators(i))) {
            visited.insert(static_cast<std::uint32_t>(d));
            const std::uint32_t id = map.arrays().cell_id[static_cast<std::size_t>(i)][index(d)];
            if (id != none_u32 && (found.ids.empty() || found.ids.back() != id)) insert_sorted(found.ids, id);
            if (id != first_id) found.is_uniform = false;
        }
        orbits.push_back(std::move(found));
    }
    return orbits;
}

}  // namespace

void update_cells(Map& map, int i, std::span<const DartId> touched, Changes& changes,
                  std::span<const std::uint32_t> lost) {
    using Kind = CellChange::Kind;
    std::vector<TouchedOrbit> orbits = find_orbits(map, i, touched);
    IdSet taken;
    for (TouchedOrbit& found : orbits)
        for (const std::uint32_t id : found.ids)
            if (found.kept == none_u32 && taken.insert(id)) found.kept = id;

    for (TouchedOrbit& found : orbits) {
        const bool is_new = found.kept == none_u32;
        if (is_new) {
            found.kept = MapAccess::new_cell(map, i);
            if (found.ids.empty()) changes.cells.push_back({Kind::Created, i, found.kept});
            else changes.cells.push_back({Kind::Split, i, found.ids.front(), found.kept});
        }
        for (const std::uint32_t id : found.ids) {
            if (!taken.insert(id)) continue;
            changes.cells.push_back({Kind::Merged, i, found.kept, id});
            MapAccess::drop_cell(map, i);
        }
        if (is_new || !found.is_uniform)
            for (const DartId d : Orbit(map, found.dart, cell_generators(i))) MapAccess::cell(map, i, d) = found.kept;
    }
    for (const std::uint32_t id : lost) {
        if (!taken.insert(id)) continue;
        changes.cells.push_back({Kind::Removed, i, id});
        MapAccess::drop_cell(map, i);
    }
}

void number_cells(Map& map) {
    for (int i = 0; i < 4; ++i)
        for (const DartId d : map.darts()) {
            if (MapAccess::cell(map, i, d) != none_u32) continue;
            const std::uint32_t id = MapAccess::new_cell(map, i);
            for (const DartId x : Orbit(map, d, cell_generators(i))) MapAccess::cell(map, i, x) = id;
        }
}

}  // namespace enfilade::gmap::detail

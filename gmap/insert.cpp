#include "gmap/insert.h"

#include <array>
#include <utility>
#include <vector>

#include "gmap/access.h"
#include "gmap/orbit.h"
#include "gmap/update.h"

namespace enfilade::gmap {

using detail::IdSet;
using detail::MapAccess;
using detail::none_u32;

namespace {

constexpr std::uint32_t raw(DartId d) { return static_cast<std::uint32_t>(d); }

/// Where a walk along a side of a face from the corner of `d` meets the corner of `e`: at `e` or at alpha<1>(e).
std::optional<DartId> walk_to_corner(const Map& map, DartId d, DartId e) {
    const DartId e1 = map.alpha<1>(e);
    const DartId d1 = map.alpha<1>(d);
    const DartId back = map.alpha<3>(d);
    if (e1 == e || d1 == d || e == d || e == d1) return std::nullopt;
    for (DartId x = d;;) {
        if (map.is_free<0>(x)) return std::nullopt;
        x = map.alpha<0>(x);
        if (x == e || x == e1) return x;
        if (map.is_free<1>(x)) return std::nullopt;
        x = map.alpha<1>(x);
        if (x == d || (back != d && x == back)) return std::nullopt;
    }
}

/// The new edge on one side of the face, between corner (d, alpha1 d) and the corner that the walk from d meets at `e`.
/// Returns its four darts: at d, at e, at the old alpha1(d), at the old alpha1(e).
std::array<DartId, 4> split_side(Map& map, DartId d, DartId e) {
    const DartId d1 = map.alpha<1>(d);
    const DartId e1 = map.alpha<1>(e);
    std::array<DartId, 4> fresh{};
    const std::array<DartId, 4> at{d, e, d1, e1};
    for (std::size_t k = 0; k < 4; ++k) {
        fresh[k] = MapAccess::new_dart(map, at[k]);
        MapAccess::cell(map, 1, fresh[k]) = none_u32;
        MapAccess::link(map, 1, fresh[k], at[k]);
    }
    MapAccess::link(map, 0, fresh[0], fresh[1]);
    MapAccess::link(map, 0, fresh[2], fresh[3]);
    MapAccess::link(map, 2, fresh[0], fresh[2]);
    MapAccess::link(map, 2, fresh[1], fresh[3]);
    return fresh;
}

/// The darts of the path's edges in the shell; nothing where an edge is met twice or is open.
std::optional<IdSet> path_edges(const Map& map, std::span<const DartId> path) {
    IdSet darts;
    if (path.size() < 2) return std::nullopt;
    for (const DartId d : path) {
        if (!map.contains(d) || map.is_free<0>(d) || map.is_free<2>(d)) return std::nullopt;
        for (const DartId x : {d, map.alpha<0>(d), map.alpha<2>(d), map.alpha<0, 2>(d)})
            if (!darts.insert(raw(x))) return std::nullopt;
    }
    return darts;
}

/// Whether turning from `from` inside its umbrella, beginning with alpha<1>, first meets the path at `to`.
bool sector_is_clear(const Map& map, const IdSet& path_darts, DartId from, DartId to) {
    for (DartId x = from;;) {
        if (map.is_free<1>(x)) return false;
        x = map.alpha<1>(x);
        if (path_darts.contains(raw(x))) return x == to;
        if (map.is_free<2>(x)) return false;
        x = map.alpha<2>(x);
    }
}

bool is_closed_path(const Map& map, std::span<const DartId> path, const IdSet& path_darts) {
    for (std::size_t k = 0; k < path.size(); ++k) {
        const DartId end = map.alpha<0>(path[k]);
        const DartId next = path[(k + 1) % path.size()];
        if (!sector_is_clear(map, path_darts, end, next) ||
            !sector_is_clear(map, path_darts, map.alpha<2>(end), map.alpha<2>(next)))
            return false;
    }
    return true;
}

/// One side of the new face: darts 2k and 2k + 1 beside path[k] and its alpha<0>; they are not linked to it yet.
std::vector<DartId> new_side(Map& map, std::span<const DartId> beside) {
    std::vector<DartId> side;
    side.reserve(beside.size());
    for (const DartId d : beside) {
        side.push_back(MapAccess::new_dart(map, d));
        MapAccess::cell(map, 2, side.back()) = none_u32;
    }
    for (std::size_t k = 0; k < side.size(); k += 2) {
        MapAccess::link(map, 0, side[k], side[k + 1]);
        MapAccess::link(map, 1, side[k + 1], side[(k + 2) % side.size()]);
    }
    return side;
}

}  // namespace

std::optional<Changes> insert_vertex(Map& map, DartId d) {
    if (!map.contains(d)) return std::nullopt;
    std::vector<DartId> old;
    for (const DartId x : cell<1>(map, d)) old.push_back(x);
    std::vector<DartId> fresh;
    for (const DartId x : old) {
        fresh.push_back(MapAccess::new_dart(map, x));
        MapAccess::cell(map, 0, fresh.back()) = none_u32;
    }
    // The new dart of x continues the links of x; it is found through alpha0, set last.
    const std::vector<DartId> opposite = [&] {
        std::vector<DartId> result;
        for (const DartId x : old) result.push_back(map.alpha<0>(x));
        return result;
    }();
    for (std::size_t k = 0; k < old.size(); ++k) MapAccess::alpha(map, 0, old[k]) = raw(fresh[k]);
    for (std::size_t k = 0; k < old.size(); ++k) {
        MapAccess::alpha(map, 0, fresh[k]) = raw(old[k]);
        for (const int i : {2, 3})
            if (map.alpha(i, old[k]) != old[k])
                MapAccess::alpha(map, i, fresh[k]) = raw(map.alpha<0>(map.alpha(i, old[k])));
        if (opposite[k] != old[k]) MapAccess::alpha(map, 1, fresh[k]) = raw(map.alpha<0>(opposite[k]));
    }
    Changes changes;
    changes.dart = fresh[0];
    const std::array<DartId, 2> halves{old[0], opposite[0]};
    detail::update_cells(map, 0, fresh, changes);
    detail::update_cells(map, 1, halves, changes);
    return changes;
}

std::optional<Changes> insert_edge(Map& map, DartId d, DartId e) {
    if (!map.contains(d) || !map.contains(e)) return std::nullopt;
    const std::optional<DartId> met = walk_to_corner(map, d, e);
    if (!met) return std::nullopt;
    const bool has_back = !map.is_free<3>(d);
    const DartId d3 = map.alpha<3>(d);
    const DartId e3 = map.alpha<3>(*met);
    const DartId rest = map.alpha<1>(d);
    const std::array<DartId, 4> front = split_side(map, d, *met);
    if (has_back) {
        const std::array<DartId, 4> back = split_side(map, d3, e3);
        for (std::size_t k = 0; k < 4; ++k) MapAccess::link(map, 3, front[k], back[k]);
    }
    Changes changes;
    changes.dart = front[0];
    detail::update_cells(map, 1, std::array{front[0]}, changes);
    detail::update_cells(map, 2, std::array{d, rest}, changes);
    return changes;
}

std::optional<Changes> insert_face(Map& map, std::span<const DartId> path) {
    const std::optional<IdSet> path_darts = path_edges(map, path);
    if (!path_darts || !is_closed_path(map, path, *path_darts)) return std::nullopt;
    std::vector<DartId> near;
    std::vector<DartId> far;
    for (const DartId d : path)
        for (const DartId x : {d, map.alpha<0>(d)}) {
            near.push_back(x);
            far.push_back(map.alpha<2>(x));
        }
    const std::vector<DartId> near_side = new_side(map, near);
    const std::vector<DartId> far_side = new_side(map, far);
    for (std::size_t k = 0; k < near.size(); ++k) {
        MapAccess::link(map, 2, near[k], near_side[k]);
        MapAccess::link(map, 2, far[k], far_side[k]);
        MapAccess::link(map, 3, near_side[k], far_side[k]);
    }
    Changes changes;
    changes.dart = near_side[0];
    detail::update_cells(map, 2, std::array{near_side[0]}, changes);
    detail::update_cells(map, 3, std::array{near[0], far[0]}, changes);
    return changes;
}

}  // namespace enfilade::gmap

#include "gmap/close.h"

#include "gmap/access.h"
#include "gmap/orbit.h"
#include "gmap/update.h"

namespace enfilade::gmap {

using detail::MapAccess;

Changes close(Map& map) {
    std::vector<DartId> open;
    for (const DartId d : map.darts())
        if (map.is_free<3>(d)) open.push_back(d);

    std::vector<DartId> twins;
    twins.reserve(open.size());
    for (const DartId d : open) {
        twins.push_back(MapAccess::new_dart(map, d));
        MapAccess::cell(map, 3, twins.back()) = detail::none_u32;
    }
    // Twins are linked to their darts first, so that the twin of any open dart is its alpha3.
    for (std::size_t k = 0; k < open.size(); ++k) MapAccess::link(map, 3, open[k], twins[k]);
    const auto is_twin = [&](DartId d) { return map.arrays().cell_id[3][index(d)] == detail::none_u32; };
    for (std::size_t k = 0; k < open.size(); ++k) {
        for (const int i : {0, 1})
            if (map.alpha(i, open[k]) != open[k])
                MapAccess::alpha(map, i, twins[k]) = static_cast<std::uint32_t>(map.alpha<3>(map.alpha(i, open[k])));
        // Around the edge, from volume to volume, to the other boundary face.
        DartId x = map.alpha<2>(open[k]);
        while (!is_twin(map.alpha<3>(x))) x = map.alpha<3, 2>(x);
        if (x != open[k]) MapAccess::alpha(map, 2, twins[k]) = static_cast<std::uint32_t>(map.alpha<3>(x));
    }
    Changes changes;
    if (!twins.empty()) changes.dart = twins.front();
    detail::update_cells(map, 3, twins, changes);
    return changes;
}

std::pair<Map, std::vector<VolumeId>> closed_copy(const Map& map) {
    std::pair<Map, std::vector<VolumeId>> result{map, {}};
    for (const CellChange& change : close(result.first).cells) result.second.emplace_back(VolumeId{change.cell});
    return result;
}

}  // namespace enfilade::gmap

#include "modeler/outline.h"

#include <unordered_map>

#include "base/error.h"

namespace enfilade::modeler {

std::vector<std::uint32_t> outline(const Building& building, const std::vector<std::uint32_t>& volumes,
                                   std::vector<std::uint32_t>& scratch) {
    std::vector<std::uint32_t> all;
    for (const std::uint32_t v : volumes) {
        const Piece& piece = building.pieces[building.volumes[v].piece];
        for (std::uint32_t k = 0; k < piece.corner_count; ++k)
            all.push_back(building.corners[piece.first_corner + k].half_edge);
    }
    for (const std::uint32_t h : all) scratch[h] = 0;
    std::unordered_map<std::uint32_t, std::uint32_t> leaving;
    std::uint32_t start = UINT32_MAX;
    for (const std::uint32_t h : all) {
        if (scratch[h ^ 1] != UINT32_MAX) continue;
        leaving.emplace(start_of(building, h), h);
        if (start == UINT32_MAX) start = h;
    }
    for (const std::uint32_t h : all) scratch[h] = UINT32_MAX;
    std::vector<std::uint32_t> ring;
    std::uint32_t h = start;
    do {
        ring.push_back(h);
        const auto next = leaving.find(start_of(building, h ^ 1));
        if (next == leaving.end())
            throw InputError("F22", "",
                             "The model cannot become a scene: the pieces of a volume do not close. Check the plan and "
                             "mend what is reported first.");
        h = next->second;
    } while (h != start && ring.size() <= leaving.size());
    return ring;
}

std::vector<std::uint32_t> corners_of(const Building& building, const std::vector<std::uint32_t>& ring) {
    std::vector<std::uint32_t> corners;
    const std::size_t n = ring.size();
    for (std::size_t k = 0; k < n; ++k) {
        const auto point = [&](std::size_t i) { return building.points[start_of(building, ring[i % n])]; };
        if (orientation(point(k + n - 1), point(k), point(k + 1)) != 0) corners.push_back(start_of(building, ring[k]));
    }
    return corners;
}

}  // namespace enfilade::modeler

#include "modeler/exports/space_graph.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace enfilade::modeler {

SpaceGraph space_graph(const accel::SceneView& scene, const std::vector<double>& areas) {
    const auto space_of = [&](accel::CellId cell) { return std::uint32_t(index(scene.cells[index(cell)].space)); };
    std::vector<CellMeasure> sums(scene.spaces.size());
    for (std::uint32_t c = 0; c < scene.cells.size(); ++c) {
        const CellMeasure cell = measure(scene, accel::CellId(c));
        CellMeasure& sum = sums[space_of(accel::CellId(c))];
        sum.floor_area += cell.floor_area;
        sum.volume += cell.volume;
        for (std::size_t axis = 0; axis < 3; ++axis) sum.centre[axis] += cell.volume * cell.centre[axis];
    }
    SpaceGraph graph;
    for (std::uint32_t s = 0; s < sums.size(); ++s) {
        if (!(sums[s].volume > 0)) continue;
        for (double& coordinate : sums[s].centre) coordinate /= sums[s].volume;
        graph.nodes.push_back({s, sums[s]});
    }
    std::map<std::array<std::uint32_t, 3>, double> openings;
    for (std::size_t p = 0; p < scene.portals.size(); ++p) {
        const accel::Portal& portal = scene.portals[p];
        const auto [low, high] = std::minmax({space_of(portal.front), space_of(portal.back)});
        if (low != high) openings[{low, high, std::uint32_t(portal.kind())}] += areas[p];
    }
    for (const auto& [key, opening] : openings)
        graph.links.push_back({key[0], key[1], accel::PortalKind(key[2]), opening});
    return graph;
}

}  // namespace enfilade::modeler

#include "accel/graph.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace enfilade::accel {

CellGraph cell_graph(const SceneView& view) {
    CellGraph graph;
    graph.offsets.assign(view.cells.size() + 1, 0);
    for (const Portal& portal : view.portals) {
        ++graph.offsets[index(portal.front) + 1];
        ++graph.offsets[index(portal.back) + 1];
    }
    for (std::size_t c = 0; c < view.cells.size(); ++c) graph.offsets[c + 1] += graph.offsets[c];
    graph.links.resize(graph.offsets.back());
    std::vector<std::uint32_t> next(graph.offsets.begin(), graph.offsets.end() - 1);
    for (std::size_t p = 0; p < view.portals.size(); ++p) {
        const Portal& portal = view.portals[p];
        graph.links[next[index(portal.front)]++] = {portal.back, static_cast<PortalId>(p)};
        graph.links[next[index(portal.back)]++] = {portal.front, static_cast<PortalId>(p)};
    }
    return graph;
}

std::vector<SpaceLink> space_graph(const SceneView& view) {
    std::map<std::tuple<SpaceId, SpaceId, PortalKind>, std::uint32_t> counts;
    for (const Portal& portal : view.portals) {
        const SpaceId a = view.cells[index(portal.front)].space;
        const SpaceId b = view.cells[index(portal.back)].space;
        if (a != b) ++counts[{std::min(a, b), std::max(a, b), portal.kind()}];
    }
    std::vector<SpaceLink> links;
    for (const auto& [key, count] : counts)
        links.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), count});
    return links;
}

std::vector<std::uint32_t> components(const CellGraph& graph) {
    constexpr std::uint32_t unseen = UINT32_MAX;
    const std::size_t cell_count = graph.offsets.size() - 1;
    std::vector<std::uint32_t> component(cell_count, unseen);
    std::uint32_t count = 0;
    std::vector<std::size_t> open;
    for (std::size_t start = 0; start < cell_count; ++start) {
        if (component[start] != unseen) continue;
        component[start] = count;
        open.push_back(start);
        while (!open.empty()) {
            const std::size_t c = open.back();
            open.pop_back();
            for (std::uint32_t l = graph.offsets[c]; l < graph.offsets[c + 1]; ++l) {
                const std::size_t to = index(graph.links[l].to);
                if (component[to] != unseen) continue;
                component[to] = count;
                open.push_back(to);
            }
        }
        ++count;
    }
    return component;
}

}  // namespace enfilade::accel

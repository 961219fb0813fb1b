#include "modeler/realise.h"

#include "modeler/extrude.h"
#include "modeler/plan_graph.h"

namespace enfilade::modeler {
namespace {

void describe_plan(const Stack& stack, const PlanGraph& graph, const CutPieces& pieces, Building& building) {
    building.points = graph.graph.vertices;
    building.edges.reserve(graph.graph.edges.size());
    for (std::size_t e = 0; e < graph.graph.edges.size(); ++e)
        building.edges.push_back({graph.graph.edges[e].a, graph.graph.edges[e].b, graph.line[e]});
    building.pieces.reserve(graph.piece_count());
    for (std::uint32_t p = 0; p < graph.piece_count(); ++p) {
        const auto ring = graph.piece(p);
        building.pieces.push_back(
            {std::uint32_t(building.corners.size()), std::uint32_t(ring.size()), pieces.disc[graph.source[p]]});
        for (const std::uint32_t h : ring) building.corners.push_back({plans::origin(graph.graph, h), h});
    }
    building.lines = stack.lines;
    building.lines.resize(stack.lines.size() + pieces.cuts.size());
}

}  // namespace

Building realise(Stack stack, Cutting cutting) {
    Building building;
    building.frame = stack.frame;
    building.site_min = {stack.site_min.x, stack.site_min.y, stack.bands.front().z_low};
    building.site_max = {stack.site_max.x, stack.site_max.y, stack.bands.back().z_high};
    building.spaces = stack.spaces;
    building.storeys = stack.storeys;
    building.convex = cutting == Cutting::Convex;

    const CutPieces pieces = cut(stack, cutting);
    const PlanGraph graph = plan_graph(stack, pieces, building.findings);
    building.max_deviation = graph.graph.max_deviation;
    describe_plan(stack, graph, pieces, building);

    Extrusion extrusion = extrude(stack, pieces, graph);
    building.volumes = std::move(extrusion.volumes);
    building.faces = std::move(extrusion.faces);
    building.vertices = std::move(extrusion.vertices);
    building.map = gmap::build_map(extrusion.tuples, building.map_defects);
    building.stack = std::move(stack);
    return building;
}

}  // namespace enfilade::modeler

#include "modeler/realise.h"

#include "modeler/extrude.h"
#include "modeler/plan_graph.h"

namespace enfilade::modeler {
namespace {

/// Each pass leaves fewer and smaller tangles; what is left after the last one is missing, and `check` says so (G5).
constexpr int most_recuts = 8;

void describe_plan(const Stack& stack, const PlanGraph& graph, const CutPieces& pieces, Building& building) {
    building.points = graph.graph.vertices;
    building.edges.reserve(graph.graph.edges.size());
    for (std::size_t e = 0; e < graph.graph.edges.size(); ++e)
        building.edges.push_back({graph.graph.edges[e].a, graph.graph.edges[e].b});
    building.pieces.reserve(graph.piece_count());
    for (std::uint32_t p = 0; p < graph.piece_count(); ++p) {
        const auto ring = graph.piece(p);
        building.pieces.push_back(
            {std::uint32_t(building.corners.size()), std::uint32_t(ring.size()), pieces.disc[graph.source[p]]});
        for (std::uint32_t k = 0; k < ring.size(); ++k)
            building.corners.push_back(
                {plans::origin(graph.graph, ring[k]), ring[k], graph.ring_line[graph.first_ring[p] + k]});
    }
    building.line_count = pieces.line_count;
    building.wall_colours = stack.wall_colours;
}

}  // namespace

Building realise(Stack stack, const CutOptions& options, const accel::Executor& executor) {
    std::vector<RegionCut> cuts = cut_regions(stack, options, executor);
    return realise(std::move(stack), options, std::move(cuts));
}

Building realise(Stack stack, const CutOptions& options, std::vector<RegionCut> cuts) {
    Building building;
    building.frame = stack.frame;
    building.site_min = {stack.site_min.x, stack.site_min.y, stack.bands.front().z_low};
    building.site_max = {stack.site_max.x, stack.site_max.y, stack.bands.back().z_high};
    building.spaces = stack.spaces;
    building.storeys = stack.storeys;
    building.convex = options.convex;

    CutPieces pieces = join_cuts(stack, cuts);
    PlanGraph graph = plan_graph(stack, pieces, building.findings);
    for (int pass = 0; needs_recut(stack, pieces, graph, options.convex) && pass < most_recuts; ++pass) {
        pieces = cut_tangled(stack, pieces, graph, options.convex);
        graph = plan_graph(stack, pieces, building.findings);
    }
    building.max_deviation = graph.graph.max_deviation;
    describe_plan(stack, graph, pieces, building);

    Extrusion extrusion = extrude(stack, pieces, graph);
    building.volumes = std::move(extrusion.volumes);
    building.faces = std::move(extrusion.faces);
    building.vertices = std::move(extrusion.vertices);
    building.map = gmap::build_map(extrusion.tuples, building.map_defects);
    building.stack = std::move(stack);
    building.cut_options = options;
    building.cuts = std::move(cuts);
    return building;
}

}  // namespace enfilade::modeler

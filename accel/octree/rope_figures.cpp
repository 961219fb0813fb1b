#include "accel/octree/rope_figures.h"

#include <algorithm>
#include <chrono>

#include "accel/octree/octree_stats.h"

namespace enfilade::accel {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

RopeTreeFigures figures_of(const MeshPart& mesh, const OctreeOptions& options, const Executor& executor) {
    RopeTreeFigures figures;
    Clock::time_point start = Clock::now();
    const Octree tree = build_octree(mesh, options, executor);
    figures.build_seconds = seconds_since(start);
    start = Clock::now();
    const RopeOctree stored(tree, mesh, {options.is_balanced, true}, executor);
    figures.link_seconds = seconds_since(start);
    const OctreeStats stats = octree_stats(tree);
    figures.leaves = stats.leaves;
    figures.empty_leaves = stats.empty_leaves;
    figures.references = stats.references;
    figures.deepest = stats.deepest;
    figures.neighbours = stored.neighbour_count();
    figures.stored = stored.bytes();
    figures.implicit = RopeOctree(tree, mesh, {options.is_balanced, false}, executor).bytes();
    return figures;
}

}  // namespace

std::uint32_t paper_depth(std::size_t triangles) { return triangles <= 150'000 ? 8 : triangles <= 500'000 ? 10 : 11; }

OctreeOptions paper_options(std::size_t triangles) {
    OctreeOptions options;
    options.layout = OctreeLayout::Ropes;
    options.depth = paper_depth(triangles);
    options.leaf_size = 8;
    options.has_stored_boxes = true;
    return options;
}

RopeFigures rope_figures(const MeshPart& mesh, OctreeOptions options, const Executor& executor) {
    RopeFigures figures;
    figures.triangles = mesh.used.size();
    options.is_balanced = false;
    figures.free = figures_of(mesh, options, executor);
    options.is_balanced = true;
    figures.balanced = figures_of(mesh, options, executor);
    return figures;
}

}  // namespace enfilade::accel

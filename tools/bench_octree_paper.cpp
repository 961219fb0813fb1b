// The paper's octrees (Portalez and Duguet 2016): its tables 1 and 3 on our meshes, beside what our own takes.

#include <cstdio>

#include "accel/octree/rope_figures.h"
#include "render/executor.h"
#include "tools/bench_octree.h"

namespace enfilade::tools {

void bench_octree_paper(Bench& bench, const BenchMesh& mesh) {
    const std::unique_ptr<accel::Executor> cores = render::make_executor();
    const accel::MeshPart part = mesh.part();
    const accel::RopeFigures figures = accel::rope_figures(part, accel::paper_options(part.used.size()), *cores);
    const double triangles = double(std::max<std::size_t>(1, figures.triangles));
    const auto add = [&](const char* row, double value, const char* unit) {
        bench.add_silently({.row = std::string("paper: ") + row, .scene = mesh.title(), .value = value, .unit = unit});
    };
    const accel::RopeTreeFigures& balanced = figures.balanced;
    add("levels", double(balanced.deepest), "levels");
    add("leaves, free", double(figures.free.leaves), "leaves");
    add("leaves, balanced", double(balanced.leaves), "leaves");
    add("balanced over free", figures.leaf_ratio(), "times");
    add("triangles a leaf", balanced.triangles_a_leaf(), "triangles");
    add("neighbours a leaf", balanced.neighbours_a_leaf(), "neighbours");
    add("references", double(balanced.references) / triangles, "a triangle");
    add("build and links", balanced.build_seconds + balanced.link_seconds, "s");
    add("cube map", double(balanced.stored.cube_map) / 1e6, "MB");
    add("octree", double(balanced.stored.leaves + balanced.stored.nodes) / 1e6, "MB");
    add("triangles", double(balanced.stored.triangles) / 1e6, "MB");
    add("boxes", double(balanced.stored.boxes) / 1e6, "MB");
    add("all, balanced, stored boxes", double(balanced.stored.total()) / triangles, "B a triangle");
    add("all, balanced, computed boxes", double(balanced.implicit.total()) / triangles, "B a triangle");
    add("all, free, stored boxes", double(figures.free.stored.total()) / triangles, "B a triangle");
    add("all, free, computed boxes", double(figures.free.implicit.total()) / triangles, "B a triangle");
    char text[512];
    std::snprintf(text, sizeof text,
                  "%s, the paper's octree: %zu leaves, and %zu (%.0f %%) where neighbours differ by one level at most; "
                  "%.0f B a triangle so balanced and with stored boxes, as the paper has it, %.0f without either.",
                  mesh.title().c_str(), figures.free.leaves, balanced.leaves, 100 * figures.leaf_ratio(),
                  double(balanced.stored.total()) / triangles, double(figures.free.implicit.total()) / triangles);
    bench.remark(text);
}

}  // namespace enfilade::tools

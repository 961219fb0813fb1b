// The only file of this folder with CGAL.
#include "modeler/cutting/triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

#include "base/check.h"

namespace enfilade::modeler {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceInfoBase = CGAL::Triangulation_face_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfoBase>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

}  // namespace

using plans::GridPoint;

Triangulation triangulate(std::span<const GridPoint> points, std::span<const PolygonSide> sides) {
    std::vector<std::uint32_t> used;
    for (const PolygonSide& side : sides) used.push_back(side.from);
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());

    Delaunay triangulation;
    std::vector<std::pair<Kernel::Point_2, std::uint32_t>> input;
    for (std::uint32_t k = 0; k < used.size(); ++k)
        input.emplace_back(Kernel::Point_2(points[used[k]].x, points[used[k]].y), k);
    triangulation.insert(input.begin(), input.end());
    std::vector<Delaunay::Vertex_handle> handle(used.size());
    for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v)
        handle[v->info()] = v;
    const auto vertex = [&](std::uint32_t point) {
        return handle[std::size_t(std::lower_bound(used.begin(), used.end(), point) - used.begin())];
    };
    for (const PolygonSide& side : sides) triangulation.insert_constraint(vertex(side.from), vertex(side.to));

    // Inside is what lies left of a side, and whatever is reached from there without crossing one.
    for (auto f = triangulation.all_faces_begin(); f != triangulation.all_faces_end(); ++f) f->info() = no_index;
    std::vector<Delaunay::Face_handle> inside;
    const auto enter = [&](Delaunay::Face_handle f) {
        if (f->info() != no_index || triangulation.is_infinite(f)) return;
        f->info() = std::uint32_t(inside.size());
        inside.push_back(f);
    };
    std::vector<std::pair<Delaunay::Face_handle, int>> left_of(sides.size());
    for (std::size_t k = 0; k < sides.size(); ++k) {
        Delaunay::Face_handle f;
        int i = 0;
        const bool found = triangulation.is_edge(vertex(sides[k].from), vertex(sides[k].to), f, i);
        ENFILADE_CHECK(found);
        if (f->vertex(f->ccw(i)) != vertex(sides[k].from)) {
            const Delaunay::Face_handle other = f->neighbor(i);
            i = triangulation.mirror_index(f, i);
            f = other;
        }
        left_of[k] = {f, i};
        enter(f);
    }
    for (std::size_t k = 0; k < inside.size(); ++k)
        for (int i = 0; i < 3; ++i)
            if (!inside[k]->is_constrained(i)) enter(inside[k]->neighbor(i));

    const std::size_t count = 3 * inside.size();
    Triangulation result;
    result.from.resize(count);
    result.twin.assign(count, no_index), result.side.assign(count, no_index);
    for (std::uint32_t t = 0; t < inside.size(); ++t)
        for (std::uint32_t i = 0; i < 3; ++i) {
            const auto f = inside[t];
            result.from[3 * t + i] = used[f->vertex(f->ccw(int(i)))->info()];
            if (!f->is_constrained(int(i)))
                result.twin[3 * t + i] =
                    3 * f->neighbor(int(i))->info() + std::uint32_t(triangulation.mirror_index(f, int(i)));
        }
    for (std::uint32_t k = 0; k < sides.size(); ++k)
        if (left_of[k].first->info() != no_index)
            result.side[3 * left_of[k].first->info() + std::uint32_t(left_of[k].second)] = k;
    return result;
}

}  // namespace enfilade::modeler

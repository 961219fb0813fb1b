// The oracle: CGAL's exact arrangement of the same segments. A file of its own, for it takes long to compile.

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "plans/planar_map.h"

namespace enfilade::plans {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Arr_segment_traits_2<Kernel>;
using Arrangement = CGAL::Arrangement_2<Traits>;

Arrangement exact(const std::vector<Segment>& segments) {
    std::vector<Traits::X_monotone_curve_2> curves;
    for (const Segment& s : segments)
        if (!(s.a == s.b)) curves.emplace_back(Kernel::Point_2(s.a.x, s.a.y), Kernel::Point_2(s.b.x, s.b.y));
    Arrangement arrangement;
    CGAL::insert(arrangement, curves.begin(), curves.end());
    return arrangement;
}

/// Twice the area that the outermost loops of the arrangement enclose, holes of the bounded faces included.
double enclosed_area2(const Arrangement& arrangement) {
    double sum = 0;
    for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
        if (!face->is_unbounded()) continue;
        for (auto hole = face->inner_ccbs_begin(); hole != face->inner_ccbs_end(); ++hole) {
            auto edge = *hole;
            do {
                const Kernel::Point_2 a = edge->source()->point();
                const Kernel::Point_2 b = edge->target()->point();
                sum -= CGAL::to_double(a.x() * b.y() - a.y() * b.x());
                ++edge;
            } while (edge != *hole);
        }
    }
    return sum;
}

double enclosed_area2(const PlanarMap& map) {
    double sum = 0;
    for (std::size_t l = 0; l < map.loop_first.size(); ++l)
        if (map.face_of_loop[l] == 0) sum -= double(map.loop_area2[l]);
    return sum;
}

std::set<std::pair<double, double>> places(const Arrangement& arrangement) {
    std::set<std::pair<double, double>> result;
    for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v)
        result.emplace(CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y()));
    return result;
}

RC_GTEST_PROP(NodingCgal, IsTheExactArrangementWhereCrossingsAreIntegral, ()) {
    // On a raster of 2 x 2, segments along the axes and diagonals cross in integers, and pass no pixel beside them.
    std::vector<Segment> segments;
    const int count = *rc::gen::inRange(1, 30);
    for (int i = 0; i < count; ++i) {
        const GridPoint a{2 * *rc::gen::inRange(-8, 9), 2 * *rc::gen::inRange(-8, 9)};
        const int length = 2 * *rc::gen::inRange(1, 9);
        const auto step = *rc::gen::element(std::pair(1, 0), std::pair(0, 1), std::pair(1, 1), std::pair(1, -1));
        segments.push_back({a, {a.x + length * step.first, a.y + length * step.second}});
    }
    const NodedGraph graph = node(segments);
    const PlanarMap map = planar_map(graph);
    const Arrangement arrangement = exact(segments);
    RC_ASSERT(graph.vertices.size() == arrangement.number_of_vertices());
    RC_ASSERT(graph.edges.size() == arrangement.number_of_edges());
    RC_ASSERT(map.face_count == arrangement.number_of_faces());
    RC_ASSERT(graph.max_deviation == 0.0);
    RC_ASSERT(enclosed_area2(map) == enclosed_area2(arrangement));
    std::set<std::pair<double, double>> ours;
    for (const GridPoint p : graph.vertices) ours.emplace(p.x, p.y);
    RC_ASSERT(ours == places(arrangement));
}

RC_GTEST_PROP(NodingCgal, HoldsARoundedVertexForEachExactOne, ()) {
    std::vector<Segment> segments;
    const int count = *rc::gen::inRange(1, 25);
    const auto coordinate = [] { return *rc::gen::inRange(-30, 31); };
    for (int i = 0; i < count; ++i) segments.push_back({{coordinate(), coordinate()}, {coordinate(), coordinate()}});
    const NodedGraph graph = node(segments);
    const Arrangement arrangement = exact(segments);
    std::set<GridPoint> rounded;
    for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v) {
        // Exact floor(x + 1/2): the interval of the coordinate holds no integer and a half but in ties.
        const auto round = [](const Kernel::FT& value) {
            auto whole = std::int32_t(std::floor(CGAL::to_double(value)));
            while (Kernel::FT(2 * whole - 1) > 2 * value) --whole;
            while (Kernel::FT(2 * whole + 1) <= 2 * value) ++whole;
            return whole;
        };
        rounded.insert({round(v->point().x()), round(v->point().y())});
    }
    RC_ASSERT(std::vector<GridPoint>(rounded.begin(), rounded.end()) == graph.vertices);
}

}  // namespace
}  // namespace enfilade::plans

#include "modeler/meshes/polygon_triangles.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace enfilade::modeler {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using InfoFaceBase = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, InfoFaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

constexpr int unknown = -1;
using Side = std::array<std::uint32_t, 2>;

/// How many rings are around each triangle: 0 outside, 1 in the polygon, 2 in a hole.
void count_levels(Triangulation& cdt) {
    for (const auto face : cdt.all_face_handles()) face->info() = unknown;
    std::vector<Triangulation::Edge> border;
    std::vector<Triangulation::Face_handle> stack;
    const auto flood = [&](Triangulation::Face_handle start, int level) {
        start->info() = level;
        stack.assign(1, start);
        while (!stack.empty()) {
            const auto face = stack.back();
            stack.pop_back();
            for (int i = 0; i < 3; ++i) {
                const auto other = face->neighbor(i);
                if (other->info() != unknown) continue;
                if (face->is_constrained(i)) {
                    border.emplace_back(face, i);
                } else {
                    other->info() = level;
                    stack.push_back(other);
                }
            }
        }
    };
    flood(cdt.infinite_face(), 0);
    while (!border.empty()) {
        const auto [face, i] = border.back();
        border.pop_back();
        if (face->neighbor(i)->info() == unknown) flood(face->neighbor(i), face->info() + 1);
    }
}

/// Parts of the polygon that hang together by edges that are no side.
std::size_t count_parts(Triangulation& cdt) {
    std::size_t parts = 0;
    std::vector<Triangulation::Face_handle> stack;
    for (const auto start : cdt.finite_face_handles()) {
        if (start->info() != 1) continue;
        ++parts;
        start->info() = -2;
        stack.push_back(start);
        while (!stack.empty()) {
            const auto face = stack.back();
            stack.pop_back();
            for (int i = 0; i < 3; ++i)
                if (!face->is_constrained(i) && face->neighbor(i)->info() == 1) {
                    face->neighbor(i)->info() = -2;
                    stack.push_back(face->neighbor(i));
                }
        }
    }
    for (const auto face : cdt.finite_face_handles())
        if (face->info() == -2) face->info() = 1;
    return parts;
}

/// Twice the area of the first ring is negative.
bool turns_right(std::span<const std::array<double, 2>> ring) {
    // At the lowest corner of a simple ring the turn is that of the whole.
    std::size_t low = 0;
    for (std::size_t k = 1; k < ring.size(); ++k)
        if (ring[k] < ring[low]) low = k;
    const auto point = [&](std::size_t k) { return Kernel::Point_2(ring[k][0], ring[k][1]); };
    return CGAL::orientation(point((low + ring.size() - 1) % ring.size()), point(low),
                             point((low + 1) % ring.size())) == CGAL::RIGHT_TURN;
}

}  // namespace

struct PolygonTriangulator::State {
    Triangulation cdt;
    std::vector<Triangulation::Vertex_handle> vertices;
    std::vector<std::uint32_t> order;
    std::vector<Side> sides;

    PolygonVerdict insert(std::span<const std::array<double, 2>> corners, std::span<const std::uint32_t> ring_ends);
    PolygonVerdict insert_sides();
    PolygonVerdict judge_holes(std::span<const std::uint32_t> ring_ends);
};

PolygonVerdict PolygonTriangulator::State::insert(std::span<const std::array<double, 2>> corners,
                                                  std::span<const std::uint32_t> ring_ends) {
    cdt.clear();
    vertices.assign(corners.size(), {});
    // In an order that does not depend on how the ring is written: a face that two solids share is cut the same way.
    order.resize(corners.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return std::pair(corners[a], a) < std::pair(corners[b], b); });
    const auto ring_of = [&](std::uint32_t c) {
        return std::upper_bound(ring_ends.begin(), ring_ends.end(), c) - ring_ends.begin();
    };
    Triangulation::Face_handle hint;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::uint32_t k = order[i];
        vertices[k] = cdt.insert({corners[k][0], corners[k][1]}, hint);
        hint = vertices[k]->face();
        if (i == 0 || corners[order[i - 1]] != corners[k]) vertices[k]->info() = k;
        // A hole may touch another ring at a point: that corner is one for both.
        else if (ring_of(order[i - 1]) == ring_of(k)) return {PolygonFault::Coincident, k};
    }
    if (cdt.dimension() < 2) return {PolygonFault::NoArea, 0};
    sides.clear();
    std::uint32_t begin = 0;
    for (const std::uint32_t end : ring_ends) {
        for (std::uint32_t k = begin; k < end; ++k) sides.push_back({k, k + 1 < end ? k + 1 : begin});
        begin = end;
    }
    std::sort(sides.begin(), sides.end(), [&](const Side& s, const Side& t) {
        return std::minmax(corners[s[0]], corners[s[1]]) < std::minmax(corners[t[0]], corners[t[1]]);
    });
    return insert_sides();
}

PolygonVerdict PolygonTriangulator::State::insert_sides() {
    for (const auto& [k, after] : sides) {
        Triangulation::Face_handle face;
        int i = 0;
        if (cdt.is_edge(vertices[k], vertices[after], face, i) && face->is_constrained(i))
            return {PolygonFault::Touching, k};
        try {
            cdt.insert_constraint(vertices[k], vertices[after]);
        } catch (const Triangulation::Intersection_of_constraints_exception&) {
            return {PolygonFault::Crossing, k};
        }
    }
    for (const auto& [k, after] : sides)
        if (!cdt.is_edge(vertices[k], vertices[after])) return {PolygonFault::Touching, k};
    return {};
}

PolygonVerdict PolygonTriangulator::State::judge_holes(std::span<const std::uint32_t> ring_ends) {
    for (std::size_t r = 1; r < ring_ends.size(); ++r) {
        const std::uint32_t begin = ring_ends[r - 1];
        Triangulation::Face_handle face;
        int i = 0;
        cdt.is_edge(vertices[begin], vertices[begin + 1], face, i);
        const int low = std::min(face->info(), face->neighbor(i)->info());
        if (low == 0) return {PolygonFault::HoleOutside, begin};
        if (low >= 2) return {PolygonFault::HoleNested, begin};
    }
    return {count_parts(cdt) == 1 ? PolygonFault::None : PolygonFault::Disconnected, 0};
}

PolygonTriangulator::PolygonTriangulator() : state_(std::make_unique<State>()) {}
PolygonTriangulator::~PolygonTriangulator() = default;

PolygonVerdict PolygonTriangulator::triangulate(std::span<const std::array<double, 2>> corners,
                                                std::span<const std::uint32_t> ring_ends,
                                                std::vector<std::array<std::uint32_t, 3>>& triangles) {
    triangles.clear();
    if (const PolygonVerdict verdict = state_->insert(corners, ring_ends); verdict.fault != PolygonFault::None)
        return verdict;
    count_levels(state_->cdt);
    if (const PolygonVerdict verdict = state_->judge_holes(ring_ends); verdict.fault != PolygonFault::None)
        return verdict;
    const bool right = turns_right(corners.first(ring_ends.front()));
    for (const auto face : state_->cdt.finite_face_handles()) {
        if (face->info() != 1) continue;
        const std::uint32_t a = face->vertex(0)->info(), b = face->vertex(1)->info(), c = face->vertex(2)->info();
        if (right) triangles.push_back({a, c, b});
        else triangles.push_back({a, b, c});
    }
    return {};
}

}  // namespace enfilade::modeler

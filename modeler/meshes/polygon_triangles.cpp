#include "modeler/meshes/polygon_triangles.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

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

    PolygonVerdict insert(std::span<const std::array<double, 2>> corners, std::span<const std::uint32_t> ring_ends);
    PolygonVerdict judge_holes(std::span<const std::uint32_t> ring_ends);
};

PolygonVerdict PolygonTriangulator::State::insert(std::span<const std::array<double, 2>> corners,
                                                  std::span<const std::uint32_t> ring_ends) {
    cdt.clear();
    vertices.clear();
    for (std::uint32_t k = 0; k < corners.size(); ++k) {
        const std::size_t before = cdt.number_of_vertices();
        vertices.push_back(cdt.insert({corners[k][0], corners[k][1]},
                                      vertices.empty() ? Triangulation::Face_handle() : vertices.back()->face()));
        // A hole may touch another ring at a point: that corner is one for both.
        if (before == cdt.number_of_vertices()) {
            const std::uint32_t other = vertices.back()->info();
            const auto ring_of = [&](std::uint32_t c) {
                return std::upper_bound(ring_ends.begin(), ring_ends.end(), c) - ring_ends.begin();
            };
            if (ring_of(other) == ring_of(k)) return {PolygonFault::Coincident, k};
        } else {
            vertices.back()->info() = k;
        }
    }
    if (cdt.dimension() < 2) return {PolygonFault::NoArea, 0};
    std::uint32_t begin = 0;
    for (const std::uint32_t end : ring_ends) {
        for (std::uint32_t k = begin; k < end; ++k) {
            const auto from = vertices[k], to = vertices[k + 1 < end ? k + 1 : begin];
            Triangulation::Face_handle face;
            int i = 0;
            if (cdt.is_edge(from, to, face, i) && face->is_constrained(i)) return {PolygonFault::Touching, k};
            try {
                cdt.insert_constraint(from, to);
            } catch (const Triangulation::Intersection_of_constraints_exception&) {
                return {PolygonFault::Crossing, k};
            }
        }
        begin = end;
    }
    begin = 0;
    for (const std::uint32_t end : ring_ends) {
        for (std::uint32_t k = begin; k < end; ++k)
            if (!cdt.is_edge(vertices[k], vertices[k + 1 < end ? k + 1 : begin])) return {PolygonFault::Touching, k};
        begin = end;
    }
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

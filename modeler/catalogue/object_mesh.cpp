#include "modeler/catalogue/object_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "modeler/catalogue/vertex_places.h"

namespace enfilade::modeler {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// Whether a * b == c * d, exactly: the factors are differences of floats, whose products doubles round.
bool equal_products(double a, double b, double c, double d) {
    const double p = a * b;
    const double q = c * d;
    return p == q && std::fma(a, b, -p) == std::fma(c, d, -q);
}

bool has_no_area(const ObjectMesh& mesh, const Corners& corners) {
    const auto& a = mesh.vertices[corners[0]];
    const auto& b = mesh.vertices[corners[1]];
    const auto& c = mesh.vertices[corners[2]];
    double u[3];
    double v[3];
    for (int k = 0; k < 3; ++k) {
        u[k] = double(b[k]) - a[k];
        v[k] = double(c[k]) - a[k];
    }
    return equal_products(u[1], v[2], u[2], v[1]) && equal_products(u[2], v[0], u[0], v[2]) &&
           equal_products(u[0], v[1], u[1], v[0]);
}

template <class Value, class Visit>
void for_each_run(const std::vector<Value>& sorted, const Visit& visit) {
    for (std::size_t first = 0; first < sorted.size();) {
        std::size_t end = first + 1;
        while (end < sorted.size() && sorted[end] == sorted[first]) ++end;
        visit(end - first);
        first = end;
    }
}

}  // namespace

bool ObjectMesh::is_like(const ObjectMesh& other) const {
    const auto same = [](const auto& a, const auto& b) { return *a == *b; };
    return name == other.name && vertices == other.vertices && triangles == other.triangles &&
           triangle_materials == other.triangle_materials && materials == other.materials &&
           texcoords == other.texcoords &&
           std::equal(textures.begin(), textures.end(), other.textures.begin(), other.textures.end(), same);
}

MeshDefects defects_of(const ObjectMesh& mesh) {
    MeshDefects defects;
    const std::vector<std::uint32_t> places = vertex_places(mesh.vertices);
    std::vector<Corners> triangles;
    std::vector<std::uint64_t> edges;
    triangles.reserve(mesh.triangles.size());
    edges.reserve(mesh.triangles.size() * 3);
    for (const Corners& corners : mesh.triangles) {
        if (has_no_area(mesh, corners)) ++defects.degenerate;
        Corners at = {places[corners[0]], places[corners[1]], places[corners[2]]};
        std::sort(at.begin(), at.end());
        triangles.push_back(at);
        // A triangle of two places is no side of anything: its edges would hide a hole, or invent a crowd.
        if (at[0] == at[1] || at[1] == at[2]) continue;
        for (const auto& [low, high] : {std::pair(at[0], at[1]), std::pair(at[1], at[2]), std::pair(at[0], at[2])})
            edges.push_back(std::uint64_t(low) << 32 | high);
    }
    std::sort(triangles.begin(), triangles.end());
    std::sort(edges.begin(), edges.end());
    for_each_run(triangles, [&](std::size_t count) { defects.duplicate += static_cast<std::uint32_t>(count - 1); });
    for_each_run(edges, [&](std::size_t count) {
        if (count == 1) ++defects.open_edges;
        if (count > 2) ++defects.crowded_edges;
    });
    return defects;
}

}  // namespace enfilade::modeler

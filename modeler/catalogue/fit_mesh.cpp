#include "modeler/catalogue/fit_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "modeler/catalogue/vertex_places.h"

namespace enfilade::modeler {
namespace {

using Point3 = std::array<double, 3>;

/// Rotation, axis and front in one linear map, without scale.
Rotation upright(const RawMesh& raw, const Fitting& fitting) {
    const Rotation& r = fitting.rotation;
    Rotation m = r;
    if (fitting.up.value_or(raw.up) == UpAxis::Y)  // (x, y, z) -> (x, -z, y)
        m = {r[0], r[1], r[2], -r[6], -r[7], -r[8], r[3], r[4], r[5]};
    const auto rows = [&](double sx, std::size_t x, double sy, std::size_t y) {
        const Rotation t = m;
        for (std::size_t k = 0; k < 3; ++k) {
            m[k] = sx * t[3 * x + k];
            m[3 + k] = sy * t[3 * y + k];
        }
    };
    switch (fitting.front) {
        case Front::MinusY: break;
        case Front::PlusY: rows(-1, 0, -1, 1); break;
        case Front::MinusX: rows(-1, 1, 1, 0); break;  // (x, y) -> (-y, x): -x becomes -y
        case Front::PlusX: rows(1, 1, -1, 0); break;   // (x, y) -> (y, -x): +x becomes -y
    }
    return m;
}

Point3 turned(const Rotation& m, const Point3& p) {
    // Unlike a product with zeros, this keeps coordinates that only change their places as they are.
    Point3 out{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (m[3 * i + k] != 0) out[i] += m[3 * i + k] * p[k];
    return out;
}

MeshBox turned_box(const RawMesh& raw, const Rotation& m) {
    constexpr double far = std::numeric_limits<double>::infinity();
    MeshBox box{{far, far, far}, {-far, -far, -far}};
    std::vector<bool> seen(raw.points.size());
    for (const auto& triangle : raw.triangles)
        for (const std::uint32_t v : triangle) {
            if (seen[v]) continue;
            seen[v] = true;
            const Point3 p = turned(m, raw.points[v]);
            for (std::size_t k = 0; k < 3; ++k) {
                box.low[k] = std::min(box.low[k], p[k]);
                box.high[k] = std::max(box.high[k], p[k]);
            }
        }
    return raw.triangles.empty() ? MeshBox{} : box;
}

/// Leaves each place once, in the order in which triangles come by.
void share_vertices(ObjectMesh& mesh) {
    const std::vector<std::uint32_t> places = vertex_places(mesh.vertices);
    std::vector<std::uint32_t> number(mesh.vertices.size(), UINT32_MAX);
    std::vector<std::array<float, 3>> kept;
    for (auto& triangle : mesh.triangles)
        for (std::uint32_t& v : triangle) {
            std::uint32_t& to = number[places[v]];
            if (to == UINT32_MAX) {
                to = static_cast<std::uint32_t>(kept.size());
                kept.push_back(mesh.vertices[places[v]]);
            }
            v = to;
        }
    mesh.vertices = std::move(kept);
}

/// Materials without a triangle go.
void copy_materials(const RawMesh& raw, ObjectMesh& mesh) {
    std::vector<std::uint32_t> number(raw.materials.size(), UINT32_MAX);
    for (std::uint32_t& m : mesh.triangle_materials) {
        if (number[m] == UINT32_MAX) {
            number[m] = static_cast<std::uint32_t>(mesh.materials.size());
            mesh.materials.push_back({raw.materials[m].name, raw.materials[m].colour, raw.materials[m].look});
        }
        m = number[m];
    }
}

}  // namespace

MeshBox box_of(const ObjectMesh& mesh) {
    MeshBox box;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = mesh.vertices[v][k];
            box.low[k] = v == 0 ? x : std::min(box.low[k], x);
            box.high[k] = v == 0 ? x : std::max(box.high[k], x);
        }
    return box;
}

std::array<double, 3> natural_size(const RawMesh& raw, const Fitting& fitting) {
    const MeshBox box = turned_box(raw, upright(raw, fitting));
    return {box.side(0), box.side(1), box.side(2)};
}

ObjectMesh fitted(const RawMesh& raw, const Fitting& fitting, std::string name) {
    const Rotation m = upright(raw, fitting);
    const MeshBox box = turned_box(raw, m);
    Point3 scale;
    for (std::size_t k = 0; k < 3; ++k) {
        scale[k] = fitting.unit;
        if (fitting.size && box.side(k) > 0) scale[k] = (*fitting.size)[k] / box.side(k);
    }
    const Point3 foot = {(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2, box.low[2]};
    ObjectMesh mesh;
    mesh.name = std::move(name);
    mesh.vertices.reserve(raw.points.size());
    for (const Point3& from : raw.points) {
        const Point3 p = turned(m, from);
        std::array<float, 3> to;
        for (std::size_t k = 0; k < 3; ++k) to[k] = static_cast<float>((p[k] - foot[k]) * scale[k]);
        mesh.vertices.push_back(to);
    }
    for (std::size_t t = 0; t < raw.triangles.size(); ++t) {
        if (!(raw.materials[raw.triangle_materials[t]].opacity > 0)) continue;
        mesh.triangles.push_back(raw.triangles[t]);
        mesh.triangle_materials.push_back(raw.triangle_materials[t]);
        if (raw.texcoords.empty()) continue;
        for (std::size_t k = 0; k < 3; ++k) mesh.texcoords.push_back(raw.texcoords[3 * t + k]);
    }
    mesh.textures = raw.textures;
    // Unused points of the file may be no numbers: they must not be compared.
    for (auto& v : mesh.vertices)
        if (!(std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]))) v = {0, 0, 0};
    share_vertices(mesh);
    copy_materials(raw, mesh);
    return mesh;
}

}  // namespace enfilade::modeler

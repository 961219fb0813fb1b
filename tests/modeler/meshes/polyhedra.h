#pragma once
// Sound polyhedra, to be harmed; and what is then found.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "modeler/check.h"
#include "modeler/meshes/mesh.h"

namespace enfilade::modeler::test {

using Ring = std::vector<std::uint32_t>;
using Point = std::array<double, 3>;

/// Points and faces, as a file would hold them.
struct Polyhedron {
    std::vector<Point> points;
    std::vector<Ring> faces;

    [[nodiscard]] Mesh mesh() const {
        Mesh result{.format = MeshFormat::Off};
        result.points = points;
        for (const Ring& face : faces) {
            result.ring.insert(result.ring.end(), face.begin(), face.end());
            result.end_face();
        }
        return result;
    }
    void flip(std::size_t face) { std::reverse(faces[face].begin(), faces[face].end()); }
    void flip_all() {
        for (std::size_t f = 0; f < faces.size(); ++f) flip(f);
    }
};

/// Corner k has the bits x, y, z of k; faces as seen from outside: bottom, top, front, back, left, right.
inline Polyhedron cube(Point low = {0, 0, 0}, double side = 1) {
    Polyhedron result;
    for (unsigned k = 0; k < 8; ++k)
        result.points.push_back({low[0] + ((k & 1u) != 0 ? side : 0), low[1] + ((k & 2u) != 0 ? side : 0),
                                 low[2] + ((k & 4u) != 0 ? side : 0)});
    result.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return result;
}

/// Every face cut into triangles from its first corner.
inline Polyhedron triangles(const Polyhedron& from) {
    Polyhedron result{from.points, {}};
    for (const Ring& face : from.faces)
        for (std::size_t k = 1; k + 1 < face.size(); ++k) result.faces.push_back({face[0], face[k], face[k + 1]});
    return result;
}

/// `b` beside `a`, points on the same place kept apart.
inline Polyhedron beside(Polyhedron a, const Polyhedron& b) {
    const auto shift = static_cast<std::uint32_t>(a.points.size());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (Ring face : b.faces) {
        for (std::uint32_t& v : face) v += shift;
        a.faces.push_back(std::move(face));
    }
    return a;
}

/// Vertices of equal coordinates made one, the others left without faces.
inline Polyhedron sewn(Polyhedron p) {
    for (Ring& face : p.faces)
        for (std::uint32_t& v : face)
            v = static_cast<std::uint32_t>(std::find(p.points.begin(), p.points.end(), p.points[v]) - p.points.begin());
    return p;
}

/// A ball of triangles: `rings` circles of `around` points between two poles, at radii that `radius(k)` gives.
template <class Radius>
Polyhedron ball(std::uint32_t rings, std::uint32_t around, const Radius& radius) {
    Polyhedron result;
    const auto add = [&](double latitude, double longitude) {
        const double r = radius(result.points.size());
        result.points.push_back({r * std::cos(latitude) * std::cos(longitude),
                                 r * std::cos(latitude) * std::sin(longitude), r * std::sin(latitude)});
    };
    add(-std::numbers::pi / 2, 0);
    for (std::uint32_t i = 0; i < rings; ++i)
        for (std::uint32_t k = 0; k < around; ++k)
            add(std::numbers::pi * ((i + 1.0) / (rings + 1) - 0.5), 2 * std::numbers::pi * k / around);
    add(std::numbers::pi / 2, 0);
    const auto at = [&](std::uint32_t i, std::uint32_t k) { return 1 + i * around + k % around; };
    const auto top = static_cast<std::uint32_t>(result.points.size() - 1);
    for (std::uint32_t k = 0; k < around; ++k) {
        result.faces.push_back({0, at(0, k + 1), at(0, k)});
        for (std::uint32_t i = 0; i + 1 < rings; ++i) {
            result.faces.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
            result.faces.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
        }
        result.faces.push_back({at(rings - 1, k), at(rings - 1, k + 1), top});
    }
    return result;
}

/// A ring of `across` times `around` quadrangles cut into triangles.
inline Polyhedron torus(std::uint32_t around, std::uint32_t across) {
    Polyhedron result;
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t k = 0; k < across; ++k) {
            const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * k / across;
            const double r = 3 + std::cos(b);
            result.points.push_back({r * std::cos(a), r * std::sin(a), std::sin(b)});
        }
    const auto at = [&](std::uint32_t i, std::uint32_t k) { return (i % around) * across + k % across; };
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t k = 0; k < across; ++k) {
            result.faces.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            result.faces.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    return result;
}

/// "T2", "G4 warning", ...: each code once, with its severity where it is no error, in the order of the report.
inline std::vector<std::string> codes(const CheckReport& report) {
    std::vector<std::string> result;
    for (const Finding& finding : report.findings) {
        const std::string text =
            finding.code + (finding.severity == Severity::Error ? "" : std::string(" ") + name_of(finding.severity));
        if (std::find(result.begin(), result.end(), text) == result.end()) result.push_back(text);
    }
    return result;
}

using Codes = std::vector<std::string>;

inline Codes codes_of(const Polyhedron& polyhedron) { return codes(check_mesh(polyhedron.mesh())); }

}  // namespace enfilade::modeler::test

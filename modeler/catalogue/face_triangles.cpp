#include "modeler/catalogue/face_triangles.h"

#include <cmath>
#include <map>
#include <numeric>

namespace enfilade::modeler {
namespace {

constexpr std::size_t max_corners_cut = 2000;
constexpr std::size_t tries_a_corner = 20;  ///< for ears, before the rest becomes a fan

using Point2 = std::array<double, 2>;

/// Twice the area of abc, positive where it turns left.
double turn(const Point2& a, const Point2& b, const Point2& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Newell's normal: its length is twice the area of a flat polygon.
std::array<double, 3> normal_of(std::span<const std::array<double, 3>> corners) {
    std::array<double, 3> normal{};
    const auto& origin = corners[0];
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto& p = corners[k];
        const auto& q = corners[(k + 1) % corners.size()];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const std::size_t l = (i + 2) % 3;
            normal[i] += (p[j] - origin[j]) * (q[l] - origin[l]) - (p[l] - origin[l]) * (q[j] - origin[j]);
        }
    }
    return normal;
}

/// Where a corner lies on a texture; the origin where the file does not say, or says nothing that can be looked up.
std::array<float, 2> texcoord(const Mesh& mesh, std::uint32_t at) {
    constexpr float most_repeats = 1e5f;
    if (at >= mesh.texcoords.size()) return {0, 0};
    const std::array<float, 2>& uv = mesh.texcoords[at];
    const bool is_sound = std::abs(uv[0]) <= most_repeats && std::abs(uv[1]) <= most_repeats;
    return is_sound ? uv : std::array<float, 2>{0, 0};
}

}  // namespace

bool FaceTriangles::is_ear(std::size_t before, std::size_t at, std::size_t after) const {
    const Point2& a = flat_[left_[before]];
    const Point2& b = flat_[left_[at]];
    const Point2& c = flat_[left_[after]];
    if (!(turn(a, b, c) > 0)) return false;
    for (std::size_t k = 0; k < left_.size(); ++k) {
        if (k == before || k == at || k == after) continue;
        const Point2& p = flat_[left_[k]];
        if (p == a || p == b || p == c) continue;  // a bridge to a hole comes by twice
        if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
}

void FaceTriangles::find_triangles(std::span<const std::array<double, 3>> corners) {
    triangles_.clear();
    const auto normal = normal_of(corners);
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    const double sign = normal[axis] < 0 ? -1 : 1;
    flat_.clear();
    for (const auto& p : corners) flat_.push_back({p[u] - corners[0][u], sign * (p[v] - corners[0][v])});
    left_.resize(corners.size());
    std::iota(left_.begin(), left_.end(), 0u);
    // From the second corner on, so that a convex quadrangle is cut from its first to its third corner.
    std::size_t at = 1;
    std::size_t budget = corners.size() <= max_corners_cut ? tries_a_corner * corners.size() : 0;
    for (std::size_t tries = 0; left_.size() > 3 && tries < left_.size() && budget > 0; --budget) {
        const std::size_t n = left_.size();
        at %= n;
        const std::size_t before = (at + n - 1) % n;
        const std::size_t after = (at + 1) % n;
        if (!is_ear(before, at, after)) {
            ++at;
            ++tries;
            continue;
        }
        triangles_.push_back({left_[before], left_[at], left_[after]});
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
        tries = 0;
    }
    for (std::size_t k = 2; k < left_.size(); ++k) triangles_.push_back({left_[0], left_[k - 1], left_[k]});
}

RawMesh triangulated(const Mesh& mesh) {
    RawMesh raw;
    raw.points = mesh.points;
    raw.materials.reserve(mesh.materials.size() + 1);
    std::map<std::string, std::uint32_t> known;
    const auto material_of = [&](const std::string& name) {
        const auto [at, is_new] = known.emplace(name, static_cast<std::uint32_t>(raw.materials.size()));
        if (is_new) raw.materials.push_back({.name = name});
        return at->second;
    };
    FaceTriangles cutter;
    std::vector<std::array<double, 3>> corners;
    std::size_t next_material = 0;
    std::string material;
    std::uint32_t material_number = UINT32_MAX;
    const auto is_sound = [&](std::uint32_t v) {
        return v < raw.points.size() && std::isfinite(raw.points[v][0] + raw.points[v][1] + raw.points[v][2]);
    };
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        for (; next_material < mesh.materials.size() && mesh.materials[next_material].first_face <= f;
             ++next_material) {
            material = mesh.materials[next_material].name;
            material_number = UINT32_MAX;
        }
        const std::span<const std::uint32_t> ring = mesh.face(f);
        if (ring.size() < 3) {
            ++raw.lines;
            continue;
        }
        bool sound = true;
        for (const std::uint32_t v : ring) sound = sound && is_sound(v);
        if (!sound) {
            raw.dropped += static_cast<std::uint32_t>(ring.size() - 2);
            continue;
        }
        if (material_number == UINT32_MAX) material_number = material_of(material);
        corners.clear();
        for (const std::uint32_t v : ring) corners.push_back(raw.points[v]);
        cutter.cut(corners, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            raw.triangles.push_back({ring[a], ring[b], ring[c]});
            raw.triangle_materials.push_back(material_number);
            if (mesh.ring_texcoord.empty()) return;
            const std::uint32_t first = mesh.ring_first[f];
            for (const std::uint32_t k : {a, b, c})
                raw.texcoords.push_back(texcoord(mesh, mesh.ring_texcoord[first + k]));
        });
    }
    return raw;
}

}  // namespace enfilade::modeler

#include "modeler/catalogue/own/shaper.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "base/check.h"
#include "modeler/catalogue/own/lid.h"

namespace enfilade::modeler::own {
namespace {

/// Points are kept on a grid of about a micrometre: what falls together is one vertex.
constexpr double grid = 0x1p-20;
double snapped(double v) { return std::round(v / grid) * grid; }

/// Gives every place of one skin one number.
class Welder {
public:
    explicit Welder(std::vector<Vec>& vertices) : vertices_(vertices) {}
    std::uint32_t operator()(Vec p) {
        p = {snapped(p.x), snapped(p.y), snapped(p.z)};
        const auto [found, is_new] = seen_.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(vertices_.size()));
        if (is_new) vertices_.push_back(p);
        return found->second;
    }

private:
    std::vector<Vec>& vertices_;
    std::map<std::tuple<double, double, double>, std::uint32_t> seen_;
};

/// The ring without repeated corners.
std::vector<std::uint32_t> distinct(std::span<const std::uint32_t> ring) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t k : ring) {
        if (corners.empty() || corners.back() != k) corners.push_back(k);
    }
    while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    return corners;
}

}  // namespace

Shaper::Shaper(std::uint32_t detail) : detail_(static_cast<int>(std::clamp(detail, 1u, most_detail))) {}

int Shaper::fine(int plain) const { return static_cast<int>(std::lround(plain * (1 + 0.6 * (detail_ - 1)))); }

std::uint32_t Shaper::material_of(const Paint& paint) {
    const auto found = std::ranges::find(materials_, paint.name, &ObjectMaterial::name);
    if (found == materials_.end()) {
        const auto& c = paint.colour;
        const float most = std::max({c[0], c[1], c[2]});
        ObjectMaterial material{paint.name, c};
        material.look.mirror = paint.mirror;
        for (std::size_t k = 0; k < 3; ++k) material.look.through[k] = paint.through * c[k] / most;
        materials_.push_back(std::move(material));
        return static_cast<std::uint32_t>(materials_.size() - 1);
    }
    return static_cast<std::uint32_t>(found - materials_.begin());
}

void Shaper::skin(std::span<const Ring> rings, const Paint& paint, Ends ends) {
    const std::size_t first_triangle = triangles_.size();
    Welder weld(vertices_);
    std::vector<std::vector<std::uint32_t>> numbers;
    for (const Ring& ring : rings) {
        std::vector<std::uint32_t>& row = numbers.emplace_back();
        for (const Vec& p : ring) row.push_back(weld(pose_(p)));
    }
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && c != a) triangles_.push_back({a, b, c});
    };
    const std::size_t steps = numbers.size() - (ends == Ends::Looped ? 0 : 1);
    for (std::size_t r = 0; r < steps; ++r) {
        const auto &low = numbers[r], &high = numbers[(r + 1) % numbers.size()];
        for (std::size_t k = 0; k < low.size(); ++k) {
            const std::size_t next = (k + 1) % low.size();
            const Vec a = vertices_[low[k]], b = vertices_[low[next]];
            const Vec c = vertices_[high[next]], d = vertices_[high[k]];
            // The shorter diagonal, so that rounded corners stay round.
            if (dot(c - a, c - a) <= dot(d - b, d - b)) {
                add(low[k], low[next], high[next]), add(low[k], high[next], high[k]);
            } else {
                add(low[k], low[next], high[k]), add(low[next], high[next], high[k]);
            }
        }
    }
    if (ends == Ends::Capped) {
        for (const bool is_last : {false, true}) {
            const std::vector<std::uint32_t> corners = distinct(is_last ? numbers.back() : numbers.front());
            std::vector<Vec> places;
            for (const std::uint32_t k : corners) places.push_back(vertices_[k]);
            for (const auto& [a, b, c] : lid(places)) {
                if (is_last) add(corners[a], corners[b], corners[c]);
                else add(corners[a], corners[c], corners[b]);
            }
        }
    }
    double volume = 0;
    for (std::size_t t = first_triangle; t < triangles_.size(); ++t) {
        const auto& [a, b, c] = triangles_[t];
        const Vec origin = vertices_[triangles_[first_triangle][0]];
        volume += dot(vertices_[a] - origin, cross(vertices_[b] - origin, vertices_[c] - origin));
    }
    if (volume < 0) {
        for (std::size_t t = first_triangle; t < triangles_.size(); ++t) std::swap(triangles_[t][1], triangles_[t][2]);
    }
    triangle_materials_.resize(triangles_.size(), material_of(paint));
}

ObjectMesh Shaper::finish(std::string_view name, const Size& size) && {
    ENFILADE_CHECK(!triangles_.empty());
    constexpr double far = std::numeric_limits<double>::max();
    Vec low{far, far, far}, high{-far, -far, -far};
    for (const Vec& p : vertices_) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const Vec extent = high - low;
    ObjectMesh mesh;
    mesh.name = name;
    mesh.triangles = std::move(triangles_);
    mesh.triangle_materials = std::move(triangle_materials_);
    mesh.materials = std::move(materials_);
    mesh.vertices.reserve(vertices_.size());
    for (const Vec& p : vertices_) {
        mesh.vertices.push_back({static_cast<float>(((p.x - low.x) / extent.x - 0.5) * size.width),
                                 static_cast<float>(((p.y - low.y) / extent.y - 0.5) * size.depth),
                                 static_cast<float>((p.z - low.z) / extent.z * size.height)});
    }
    return mesh;
}

}  // namespace enfilade::modeler::own

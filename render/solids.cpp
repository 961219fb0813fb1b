#include "render/solids.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "render/line_boxes.h"
#include "render/walk.h"

namespace enfilade::render {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::uint32_t prisms_a_leaf = 4;

using Bounds = std::array<std::array<double, 3>, 2>;

/// Boxes are larger than their solids by this, in metres.
constexpr double margin = 1e-3;

/// On which side of the ray the vertical line passes: one number for all prisms that share it.
double side_of(const Ray<double>& ray, const std::array<double, 2>& p) {
    return (p[1] - ray.origin.y) * ray.direction.x - (p[0] - ray.origin.x) * ray.direction.y;
}

}  // namespace

Solids::Solids(std::vector<SolidPrism> prisms, std::vector<std::array<double, 2>> corners)
    : prisms_(std::move(prisms)), corners_(std::move(corners)), order_(prisms_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!order_.empty()) build(0, std::uint32_t(order_.size()));
}

void Solids::build(std::uint32_t begin, std::uint32_t end) {
    const auto bounds_of = [&](const SolidPrism& prism) {
        Bounds box = {{{infinite, infinite, prism.z_low}, {-infinite, -infinite, prism.z_high}}};
        for (std::uint32_t c = prism.first_corner; c < prism.first_corner + prism.corner_count; ++c)
            for (std::size_t k = 0; k < 2; ++k) {
                box[0][k] = std::min(box[0][k], corners_[c][k]);
                box[1][k] = std::max(box[1][k], corners_[c][k]);
            }
        return box;
    };
    Node node = {{infinite, infinite, infinite}, {-infinite, -infinite, -infinite}, 0, begin, 0};
    for (std::uint32_t i = begin; i < end; ++i) {
        const Bounds box = bounds_of(prisms_[order_[i]]);
        for (std::size_t k = 0; k < 3; ++k) {
            node.low[k] = std::min(node.low[k], box[0][k] - margin);
            node.high[k] = std::max(node.high[k], box[1][k] + margin);
        }
    }
    const std::size_t at = nodes_.size();
    if (end - begin <= prisms_a_leaf) node.count = end - begin;
    nodes_.push_back(node);
    if (node.count == 0) {
        std::size_t axis = 0;
        for (std::size_t k = 1; k < 3; ++k)
            if (node.high[k] - node.low[k] > node.high[axis] - node.low[axis]) axis = k;
        std::vector<std::pair<double, std::uint32_t>> keys;
        for (std::uint32_t i = begin; i < end; ++i) {
            const Bounds box = bounds_of(prisms_[order_[i]]);
            keys.emplace_back(box[0][axis] + box[1][axis], order_[i]);
        }
        std::sort(keys.begin(), keys.end());
        for (std::uint32_t i = begin; i < end; ++i) order_[i] = keys[i - begin].second;
        const std::uint32_t middle = begin + (end - begin) / 2;
        build(begin, middle);
        build(middle, end);
    }
    nodes_[at].skip = std::uint32_t(nodes_.size());
}

/// By the crossings of a half-line towards +x from the point shifted by (-e^2, -e^3), as `accel::locate` counts them.
bool Solids::stands_over(const SolidPrism& prism, double x, double y) const {
    bool inside = false;
    for (std::uint32_t i = 0, j = prism.corner_count - 1; i < prism.corner_count; j = i++) {
        const auto& a = corners_[prism.first_corner + j];
        const auto& b = corners_[prism.first_corner + i];
        const bool upwards = b[1] >= y;
        if ((a[1] >= y) == upwards) continue;
        const double side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
        if (upwards ? side >= 0 : side <= 0) inside = !inside;
    }
    return inside;
}

void Solids::add_stretches(const Ray<double>& ray, std::uint32_t id, double from, double to,
                           std::vector<SolidStretch>& found) const {
    const SolidPrism& prism = prisms_[id];
    const double dz = ray.direction.z, oz = ray.origin.z;
    if (dz == 0 && !(oz >= prism.z_low && oz < prism.z_high)) return;
    if (dz != 0) {
        const double low = (prism.z_low - oz) / dz, high = (prism.z_high - oz) / dz;
        from = std::max(from, std::min(low, high));
        to = std::min(to, std::max(low, high));
    }
    if (!(from < to)) return;
    if (ray.direction.x == 0 && ray.direction.y == 0) {
        if (stands_over(prism, ray.origin.x, ray.origin.y)) found.push_back({from, to, id});
        return;
    }
    // Signs change an even number of times around a ring: in, out, in, out.
    const auto is_left = [&](double side) { return side > 0 || (side == 0 && ray.zero_mask != 0); };
    const std::size_t before = found.size();
    const std::array<double, 2>* corners = corners_.data() + prism.first_corner;
    std::array<double, 2> p = corners[prism.corner_count - 1];
    double p_side = side_of(ray, p);
    for (std::uint32_t i = 0; i < prism.corner_count; ++i) {
        const std::array<double, 2> q = corners[i];
        const double q_side = side_of(ray, q);
        if (is_left(p_side) != is_left(q_side)) {
            const Crossing<double> at = is_left(q_side) ? crossing(ray, p[0], p[1], p_side, q[0], q[1], q_side)
                                                        : crossing(ray, q[0], q[1], q_side, p[0], p[1], p_side);
            found.push_back({at.num / at.den, 0, id});
        }
        p = q;
        p_side = q_side;
    }
    const auto borders = found.begin() + std::ptrdiff_t(before);
    std::sort(borders, found.end(), [](const SolidStretch& a, const SolidStretch& b) { return a.enter < b.enter; });
    std::size_t kept = before;
    for (std::size_t i = before; i + 1 < found.size(); i += 2) {
        const double enter = std::max(from, found[i].enter), leave = std::min(to, found[i + 1].enter);
        if (enter < leave) found[kept++] = {enter, leave, id};
    }
    found.resize(kept);
}

bool Solids::are_around(const Vec3d& p) const {
    if (nodes_.empty()) return false;
    const auto &low = nodes_.front().low, &high = nodes_.front().high;
    return p.x >= low[0] && p.x <= high[0] && p.y >= low[1] && p.y <= high[1] && p.z >= low[2] && p.z <= high[2];
}

void Solids::along(const Ray<double>& ray, double from, double to, std::vector<SolidStretch>& found) const {
    found.clear();
    const detail::LineBoxes line(ray);
    for (std::size_t i = 0; i < nodes_.size();) {
        const Node& node = nodes_[i];
        if (!line.meets(node.low, node.high, from, to)) {
            i = node.skip;
            continue;
        }
        for (std::uint32_t k = 0; k < node.count; ++k) add_stretches(ray, order_[node.first + k], from, to, found);
        ++i;
    }
    std::sort(found.begin(), found.end(), [](const SolidStretch& a, const SolidStretch& b) {
        if (a.enter != b.enter) return a.enter < b.enter;
        return a.leave != b.leave ? a.leave < b.leave : a.prism < b.prism;
    });
}

}  // namespace enfilade::render

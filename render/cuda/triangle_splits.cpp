// Boxes of parts of triangles.

#include <algorithm>
#include <cmath>

#include "render/cuda/triangle_scene.h"
#include "render/vec.h"

namespace enfilade::render::cuda {
namespace {

/// A convex part of a triangle.
struct Part {
    std::array<std::array<double, 3>, 10> corners;
    int count = 0;
    void add(const std::array<double, 3>& corner) {
        if (count < 10) corners[static_cast<std::size_t>(count++)] = corner;
    }
};

/// Rounded outward.
SahBox box_of(const Part& part) {
    SahBox box = SahBox::none();
    for (int i = 0; i < part.count; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const double at = part.corners[static_cast<std::size_t>(i)][k];
            float low = static_cast<float>(at), high = low;
            if (double{low} > at) low = std::nextafter(low, -std::numeric_limits<float>::infinity());
            if (double{high} < at) high = std::nextafter(high, std::numeric_limits<float>::infinity());
            box.low[k] = std::min(box.low[k], low);
            box.high[k] = std::max(box.high[k], high);
        }
    return box;
}

/// What of it lies on one side of a plane across an axis.
Part side_of(const Part& part, std::size_t axis, double plane, bool is_above) {
    Part side;
    const auto depth = [&](const std::array<double, 3>& p) { return is_above ? p[axis] - plane : plane - p[axis]; };
    for (int i = 0; i < part.count; ++i) {
        const auto& p = part.corners[static_cast<std::size_t>(i)];
        const auto& q = part.corners[static_cast<std::size_t>((i + 1) % part.count)];
        const double dp = depth(p), dq = depth(q);
        if (dp >= 0) side.add(p);
        if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0)) {
            const double s = dp / (dp - dq);
            std::array<double, 3> cut;
            for (std::size_t k = 0; k < 3; ++k) cut[k] = p[k] + s * (q[k] - p[k]);
            cut[axis] = plane;
            side.add(cut);
        }
    }
    return side;
}

/// The plane of the coarsest halving of the scene that runs through a box: its axis, place and level.
struct Halving {
    std::size_t axis = 3;  ///< 3: none
    double plane = 0;
    int level = 0;
};

class Splitter {
public:
    explicit Splitter(const SahBox& scene) {
        for (std::size_t k = 0; k < 3; ++k) {
            low_[k] = scene.low[k];
            size_ = std::max(size_, double{scene.high[k]} - low_[k]);
        }
    }

    [[nodiscard]] Halving halving_of(const SahBox& box) const {
        Halving best;
        for (std::size_t k = 0; k < 3; ++k) {
            const double a = (double{box.low[k]} - low_[k]) / size_, b = (double{box.high[k]} - low_[k]) / size_;
            if (!(b > a)) continue;
            for (int level = 1; level <= most_levels; ++level) {
                const double steps = std::ldexp(1.0, level), plane = std::floor(a * steps) + 1;
                if (!(plane < b * steps)) continue;
                if (best.axis == 3 || level < best.level) best = {k, low_[k] + plane / steps * size_, level};
                break;
            }
        }
        return best;
    }

    /// The gain that Karras and Aila expect of splitting a triangle (their equation 8).
    [[nodiscard]] double gain_of(const SceneTriangle& t, const SahBox& box) const {
        const Halving halving = halving_of(box);
        if (halving.axis == 3) return 0;
        const Vec3d a = {t.a.x, t.a.y, t.a.z};
        const Vec3d n = cross(Vec3d{t.b.x, t.b.y, t.b.z} - a, Vec3d{t.c.x, t.c.y, t.c.z} - a);
        const double least_area = 0.5 * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
        return std::cbrt(std::ldexp(std::max(0.0, box.half_area() - least_area), -halving.level));
    }

    void split(const Part& part, const SahBox& box, std::uint32_t item, std::uint32_t splits,
               std::vector<SahEntry>& entries) const {
        const Halving halving = splits > 0 ? halving_of(box) : Halving();
        if (halving.axis == 3) {
            entries.push_back({box, item});
            return;
        }
        const Part below = side_of(part, halving.axis, halving.plane, false);
        const Part above = side_of(part, halving.axis, halving.plane, true);
        if (below.count < 3 || above.count < 3) {
            entries.push_back({box, item});
            return;
        }
        const SahBox low = box_of(below), high = box_of(above);
        const double size_low = longest(low), size_high = longest(high), sum = size_low + size_high;
        const auto rest = static_cast<double>(splits - 1);
        const auto of_low = static_cast<std::uint32_t>(sum > 0 ? std::floor(rest * size_low / sum + 0.5) : 0);
        split(below, low, item, of_low, entries);
        split(above, high, item, splits - 1 - of_low, entries);
    }

private:
    static constexpr int most_levels = 24;

    static double longest(const SahBox& box) {
        double size = 0;
        for (std::size_t k = 0; k < 3; ++k) size = std::max(size, double{box.high[k]} - box.low[k]);
        return size;
    }

    std::array<double, 3> low_{};
    double size_ = 0;
};

Part part_of(const SceneTriangle& t) {
    Part part;
    for (const accel::Vertex& v : {t.a, t.b, t.c}) part.add({v.x, v.y, v.z});
    return part;
}

}  // namespace

std::vector<SahEntry> triangle_entries(const TriangleScene& scene, std::uint32_t begin, std::uint32_t end,
                                       float split_share) {
    std::vector<SahEntry> entries;
    SahBox all = SahBox::none();
    for (std::uint32_t t = begin; t < end; ++t) {
        if (!scene.can_be_hit[t]) continue;
        entries.push_back({scene.box_of(t), t});
        all.add(entries.back().box);
    }
    if (entries.empty() || !(split_share > 0)) return entries;

    const Splitter splitter(all);
    std::vector<double> gains;
    double sum = 0;
    for (const SahEntry& e : entries) sum += gains.emplace_back(splitter.gain_of(scene.triangles[e.item], e.box));
    if (!(sum > 0)) return entries;
    const double scale = double{split_share} * static_cast<double>(entries.size()) / sum;
    std::vector<SahEntry> split;
    split.reserve(entries.size() + static_cast<std::size_t>(scale * sum) + 1);
    for (std::size_t k = 0; k < entries.size(); ++k)
        splitter.split(part_of(scene.triangles[entries[k].item]), entries[k].box, entries[k].item,
                       static_cast<std::uint32_t>(std::min(scale * gains[k], 1024.0)), split);
    return split;
}

}  // namespace enfilade::render::cuda

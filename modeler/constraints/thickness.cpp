// G6: walls and slabs have a thickness that can be built.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <unordered_map>

#include "modeler/constraints/box_pairs.h"
#include "modeler/constraints/star_blame.h"
#include "modeler/place.h"
#include "plans/vector2.h"

namespace enfilade::modeler {
namespace {

/// Each side of a wall is rounded to the grid twice, by half a unit per axis each time: what is asked for as thick
/// enough may come out thinner by this many units.
const double rounding = 2 * std::sqrt(2.0);

/// Metres: what is thin over less than a hand's breadth is a scrap that walls leave where they meet. So is what is thin
/// over less than half of a wall that is thick enough in the plan: a thicker wall has taken the rest.
constexpr double scrap = 0.1;

/// Two faces of one wall look away from each other where they are parallel, but for what rounding turns short ones by:
/// the tip of a wedge between walls that meet is no thin wall.
const double opposite = std::cos(3 * std::numbers::pi / 180);

/// An upright face of a wall towards something that is no wall, seen from above with the wall on its left.
struct WallSide {
    double ax = 0, ay = 0, bx = 0, by = 0;  ///< grid units
    double z_low = 0, z_high = 0;
    [[nodiscard]] double length() const { return std::hypot(bx - ax, by - ay); }
};

struct Thinness {
    double thickness = std::numeric_limits<double>::infinity();  ///< grid units
    double over = 0;                                             ///< length of what is too thin
    std::array<double, 3> place = {};
};

/// The distance between two sides that look away from each other, over the length that they have in common.
std::optional<Thinness> between(const WallSide& f, const WallSide& g) {
    const double f_length = f.length(), g_length = g.length();
    const double low = std::max(f.z_low, g.z_low), high = std::min(f.z_high, g.z_high);
    if (f_length == 0 || g_length == 0 || low >= high) return std::nullopt;
    const double ux = (f.bx - f.ax) / f_length, uy = (f.by - f.ay) / f_length;
    if ((ux * (g.bx - g.ax) + uy * (g.by - g.ay)) / g_length > -opposite) return std::nullopt;
    // g runs back: from its end to its start along f; how far it lies to the left of f, at both ends of the overlap.
    const auto along = [&](double x, double y) { return ux * (x - f.ax) + uy * (y - f.ay); };
    const auto left = [&](double x, double y) { return ux * (y - f.ay) - uy * (x - f.ax); };
    const double g_from = along(g.bx, g.by), g_to = along(g.ax, g.ay);
    const double from = std::max(0.0, g_from), to = std::min(f_length, g_to);
    if (to <= from) return std::nullopt;
    const auto left_at = [&](double t) {
        const double share = (t - g_from) / (g_to - g_from);
        return left(g.bx, g.by) * (1 - share) + left(g.ax, g.ay) * share;
    };
    const double at_from = left_at(from), at_to = left_at(to);
    if (std::max(at_from, at_to) <= 0) return std::nullopt;  // it lies behind f, or on it
    if (std::abs(at_from - at_to) > 2 * rounding) return std::nullopt;
    Thinness result;
    result.thickness = std::max(0.0, std::min(at_from, at_to));
    result.over = to - from;
    const double middle = (from + to) / 2, half = left_at(middle) / 2;
    result.place = {f.ax + ux * middle - uy * half, f.ay + uy * middle + ux * half, (low + high) / 2};
    return result;
}

class ThicknessCheck {
public:
    ThicknessCheck(const Subject& subject, Blame& blame, CheckReport& report)
        : subject_(subject),
          building_(subject.building),
          blame_(blame),
          report_(report),
          least_(subject.options.least_thickness / subject.building.frame.unit - rounding) {
        for (const plans::Storey& storey : subject.plan.storeys)
            for (const plans::Wall& wall : storey.walls) walls_.emplace(wall.id, &wall);
    }

    void run() {
        std::vector<std::vector<std::uint32_t>> walls(building_.spaces.size()), slabs(building_.spaces.size());
        for (std::uint32_t v = 0; v < building_.volumes.size(); ++v) {
            const Volume& volume = building_.volumes[v];
            if (volume.label != Label::Wall && volume.label != Label::Slab) continue;
            if (blame_.volume[v]) ++report_.suppressed;
            else (volume.label == Label::Wall ? walls : slabs)[volume.space].push_back(v);
        }
        for (std::uint32_t s = 0; s < building_.spaces.size(); ++s) {
            check_wall(s, walls[s]);
            check_slab(s, slabs[s]);
        }
    }

private:
    /// The sides of a wall's volumes that do not face another wall or another part of it.
    void collect(const std::vector<std::uint32_t>& volumes) {
        const FaceRings& rings = subject_.rings;
        sides_.clear();
        for (const std::uint32_t v : volumes) {
            outline(v);
            for (const std::uint32_t f : rings.faces_of(v)) {
                if (rings.lie(f) != Lie::Upright) continue;
                const std::uint32_t other = rings.volumes(f)[rings.volumes(f)[0] == v ? 1 : 0];
                if (other < building_.volumes.size() && building_.volumes[other].label == Label::Wall) continue;
                add_side(f);
            }
        }
    }

    /// The sides of the volume's level faces, each with the volume on its left.
    void outline(std::uint32_t volume) {
        const FaceRings& rings = subject_.rings;
        outline_.clear();
        for (const std::uint32_t f : rings.faces_of(volume)) {
            if (rings.lie(f) != Lie::Level) continue;
            rings.flatten(f, ring_);
            std::int64_t area = 0;
            for (std::size_t k = 1; k + 1 < ring_.size(); ++k) area += orientation(ring_[0], ring_[k], ring_[k + 1]);
            if (area < 0) std::reverse(ring_.begin(), ring_.end());
            for (std::size_t k = 0; k < ring_.size(); ++k)
                outline_.emplace_back(ring_[k], ring_[k + 1 < ring_.size() ? k + 1 : 0]);
        }
        std::sort(outline_.begin(), outline_.end());
    }

    void add_side(std::uint32_t face) {
        plans::GridPoint a, b;
        WallSide side;
        bool first = true;
        for (const std::uint32_t v : subject_.rings.ring(face)) {
            const Point3& p = subject_.rings.point(v);
            const plans::GridPoint foot{p[0], p[1]};
            if (first) a = b = foot, side.z_low = side.z_high = p[2];
            first = false;
            a = std::min(a, foot), b = std::max(b, foot);
            side.z_low = std::min(side.z_low, double(p[2]));
            side.z_high = std::max(side.z_high, double(p[2]));
        }
        if (!std::binary_search(outline_.begin(), outline_.end(), std::pair(a, b))) {
            if (!std::binary_search(outline_.begin(), outline_.end(), std::pair(b, a))) return;
            std::swap(a, b);
        }
        side.ax = a.x, side.ay = a.y, side.bx = b.x, side.by = b.y;
        sides_.push_back(side);
    }

    void check_wall(std::uint32_t space, const std::vector<std::uint32_t>& volumes) {
        if (volumes.empty()) return;
        collect(volumes);
        std::vector<GridBox> boxes(sides_.size());
        const std::int32_t margin = std::int32_t(std::ceil(std::max(0.0, least_) / 2)) + 1;
        for (std::size_t k = 0; k < sides_.size(); ++k) {
            const WallSide& side = sides_[k];
            boxes[k].add(Point3{std::int32_t(std::min(side.ax, side.bx)) - margin,
                                std::int32_t(std::min(side.ay, side.by)) - margin, std::int32_t(side.z_low)});
            boxes[k].add(Point3{std::int32_t(std::max(side.ax, side.bx)) + margin,
                                std::int32_t(std::max(side.ay, side.by)) + margin, std::int32_t(side.z_high)});
        }
        Thinness worst;
        std::map<std::array<double, 4>, double> thin;  // by the side's foot: stacked faces count once
        BoxTree(boxes).for_each_touching_pair([&](std::uint32_t i, std::uint32_t j) {
            const auto found = between(sides_[i], sides_[j]);
            if (!found || found->thickness >= least_) return;
            double& over = thin[{sides_[i].ax, sides_[i].ay, sides_[i].bx, sides_[i].by}];
            over = std::max(over, found->over);
            if (found->thickness < worst.thickness) worst = *found;
        });
        double over = 0;
        for (const auto& [foot, length] : thin) over += length;
        if (over * building_.frame.unit >= least_length(space)) report(space, volumes.front(), worst);
    }

    [[nodiscard]] double least_length(std::uint32_t space) const {
        const auto wall = walls_.find(building_.spaces[space].id);
        if (wall == walls_.end() || wall->second->thickness < subject_.options.least_thickness) return scrap;
        return std::max(scrap, plans::distance(wall->second->start, wall->second->end) / 2);
    }

    void check_slab(std::uint32_t space, const std::vector<std::uint32_t>& volumes) {
        const FaceRings& rings = subject_.rings;
        Thinness worst;
        std::uint32_t where = 0;
        for (const std::uint32_t v : volumes) {
            std::int32_t low = INT32_MAX, high = INT32_MIN;
            const auto faces = rings.faces_of(v);
            if (std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) { return rings.lie(f) == Lie::Tilted; }))
                continue;  // G7
            for (const std::uint32_t f : faces) {
                if (rings.lie(f) != Lie::Level) continue;
                low = std::min(low, rings.point(rings.ring(f)[0])[2]);
                high = std::max(high, rings.point(rings.ring(f)[0])[2]);
            }
            const double thickness = double(high) - low;
            if (low >= high || thickness >= worst.thickness) continue;  // without two levels: a broken map
            worst.thickness = thickness;
            where = v;
        }
        if (worst.thickness >= least_) return;
        Finding finding = finding_of(space, worst);
        place_at_volume(building_, where, finding);
        report_.findings.push_back(std::move(finding));
    }

    [[nodiscard]] Finding finding_of(std::uint32_t space, const Thinness& thin) const {
        Finding finding{.code = "G6", .severity = Severity::Warning};
        finding.sentence = "The " + title(building_.spaces[space]) + " is only " +
                           millimetres(building_, thin.thickness) + " thick, less than the " +
                           millimetres(building_, subject_.options.least_thickness / building_.frame.unit) +
                           " that can be built.";
        finding.hint = "Give it its true thickness in the plan, or leave it out.";
        return finding;
    }

    void report(std::uint32_t space, std::uint32_t volume, const Thinness& thin) {
        Finding finding = finding_of(space, thin);
        const plans::GridFrame& frame = building_.frame;
        finding.point = {frame.origin_x + frame.unit * thin.place[0], frame.origin_y + frame.unit * thin.place[1],
                         frame.origin_z + frame.unit * thin.place[2]};
        place_at_volume(building_, volume, finding);
        report_.findings.push_back(std::move(finding));
    }

    const Subject& subject_;
    const Building& building_;
    Blame& blame_;
    CheckReport& report_;
    double least_;                                               ///< grid units
    std::unordered_map<std::string, const plans::Wall*> walls_;  ///< of the plan, by id
    std::vector<WallSide> sides_;
    std::vector<std::pair<plans::GridPoint, plans::GridPoint>> outline_;
    std::vector<plans::GridPoint> ring_;
};

}  // namespace

void check_thickness(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("G6");
    if (blame.whole_map) ++report.suppressed;
    else ThicknessCheck(subject, blame, report).run();
}

}  // namespace enfilade::modeler

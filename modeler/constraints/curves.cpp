// G9: the faces of curved walls follow the circles of the plan.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "modeler/constraints/star_blame.h"
#include "modeler/place.h"
#include "plans/outline.h"
#include "plans/vector2.h"

namespace enfilade::modeler {
namespace {

using plans::OutlinePart;
using plans::Point;

/// Grid units by which the ends of a facet may lie off its circle and its middle off the chord: two roundings of half a
/// unit per axis each (the wall's corners, then the pieces' graph), and one for the axis' own ends.
constexpr double rounding = 3;

/// Sine of the angle to the circle's tangent below which a face lies along the circle, and is no jamb or joint.
constexpr double along_circle = 0.3;

/// What lies farther off both circles than this many times what is allowed, or than a quarter of the wall's thickness,
/// is something else: a cut by another element.
constexpr double most_stray = 5;

/// One side of a curved wall, between the corners that its joints give it: those may lie off the circle.
struct CurvedSide {
    double radius = 0;
    double from = 1;  ///< shares of the axis
    double to = 0;
};

struct Stray {
    std::uint32_t face = UINT32_MAX;
    double metres = 0;
    std::array<double, 3> place = {};
};

/// Faces with walls and openings behind them are joints, jambs and cuts by others.
bool shows_the_circle(Label beyond) {
    switch (beyond) {
        case Label::Wall:
        case Label::Door:
        case Label::Window:
        case Label::Opening: return false;
        default: return true;
    }
}

class CurveCheck {
public:
    CurveCheck(const Subject& subject, Blame& blame, CheckReport& report)
        : subject_(subject), building_(subject.building), blame_(blame), report_(report) {
        bound_ = building_.sagitta + building_.frame.unit * std::max(rounding, building_.max_deviation + rounding / 2);
    }

    void run() {
        for (const StoreyInfo& info : building_.storeys)
            for (const plans::Storey& storey : subject_.plan.storeys)
                if (storey.id == info.id && std::any_of(storey.walls.begin(), storey.walls.end(),
                                                        [](const plans::Wall& w) { return w.arc_extent != 0; }))
                    check_storey(storey);
    }

private:
    void check_storey(const plans::Storey& storey) {
        const double unit = building_.frame.unit;
        const plans::OutlineOptions options{.origin = {building_.frame.origin_x, building_.frame.origin_y},
                                            .sagitta = building_.sagitta,
                                            .join = 4 * unit,
                                            .flat = unit / 4};
        const plans::StoreyOutlines outlines = plans::outlines(storey, options);
        for (std::size_t w = 0; w < storey.walls.size(); ++w) {
            const plans::WallOutline& outline = outlines.walls[w];
            if (outline.ring.empty() || outline.axis.straight()) continue;
            const auto space = subject_.spaces.find(Label::Wall, storey.walls[w].id);
            if (space) check_wall(*space, outline);
        }
    }

    void check_wall(std::uint32_t space, const plans::WallOutline& outline) {
        const std::array<CurvedSide, 2> sides = {side_of(outline, OutlinePart::Left),
                                                 side_of(outline, OutlinePart::Right)};
        const FaceRings& rings = subject_.rings;
        Stray worst;
        for (const std::uint32_t v : subject_.spaces.volumes(space)) {
            if (v >= rings.volume_bound()) continue;
            for (const std::uint32_t f : rings.faces_of(v)) {
                if (rings.lie(f) != Lie::Upright) continue;
                const std::uint32_t beyond = rings.volumes(f)[rings.volumes(f)[0] == v ? 1 : 0];
                if (beyond >= building_.volumes.size() || !shows_the_circle(building_.volumes[beyond].label)) continue;
                if (stands_on_another(v, f)) continue;
                const Stray stray = stray_of(f, outline, sides);
                if (stray.metres <= bound_) continue;
                if (blame_.volume[v] || (f < blame_.face.size() && blame_.face[f])) {
                    ++report_.suppressed;
                    continue;
                }
                if (stray.metres > worst.metres) worst = stray;
            }
        }
        if (worst.face != UINT32_MAX) report(space, worst);
    }

    /// Over a lower wall or column that cuts into this one its side is the cut, and has the open air beyond it.
    [[nodiscard]] bool stands_on_another(std::uint32_t volume, std::uint32_t face) const {
        for (const std::uint32_t v : subject_.rings.ring(face))
            if (subject_.rings.point(v)[2] <= building_.volumes[volume].z_low) return false;
        return true;
    }

    /// Where the side's own points are; the corners at its ends count where the joint left them on the circle.
    [[nodiscard]] CurvedSide side_of(const plans::WallOutline& outline, OutlinePart part) const {
        const plans::WallAxis& axis = outline.axis;
        const bool is_inner = (part == OutlinePart::Left) == (axis.extent() > 0);
        CurvedSide side{.radius = std::max(0.0, axis.radius() + (is_inner ? -outline.half : outline.half))};
        const Point centre = axis.offset(0.5, axis.extent() > 0 ? axis.radius() : -axis.radius());
        const std::size_t n = outline.ring.size();
        for (std::size_t k = 0; k < n; ++k) {
            if (outline.ring[k].part != part && outline.ring[(k + n - 1) % n].part != part) continue;
            const Point p = outline.ring[k].at;
            if (std::abs(plans::distance(p, centre) - side.radius) > building_.frame.unit) continue;
            side.from = std::min(side.from, axis.nearest(p));
            side.to = std::max(side.to, axis.nearest(p));
        }
        return side;
    }

    /// How far an upright face strays from that side of the wall which it fits best, 0 where it does not lie along the
    /// circle, or reaches beyond what the joints leave of one of the sides.
    [[nodiscard]] Stray stray_of(std::uint32_t face, const plans::WallOutline& outline,
                                 const std::array<CurvedSide, 2>& sides) const {
        const FaceRings& rings = subject_.rings;
        const double unit = building_.frame.unit;
        Point3 low = rings.point(rings.ring(face)[0]), high = low;
        std::int32_t z_low = low[2], z_high = low[2];
        for (const std::uint32_t v : rings.ring(face)) {
            const Point3& p = rings.point(v);
            low = std::min(low, p), high = std::max(high, p);
            z_low = std::min(z_low, p[2]), z_high = std::max(z_high, p[2]);
        }
        const Point a{unit * low[0], unit * low[1]}, b{unit * high[0], unit * high[1]};  // relative to the origin
        const Point middle = (a + b) * 0.5;
        const plans::WallAxis& axis = outline.axis;
        const Point centre = axis.offset(0.5, axis.extent() > 0 ? axis.radius() : -axis.radius());
        const double length = plans::distance(a, b), radius = plans::distance(middle, centre);
        if (length == 0 || radius == 0) return {};
        if (std::abs(plans::dot(b - a, middle - centre)) > along_circle * length * radius) return {};
        const double slack = 2 * unit / axis.length();
        // The end of a wall may run along the circle by chance: its corners there are off the circle.
        for (const Point p : {a, b}) {
            const double t = axis.nearest(p), off = std::abs(plans::distance(p, centre) - axis.radius());
            if ((t < slack || t > 1 - slack) && std::abs(off - outline.half) > bound_) return {};
        }
        Stray least{.metres = std::numeric_limits<double>::infinity()};
        for (const CurvedSide& side : sides) {
            Stray stray{.face = face};
            for (const Point p : {middle, a, b}) {
                if (axis.nearest(p) < side.from - slack || axis.nearest(p) > side.to + slack) return {};
                const double off = std::abs(plans::distance(p, centre) - side.radius);
                if (off <= stray.metres) continue;
                stray.metres = off;
                stray.place = {building_.frame.origin_x + p.x, building_.frame.origin_y + p.y,
                               building_.frame.origin_z + unit * (double(z_low) + z_high) / 2};
            }
            if (stray.metres < least.metres) least = stray;
        }
        return least.metres <= std::max(most_stray * bound_, outline.half / 2) ? least : Stray{};
    }

    void report(std::uint32_t space, const Stray& stray) {
        char asked[32];
        std::snprintf(asked, sizeof asked, "%.3g mm", 1000 * building_.sagitta);
        Finding finding{.code = "G9", .severity = Severity::Error};
        finding.sentence = "The curved " + title(building_.spaces[space]) + " strays from its circle by " +
                           millimetres(building_, stray.metres / building_.frame.unit) + ", where " + asked +
                           " was asked for.";
        finding.hint = "The model is not of this plan, or was built with a coarser curve: build it again.";
        finding.point = stray.place;
        place_at_space(building_, space, finding);
        for (const std::uint32_t v : subject_.rings.volumes(stray.face)) blame_.volume[v] = true;
        report_.findings.push_back(std::move(finding));
    }

    const Subject& subject_;
    const Building& building_;
    Blame& blame_;
    CheckReport& report_;
    double bound_ = 0;  ///< metres
};

}  // namespace

void check_curves(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("G9");
    if (blame.whole_map) ++report.suppressed;
    else CurveCheck(subject, blame, report).run();
}

}  // namespace enfilade::modeler

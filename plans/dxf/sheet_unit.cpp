#include "plans/dxf/sheet_unit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "plans/dxf/gap.h"
#include "plans/dxf/wall_bodies.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr std::array candidates = {Unit::Millimetre, Unit::Centimetre, Unit::Metre, Unit::Inch, Unit::Foot};

/// Feet and inches as people write them (58'-0", 3'6 1/2") in metres; nothing for other texts.
std::optional<double> feet_and_inches(const std::string& text) {
    double feet = 0, inches = 0;
    int used = 0;
    if (std::sscanf(text.c_str(), " %lf' - %lf\"%n", &feet, &inches, &used) == 2 ||
        std::sscanf(text.c_str(), " %lf'-%lf\"%n", &feet, &inches, &used) == 2 ||
        std::sscanf(text.c_str(), " %lf' %lf\"%n", &feet, &inches, &used) == 2)
        return feet * 0.3048 + inches * 0.0254;
    if (text.find('\'') != std::string::npos && std::sscanf(text.c_str(), " %lf'", &feet) == 1) return feet * 0.3048;
    return std::nullopt;
}

/// A plain number that is not the measured length itself is the length in metres.
std::optional<double> other_metres(const std::string& text, double length) {
    double number = 0;
    int used = 0;
    if (std::sscanf(text.c_str(), " %lf%n", &number, &used) != 1 || std::size_t(used) != text.size() || number <= 0)
        return std::nullopt;
    const double ratio = length / number;
    for (const double scale : {10.0, 100.0, 1000.0})
        if (std::abs(ratio / scale - 1) < 0.01) return number;
    return std::nullopt;
}

struct Sizes {
    double paired = 0;     ///< share of the wall lines that have a partner
    double thickness = 0;  ///< the usual one, metres
    double door = 0;       ///< median width of swings, metres; 0: none
    double extent = 0;     ///< longer side of the walls' box, metres
};

Sizes sizes_in(const Drawing& drawing, const Roles& roles, double scale) {
    Sizes sizes;
    const std::vector<SheetStroke> strokes = sheet_strokes(drawing, roles, scale);
    std::vector<SheetStroke> walls;
    std::vector<double> swings;
    PlanBox box;
    for (const SheetStroke& s : strokes) {
        if (s.role == Role::Wall || s.role == Role::LowWall) {
            walls.push_back(s);
            box.add(s.stroke.a);
            box.add(s.stroke.b);
        }
        if (s.stroke.bulge != 0 && (s.role == Role::Door || s.role == Role::Opening)) {
            const CircleArc arc = circle_arc(s.stroke);
            if (std::abs(arc.sweep) > 0.8 && std::abs(arc.sweep) < 1.8) swings.push_back(arc.radius);
        }
    }
    const WallBodies bodies = wall_bodies(walls);
    sizes.paired = bodies.total_length > 0 ? bodies.paired_length / bodies.total_length : 0;
    sizes.thickness = bodies.usual_thickness;
    if (!box.empty()) sizes.extent = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
    if (!swings.empty()) {
        std::nth_element(swings.begin(), swings.begin() + std::ptrdiff_t(swings.size() / 2), swings.end());
        sizes.door = swings[swings.size() / 2];
    }
    return sizes;
}

/// 1 within [low, high], falling to 0 at half and double of it.
double plausible(double value, double low, double high) {
    if (value <= 0) return 0;
    const double off = value < low ? std::log2(low / value) : value > high ? std::log2(value / high) : 0;
    return std::max(0.0, 1 - off);
}

double score_of(const Sizes& sizes) {
    double score = 2 * sizes.paired * plausible(sizes.thickness, 0.07, 0.45);
    if (sizes.door > 0) score += 2 * plausible(sizes.door, 0.6, 1.1);
    score += plausible(sizes.extent, 5, 150);
    return score;
}

/// How many of the typed dimensions agree with the unit, as a share; nothing where none can be read.
std::optional<double> typed_agreement(const Drawing& drawing, double scale) {
    std::uint32_t read = 0, agree = 0;
    for (const Dimension& dimension : drawing.dimensions) {
        const std::string& text = dimension.text.empty() ? dimension.written : dimension.text;
        auto typed = feet_and_inches(text);
        if (!typed) typed = other_metres(text, dimension.length);
        if (!typed || dimension.length <= 0 || *typed <= 0) continue;
        ++read;
        agree += std::abs(dimension.length * scale / *typed - 1) < 0.02;
    }
    if (read == 0) return std::nullopt;
    return double(agree) / read;
}

std::string evidence_text(const Sizes& sizes) {
    char text[160];
    if (sizes.door > 0)
        std::snprintf(text, sizeof text,
                      "so its walls are %.2f m thick, its doors %.2f m wide and the whole %.0f m long", sizes.thickness,
                      sizes.door, sizes.extent);
    else
        std::snprintf(text, sizeof text, "so its walls are %.2f m thick and the whole is %.0f m long", sizes.thickness,
                      sizes.extent);
    return text;
}

}  // namespace

UnitVerdict sheet_unit(const Drawing& drawing, const Roles& roles) {
    std::vector<Unit> units(candidates.begin(), candidates.end());
    if (drawing.declared_unit && std::find(units.begin(), units.end(), *drawing.declared_unit) == units.end())
        units.push_back(*drawing.declared_unit);
    UnitVerdict verdict;
    double best = -1;
    for (const Unit unit : units) {
        const Sizes sizes = sizes_in(drawing, roles, metres(unit));
        double score = score_of(sizes);
        if (const auto typed = typed_agreement(drawing, metres(unit))) score += 3 * *typed;
        if (drawing.linear_format == 3 || drawing.linear_format == 4) score += unit == Unit::Inch ? 0.5 : 0;
        // The file is believed unless the sizes clearly speak against it.
        if (drawing.declared_unit == unit) score += 1;
        else if (!drawing.declared_unit && (unit == Unit::Inch || unit == Unit::Foot) == !drawing.metric) score += 0.2;
        if (score <= best) continue;
        best = score;
        verdict.unit = unit;
        verdict.evidence = evidence_text(sizes);
    }
    verdict.overruled = drawing.declared_unit && *drawing.declared_unit != verdict.unit;
    verdict.guessed = !drawing.declared_unit;
    return verdict;
}

}  // namespace enfilade::plans

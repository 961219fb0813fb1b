// Walls that cannot be built.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plans/clean_steps.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

bool numbers(const Wall& wall) {
    return std::isfinite(wall.start.x) && std::isfinite(wall.start.y) && std::isfinite(wall.end.x) &&
           std::isfinite(wall.end.y) && std::isfinite(wall.arc_extent) && std::isfinite(wall.thickness) &&
           std::isfinite(wall.height_at_start) && std::isfinite(wall.height_at_end);
}

/// Why the wall cannot stay, as a finding without its storey's walls changed.
bool unusable(const Wall& wall, const Storey& storey, CleanReport& report) {
    const auto leave_out = [&](const char* code, Severity severity, Point at, const std::string& why,
                               const char* hint) {
        Finding finding = about(code, severity, "wall", wall, storey, at);
        if (!std::isfinite(at.x) || !std::isfinite(at.y)) finding.point.reset();
        finding.sentence = named("Wall", wall, storey) + " " + why + ", and was left out.";
        finding.hint = hint;
        report.add(std::move(finding));
        return true;
    };
    const Point middle = (wall.start + wall.end) * 0.5;
    if (!numbers(wall))
        return leave_out("P210", Severity::Error, middle, "has a number that is not finite",
                         "Give it finite coordinates and sizes.");
    if (std::abs(wall.arc_extent) >= 2 * std::numbers::pi)
        return leave_out("P210", Severity::Error, middle, "turns by a whole circle or more",
                         "Draw a round wall as two arcs.");
    if (wall.thickness < 0 || wall.height_at_start < 0 || wall.height_at_end < 0)
        return leave_out("P210", Severity::Error, middle, "has a negative thickness or height",
                         "Give it positive sizes.");
    if (wall.height_at_start == 0 && wall.height_at_end == 0)
        return leave_out("P213", Severity::Warning, middle, "has no height",
                         "Give it a height, or remove it from the plan.");
    if (const double length = axis_of(wall).length(); !(length >= shortest_wall))
        return leave_out("P211", Severity::Warning, middle, "is " + millimetres_text(length) + " long",
                         "Remove it from the plan, or lengthen it to 10 mm at least.");
    return false;
}

}  // namespace

bool clean_walls(Storey& storey, CleanReport& report) {
    std::vector<Wall> walls;
    for (const Wall& wall : storey.walls)
        if (!unusable(wall, storey, report)) walls.push_back(wall);
    const bool changed = walls.size() != storey.walls.size();
    storey.walls = std::move(walls);
    return changed;
}

}  // namespace enfilade::plans

// Walls that cannot be built.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plans/clean_steps.h"
#include "plans/limits.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double kThinnestDrawn = 0.01;  ///< m: what a wall drawn as a line stands for

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
    if (axis_of(wall).radius() > limits::coordinate)
        return leave_out("P210", Severity::Error, middle, "is an arc of more than 10000 km radius",
                         "Draw it straight, or as an arc that turns less than a whole circle.");
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
    bool changed = walls.size() != storey.walls.size();
    storey.walls = std::move(walls);
    for (Wall& wall : storey.walls)
        if (wall.thickness == 0) {
            Finding finding = about("P212", Severity::Warning, "wall", wall, storey, axis_of(wall).at(0.5));
            finding.sentence = named("Wall", wall, storey) + " has no thickness: it is built " +
                               millimetres_text(kThinnestDrawn) + " thick.";
            finding.hint = "Give it a thickness.";
            finding.moved_mm = kThinnestDrawn / 2 * 1000;
            wall.thickness = kThinnestDrawn;
            report.add(std::move(finding));
            changed = true;
        }
    return changed;
}

void note_high_walls(const Storey& storey, CleanReport& report) {
    std::size_t count = 0;
    const Wall* highest = nullptr;
    const auto top = [](const Wall& wall) { return std::max(wall.height_at_start, wall.height_at_end); };
    for (const Wall& wall : storey.walls) {
        if (top(wall) <= storey.height + level_tops) continue;
        ++count;
        if (highest == nullptr || top(wall) > top(*highest) || (top(wall) == top(*highest) && wall.id < highest->id))
            highest = &wall;
    }
    if (count == 0) return;
    Finding finding = about("P218", Severity::Note, "wall", *highest, storey, axis_of(*highest).at(0.5));
    finding.sentence = "Storey " + called(storey) + " is " + metres_text(storey.height) + " high and has " +
                       std::to_string(count) + " wall" + (count == 1 ? "" : "s") + " above that, the highest " +
                       metres_text(top(*highest)) + ": they end at its ceiling.";
    finding.hint = "Make the storey higher if it is meant to be.";
    report.add(std::move(finding));
}

}  // namespace enfilade::plans

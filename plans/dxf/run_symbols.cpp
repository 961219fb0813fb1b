// Doors and windows drawn over a wall that goes on under them.

#include <algorithm>
#include <cmath>
#include <optional>

#include "plans/dxf/run_parts.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double narrowest_door = 0.4;  ///< metres: a leaf's edge that touches the wall is less

struct Along {
    double u = 0;  ///< from the run's start
    double v = 0;
};

struct RunFrame {
    explicit RunFrame(const WallRun& run)
        : start(run.start),
          dir((run.end - run.start) * (1 / distance(run.start, run.end))),
          length(distance(run.start, run.end)) {}
    [[nodiscard]] Along of(Point p) const { return {dot(dir, p - start), dot(turned_left(dir), p - start)}; }
    Point start;
    Point dir;
    double length;
};

bool is_free(const WallRun& run, double u0, double u1) {
    return std::none_of(run.openings.begin(), run.openings.end(),
                        [&](const RunOpening& o) { return o.u1 > u0 + 0.02 && o.u0 < u1 - 0.02; });
}

void add(WallRun& run, const RunOpening& opening) {
    run.openings.push_back(opening);
    std::stable_sort(run.openings.begin(), run.openings.end(),
                     [](const RunOpening& l, const RunOpening& r) { return l.u0 < r.u0; });
}

/// The run in which a door shuts: hinge and one end of the swing lie in it.
void place_swing(std::vector<WallRun>& runs, const std::vector<RunFrame>& frames, const BoxIndex& index,
                 const SheetStroke& stroke, const DoorSwing& swing) {
    struct Fit {
        std::uint32_t run;
        double u0, u1, off;
    };
    std::optional<Fit> best;
    index.near(swing.hinge, [&](std::uint32_t k) {
        const Along hinge = frames[k].of(swing.hinge);
        const double room = runs[k].thickness / 2 + 0.12;
        for (const Point end : {swing.a, swing.b}) {
            const Along shut = frames[k].of(end);
            const double u0 = std::min(hinge.u, shut.u), u1 = std::max(hinge.u, shut.u);
            if (std::abs(hinge.v) > room || std::abs(shut.v) > room || u0 < -0.05 || u1 > frames[k].length + 0.05)
                continue;
            const double off = std::abs(hinge.v) + std::abs(shut.v);
            if (!best || off < best->off) best = Fit{k, u0, u1, off};
        }
    });
    if (!best || !is_free(runs[best->run], best->u0, best->u1)) return;
    RunOpening opening{OpeningKind::Door, {}, best->u0, best->u1, {}, {}, true};
    if (stroke.rule) opening.sill = stroke.rule->sill, opening.head = stroke.rule->head;
    add(runs[best->run], opening);
}

/// Lines of windows along a run: what overlaps or nearly touches is one window.
struct WindowLine {
    double u0;
    double u1;
    OpeningKind kind;
    const RoleRule* rule;
};

std::vector<WindowLine> window_lines(const WallRun& run, const RunFrame& frame, const std::vector<SheetStroke>& strokes,
                                     const StrokeIndex& index, std::vector<bool>& used) {
    std::vector<WindowLine> lines;
    PlanBox box;
    box.add(run.start);
    box.add(run.end);
    for (const std::uint32_t k : index.near(box.grown(run.thickness))) {
        const SheetStroke& s = strokes[k];
        if (used[k] || s.stroke.bulge != 0 ||
            (s.role != Role::Window && s.role != Role::Door && !(s.role == Role::Opening && is_low(run))))
            continue;
        const Along a = frame.of(s.stroke.a), b = frame.of(s.stroke.b);
        const double room = run.thickness / 2 + 0.02;
        if (std::abs(a.v) > room || std::abs(b.v) > room || std::abs(b.u - a.u) < 0.25) continue;
        const double u0 = std::max(std::min(a.u, b.u), 0.0), u1 = std::min(std::max(a.u, b.u), frame.length);
        if (u1 - u0 < 0.25 || u1 - u0 < 0.6 * std::abs(b.u - a.u)) continue;
        used[k] = true;
        lines.push_back({u0, u1, s.role == Role::Door ? OpeningKind::Door : OpeningKind::Window, s.rule});
    }
    std::stable_sort(lines.begin(), lines.end(), [](const WindowLine& l, const WindowLine& r) { return l.u0 < r.u0; });
    return lines;
}

}  // namespace

void place_symbols(std::vector<WallRun>& runs, const std::vector<SheetStroke>& strokes, std::vector<bool>& used) {
    std::vector<RunFrame> frames;
    std::vector<PlanBox> boxes(runs.size());
    for (std::size_t k = 0; k < runs.size(); ++k) {
        frames.emplace_back(runs[k]);
        boxes[k].add(runs[k].start);
        boxes[k].add(runs[k].end);
        boxes[k] = boxes[k].grown(0.5);
    }
    const BoxIndex index(boxes);
    for (std::size_t k = 0; k < strokes.size(); ++k) {
        if (used[k]) continue;
        if (const auto swing = door_swing(strokes[k])) place_swing(runs, frames, index, strokes[k], *swing);
    }
    const StrokeIndex stroke_index(strokes);
    for (std::size_t k = 0; k < runs.size(); ++k) {
        std::optional<WindowLine> open;
        const auto close = [&] {
            if (!open || !is_free(runs[k], open->u0, open->u1)) return;
            if (open->kind == OpeningKind::Door && open->u1 - open->u0 < narrowest_door) return;
            RunOpening opening{open->kind, {}, open->u0, open->u1, {}, {}, false};
            if (open->rule) opening.sill = open->rule->sill, opening.head = open->rule->head;
            add(runs[k], opening);
        };
        for (const WindowLine& line : window_lines(runs[k], frames[k], strokes, stroke_index, used)) {
            if (open && line.u0 < open->u1 + 0.06) {
                open->u1 = std::max(open->u1, line.u1);
                continue;
            }
            close();
            open = line;
        }
        close();
    }
}

}  // namespace enfilade::plans

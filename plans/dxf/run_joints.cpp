// Ends of walls, and what lies ahead of them.

#include <algorithm>
#include <cmath>
#include <optional>

#include "plans/dxf/run_parts.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

double length_of(const WallRun& run) { return distance(run.start, run.end); }

}  // namespace

std::optional<Meeting> meeting(const WallRun& run, bool at_end, const WallRun& other) {
    const Point from = at_end ? run.start : run.end, to = at_end ? run.end : run.start;
    const double length = distance(from, to), other_length = distance(other.start, other.end);
    if (length < 1e-6 || other_length < 1e-6) return std::nullopt;
    const Point d = (to - from) * (1 / length), e = (other.end - other.start) * (1 / other_length);
    const double sine = cross(d, e);
    if (std::abs(sine) < 0.12) return std::nullopt;
    const double ahead = cross(other.start - to, e) / sine;
    const double along = cross(other.start - to, d) / sine;
    return Meeting{ahead, std::max({0.0, -along, along - other_length}), std::abs(sine)};
}

void move_end(WallRun& run, bool at_end, double ahead) {
    const Point d = (run.end - run.start) * (1 / distance(run.start, run.end));
    if (at_end) {
        run.end = run.end + d * ahead;
        return;
    }
    run.start = run.start - d * ahead;
    for (RunOpening& opening : run.openings) opening.u0 += ahead, opening.u1 += ahead;
}

std::vector<SheetStroke> axes_of(const std::vector<WallRun>& runs) {
    std::vector<SheetStroke> axes;
    for (const WallRun& run : runs) axes.push_back({.stroke = {run.start, run.end, 0}, .role = Role::WallAxis});
    return axes;
}

void join_ends(std::vector<WallRun>& runs) {
    std::vector<PlanBox> boxes(runs.size());
    for (std::size_t k = 0; k < runs.size(); ++k) {
        boxes[k].add(runs[k].start);
        boxes[k].add(runs[k].end);
        boxes[k] = boxes[k].grown(1.0);
    }
    const BoxIndex index(boxes);
    // All ends are judged as they were found, then moved: the result does not depend on the order.
    struct Move {
        std::uint32_t run;
        bool at_end;
        double ahead;
    };
    std::vector<Move> moves;
    for (std::uint32_t k = 0; k < runs.size(); ++k)
        for (const bool at_end : {false, true}) {
            const WallRun& run = runs[k];
            // A wall that is there goes before one that would have to be led here.
            std::optional<Meeting> best;
            const auto cost = [](const Meeting& m) { return std::abs(m.ahead) + 2 * m.beyond; };
            index.near(at_end ? run.end : run.start, [&](std::uint32_t o) {
                if (o == k) return;
                const auto met = meeting(run, at_end, runs[o]);
                if (!met) return;
                const double reach = runs[o].thickness / 2 / met->sine + run.thickness / 2 * (1 / met->sine - 1) + 0.06;
                if (std::abs(met->ahead) > reach || -met->ahead > 0.6 * length_of(run)) return;
                if (met->beyond > run.thickness / 2 / met->sine + 0.06) return;
                if (!best || cost(*met) < cost(*best)) best = met;
            });
            if (best) moves.push_back({k, at_end, best->ahead});
        }
    for (const Move& move : moves) {
        move_end(runs[move.run], move.at_end, move.ahead);
        (move.at_end ? runs[move.run].end_joined : runs[move.run].start_joined) = true;
    }
}

void bridge_to_walls(std::vector<WallRun>& runs, const std::vector<SheetStroke>& strokes, const StrokeIndex& index,
                     std::vector<bool>& used, const GapLimits& limits) {
    const std::vector<WallRun> found = runs;
    const StrokeIndex axes(axes_of(found));
    for (std::uint32_t k = 0; k < runs.size(); ++k)
        for (const bool at_end : {false, true}) {
            WallRun& run = runs[k];
            if ((at_end ? run.end_joined : run.start_joined) || length_of(run) < 1e-6) continue;
            std::optional<double> nearest;
            double half = 0;
            const Point end = at_end ? run.end : run.start, ahead = at_end ? run.end - run.start : run.start - run.end;
            PlanBox reach;
            reach.add(end);
            reach.add(end + ahead * (limits.drawn / length_of(run)));
            for (const std::uint32_t o : axes.near(reach.grown(run.thickness + 0.01))) {
                if (o == k) continue;
                const auto met = meeting(run, at_end, found[o]);
                if (!met || met->beyond > run.thickness || met->ahead < 0.3 || met->ahead > limits.drawn) continue;
                if (nearest && met->ahead >= *nearest) continue;
                nearest = met->ahead;
                half = found[o].thickness / 2 / met->sine;
            }
            if (!nearest || *nearest - half < 0.3) continue;
            const Point d = (run.end - run.start) * (1 / length_of(run));
            const double u_end = dot(d, at_end ? run.end : run.start);
            const double far = at_end ? u_end + *nearest - half : u_end - *nearest + half;
            // Another wall that runs there needs no second one in it.
            const Point middle = end + ahead * ((*nearest - half) / 2 / length_of(run));
            const bool taken = std::any_of(found.begin(), found.end(), [&](const WallRun& other) {
                const Point o = other.end - other.start;
                return &other != &found[k] && std::abs(cross(d, o)) < 0.05 * length_of(other) &&
                       distance(middle, other.start, other.end) < (other.thickness + run.thickness) / 2;
            });
            if (taken) continue;
            const GapPlace gap{d, dot(turned_left(d), run.start), std::min(u_end, far), std::max(u_end, far),
                               run.thickness};
            const GapEvidence seen = gap_evidence(gap, strokes, index);
            if (!seen.fills(gap)) continue;
            // What stands in another wall's gap leads this one nowhere.
            if (std::all_of(seen.strokes.begin(), seen.strokes.end(), [&](std::uint32_t s) { return used[s]; }))
                continue;
            for (const std::uint32_t s : seen.strokes) used[s] = true;
            const GapKind kind = kind_of(seen);
            // What is not drawn over is wall, but for what may be the drawing's carelessness.
            const double u0 = seen.u0 - gap.u0 < 0.15 ? gap.u0 : seen.u0;
            const double u1 = gap.u1 - seen.u1 < 0.15 ? gap.u1 : seen.u1;
            // The end moves first: openings are measured from the start.
            move_end(run, at_end, *nearest);
            (at_end ? run.end_joined : run.start_joined) = true;
            const double from = dot(d, run.start);
            run.openings.push_back(
                {kind.kind, kind.inside, u0 - from, u1 - from, seen.sill, seen.head, seen.door_arcs > 0});
            std::stable_sort(run.openings.begin(), run.openings.end(),
                             [](const RunOpening& l, const RunOpening& r) { return l.u0 < r.u0; });
        }
}

}  // namespace enfilade::plans

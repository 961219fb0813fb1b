#include "plans/dxf/wall_runs.h"

#include <algorithm>
#include <cmath>

#include "plans/dxf/door_screens.h"
#include "plans/dxf/pane_walls.h"
#include "plans/dxf/run_parts.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double slanted_reach = 4;  ///< metres: (PairLimits::most + 0.1) / 0.2, the least sine

/// What is between two stretches of wall on one axis.
enum class Between { Wall, Opening, Nothing };

/// Whether the open lies beside an opening in a wall: rays from it along the normal meet no other run.
bool is_exterior(const std::vector<WallRun>& runs, Point place, Point direction, double thickness, double width) {
    const Point normal = turned_left(direction);
    // Three rays to each side: joints of drawn walls have holes through which one may slip.
    int escaped[2] = {0, 0};
    for (const double shift : {-0.3, 0.0, 0.3}) {
        const Point from = place + direction * (shift * width);
        bool hit[2] = {false, false};
        for (const WallRun& run : runs) {
            if (is_low(run)) continue;
            const double sa = dot(run.start - from, direction), sb = dot(run.end - from, direction);
            if (sa * sb > 0 || std::abs(sb - sa) < 1e-9) continue;
            const Point at = run.start + (run.end - run.start) * (sa / (sa - sb));
            const double t = dot(at - from, normal);
            if (std::abs(t) >= thickness) hit[t > 0] = true;
        }
        escaped[0] += !hit[0];
        escaped[1] += !hit[1];
    }
    return escaped[0] >= 2 || escaped[1] >= 2;
}

void settle_kinds(std::vector<WallRun>& runs) {
    for (WallRun& run : runs)
        for (RunOpening& opening : run.openings) {
            if (!opening.inside) continue;
            const Point d = (run.end - run.start) * (1 / distance(run.start, run.end));
            const Point middle = run.start + d * ((opening.u0 + opening.u1) / 2);
            if (!is_exterior(runs, middle, d, run.thickness, opening.u1 - opening.u0)) opening.kind = *opening.inside;
            opening.inside.reset();
        }
}

class RunMaker {
public:
    RunMaker(const WallBodies& bodies, const std::vector<SheetStroke>& strokes, std::vector<WallMass>* masses,
             const GapLimits& limits)
        : bodies_(bodies),
          strokes_(strokes),
          masses_(masses),
          index_(strokes),
          limits_(limits),
          used_(strokes.size(), false) {
        for (const WallBody& body : bodies.straight) {
            const Point dir = bodies.groups[body.group].dir;
            const Point at = turned_left(dir) * body.v;
            as_runs_.push_back({dir * body.u0 + at, dir * body.u1 + at, body.thickness, body.height, {}});
        }
        run_index_.emplace(axes_of(as_runs_));
    }

    std::vector<WallRun> make() {
        std::vector<WallRun> runs;
        for (const std::vector<WallBody>& axis : axes()) follow(axis, runs);
        // Twice: an end may lie on the axis of a wall that is led up to it.
        join_ends(runs);
        join_ends(runs);
        bridge_to_walls(runs, strokes_, index_, used_, limits_);
        join_ends(runs);
        const std::vector<WallMass> masses = masses_ ? wall_masses(strokes_, runs) : std::vector<WallMass>{};
        lead_into_masses(runs, masses, 0.06);
        add_door_screens(runs, strokes_, masses, used_);
        place_symbols(runs, strokes_, used_);
        add_panes(runs, strokes_, masses, used_);
        if (masses_) *masses_ = masses;
        settle_kinds(runs);
        return runs;
    }

private:
    /// Bodies that share axis, thickness and height as far as drawings are exact: a list each, by u0.
    [[nodiscard]] std::vector<std::vector<WallBody>> axes() const {
        std::vector<WallBody> sorted = bodies_.straight;
        std::stable_sort(sorted.begin(), sorted.end(), [](const WallBody& l, const WallBody& r) {
            return l.group != r.group ? l.group < r.group : l.v < r.v;
        });
        std::vector<std::vector<WallBody>> found;
        std::vector<bool> done(sorted.size(), false);
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            if (done[i]) continue;
            const WallBody& first = sorted[i];
            found.emplace_back();
            for (std::size_t j = i; j < sorted.size(); ++j) {
                const WallBody& other = sorted[j];
                if (other.group != first.group || other.v - first.v > 0.03) break;
                if (done[j] || other.height != first.height || std::abs(other.thickness - first.thickness) > 0.05)
                    continue;
                done[j] = true;
                found.back().push_back(other);
            }
            std::stable_sort(found.back().begin(), found.back().end(),
                             [](const WallBody& l, const WallBody& r) { return l.u0 < r.u0; });
        }
        return found;
    }

    void follow(const std::vector<WallBody>& axis, std::vector<WallRun>& runs) {
        std::size_t first = 0;
        std::vector<GapPlace> openings;
        std::vector<GapEvidence> evidence;
        double reached = axis[0].u1;
        for (std::size_t k = 1; k <= axis.size(); ++k) {
            Between between = Between::Nothing;
            GapPlace gap;
            GapEvidence seen;
            if (k < axis.size()) {
                gap = {bodies_.groups[axis[k].group].dir, (axis[k - 1].v + axis[k].v) / 2, reached, axis[k].u0,
                       (axis[k - 1].thickness + axis[k].thickness) / 2};
                between = what_is_in(axis[k].group, gap, seen);
            }
            if (between == Between::Opening) {
                if (seen.jambs && seen.jamb1 - seen.jamb0 > 0.3) gap.u0 = seen.jamb0, gap.u1 = seen.jamb1;
                openings.push_back(gap);
                evidence.push_back(seen);
            }
            if (between == Between::Nothing) {
                finish(axis, first, k, reached, openings, evidence, runs);
                first = k;
                openings.clear();
                evidence.clear();
            }
            if (k < axis.size()) reached = between == Between::Nothing ? axis[k].u1 : std::max(reached, axis[k].u1);
        }
    }

    Between what_is_in(std::uint32_t group, const GapPlace& gap, GapEvidence& seen) {
        const double width = gap.u1 - gap.u0;
        if (width <= 0.01) return Between::Wall;
        if (width > limits_.drawn) return Between::Nothing;
        if (width < 0.75 && (face_goes_on(group, gap) || crossing(gap))) return Between::Wall;
        seen = gap_evidence(gap, strokes_, index_);
        if (!seen.fills(gap) && (width > limits_.bare || !seen.jambs))
            return face_goes_on(group, gap) && width < limits_.bare ? Between::Wall : Between::Nothing;
        if (width < 0.3) return Between::Wall;
        for (const std::uint32_t k : seen.strokes) used_[k] = true;
        return Between::Opening;
    }

    [[nodiscard]] bool face_goes_on(std::uint32_t group, const GapPlace& gap) const {
        for (const double v : {gap.v - gap.thickness / 2, gap.v + gap.thickness / 2})
            for (const FaceLine& line : bodies_.groups[group].lines)
                if (std::abs(line.v - v) < 0.015 && line.u0 < gap.u0 + 0.015 && line.u1 > gap.u1 - 0.015) return true;
        return false;
    }

    /// Other walls fill the gap: they come from one side or run across.
    [[nodiscard]] bool crossing(const GapPlace& gap) const {
        const Point normal = turned_left(gap.dir);
        double filled = 0;
        PlanBox box;
        for (const double u : {gap.u0, gap.u1}) box.add(gap.dir * u + normal * gap.v);
        // No wall that slants as little as is counted reaches farther along the gap.
        for (const std::uint32_t k : run_index_->near(box.grown(slanted_reach))) {
            const WallRun& other = as_runs_[k];
            const Point d = (other.end - other.start) * (1 / distance(other.start, other.end));
            const double sine = std::abs(cross(gap.dir, d));
            if (sine < 0.2) continue;
            const double va = dot(normal, other.start) - gap.v, vb = dot(normal, other.end) - gap.v;
            if (std::min(va, vb) > gap.thickness / 2 + 0.05 || std::max(va, vb) < -gap.thickness / 2 - 0.05) continue;
            const double t = std::abs(vb - va) < 1e-9 ? 0 : va / (va - vb);
            const double u = dot(gap.dir, other.start + (other.end - other.start) * t);
            const double half = other.thickness / sine / 2;
            filled += std::max(0.0, std::min(u + half, gap.u1) - std::max(u - half, gap.u0));
        }
        return filled >= 0.6 * (gap.u1 - gap.u0);
    }

    void finish(const std::vector<WallBody>& axis, std::size_t first, std::size_t end, double reached,
                const std::vector<GapPlace>& gaps, const std::vector<GapEvidence>& evidence,
                std::vector<WallRun>& runs) const {
        double weight = 0, v = 0, thickness = 0;
        for (std::size_t k = first; k < end; ++k) {
            const double w = axis[k].u1 - axis[k].u0;
            weight += w;
            v += w * axis[k].v;
            thickness += w * axis[k].thickness;
        }
        const Point dir = bodies_.groups[axis[first].group].dir;
        const Point at = turned_left(dir) * (v / weight);
        const double u0 = axis[first].u0;
        WallRun run{dir * u0 + at, dir * reached + at, thickness / weight, axis[first].height, {}};
        for (std::size_t k = 0; k < gaps.size(); ++k) {
            const GapKind kind = kind_of(evidence[k]);
            run.openings.push_back({kind.kind, kind.inside, gaps[k].u0 - u0, gaps[k].u1 - u0, evidence[k].sill,
                                    evidence[k].head, evidence[k].door_arcs > 0});
        }
        runs.push_back(std::move(run));
    }

    const WallBodies& bodies_;
    const std::vector<SheetStroke>& strokes_;
    std::vector<WallMass>* masses_;
    StrokeIndex index_;
    GapLimits limits_;
    std::vector<bool> used_;
    std::vector<WallRun> as_runs_;  ///< the bodies, before they are joined
    std::optional<StrokeIndex> run_index_;
};

}  // namespace

std::vector<WallRun> wall_runs(const WallBodies& bodies, const std::vector<SheetStroke>& strokes,
                               std::vector<WallMass>* masses, const GapLimits& limits) {
    return RunMaker(bodies, strokes, masses, limits).make();
}

}  // namespace enfilade::plans

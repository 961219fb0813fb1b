#include "plans/dxf/pane_walls.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "plans/dxf/gap.h"
#include "plans/dxf/run_parts.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr PairLimits pane_limits = {.least = 0.015, .most = 0.25, .same_line = 0.004};
constexpr double least_length = 0.3;  ///< metres
constexpr double least_thickness = 0.06;
constexpr double staggered = 0.12;      ///< metres between the axes of sliding panes
constexpr double between_panes = 0.15;  ///< metres along them
constexpr double beside_wall = 0.4;     ///< metres: what runs along a wall closer than this is its sill or blind
constexpr double reach = 0.35;          ///< metres from the end of a band to what it ends at
constexpr double leaf_slack = 0.1;      ///< metres
constexpr double into = 0.1;            ///< metres that a band goes into a wall on its own line

struct Band {
    WallRun run;
    bool stands = true;
};

/// Strokes of panes that nothing else has taken, but for the leaves of swings.
std::vector<SheetStroke> free_panes(const std::vector<SheetStroke>& strokes, const std::vector<bool>& used) {
    std::vector<DoorSwing> swings;
    for (const SheetStroke& s : strokes)
        if (const auto swing = door_swing(s)) swings.push_back(*swing);
    const auto is_leaf = [&](const Stroke& line) {
        return std::any_of(swings.begin(), swings.end(), [&](const DoorSwing& swing) {
            return std::abs(distance(line.a, line.b) - distance(swing.hinge, swing.a)) < leaf_slack &&
                   (distance(line.a, swing.hinge) < leaf_slack || distance(line.b, swing.hinge) < leaf_slack);
        });
    };
    std::vector<SheetStroke> panes;
    for (std::size_t k = 0; k < strokes.size(); ++k)
        if (!used[k] && strokes[k].stroke.bulge == 0 &&
            (strokes[k].role == Role::Window || strokes[k].role == Role::Opening) && !is_leaf(strokes[k].stroke))
            panes.push_back(strokes[k]);
    return panes;
}

/// Panes one behind the other become one band, those that slide past each other too.
std::vector<Band> bands_of(const std::vector<SheetStroke>& panes) {
    const WallBodies bodies = wall_bodies(panes, pane_limits);
    std::vector<WallBody> sorted = bodies.straight;
    std::stable_sort(sorted.begin(), sorted.end(), [](const WallBody& l, const WallBody& r) {
        return l.group != r.group ? l.group < r.group : l.u0 < r.u0;
    });
    std::vector<bool> done(sorted.size(), false);
    std::vector<Band> bands;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        if (done[i]) continue;
        double low = sorted[i].v - sorted[i].thickness / 2, high = sorted[i].v + sorted[i].thickness / 2;
        double u1 = sorted[i].u1;
        for (std::size_t j = i + 1; j < sorted.size() && sorted[j].group == sorted[i].group; ++j) {
            const WallBody& next = sorted[j];
            if (next.u0 > u1 + between_panes) break;
            if (done[j] || std::abs(next.v - (low + high) / 2) > staggered) continue;
            done[j] = true;
            u1 = std::max(u1, next.u1);
            low = std::min(low, next.v - next.thickness / 2);
            high = std::max(high, next.v + next.thickness / 2);
        }
        if (u1 - sorted[i].u0 < least_length) continue;
        const Point dir = bodies.groups[sorted[i].group].dir, aside = turned_left(dir) * ((low + high) / 2);
        WallRun run;
        run.start = dir * sorted[i].u0 + aside;
        run.end = dir * u1 + aside;
        run.thickness = std::max(high - low, least_thickness);
        bands.push_back({std::move(run)});
    }
    return bands;
}

/// How far apart two runs lie across, where they are parallel and side by side for at least half of the first.
std::optional<double> apart(const WallRun& run, const WallRun& other) {
    const double length = distance(run.start, run.end), other_length = distance(other.start, other.end);
    if (length < 1e-6 || other_length < 1e-6) return std::nullopt;
    const Point d = (run.end - run.start) * (1 / length), e = (other.end - other.start) * (1 / other_length);
    if (std::abs(cross(d, e)) > 0.1) return std::nullopt;
    const double a = dot(other.start - run.start, d), b = dot(other.end - run.start, d);
    const double common = std::min(length, std::max(a, b)) - std::max(0.0, std::min(a, b));
    if (common < 0.5 * length) return std::nullopt;
    return std::abs(cross(d, (other.start + other.end) * 0.5 - run.start));
}

bool ends_at(Point end, const WallRun& other) {
    return distance(end, other.start, other.end) < other.thickness / 2 + reach;
}

bool ends_at(Point end, const WallMass& mass) {
    for (std::size_t k = 0; k < mass.polygon.size(); ++k)
        if (distance(end, mass.polygon[k], mass.polygon[(k + 1) % mass.polygon.size()]) < reach) return true;
    return false;
}

/// Leads the end to the axis of what stands across it, or into what stands on its line.
void lead(WallRun& run, bool at_end, const std::vector<const WallRun*>& others) {
    std::optional<Meeting> best;
    double straight_on = 0;
    for (const WallRun* other : others) {
        const Point end = at_end ? run.end : run.start;
        if (other == &run || !ends_at(end, *other)) continue;
        const auto met = meeting(run, at_end, *other);
        if (!met || met->sine < 0.3) {
            const Point ahead =
                (at_end ? run.end - run.start : run.start - run.end) * (1 / distance(run.start, run.end));
            const double to = std::min(dot(other->start - end, ahead), dot(other->end - end, ahead));
            if (std::abs(to) < reach) straight_on = std::max(straight_on, to + into);
            continue;
        }
        const double most = other->thickness / 2 / met->sine + reach;
        if (std::abs(met->ahead) > most || met->beyond > run.thickness / 2 + reach) continue;
        if (!best || std::abs(met->ahead) + 2 * met->beyond < std::abs(best->ahead) + 2 * best->beyond) best = met;
    }
    if (best) move_end(run, at_end, best->ahead);
    else if (straight_on > 0) move_end(run, at_end, straight_on);
}

/// Bands with an end in the air are none; those that ended at them neither.
void drop_loose(std::vector<Band>& bands, const std::vector<WallRun>& runs, const std::vector<WallMass>& masses) {
    for (bool changed = true; changed;) {
        changed = false;
        for (Band& band : bands) {
            const auto held = [&](Point end) {
                return std::any_of(runs.begin(), runs.end(), [&](const WallRun& r) { return ends_at(end, r); }) ||
                       std::any_of(masses.begin(), masses.end(), [&](const WallMass& m) { return ends_at(end, m); }) ||
                       std::any_of(bands.begin(), bands.end(), [&](const Band& other) {
                           return &other != &band && other.stands && ends_at(end, other.run);
                       });
            };
            if (!band.stands || (held(band.run.start) && held(band.run.end))) continue;
            band.stands = false;
            changed = true;
        }
    }
    std::erase_if(bands, [](const Band& band) { return !band.stands; });
}

}  // namespace

void add_panes(std::vector<WallRun>& runs, const std::vector<SheetStroke>& strokes, const std::vector<WallMass>& masses,
               std::vector<bool>& used) {
    std::vector<Band> bands = bands_of(free_panes(strokes, used));
    std::erase_if(bands, [&](const Band& band) {
        return std::any_of(runs.begin(), runs.end(), [&](const WallRun& run) {
            const auto off = apart(band.run, run);
            return off && *off < run.thickness / 2 + beside_wall;
        });
    });
    drop_loose(bands, runs, masses);
    if (bands.empty()) return;
    std::vector<WallRun> led;
    std::vector<const WallRun*> others;
    for (const WallRun& run : runs) others.push_back(&run);
    for (const Band& band : bands) others.push_back(&band.run);
    for (const Band& band : bands) {
        WallRun run = band.run;
        std::vector<const WallRun*> rest = others;
        std::erase(rest, &band.run);
        const Point start = run.start, end = run.end;
        lead(run, false, rest);
        lead(run, true, rest);
        const Point d = (run.end - run.start) * (1 / distance(run.start, run.end));
        run.openings.push_back({OpeningKind::Window,
                                OpeningKind::Window,
                                dot(start - run.start, d),
                                dot(end - run.start, d),
                                0.0,
                                {},
                                false});
        led.push_back(std::move(run));
    }
    lead_into_masses(led, masses, reach);
    runs.insert(runs.end(), led.begin(), led.end());
}

}  // namespace enfilade::plans

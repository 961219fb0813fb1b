#include "plans/dxf/door_screens.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/disjoint_sets.h"
#include "plans/dxf/gap.h"
#include "plans/dxf/run_parts.h"
#include "plans/dxf/solids.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double thickness = 0.1;    ///< metres, of walls that are nothing but a door
constexpr double jamb = 0.15;        ///< metres from a leaf to what it shuts against
constexpr double beside_row = 0.45;  ///< metres from a row of leaves, some of them open, to what it shuts against
constexpr double in_a_row = 1.0;     ///< metres between leaves that open to both sides
constexpr double touching = 0.12;    ///< metres: lines of one leaf, or of two that hang together
constexpr double least_width = 0.4;  ///< metres
constexpr double most_width = 6.5;
constexpr double deepest_row = 0.7;  ///< metres that open leaves stand out

/// From solid to solid.
struct Chord {
    Point a;
    Point b;
    bool swings = false;
};

/// Both ends led on by `slack` at most until they meet a solid; nothing where they do not, or something stands between.
std::optional<Chord> bridging(Point a, Point b, double slack, const Solids& solids) {
    const double length = distance(a, b);
    if (length < least_width || length > most_width) return std::nullopt;
    const Point d = (b - a) * (1 / length);
    for (const double share : {0.2, 0.35, 0.5, 0.65, 0.8})
        if (solids(a + d * (share * length))) return std::nullopt;
    const auto met = [&](Point from, Point ahead) -> std::optional<double> {
        // A leaf may be drawn into its frame a little.
        for (double s = -jamb / 2; s <= slack; s += 0.01)
            if (solids(from + ahead * s)) return s;
        return std::nullopt;
    };
    const auto before = met(a, d * -1), behind = met(b, d);
    if (!before || !behind) return std::nullopt;
    return Chord{a - d * *before, b + d * *behind};
}

struct Swing {
    std::uint32_t stroke;
    DoorSwing door;
};

/// Swings that bridge alone, or in twos whose free ends meet.
void swing_chords(const std::vector<SheetStroke>& strokes, const Solids& solids, std::vector<bool>& used,
                  std::vector<Chord>& chords) {
    std::vector<Swing> swings;
    for (std::uint32_t k = 0; k < strokes.size(); ++k)
        if (!used[k])
            if (const auto door = door_swing(strokes[k])) swings.push_back({k, *door});
    const auto take = [&](std::optional<Chord> chord, std::initializer_list<std::uint32_t> of) {
        if (!chord) return false;
        chord->swings = true;
        chords.push_back(*chord);
        for (const std::uint32_t k : of) used[k] = true;
        return true;
    };
    for (std::size_t i = 0; i < swings.size(); ++i) {
        const DoorSwing& one = swings[i].door;
        if (used[swings[i].stroke]) continue;
        if (take(bridging(one.hinge, one.a, jamb, solids), {swings[i].stroke}) ||
            take(bridging(one.hinge, one.b, jamb, solids), {swings[i].stroke}))
            continue;
        for (std::size_t j = i + 1; j < swings.size() && !used[swings[i].stroke]; ++j) {
            const DoorSwing& other = swings[j].door;
            if (used[swings[j].stroke] || distance(one.hinge, other.hinge) > most_width) continue;
            for (const Point mine : {one.a, one.b})
                for (const Point its : {other.a, other.b})
                    if (!used[swings[i].stroke] && distance(mine, its) < touching &&
                        distance((mine + its) * 0.5, one.hinge, other.hinge) < touching)
                        take(bridging(one.hinge, other.hinge, jamb, solids), {swings[i].stroke, swings[j].stroke});
        }
    }
}

/// Lines of doors that hang together.
using Leaf = std::vector<std::uint32_t>;

std::vector<Leaf> leaves_of(const std::vector<SheetStroke>& strokes, const std::vector<bool>& used) {
    std::vector<std::uint32_t> lines;
    std::vector<Point> hinges;
    for (std::uint32_t k = 0; k < strokes.size(); ++k) {
        if (strokes[k].role != Role::Door) continue;
        if (strokes[k].stroke.bulge == 0 && !used[k]) lines.push_back(k);
        if (const auto swing = door_swing(strokes[k])) hinges.push_back(swing->hinge);
    }
    // Each line joins those near its ends.
    std::vector<PlanBox> boxes;
    for (const std::uint32_t k : lines) {
        PlanBox box;
        box.add(strokes[k].stroke.a);
        box.add(strokes[k].stroke.b);
        boxes.push_back(box.grown(touching));
    }
    DisjointSets hanging(lines.size());
    if (!boxes.empty()) {
        const BoxIndex index(boxes);
        for (std::uint32_t i = 0; i < lines.size(); ++i)
            for (const Point end : {strokes[lines[i]].stroke.a, strokes[lines[i]].stroke.b})
                index.near(end, [&](std::uint32_t j) {
                    const Stroke& other = strokes[lines[j]].stroke;
                    if (distance(end, other.a, other.b) < touching) hanging.join(i, j);
                });
    }
    std::vector<Leaf> leaves(lines.size());
    for (std::uint32_t i = 0; i < lines.size(); ++i) leaves[hanging.find(i)].push_back(lines[i]);
    std::erase_if(leaves, [&](const Leaf& leaf) {
        // What hangs on the hinge of a swing is its leaf.
        return leaf.size() < 2 || std::any_of(hinges.begin(), hinges.end(), [&](Point hinge) {
                   return std::any_of(leaf.begin(), leaf.end(), [&](std::uint32_t k) {
                       return distance(hinge, strokes[k].stroke.a, strokes[k].stroke.b) < touching;
                   });
               });
    });
    return leaves;
}

/// A leaf, or several in a row, along a direction; `v` is the line on which they hang.
struct Row {
    double u0 = 0;
    double u1 = 0;
    double v = 0;
    std::vector<std::uint32_t> lines;
};

Row row_of(const Leaf& leaf, Point dir, const std::vector<SheetStroke>& strokes, double& depth) {
    Row row{HUGE_VAL, -HUGE_VAL, 0, leaf};
    double v0 = HUGE_VAL, v1 = -HUGE_VAL;
    std::vector<Point> ends;  // u, v
    for (const std::uint32_t k : leaf)
        for (const Point p : {strokes[k].stroke.a, strokes[k].stroke.b}) {
            ends.push_back({dot(dir, p), dot(turned_left(dir), p)});
            row.u0 = std::min(row.u0, ends.back().x), row.u1 = std::max(row.u1, ends.back().x);
            v0 = std::min(v0, ends.back().y), v1 = std::max(v1, ends.back().y);
        }
    depth = v1 - v0;
    row.v = (v0 + v1) / 2;
    if (depth < touching) return row;
    // Folded leaves begin and end on the line on which they hang.
    double sum = 0;
    int count = 0;
    for (const Point end : ends)
        if (end.x < row.u0 + 0.03 || end.x > row.u1 - 0.03) sum += end.y, ++count;
    row.v = sum / count < row.v ? v0 : v1;
    return row;
}

void row_chords(const std::vector<SheetStroke>& strokes, Point dir, const Solids& solids, std::vector<bool>& used,
                std::vector<Chord>& chords) {
    std::vector<Row> rows;
    for (const Leaf& leaf : leaves_of(strokes, used)) {
        double depth = 0;
        const Row row = row_of(leaf, dir, strokes, depth);
        if (depth < deepest_row && row.u1 - row.u0 > 0.2) rows.push_back(row);
    }
    std::stable_sort(rows.begin(), rows.end(), [](const Row& l, const Row& r) { return l.u0 < r.u0; });
    const auto at = [&](double u, double v) { return dir * u + turned_left(dir) * v; };
    std::vector<bool> done(rows.size(), false);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (done[i]) continue;
        Row row = rows[i];
        for (std::size_t j = i + 1; j < rows.size() && rows[j].u0 < row.u1 + in_a_row; ++j) {
            if (done[j] || std::abs(rows[j].v - row.v) > touching) continue;
            if (rows[j].u0 > row.u1 && solids(at((row.u1 + rows[j].u0) / 2, row.v))) break;
            done[j] = true;
            row.u1 = std::max(row.u1, rows[j].u1);
            row.lines.insert(row.lines.end(), rows[j].lines.begin(), rows[j].lines.end());
        }
        if (const auto chord = bridging(at(row.u0, row.v), at(row.u1, row.v), beside_row, solids)) {
            chords.push_back(*chord);
            for (const std::uint32_t k : row.lines) used[k] = true;
        }
    }
}

/// The direction in which most of the walls run, and the one across.
std::optional<Point> main_direction(const std::vector<WallRun>& runs) {
    constexpr int bins = 180;
    std::vector<double> length(bins, 0);
    std::vector<Point> sum(bins, Point{0, 0});
    for (const WallRun& run : runs) {
        Point d = run.end - run.start;
        if (d.x < 0 || (d.x == 0 && d.y < 0)) d = d * -1;
        if (norm(d) < 1e-6) continue;
        double angle = std::atan2(d.y, d.x) * bins / std::acos(-1.0);  // [-90, 90]
        if (angle < 0) angle += bins / 2.0, d = turned_left(d);
        const auto bin = std::size_t(std::clamp(int(angle + 0.5), 0, bins - 1)) % (bins / 2);
        if (bin == 0 && d.y > d.x) d = turned_left(d) * -1;
        length[bin] += norm(d);
        sum[bin] = sum[bin] + d;
    }
    const auto most = std::max_element(length.begin(), length.end());
    if (most == length.end() || *most <= 0) return std::nullopt;
    const Point d = sum[std::size_t(most - length.begin())];
    return d * (1 / norm(d));
}

}  // namespace

void add_door_screens(std::vector<WallRun>& runs, const std::vector<SheetStroke>& strokes,
                      const std::vector<WallMass>& masses, std::vector<bool>& used) {
    const Solids solids(runs, masses);
    std::vector<Chord> chords;
    swing_chords(strokes, solids, used, chords);
    if (const auto dir = main_direction(runs))
        for (const Point d : {*dir, turned_left(*dir)}) row_chords(strokes, d, solids, used, chords);
    const std::vector<WallRun> found = runs;
    for (const Chord& chord : chords) {
        WallRun run;
        run.thickness = thickness;
        const double width = distance(chord.a, chord.b);
        const Point d = (chord.b - chord.a) * (1 / width);
        run.start = chord.a;
        run.end = chord.b;
        // Into what it shuts against: to the axis of a wall across, else a little.
        for (const bool at_end : {false, true}) {
            double ahead = 0.1;
            for (const WallRun& other : found) {
                const auto met = meeting(run, at_end, other);
                if (!met || met->sine < 0.3 || met->beyond > other.thickness / 2 + thickness) continue;
                if (met->ahead > 0 && met->ahead < other.thickness / 2 / met->sine + 0.06)
                    ahead = std::max(ahead, met->ahead);
            }
            move_end(run, at_end, ahead);
        }
        const double from = dot(chord.a - run.start, d);
        run.openings.push_back({OpeningKind::Door, {}, from, from + width, {}, {}, chord.swings});
        runs.push_back(std::move(run));
    }
}

}  // namespace enfilade::plans

// Walls with two heights, cut across their axis into steps: the modeler knows level tops only.

#include <algorithm>
#include <cmath>
#include <compare>
#include <unordered_map>

#include "plans/clean_steps.h"

namespace enfilade::plans {
namespace {

constexpr double kShortestStep = 0.05;  ///< m along the axis

bool sloped(const Wall& wall) { return std::abs(wall.height_at_end - wall.height_at_start) > level_tops; }

/// What an opening takes of its wall, along the axis.
struct Span {
    double from = 0;
    double to = 0;
    friend auto operator<=>(const Span&, const Span&) = default;
};

bool inside_any(const std::vector<Span>& spans, double at) {
    return std::any_of(spans.begin(), spans.end(), [&](const Span& s) { return s.from < at && at < s.to; });
}

/// The place nearest to `at` that cuts through no opening; negative where there is none.
double free_place(double at, double length, const std::vector<Span>& spans) {
    if (!inside_any(spans, at)) return at;
    double best = -1;
    for (const Span& span : spans)
        for (const double place : {span.from - end_margin, span.to + end_margin, span.from, span.to}) {
            if (place < kShortestStep || place > length - kShortestStep || inside_any(spans, place)) continue;
            if (best < 0 || std::abs(place - at) < std::abs(best - at) - same_length) best = place;
        }
    return best;
}

/// Where the wall is cut, along its axis, from 0 to its length.
std::vector<double> cuts(double length, double rise, double step, const std::vector<Span>& spans) {
    const double most = std::max(1.0, std::floor(length / kShortestStep));
    const double count = std::clamp(std::ceil(rise / step - 1e-9), 1.0, most);
    std::vector<double> at{0};
    for (double k = 1; k < count; ++k) {
        const double place = free_place(length * k / count, length, spans);
        if (place >= 0) at.push_back(place);
    }
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end(), [](double l, double r) { return r - l < kShortestStep / 2; }), at.end());
    at.push_back(length);
    return at;
}

std::string fresh_id(const std::string& wish, std::unordered_set<std::string>& ids) {
    std::string id = wish;
    while (!ids.insert(id).second) id += '+';
    return id;
}

/// Textures begin at the start of their wall: of a piece that begins `along` behind it they are moved back.
void go_on(Wall& piece, double along) {
    if (piece.left_texture) piece.left_texture->offset_x += along / piece.left_texture->width;
    if (piece.right_texture) piece.right_texture->offset_x -= along / piece.right_texture->width;
}

/// The pieces of a sloped wall, each as high as the wall's middle over it: the volume stays.
std::vector<Wall> pieces_of(const Wall& wall, const std::vector<double>& at, std::unordered_set<std::string>& ids) {
    const WallAxis axis = axis_of(wall);
    std::vector<Wall> pieces;
    for (std::size_t k = 0; k + 1 < at.size(); ++k) {
        const double from = at[k] / axis.length();
        const double to = at[k + 1] / axis.length();
        Wall piece = wall;
        if (at.size() > 2) piece.id = fresh_id(wall.id + "/" + std::to_string(k + 1), ids);
        piece.start = k == 0 ? wall.start : axis.at(from);
        piece.end = k + 2 == at.size() ? wall.end : axis.at(to);
        piece.arc_extent = wall.arc_extent * (to - from);
        piece.height_at_start = piece.height_at_end =
            wall.height_at_start + (wall.height_at_end - wall.height_at_start) * (from + to) / 2;
        go_on(piece, at[k]);
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

Finding cut_finding(const Wall& wall, const std::vector<double>& at, const Storey& storey) {
    const WallAxis axis = axis_of(wall);
    Finding finding = about("P217", Severity::Warning, "wall", wall, storey, axis.at(0.5));
    double largest = 0;
    double moved = 0;  // volume: each step stands above the slope on one half and below it on the other
    const double slope = std::abs(wall.height_at_end - wall.height_at_start) / axis.length();
    for (std::size_t k = 0; k + 1 < at.size(); ++k) {
        const double run = at[k + 1] - at[k];
        largest = std::max(largest, run * slope);
        moved += wall.thickness * run * run * slope / 4;
    }
    const std::size_t count = at.size() - 1;
    finding.sentence = named("Wall", wall, storey) + " slopes from " + metres_text(wall.height_at_start) + " to " +
                       metres_text(wall.height_at_end) + ": it is built as " + std::to_string(count) +
                       (count > 1 ? " level steps" : " level piece") + ", " + rounded_text(moved, 4) +
                       " m3 of it moved.";
    finding.hint =
        "Finer steps follow the slope more closely (--step-mm); several walls of level height place them where you "
        "want.";
    finding.moved_mm = largest / 2 * 1000;
    return finding;
}

}  // namespace

bool cut_slopes(Storey& storey, double step, std::unordered_set<std::string>& ids, CleanReport& report) {
    if (std::none_of(storey.walls.begin(), storey.walls.end(), sloped)) return false;
    std::unordered_map<std::string, std::vector<std::size_t>> openings_of;
    for (std::size_t o = 0; o < storey.openings.size(); ++o) openings_of[storey.openings[o].wall].push_back(o);

    std::vector<Wall> walls;
    for (const Wall& wall : storey.walls) {
        if (!sloped(wall)) {
            walls.push_back(wall);
            continue;
        }
        const double length = axis_of(wall).length();
        std::vector<Span> spans;
        const auto hosted = openings_of.find(wall.id);
        if (hosted != openings_of.end())
            for (const std::size_t o : hosted->second) {
                const Opening& opening = storey.openings[o];
                spans.push_back({opening.offset - opening.width / 2, opening.offset + opening.width / 2});
            }
        std::sort(spans.begin(), spans.end());
        const std::vector<double> at = cuts(length, std::abs(wall.height_at_end - wall.height_at_start), step, spans);
        const std::vector<Wall> pieces = pieces_of(wall, at, ids);
        if (hosted != openings_of.end())
            for (const std::size_t o : hosted->second) {
                Opening& opening = storey.openings[o];
                const auto next = std::upper_bound(at.begin() + 1, at.end() - 1, opening.offset);
                const std::size_t k = std::size_t(next - at.begin()) - 1;
                opening.wall = pieces[k].id;
                opening.offset -= at[k];
            }
        report.add(cut_finding(wall, at, storey));
        walls.insert(walls.end(), pieces.begin(), pieces.end());
    }
    storey.walls = std::move(walls);
    return true;
}

}  // namespace enfilade::plans

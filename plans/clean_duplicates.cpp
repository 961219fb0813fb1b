// Walls drawn twice: in two levels made one, or one over the other.

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "plans/box_index.h"
#include "plans/clean_steps.h"

namespace enfilade::plans {
namespace {

constexpr double kSamePlace = 0.001;  ///< m

enum class Match { None, Same, Reversed };

Match match(const Wall& wall, const Wall& other) {
    const auto same = [](Point a, Point b) { return distance(a, b) <= kSamePlace; };
    if (!same(axis_of(wall).at(0.5), axis_of(other).at(0.5))) return Match::None;
    if (same(wall.start, other.start) && same(wall.end, other.end)) return Match::Same;
    if (same(wall.start, other.end) && same(wall.end, other.start)) return Match::Reversed;
    return Match::None;
}

/// Whether `wall` lies within `kept` wholly.
bool covered(const Wall& wall, const Wall& kept, Match how) {
    const double start = how == Match::Same ? kept.height_at_start : kept.height_at_end;
    const double end = how == Match::Same ? kept.height_at_end : kept.height_at_start;
    return wall.thickness <= kept.thickness + same_length && wall.height_at_start <= start + same_length &&
           wall.height_at_end <= end + same_length;
}

/// Larger walls first: what they cover goes.
std::vector<std::uint32_t> by_size(const std::vector<Wall>& walls) {
    std::vector<std::uint32_t> order(walls.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto height = [&](std::uint32_t w) { return walls[w].height_at_start + walls[w].height_at_end; };
    std::sort(order.begin(), order.end(), [&](std::uint32_t l, std::uint32_t r) {
        if (walls[l].thickness != walls[r].thickness) return walls[l].thickness > walls[r].thickness;
        if (height(l) != height(r)) return height(l) > height(r);
        return walls[l].id < walls[r].id;
    });
    return order;
}

BoxIndex index_middles(const std::vector<Wall>& walls) {
    std::vector<PlanBox> boxes(walls.size());
    for (std::size_t w = 0; w < walls.size(); ++w) {
        boxes[w].add((walls[w].start + walls[w].end) * 0.5);
        boxes[w] = boxes[w].grown(2 * kSamePlace);
    }
    return BoxIndex(boxes);
}

struct Heir {
    std::uint32_t wall = UINT32_MAX;
    Match how = Match::None;
};

/// The openings of `wall` go over to its heir, and the colours and textures where that has none.
void inherit(const Wall& wall, Wall& heir, Match how, const std::vector<std::uint32_t>& openings, Storey& storey) {
    const bool reversed = how == Match::Reversed;
    const auto& left = reversed ? wall.right_colour : wall.left_colour;
    const auto& right = reversed ? wall.left_colour : wall.right_colour;
    if (!heir.left_colour) heir.left_colour = left;
    if (!heir.right_colour) heir.right_colour = right;
    if (!heir.left_texture) heir.left_texture = reversed ? wall.right_texture : wall.left_texture;
    if (!heir.right_texture) heir.right_texture = reversed ? wall.left_texture : wall.right_texture;
    for (const std::uint32_t o : openings) {
        Opening& opening = storey.openings[o];
        opening.wall = heir.id;
        if (!reversed) continue;
        opening.offset = axis_of(heir).length() - opening.offset;
        std::swap(opening.depth_left, opening.depth_right);
    }
}

}  // namespace

bool drop_duplicate_walls(Storey& storey, CleanReport& report) {
    std::vector<Wall>& walls = storey.walls;
    if (walls.size() < 2) return false;
    const BoxIndex middles = index_middles(walls);
    std::vector<bool> keep(walls.size(), false);
    std::vector<std::pair<std::uint32_t, Heir>> dropped;
    for (const std::uint32_t w : by_size(walls)) {
        Heir heir;
        middles.near((walls[w].start + walls[w].end) * 0.5, [&](std::uint32_t k) {
            if (!keep[k] || (heir.wall != UINT32_MAX && walls[heir.wall].id < walls[k].id)) return;
            const Match how = match(walls[w], walls[k]);
            if (how != Match::None && covered(walls[w], walls[k], how)) heir = {k, how};
        });
        keep[w] = heir.wall == UINT32_MAX;
        if (!keep[w]) dropped.push_back({w, heir});
    }
    if (dropped.empty()) return false;

    std::unordered_map<std::string, std::vector<std::uint32_t>> openings_of;
    for (std::uint32_t o = 0; o < storey.openings.size(); ++o) openings_of[storey.openings[o].wall].push_back(o);
    for (const auto& [w, heir] : dropped) {
        Finding finding = about("P214", Severity::Warning, "wall", walls[w], storey, axis_of(walls[w]).at(0.5));
        finding.elements.push_back({"wall", walls[heir.wall].id, walls[heir.wall].name});
        finding.sentence = named("Wall", walls[w], storey) + " lies on wall " + called(walls[heir.wall]) +
                           ", and was left out; its openings stand in that one.";
        finding.hint = "Remove one of the two from the plan.";
        report.add(std::move(finding));
        inherit(walls[w], walls[heir.wall], heir.how, openings_of[walls[w].id], storey);
    }
    std::size_t k = 0;
    std::erase_if(walls, [&](const Wall&) { return !keep[k++]; });
    return true;
}

}  // namespace enfilade::plans

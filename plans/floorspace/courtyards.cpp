#include "plans/floorspace/courtyards.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

/// A piece in one of its directions: 2 * piece, + 1 from b to a.
using HalfPiece = std::uint32_t;

class CourtyardFinder {
public:
    CourtyardFinder(const FloorStory& story, const FloorSpaces& spaces, const FloorGraph& graph)
        : graph_(graph), spaces_(spaces), left_(2 * graph.pieces.size(), false), index_(boxes_of(spaces)) {
        for (const FloorOutline& outline : spaces.outlines)
            for (const FloorSide side : story.faces[story.spaces[outline.space].face].sides)
                for (const FloorPieceUse use : graph.of_edge[side.edge]) cover(outline, use.piece);
    }

    std::vector<FloorCourtyard> find(double least_width) {
        std::vector<FloorCourtyard> courtyards;
        std::vector<bool> done(left_.size(), false);
        for (HalfPiece first = 0; first < left_.size(); ++first) {
            if (done[first] || !borders(first)) continue;
            FloorCourtyard courtyard;
            double twice = 0;
            double around = 0;
            bool empty = true;
            HalfPiece here = first;
            do {  // with a space on the left and, it seems, none on the right
                done[here] = true;
                const Point a = graph_.nodes[start(here)];
                const Point b = graph_.nodes[end(here)];
                const Point origin = graph_.nodes[start(first)];
                twice += cross(a - origin, b - origin);
                around += distance(a, b);
                empty = empty && nothing_right_of(a, b);
                courtyard.corners.push_back(a);
                here = next(here);
            } while (here != no_floor_item && !done[here]);
            if (here != first || twice >= 0 || !empty) continue;
            courtyard.area = -twice / 2;
            if (2 * courtyard.area / around < least_width) continue;
            std::reverse(courtyard.corners.begin(), courtyard.corners.end());
            courtyards.push_back(std::move(courtyard));
        }
        return courtyards;
    }

private:
    static std::vector<PlanBox> boxes_of(const FloorSpaces& spaces) {
        std::vector<PlanBox> boxes;
        for (const FloorOutline& outline : spaces.outlines) boxes.push_back(outline.box);
        return boxes;
    }

    [[nodiscard]] std::uint32_t start(HalfPiece h) const {
        return h % 2 == 0 ? graph_.pieces[h / 2].a : graph_.pieces[h / 2].b;
    }
    [[nodiscard]] std::uint32_t end(HalfPiece h) const { return start(h ^ 1); }
    [[nodiscard]] bool borders(HalfPiece h) const { return left_[h] && !left_[h ^ 1]; }

    void cover(const FloorOutline& outline, std::uint32_t piece) {
        const Point a = graph_.nodes[graph_.pieces[piece].a];
        const Point b = graph_.nodes[graph_.pieces[piece].b];
        const Point aside = turned_left(b - a) * (2 * floor_tolerance / distance(a, b));
        const bool on_left = within((a + b) * 0.5 + aside, outline);
        left_[2 * piece + (on_left ? 0 : 1)] = true;
    }

    [[nodiscard]] bool nothing_right_of(Point a, Point b) const {
        const Point aside = turned_left(b - a) * (2 * floor_tolerance / distance(a, b));
        const Point p = (a + b) * 0.5 - aside;
        bool empty = true;
        index_.near(p, [&](std::uint32_t o) { empty = empty && !within(p, spaces_.outlines[o]); });
        return empty;
    }

    /// The next one around the place on the right: the first counter-clockwise from where this one came.
    [[nodiscard]] HalfPiece next(HalfPiece h) const {
        const std::uint32_t node = end(h);
        const Point back = graph_.nodes[start(h)] - graph_.nodes[node];
        HalfPiece best = no_floor_item;
        double best_turn = 0;
        for (const std::uint32_t piece : graph_.at_node[node]) {
            const HalfPiece out = 2 * piece + (graph_.pieces[piece].a == node ? 0 : 1);
            if (!borders(out)) continue;
            const Point d = graph_.nodes[end(out)] - graph_.nodes[node];
            double turn = std::atan2(cross(back, d), dot(back, d));
            if (turn <= 0) turn += 2 * std::numbers::pi;
            if (best != no_floor_item && turn >= best_turn) continue;
            best = out;
            best_turn = turn;
        }
        return best;
    }

    const FloorGraph& graph_;
    const FloorSpaces& spaces_;
    std::vector<bool> left_;  ///< [half pieces] a space lies on the left of it
    BoxIndex index_;
};

}  // namespace

std::vector<FloorCourtyard> find_courtyards(const FloorStory& story, const FloorSpaces& spaces, const FloorGraph& graph,
                                            double least_width) {
    return CourtyardFinder(story, spaces, graph).find(least_width);
}

}  // namespace enfilade::plans

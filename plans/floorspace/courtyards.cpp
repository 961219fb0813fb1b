#include "plans/floorspace/courtyards.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

std::vector<PlanBox> boxes_of(const FloorSpaces& spaces) {
    std::vector<PlanBox> boxes;
    for (const FloorOutline& outline : spaces.outlines) boxes.push_back(outline.box);
    return boxes;
}

bool lies_in_space(Point p, const FloorSpaces& spaces, const BoxIndex& index) {
    bool in = false;
    index.near(p, [&](std::uint32_t o) { in = in || within(p, spaces.outlines[o]); });
    return in;
}

/// A piece in one of its directions: 2 * piece, + 1 from b to a.
using HalfPiece = std::uint32_t;

class VoidFinder {
public:
    VoidFinder(const FloorStory& story, const FloorSpaces& spaces, const FloorGraph& graph)
        : graph_(graph), spaces_(spaces), left_(2 * graph.pieces.size(), false), index_(boxes_of(spaces)) {
        for (const FloorOutline& outline : spaces.outlines)
            for (const FloorSide side : story.faces[story.spaces[outline.space].face].sides)
                for (const FloorPieceUse use : graph.of_edge[side.edge]) cover(outline, use.piece);
    }

    FloorVoids find(double least_width) {
        FloorVoids voids;
        for (HalfPiece h = 0; h < left_.size(); ++h)
            if (borders(h) && nothing_at(right_of(h))) voids.beside.push_back(right_of(h));
        std::vector<bool> done(left_.size(), false);
        for (HalfPiece first = 0; first < left_.size(); ++first)
            if (!done[first] && borders(first)) go_around(first, least_width, done, voids.courtyards);
        return voids;
    }

private:
    /// Follows the sides with a space on the left and, it seems, none on the right.
    void go_around(HalfPiece first, double least_width, std::vector<bool>& done,
                   std::vector<FloorCourtyard>& courtyards) const {
        FloorCourtyard courtyard;
        FloorOutline& outline = courtyard.outline;
        const Point origin = graph_.nodes[start(first)];
        double twice = 0;
        bool empty = true;
        HalfPiece here = first;
        do {
            done[here] = true;
            const Point a = graph_.nodes[start(here)];
            const Point b = graph_.nodes[end(here)];
            twice += cross(a - origin, b - origin);
            outline.perimeter += distance(a, b);
            courtyard.beside.push_back(right_of(here));
            empty = empty && nothing_at(courtyard.beside.back());
            outline.corners.push_back(a);
            outline.box.add(a);
            here = next(here);
        } while (here != no_floor_item && !done[here]);
        if (here != first || twice >= 0 || !empty) return;
        outline.area = -twice / 2;
        courtyard.narrow = 2 * outline.area / outline.perimeter < least_width;
        std::reverse(outline.corners.begin(), outline.corners.end());
        courtyards.push_back(std::move(courtyard));
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

    [[nodiscard]] Point right_of(HalfPiece h) const {
        const Point a = graph_.nodes[start(h)];
        const Point b = graph_.nodes[end(h)];
        return (a + b) * 0.5 - turned_left(b - a) * (2 * floor_tolerance / distance(a, b));
    }
    [[nodiscard]] bool nothing_at(Point p) const { return !lies_in_space(p, spaces_, index_); }

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

FloorVoids find_voids(const FloorStory& story, const FloorSpaces& spaces, const FloorGraph& graph, double least_width) {
    return VoidFinder(story, spaces, graph).find(least_width);
}

void find_covered(const std::vector<FloorSpaces>& spaces, std::vector<FloorVoids>& voids) {
    for (std::size_t k = voids.size() - 1; k-- > 0;) {
        const BoxIndex index(boxes_of(spaces[k + 1]));
        const FloorVoids& above = voids[k + 1];
        const auto under_the_sky = [&](Point p) {
            if (lies_in_space(p, spaces[k + 1], index)) return false;
            for (const FloorCourtyard& courtyard : above.courtyards)
                if (within(p, courtyard.outline)) return !courtyard.covered && !courtyard.narrow;
            return true;  // beside the spaces above
        };
        for (FloorCourtyard& courtyard : voids[k].courtyards) {
            const auto in_it = [&](Point p) { return within(p, courtyard.outline) && under_the_sky(p); };
            courtyard.covered = std::none_of(courtyard.beside.begin(), courtyard.beside.end(), under_the_sky) &&
                                std::none_of(above.beside.begin(), above.beside.end(), in_it);
        }
    }
}

}  // namespace enfilade::plans

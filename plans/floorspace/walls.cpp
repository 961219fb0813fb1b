#include "plans/floorspace/walls.h"

#include <algorithm>
#include <cmath>

#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double thinnest = 0.02;   ///< metres; 1 cm is the least that constraint G6 lets pass
constexpr double straight = 1e-4;   ///< metres that a node of a wall may lie beside its axis
constexpr double most_taken = 0.5;  ///< metres that a wall can take up at the end of another, at sharp corners

class WallMaker {
public:
    WallMaker(const FloorStory& story, const FloorSpaces& spaces, const FloorGraph& graph, double thickness)
        : graph_(graph), thickness_(graph.pieces.size(), thickness) {
        for (std::uint32_t o = 0; o < spaces.outlines.size(); ++o) {
            const FloorOutline& outline = spaces.outlines[o];
            const double fits = outline.area / outline.perimeter;
            if (fits >= thickness) continue;
            (fits < thinnest ? result_.lost : result_.thinned).push_back(o);
            for (const FloorSide side : story.faces[story.spaces[outline.space].face].sides)
                for (const FloorPieceUse use : graph.of_edge[side.edge])
                    thickness_[use.piece] =
                        std::min(thickness_[use.piece], std::max(fits, std::min(thinnest, thickness)));
        }
        result_.of_piece.assign(graph.pieces.size(), {no_floor_item, 0, true});
    }

    FloorWalls make() {
        for (std::uint32_t p = 0; p < graph_.pieces.size(); ++p)
            if (result_.of_piece[p].wall == no_floor_item) make_wall(p);
        for (std::uint32_t p = 0; p < graph_.pieces.size(); ++p) {
            take_up(p, graph_.pieces[p].a);
            take_up(p, graph_.pieces[p].b);
        }
        return std::move(result_);
    }

private:
    [[nodiscard]] std::uint32_t other_end(std::uint32_t piece, std::uint32_t node) const {
        return graph_.pieces[piece].a == node ? graph_.pieces[piece].b : graph_.pieces[piece].a;
    }

    /// Goes on from a node straight ahead as far as nothing else ends there; returns the last node, and puts the
    /// pieces passed behind `chain`.
    std::uint32_t extend(std::uint32_t node, Point base, Point direction, std::vector<std::uint32_t>& chain) {
        for (;;) {
            const std::vector<std::uint32_t>& here = graph_.at_node[node];
            if (here.size() != 2) return node;
            const std::uint32_t next = here[0] == chain.back() ? here[1] : here[0];
            const std::uint32_t ahead = other_end(next, node);
            const Point to = graph_.nodes[ahead];
            if (result_.of_piece[next].wall != no_floor_item || thickness_[next] != thickness_[chain.back()] ||
                !(dot(to - graph_.nodes[node], direction) > 0) || std::abs(cross(to - base, direction)) > straight)
                return node;
            result_.of_piece[next].wall = std::uint32_t(result_.walls.size());
            chain.push_back(next);
            node = ahead;
        }
    }

    void make_wall(std::uint32_t piece) {
        const FloorPiece& seed = graph_.pieces[piece];
        const auto number = std::uint32_t(result_.walls.size());
        const Point base = graph_.nodes[seed.a];
        const Point direction = (graph_.nodes[seed.b] - base) * (1 / graph_.length(piece));
        result_.of_piece[piece].wall = number;
        std::vector<std::uint32_t> before{piece};
        std::vector<std::uint32_t> behind{piece};
        const std::uint32_t first = extend(seed.a, base, direction * -1, before);
        const std::uint32_t last = extend(seed.b, base, direction, behind);
        FloorWall wall{seed.edge, graph_.nodes[first], graph_.nodes[last], thickness_[piece], 0, 0};
        before.insert(before.end(), behind.begin() + 1, behind.end());
        const Point along = (wall.end - wall.start) * (1 / distance(wall.start, wall.end));
        for (const std::uint32_t p : before) {
            const Point a = graph_.nodes[graph_.pieces[p].a];
            const Point b = graph_.nodes[graph_.pieces[p].b];
            result_.of_piece[p] = {number, dot(a - wall.start, along), dot(b - a, along) > 0};
            wall.edge = std::min(wall.edge, graph_.pieces[p].edge);
        }
        result_.walls.push_back(wall);
    }

    /// What the walls that meet a piece's wall at a node take up of it.
    void take_up(std::uint32_t piece, std::uint32_t node) {
        const std::uint32_t w = result_.of_piece[piece].wall;
        FloorWall& wall = result_.walls[w];
        const Point here = graph_.nodes[node];
        const Point d = graph_.nodes[other_end(piece, node)] - here;
        double taken = 0;
        for (const std::uint32_t p : graph_.at_node[node]) {
            if (p == piece || result_.of_piece[p].wall == w) continue;
            const Point e = graph_.nodes[other_end(p, node)] - here;
            const double size = norm(d) * norm(e);
            const double sine = std::abs(cross(d, e)) / size;
            const double cosine = dot(d, e) / size;
            const double half = thickness_[p] / 2;
            if (sine < 0.05) continue;  // straight on, or along it: there is no corner
            // Where the faces on the inner side of the corner meet; at a blunt corner the other's end is nearer.
            const double inner = (half + cosine * wall.thickness / 2) / sine;
            taken = std::max(taken, cosine < 0 ? std::min(inner, half) : inner);
        }
        taken = std::min(taken, most_taken);
        const bool at_start = distance(here, wall.start) < distance(here, wall.end);
        double& at = at_start ? wall.taken_at_start : wall.taken_at_end;
        at = std::max(at, taken);
    }

    const FloorGraph& graph_;
    std::vector<double> thickness_;  ///< [pieces]
    FloorWalls result_;
};

}  // namespace

FloorWalls make_walls(const FloorStory& story, const FloorSpaces& spaces, const FloorGraph& graph, double thickness) {
    return WallMaker(story, spaces, graph, thickness).make();
}

}  // namespace enfilade::plans

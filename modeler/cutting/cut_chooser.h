#pragma once
// Which cuts make a polygon convex at least cost.

#include <array>
#include <queue>
#include <span>
#include <vector>

#include "modeler/cutting/sight.h"
#include "modeler/cutting/subdivision.h"

namespace enfilade::modeler {

/// What a cut costs besides its length, in grid units of length: the sections that it adds.
struct CutPrice {
    double cut = 0;       ///< each
    double new_node = 0;  ///< where it ends in the middle of a side or a cut
};

/// Cuts a polygon at its reflex corners, greedily, looking ahead: each cut is judged by its own price and by what it
/// saves of the cheapest cuts at the corners that are still open (README.md, "Which cut next").
class CutChooser {
public:
    /// `exact`: cuts end in the middle of sides and of other cuts only at points of the grid that lie on them.
    CutChooser(std::span<const plans::GridPoint> points, std::span<const PolygonSide> sides, CutPrice price,
               bool exact);

    /// Makes cuts until no corner is open, or none that is can be closed by a cut.
    void run();

    [[nodiscard]] Subdivision& subdivision() { return subdivision_; }
    [[nodiscard]] std::uint32_t moved() const { return moved_; }

private:
    struct Corner {
        std::uint32_t point;
        std::uint32_t start;  ///< half-edge of the triangles along the side that leaves
        Direction in, out;    ///< of the edges between which it is reflex
        std::uint32_t line_in, line_out;
        bool open = true;
        double cheapest = 0;
        std::vector<std::uint32_t> candidates;
    };
    struct Candidate {
        std::uint32_t corner;
        Direction d;
        std::uint32_t wanted_line;  ///< of the side that it should prolong; `no_index` for others
        std::uint32_t line;         ///< the same where it goes on straight enough
        std::uint32_t version = 0;
        bool alive = false;
        std::uint32_t looked_at = 0;  ///< cuts made before
        bool is_moved = false;        ///< from where it would have passed a point too closely
        double cost = 0;
        Hit hit;
        std::vector<std::uint32_t> passed;
    };
    struct Waiting {
        double score, cost;
        std::uint32_t candidate, version;
        friend bool operator<(const Waiting& a, const Waiting& b) {  // the best one on top
            if (a.score != b.score) return a.score > b.score;
            if (a.cost != b.cost) return a.cost > b.cost;
            return a.candidate > b.candidate;
        }
    };

    [[nodiscard]] bool is_small() const;
    void find_corners(std::span<const std::uint32_t> before);
    void find_dominant_direction();
    void find_arcs();
    void add_candidates(std::uint32_t corner);
    void add_fan(std::uint32_t corner);
    void add_pairs();
    void add(std::uint32_t corner, Direction d, std::uint32_t line = no_index);
    void look(std::uint32_t candidate);
    void push(std::uint32_t candidate);
    void accept(std::uint32_t candidate);
    void close(Corner& corner);
    void meet_corners(std::uint32_t point, Direction back, std::uint32_t line);
    void cut_others(const Candidate& made, plans::GridPoint a, plans::GridPoint b);
    void offer_feet(const Candidate& made, plans::GridPoint a, plans::GridPoint b);
    void update_cheapest(Corner& corner);
    [[nodiscard]] bool resolves(const Corner& corner, Direction d, std::uint32_t line) const;
    [[nodiscard]] bool is_on_track(const Hit& hit) const;
    [[nodiscard]] bool prolongs(const Corner& corner, const Candidate& candidate) const;
    [[nodiscard]] Direction nudged(const Corner& corner, const Hit& hit, int units) const;
    [[nodiscard]] double score(const Candidate& candidate);
    /// Calls visit(corner) once for each open corner of the triangles passed.
    template <class Visit>
    void for_each_passed_corner(std::span<const std::uint32_t> passed, Visit visit);
    [[nodiscard]] plans::GridPoint at(std::uint32_t point) const { return subdivision_.point(point); }

    std::span<const PolygonSide> sides_;
    CutPrice price_;
    bool exact_;
    Sight sight_;
    std::vector<std::uint32_t> before_;  ///< [side]
    Subdivision subdivision_;
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> first_corner_;    ///< [point] into corners_
    std::vector<std::uint32_t> next_corner_;     ///< [corner] at the same point
    std::vector<std::vector<Direction>> extra_;  ///< [corner] directions along and across its arc's chord
    std::vector<Candidate> candidates_;
    std::vector<std::vector<std::uint32_t>> seen_from_;  ///< [triangle] candidates that pass it
    std::priority_queue<Waiting> queue_;
    std::vector<std::uint32_t> stamp_;  ///< [corner]
    std::uint32_t stamp_now_ = 0;
    Direction dominant_ = {1, 0};
    std::uint32_t moved_ = 0, cut_count_ = 0;
};

}  // namespace enfilade::modeler

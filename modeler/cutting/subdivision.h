#pragma once
// A polygon while it is cut: half-edges, and the straight tracks (sides and cuts) that they lie on.

#include <cstdint>
#include <span>
#include <vector>

#include "modeler/cutting/polygon.h"
#include "modeler/cutting/triangulation.h"

namespace enfilade::modeler {

/// A side of the polygon or a cut: a chain of half-edges from one end to the other. Cuts that end on a track put a node
/// on it, rounded to the grid, so that the chain may leave the straight line by half a unit.
struct Track {
    std::uint32_t side = no_index;          ///< of the polygon; `no_index`: a cut
    std::uint32_t line = 0;                 ///< as in PolygonSide
    std::vector<std::uint32_t> nodes;       ///< points from end to end
    std::vector<std::uint32_t> half_edges;  ///< [nodes - 1] from a node to the next; the twins run back
    bool removed = false;
};

class Subdivision {
public:
    /// `corner_before`: [side] the side that ends where a side begins, in the same wedge of the polygon.
    Subdivision(std::span<const plans::GridPoint> points, std::span<const PolygonSide> sides,
                std::span<const std::uint32_t> corner_before);

    [[nodiscard]] plans::GridPoint point(std::uint32_t p) const { return points_[p]; }
    [[nodiscard]] const Track& track(std::uint32_t t) const { return tracks_[t]; }
    [[nodiscard]] std::uint32_t track_count() const { return std::uint32_t(tracks_.size()); }
    [[nodiscard]] std::uint32_t first_cut() const { return side_count_; }  ///< tracks from here on are cuts
    [[nodiscard]] std::uint32_t from(std::uint32_t h) const { return from_[h]; }
    [[nodiscard]] std::uint32_t to(std::uint32_t h) const { return from_[next_[h]]; }
    [[nodiscard]] std::uint32_t next(std::uint32_t h) const { return next_[h]; }
    [[nodiscard]] std::uint32_t line(std::uint32_t h) const { return tracks_[track_[h]].line; }
    [[nodiscard]] bool is_removed(std::uint32_t h) const { return next_[h] == no_index; }

    /// The half-edge that leaves `p` into the wedge in which the direction to `towards` lies; `no_index` if it runs
    /// along an edge or out of the polygon.
    [[nodiscard]] std::uint32_t wedge(std::uint32_t p, plans::GridPoint towards) const;

    /// The node of a track that a cut from `eye` to a point of the track would pass closer than `least_gap`; `no_index`
    /// if there is none.
    [[nodiscard]] std::uint32_t node_near(std::uint32_t track, plans::GridPoint eye, plans::GridPoint p) const;
    /// A new node of a track. \pre node_near(track, eye, p) == no_index for any eye
    std::uint32_t add_node(std::uint32_t track, plans::GridPoint p);
    /// Whether all edges of a line at `p` run exactly on from where `from` lies.
    [[nodiscard]] bool meets_line_straight(std::uint32_t from, std::uint32_t p, std::uint32_t line) const;

    /// A cut between two points, which become neighbours: a new track. `no_index` where it would run along an edge.
    std::uint32_t connect(std::uint32_t a, std::uint32_t b, std::uint32_t line);

    /// Whether the ring goes straight on from a half-edge to the next one along it.
    [[nodiscard]] bool is_straight(std::uint32_t in, std::uint32_t out) const;
    /// Takes a cut on which no other ends out again. \pre track(cut).nodes.size() == 2
    void remove(std::uint32_t cut);
    /// Whether the pieces beside such a cut are convex together at its ends.
    [[nodiscard]] bool is_removable(std::uint32_t cut) const;

    /// The rings as they are. Nodes at which nothing ends any more are left out.
    [[nodiscard]] Partition collect(std::span<const PolygonSide> sides) const;

private:
    [[nodiscard]] std::size_t place_on(const Track& track, plans::GridPoint p) const;
    std::uint32_t add_half_edge(std::uint32_t from, std::uint32_t track);
    void join(std::uint32_t in, std::uint32_t out) { next_[in] = out, previous_[out] = in; }
    void drop_node(std::uint32_t p);
    void forget_leaving(std::uint32_t h);

    std::vector<plans::GridPoint> points_;
    std::uint32_t given_point_count_, side_count_;
    std::vector<std::uint32_t> from_, next_, previous_, twin_, track_;  ///< [half-edge]
    std::vector<std::uint32_t> first_leaving_;                          ///< [point]
    std::vector<std::uint32_t> next_leaving_;                           ///< [half-edge]
    std::vector<std::uint32_t> node_track_;                             ///< [point - given] the track it is a node of
    std::vector<Track> tracks_;
};

}  // namespace enfilade::modeler

// Rooms that several polygons share without walls between them, e.g. a kitchen open to the living room.

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/disjoint_sets.h"
#include "plans/room_match.h"

namespace enfilade::plans {
namespace {

class Divider {
public:
    Divider(const RoomOverlay& rooms, const RoomMatch& match, std::int64_t min_area2)
        : rooms_(rooms), match_(match), map_(rooms.overlay.map), graph_(rooms.overlay.graph), min_area2_(min_area2) {}

    std::vector<RoomBorder> run() {
        label_faces();
        drop_small_pieces();
        give_leftovers();
        return borders();
    }

private:
    void label_faces() {
        place_.assign(map_.face_count, kNone);
        label_.assign(map_.face_count, kNone);
        const Cover& cover = rooms_.overlay.cover;
        for (std::uint32_t f = 1; f < map_.face_count; ++f) {
            std::uint32_t polygon = kNone;
            std::uint32_t band = kNone;
            std::uint32_t place = kNone;
            for (std::uint32_t i = cover.first[f]; i < cover.first[f + 1]; ++i) {
                const std::uint32_t region = cover.entries[i].region;
                if (region < rooms_.place_count) {
                    place = region;
                    if (match_.polygons_of_place[place].size() < 2) break;
                    place_[f] = place;
                    continue;
                }
                if (place_[f] == kNone) break;
                const std::uint32_t k = (region - rooms_.place_count) % rooms_.polygon_count;
                if (match_.place_of_polygon[k] != place_[f]) continue;
                if (region < rooms_.place_count + rooms_.polygon_count) {
                    if (polygon == kNone || is_smaller(k, polygon)) polygon = k;
                } else if (band == kNone || is_smaller(band, k)) {
                    band = k;
                }
            }
            label_[f] = polygon != kNone ? polygon : band;
        }
    }

    [[nodiscard]] bool is_smaller(std::uint32_t l, std::uint32_t r) const {
        return std::pair(match_.polygon_area2[l], l) < std::pair(match_.polygon_area2[r], r);
    }

    /// Faces of one place and label, connected.
    [[nodiscard]] std::vector<std::uint32_t> pieces() const {
        DisjointSets faces(map_.face_count);
        for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
            const std::uint32_t l = map_.face(2 * e);
            const std::uint32_t r = map_.face(2 * e + 1);
            if (place_[l] != kNone && place_[l] == place_[r] && label_[l] == label_[r]) faces.join(l, r);
        }
        return faces.lowest();
    }

    /// A label keeps its largest piece, and all that have some size.
    void drop_small_pieces() {
        const std::vector<std::uint32_t> piece = pieces();
        const std::vector<std::int64_t> areas2 = face_areas2(map_);
        std::vector<std::int64_t> size(map_.face_count, 0);
        for (std::uint32_t f = 0; f < map_.face_count; ++f) size[piece[f]] += areas2[f];
        std::vector<std::uint32_t> largest(rooms_.polygon_count, kNone);
        for (std::uint32_t f = 0; f < map_.face_count; ++f)
            if (piece[f] == f && label_[f] != kNone)
                if (std::uint32_t& most = largest[label_[f]]; most == kNone || size[f] > size[most]) most = f;
        for (std::uint32_t f = 0; f < map_.face_count; ++f)
            if (label_[f] != kNone && piece[f] != largest[label_[f]] && size[piece[f]] < min_area2_)
                dropped_.push_back(f);
        for (const std::uint32_t f : dropped_) label_[f] = kNone;
    }

    void give_leftovers() {
        const std::vector<std::uint32_t> piece = pieces();
        struct Contact {
            std::uint32_t piece;
            std::uint32_t label;
            double length;
        };
        std::vector<Contact> contacts;
        for (std::uint32_t e = 0; e < graph_.edges.size(); ++e)
            for (const std::uint32_t h : {2 * e, 2 * e + 1}) {
                const std::uint32_t f = map_.face(h);
                const std::uint32_t other = map_.face(h ^ 1u);
                if (place_[f] == kNone || place_[f] != place_[other] || label_[f] != kNone || label_[other] == kNone)
                    continue;
                const GridPoint a = graph_.vertices[graph_.edges[e].a];
                const GridPoint b = graph_.vertices[graph_.edges[e].b];
                contacts.push_back({piece[f], label_[other], std::hypot(double(b.x) - a.x, double(b.y) - a.y)});
            }
        std::stable_sort(contacts.begin(), contacts.end(), [&](const Contact& l, const Contact& r) {
            return l.piece != r.piece ? l.piece < r.piece : l.label < r.label;
        });
        std::vector<std::uint32_t> heir(map_.face_count, kNone);
        std::vector<double> longest(map_.face_count, 0);
        for (std::size_t i = 0; i < contacts.size();) {
            const Contact& first = contacts[i];
            double length = 0;
            for (; i < contacts.size() && contacts[i].piece == first.piece && contacts[i].label == first.label; ++i)
                length += contacts[i].length;
            if (length <= longest[first.piece]) continue;
            longest[first.piece] = length;
            heir[first.piece] = first.label;
        }
        for (std::uint32_t f = 0; f < map_.face_count; ++f)
            if (place_[f] != kNone && label_[f] == kNone) label_[f] = heir[piece[f]];
    }

    /// Edges between labels, brought together along the side of a polygon on which they lie. A run ends where
    /// borders meet each other or the outline of their place, so that all these points are its ends.
    [[nodiscard]] std::vector<RoomBorder> borders() const {
        struct Piece {
            std::uint32_t side;
            std::uint32_t edge;
        };
        std::vector<Piece> found;
        std::vector<std::uint32_t> meetings(graph_.vertices.size(), 0);
        for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
            const std::uint32_t l = map_.face(2 * e);
            const std::uint32_t r = map_.face(2 * e + 1);
            const NodedEdge& edge = graph_.edges[e];
            if (place_[l] != place_[r]) {
                meetings[edge.a] = meetings[edge.b] = 3;
            } else if (place_[l] != kNone && label_[l] != label_[r]) {
                std::uint32_t side = kNone;
                for (std::uint32_t u = edge.first_use; u < edge.first_use + edge.use_count; ++u)
                    side = std::min(side, rooms_.tags[graph_.uses[u].segment].line);
                found.push_back({side, e});
                ++meetings[edge.a];
                ++meetings[edge.b];
            }
        }
        std::sort(found.begin(), found.end(),
                  [](const Piece& l, const Piece& r) { return l.side != r.side ? l.side < r.side : l.edge < r.edge; });
        std::vector<RoomBorder> result;
        std::uint32_t last = kNone;
        for (const Piece& piece : found) {
            const NodedEdge& edge = graph_.edges[piece.edge];
            if (!result.empty() && result.back().side == piece.side && last == edge.a && meetings[last] == 2)
                result.back().segment.b = graph_.vertices[edge.b];
            else result.push_back({{graph_.vertices[edge.a], graph_.vertices[edge.b]}, piece.side});
            last = edge.b;
        }
        return joined(result, meetings);
    }

    /// Runs on the sides of a polygon and of its band, straight on from each other, as one.
    [[nodiscard]] std::vector<RoomBorder> joined(const std::vector<RoomBorder>& runs,
                                                 const std::vector<std::uint32_t>& meetings) const {
        std::map<GridPoint, std::vector<std::size_t>> runs_at;
        std::vector<RoomBorder> joined_runs = runs;
        for (std::size_t i = 0; i < runs.size(); ++i)
            for (const GridPoint end : {runs[i].segment.a, runs[i].segment.b}) runs_at[end].push_back(i);
        std::vector<bool> gone(runs.size(), false);
        for (std::uint32_t v = 0; v < graph_.vertices.size(); ++v) {
            const GridPoint at = graph_.vertices[v];
            const auto found = runs_at.find(at);
            if (meetings[v] != 2 || found == runs_at.end() || found->second.size() != 2) continue;
            const std::size_t l = found->second[0];
            const std::size_t r = found->second[1];
            if (l == r) continue;
            const auto far_end = [&](const RoomBorder& run) {
                return run.segment.a == at ? run.segment.b : run.segment.a;
            };
            const GridPoint a = far_end(joined_runs[l]);
            const GridPoint b = far_end(joined_runs[r]);
            if (a == b || !between(a, at, b)) continue;
            joined_runs[l] = {{std::min(a, b), std::max(a, b)}, std::min(joined_runs[l].side, joined_runs[r].side)};
            gone[r] = true;
            for (std::size_t& run : runs_at[b])
                if (run == r) run = l;
        }
        std::vector<RoomBorder> result;
        for (std::size_t i = 0; i < joined_runs.size(); ++i)
            if (!gone[i]) result.push_back(joined_runs[i]);
        std::stable_sort(result.begin(), result.end(),
                         [](const RoomBorder& l, const RoomBorder& r) { return l.side < r.side; });
        return result;
    }

    /// True where p lies within one unit of the segment ab, between its ends.
    [[nodiscard]] static bool between(GridPoint a, GridPoint p, GridPoint b) {
        const double dx = double(b.x) - a.x;
        const double dy = double(b.y) - a.y;
        const double along = (double(p.x) - a.x) * dx + (double(p.y) - a.y) * dy;
        return along > 0 && along < dx * dx + dy * dy && std::abs(double(orientation(a, b, p))) <= std::hypot(dx, dy);
    }

    const RoomOverlay& rooms_;
    const RoomMatch& match_;
    const PlanarMap& map_;
    const NodedGraph& graph_;
    std::int64_t min_area2_;
    std::vector<std::uint32_t> place_;  ///< [face_count] places to divide; kNone elsewhere
    std::vector<std::uint32_t> label_;  ///< [face_count] polygon
    std::vector<std::uint32_t> dropped_;
};

}  // namespace

std::vector<RoomBorder> room_borders(const RoomOverlay& rooms, const RoomMatch& match, std::int64_t min_area2) {
    return Divider(rooms, match, min_area2).run();
}

}  // namespace enfilade::plans

#include "tests/support/room_sketch.h"

#include <algorithm>
#include <map>

#include "plans/planar_map.h"

namespace enfilade::testing {
namespace {

using plans::GridPoint;
using plans::NodedGraph;
using plans::PlanarMap;
using plans::Point;

/// For every face, how often each contour winds around it: from face to face over the edges between them.
class Coverage {
public:
    Coverage(const NodedGraph& graph, const PlanarMap& map, const std::vector<std::uint32_t>& contour_of_segment,
             std::size_t contour_count)
        : windings_(map.face_count) {
        std::vector<std::vector<std::uint32_t>> around(map.face_count);
        for (std::uint32_t h = 0; h < 2 * graph.edges.size(); ++h) around[map.face(h)].push_back(h);
        windings_[0].assign(contour_count, 0);
        std::vector<std::uint32_t> queue = {0};
        for (std::size_t k = 0; k < queue.size(); ++k)
            for (const std::uint32_t h : around[queue[k]]) {
                const std::uint32_t beyond = map.face(h ^ 1);
                if (!windings_[beyond].empty() || contour_count == 0) continue;
                windings_[beyond] = windings_[queue[k]];
                const plans::NodedEdge& edge = graph.edges[h / 2];
                for (std::uint32_t u = edge.first_use; u < edge.first_use + edge.use_count; ++u) {
                    const std::uint32_t contour = contour_of_segment[graph.uses[u].segment];
                    if (contour == UINT32_MAX) continue;
                    // The contour's left is one more than its right; `beyond` lies left of h ^ 1.
                    const bool along_twin = graph.uses[u].reversed == ((h ^ 1) % 2 == 1);
                    windings_[beyond][contour] += along_twin ? 1 : -1;
                }
                queue.push_back(beyond);
            }
    }

    [[nodiscard]] bool is_room(std::uint32_t face, const std::vector<Paint>& paints) const {
        for (std::size_t c = paints.size(); c-- > 0;)
            if (windings_[face][c] != 0) return paints[c] == Paint::Room;
        return false;
    }

private:
    std::vector<std::vector<std::int32_t>> windings_;  ///< [face][contour]
};

/// Faces of the room joined where no wall is between them: [face] the part's number, UINT32_MAX outside.
std::vector<std::uint32_t> parts_of(const NodedGraph& graph, const PlanarMap& map, const std::vector<bool>& is_room,
                                    std::vector<std::int64_t>& area2) {
    std::vector<std::vector<std::uint32_t>> beside(map.face_count);
    for (std::uint32_t h = 0; h < 2 * graph.edges.size(); ++h) beside[map.face(h)].push_back(map.face(h ^ 1));
    std::vector<std::int64_t> face_area2(map.face_count, 0);
    for (std::size_t l = 0; l < map.loop_area2.size(); ++l) face_area2[map.face_of_loop[l]] += map.loop_area2[l];
    std::vector<std::uint32_t> part(map.face_count, UINT32_MAX);
    for (std::uint32_t start = 0; start < map.face_count; ++start) {
        if (!is_room[start] || part[start] != UINT32_MAX) continue;
        const std::uint32_t k = std::uint32_t(area2.size());
        area2.push_back(0);
        std::vector<std::uint32_t> open = {start};
        part[start] = k;
        while (!open.empty()) {
            const std::uint32_t face = open.back();
            open.pop_back();
            area2[k] += face_area2[face];
            for (const std::uint32_t other : beside[face])
                if (is_room[other] && part[other] == UINT32_MAX) part[other] = k, open.push_back(other);
        }
    }
    return part;
}

}  // namespace

void RoomSketch::paint(Paint paint_of_it, const std::vector<Point>& ring) {
    std::vector<std::uint32_t> lines(ring.size());
    for (std::uint32_t k = 0; k < lines.size(); ++k) lines[k] = k;
    paint(paint_of_it, ring, lines);
}

void RoomSketch::paint(Paint paint_of_it, const std::vector<Point>& ring, const std::vector<std::uint32_t>& lines) {
    const std::uint32_t contour = std::uint32_t(paints_.size());
    paints_.push_back(paint_of_it);
    for (std::size_t k = 0; k < ring.size(); ++k)
        strokes_.push_back({ring[k], ring[(k + 1) % ring.size()], line_count_ + lines[k], contour});
    line_count_ += ring.empty() ? 0 : *std::max_element(lines.begin(), lines.end()) + 1;
}

void RoomSketch::scratch(Point a, Point b) { strokes_.push_back({a, b, 0, scratched}); }

double RoomSketch::reach() const {
    double reach = 0;
    for (const Stroke& stroke : strokes_) reach = std::max(reach, std::hypot(stroke.a.x, stroke.a.y));
    return reach;
}

std::optional<Room> RoomSketch::realise(const Placing& placing, plans::Random& random) const {
    const double c = std::cos(placing.turn), s = std::sin(placing.turn);
    const auto round = [&](Point p) {
        const double x = c * p.x - s * p.y + placing.x, y = s * p.x + c * p.y + placing.y;
        return GridPoint{std::int32_t(std::floor(x + 0.5)), std::int32_t(std::floor(y + 0.5))};
    };
    std::vector<plans::Segment> segments;
    std::vector<std::uint32_t> contour_of_segment;
    for (const Stroke& stroke : strokes_) {
        segments.push_back({round(stroke.a), round(stroke.b)});
        contour_of_segment.push_back(stroke.contour);
    }
    const NodedGraph graph = plans::node(segments);
    const PlanarMap map = planar_map(graph);
    const Coverage coverage(graph, map, contour_of_segment, paints_.size());
    std::vector<bool> is_room(map.face_count);
    for (std::uint32_t f = 0; f < map.face_count; ++f) is_room[f] = f != 0 && coverage.is_room(f, paints_);
    std::vector<std::int64_t> area2;
    const std::vector<std::uint32_t> part = parts_of(graph, map, is_room, area2);
    if (area2.empty()) return std::nullopt;
    std::uint32_t wanted = std::uint32_t(std::max_element(area2.begin(), area2.end()) - area2.begin());
    if (random.chance(0.2)) wanted = random.below(std::uint32_t(area2.size()));

    Room room;
    std::map<std::uint32_t, std::uint32_t> point_of_vertex;
    const auto point = [&](std::uint32_t vertex) {
        const auto [at, is_new] = point_of_vertex.try_emplace(vertex, std::uint32_t(room.points.size()));
        if (is_new) room.points.push_back(graph.vertices[vertex]);
        return at->second;
    };
    const std::uint32_t looks = 1 + random.below(3);
    for (std::uint32_t h = 0; h < 2 * graph.edges.size(); ++h) {
        if (part[map.face(h)] != wanted || part[map.face(h ^ 1)] == wanted) continue;
        const plans::NodedEdge& edge = graph.edges[h / 2];
        std::uint32_t line = UINT32_MAX;
        for (std::uint32_t u = edge.first_use; u < edge.first_use + edge.use_count; ++u) {
            const Stroke& stroke = strokes_[graph.uses[u].segment];
            if (stroke.contour != scratched) line = std::min(line, stroke.line);
        }
        room.sides.push_back(
            {point(origin(graph, h)), point(origin(graph, h ^ 1)), line, h, random.below(looks), 1 + random.below(4)});
    }
    for (std::size_t k = room.sides.size(); k > 1; --k)
        std::swap(room.sides[k - 1], room.sides[random.below(std::uint32_t(k))]);
    return room;
}

}  // namespace enfilade::testing

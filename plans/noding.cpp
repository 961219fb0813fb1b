#include "plans/noding.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/check.h"
#include "plans/segment_tree.h"

namespace enfilade::plans {
namespace {

__extension__ using Int128 = __int128;

/// floor(numerator / denominator + 1/2) for a positive denominator: the rounding whose pixels are half open.
std::int64_t round_quotient(Int128 numerator, std::int64_t denominator) {
    const Int128 shifted = 2 * numerator + denominator;
    const Int128 divisor = 2 * Int128(denominator);
    Int128 quotient = shifted / divisor;
    if (shifted % divisor < 0) --quotient;
    return std::int64_t(quotient);
}

int sign(std::int64_t value) { return (value > 0) - (value < 0); }

/// Segments by lexicographic direction, which makes every later decision independent of the input's.
Segment directed(const Segment& segment) { return segment.b < segment.a ? Segment{segment.b, segment.a} : segment; }

/// The rounded crossing of two segments that cross in the interior of both; all other meetings are at an end,
/// and ends are hot pixels already.
void append_crossing(const Segment& s, const Segment& t, std::vector<GridPoint>& crossings) {
    if (std::max(s.a.y, s.b.y) < std::min(t.a.y, t.b.y) || std::max(t.a.y, t.b.y) < std::min(s.a.y, s.b.y)) return;
    if (s.b.x < t.a.x || t.b.x < s.a.x) return;
    const std::int64_t t_from_a = orientation(s.a, s.b, t.a);
    const std::int64_t t_from_b = orientation(s.a, s.b, t.b);
    if (sign(t_from_a) * sign(t_from_b) >= 0) return;
    const std::int64_t s_from_a = orientation(t.a, t.b, s.a);
    const std::int64_t s_from_b = orientation(t.a, t.b, s.b);
    if (sign(s_from_a) * sign(s_from_b) >= 0) return;
    // The crossing lies at the share s_from_a / (s_from_a - s_from_b) of s.
    std::int64_t numerator = s_from_a;
    std::int64_t denominator = s_from_a - s_from_b;
    if (denominator < 0) {
        numerator = -numerator;
        denominator = -denominator;
    }
    const auto coordinate = [&](std::int32_t from, std::int32_t to) {
        return std::int32_t(from + round_quotient(Int128(numerator) * (std::int64_t(to) - from), denominator));
    };
    crossings.push_back({coordinate(s.a.x, s.b.x), coordinate(s.a.y, s.b.y)});
}

/// True where the segment meets the half-open pixel [x - 1/2, x + 1/2) x [y - 1/2, y + 1/2) of `pixel`.
/// Ends are integers, so that the projections decide by integers; the line passes the open pixel where it
/// separates two corners, and meets its boundary alone only in the lower left corner, which belongs to it.
bool meets_pixel(const Segment& segment, GridPoint pixel) {
    if (pixel.x < segment.a.x || pixel.x > segment.b.x) return false;
    if (pixel.y < std::min(segment.a.y, segment.b.y) || pixel.y > std::max(segment.a.y, segment.b.y)) return false;
    const std::int64_t dx = std::int64_t(segment.b.x) - segment.a.x;
    const std::int64_t dy = std::int64_t(segment.b.y) - segment.a.y;
    const std::int64_t twice_side = 2 * orientation(segment.a, segment.b, pixel);
    return std::abs(twice_side) < std::abs(dx) + std::abs(dy) || twice_side == dx - dy;
}

double distance(const Segment& segment, GridPoint point) {
    const double dx = double(segment.b.x) - segment.a.x;
    const double dy = double(segment.b.y) - segment.a.y;
    return std::abs(double(orientation(segment.a, segment.b, point))) / std::hypot(dx, dy);
}

/// A hot pixel on a segment.
struct Visit {
    std::uint32_t segment;
    std::uint32_t vertex;
};

/// One use of an edge before equal edges are brought together.
struct Link {
    std::uint64_t edge;  ///< lower vertex in the high half, upper vertex in the low half
    EdgeUse use;
};

/// Brings the visits of each segment together, in the order in which the segment passes the pixels: its pixels
/// are monotone in x and in y, so that vertex order decides but within one column of a falling segment.
std::vector<Visit> sorted_visits(std::vector<Visit>&& found, const std::vector<Segment>& segments,
                                 const std::vector<GridPoint>& vertices, std::vector<std::uint32_t>& first) {
    first.assign(segments.size() + 1, 0);
    for (const Visit& visit : found) ++first[visit.segment + 1];
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    std::vector<Visit> visits(found.size());
    std::vector<std::uint32_t> slot(first.begin(), first.end() - 1);
    for (const Visit& visit : found) visits[slot[visit.segment]++] = visit;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const bool falling = segments[i].b.y < segments[i].a.y;
        std::sort(visits.begin() + first[i], visits.begin() + first[i + 1], [&](const Visit& l, const Visit& r) {
            if (falling && vertices[l.vertex].x == vertices[r.vertex].x) return l.vertex > r.vertex;
            return l.vertex < r.vertex;
        });
    }
    return visits;
}

/// Sorts by edge and segment; stable counting by the lower vertex first, because edges have few higher ends.
void sort_links(std::vector<Link>& links, std::size_t vertex_count) {
    std::vector<std::uint32_t> first(vertex_count + 1, 0);
    for (const Link& link : links) ++first[(link.edge >> 32) + 1];
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    std::vector<Link> sorted(links.size());
    std::vector<std::uint32_t> slot(first.begin(), first.end() - 1);
    for (const Link& link : links) sorted[slot[link.edge >> 32]++] = link;
    for (std::size_t v = 0; v < vertex_count; ++v)
        std::sort(sorted.begin() + first[v], sorted.begin() + first[v + 1], [](const Link& l, const Link& r) {
            return l.edge != r.edge ? l.edge < r.edge : l.use.segment < r.use.segment;
        });
    links = std::move(sorted);
}

void collect_edges(const std::vector<Link>& links, NodedGraph& graph) {
    graph.uses.reserve(links.size());
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (i == 0 || links[i].edge != links[i - 1].edge)
            graph.edges.push_back(
                {std::uint32_t(links[i].edge >> 32), std::uint32_t(links[i].edge & 0xffffffffu), std::uint32_t(i), 0});
        ++graph.edges.back().use_count;
        graph.uses.push_back(links[i].use);
    }
}

}  // namespace

NodedGraph node(std::span<const Segment> input) {
    constexpr std::int32_t limit = 1 << 25;
    std::vector<Segment> segments;
    std::vector<std::uint32_t> input_index;
    segments.reserve(input.size());
    input_index.reserve(input.size());
    for (std::size_t i = 0; i < input.size(); ++i) {
        for (const GridPoint p : {input[i].a, input[i].b})
            ENFILADE_CHECK(p.x >= -limit && p.x <= limit && p.y >= -limit && p.y <= limit);
        if (input[i].a == input[i].b) continue;
        segments.push_back(directed(input[i]));
        input_index.push_back(std::uint32_t(i));
    }

    NodedGraph graph;
    std::vector<GridPoint>& vertices = graph.vertices;
    vertices.reserve(2 * segments.size());
    for (const Segment& segment : segments) {
        vertices.push_back(segment.a);
        vertices.push_back(segment.b);
    }
    visit_close_segments(segments, [&](std::span<const std::uint32_t> close) {
        for (std::size_t i = 0; i < close.size(); ++i)
            for (std::size_t j = i + 1; j < close.size(); ++j)
                append_crossing(segments[close[i]], segments[close[j]], vertices);
    });
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());

    std::vector<Visit> found;
    found.reserve(3 * segments.size());
    visit_close_points(segments, vertices,
                       [&](std::span<const std::uint32_t> close, std::span<const std::uint32_t> points) {
                           for (const std::uint32_t point : points)
                               for (const std::uint32_t segment : close)
                                   if (meets_pixel(segments[segment], vertices[point]))
                                       found.push_back({segment, point});
                       });
    std::vector<std::uint32_t> first;
    const std::vector<Visit> visits = sorted_visits(std::move(found), segments, vertices, first);

    std::vector<Link> links;
    links.reserve(visits.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const bool turned = input[input_index[i]].a != segments[i].a;
        for (std::uint32_t v = first[i]; v < first[i + 1]; ++v) {
            graph.max_deviation = std::max(graph.max_deviation, distance(segments[i], vertices[visits[v].vertex]));
            if (v == first[i]) continue;
            const std::uint64_t from = visits[v - 1].vertex;
            const std::uint64_t to = visits[v].vertex;
            const bool down = to < from;
            links.push_back({down ? (to << 32 | from) : (from << 32 | to), {input_index[i], turned != down}});
        }
    }
    sort_links(links, vertices.size());
    collect_edges(links, graph);
    return graph;
}

}  // namespace enfilade::plans

#pragma once
// The data that the steps of `arrange` hand to each other. Internal to plans/.

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "plans/layout.h"
#include "plans/outline.h"

namespace enfilade::plans {

inline constexpr std::uint32_t kNone = UINT32_MAX;

/// What a closed chain of segments encloses, in one storey. Of the regions that cover a face the one with the
/// lowest rank owns it.
struct Region {
    std::uint32_t storey = kNone;  ///< index into the chosen storeys; kNone: the site
    Owner owner;
    std::uint32_t rank = kNone;
};

/// What an input segment stands for.
struct SegmentTag {
    std::uint32_t region = kNone;  ///< lies on its left; kNone: borders between rooms
    std::uint32_t line = kNone;
    std::uint32_t border_storey = kNone;  ///< of borders between rooms
};

/// A straight piece of the plan, from end to end.
struct PlanLine {
    GridPoint a;
    GridPoint b;
    LineSource source;
};

struct Parts {
    std::vector<Segment> segments;
    std::vector<SegmentTag> tags;  ///< [segments.size()]
    std::vector<Region> regions;
    std::vector<PlanLine> lines;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> continuations;  ///< lines that may be one
    std::vector<StoreyOutlines> outlines;                                ///< [chosen storeys]
};

/// The regions that cover each face, with their winding numbers, by ascending region.
struct Cover {
    struct Entry {
        std::uint32_t region;
        std::int32_t winding;
    };
    std::vector<std::uint32_t> first;  ///< [face_count + 1]
    std::vector<Entry> entries;
};

/// A subdivision with what covers its faces.
struct Overlay {
    NodedGraph graph;
    PlanarMap map;
    Cover cover;
};

/// Areas of the faces of a map, doubled; face 0 has none.
[[nodiscard]] std::vector<std::int64_t> face_areas2(const PlanarMap& map);

/// The indices of `elements` by ascending id: the order in which everything is laid out.
template <class Element>
[[nodiscard]] std::vector<std::uint32_t> by_id(const std::vector<Element>& elements) {
    std::vector<std::uint32_t> order(elements.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = std::uint32_t(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t l, std::uint32_t r) { return elements[l].id < elements[r].id; });
    return order;
}

/// The graph of the edges to keep ([edge_count]), without the vertices that lose all of theirs.
[[nodiscard]] NodedGraph filtered(const NodedGraph& graph, const std::vector<bool>& keep);

/// Nodes the segments, drops edges that separate nothing, and propagates the covers. `tags`: [segments.size()].
[[nodiscard]] Overlay overlay(const std::vector<Segment>& segments, const std::vector<SegmentTag>& tags);

/// The same for a graph that is noded already.
[[nodiscard]] Overlay overlay_of(NodedGraph graph, const std::vector<SegmentTag>& tags);

}  // namespace enfilade::plans

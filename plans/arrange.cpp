// The exact 2D stage, step by step (ARRANGEMENT.md).

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "plans/arrange_frame.h"
#include "plans/arrange_lines.h"
#include "plans/arrange_outlines.h"
#include "plans/arrange_owners.h"
#include "plans/arrange_rooms.h"
#include "plans/layout.h"
#include "plans/room_match.h"

namespace enfilade::plans {
namespace {

constexpr double kBand = 0.2;           ///< m: room polygons lie at most this far from the walls that they mean
constexpr double kSmallestPart = 0.25;  ///< m2: smaller parts of an open room go to their neighbour

std::vector<std::uint32_t> chosen_storeys(const Plan& plan, const ArrangeOptions& options) {
    std::vector<std::uint32_t> storeys = options.storeys;
    if (storeys.empty()) {
        storeys.resize(plan.storeys.size());
        std::iota(storeys.begin(), storeys.end(), 0u);
    }
    std::sort(storeys.begin(), storeys.end());
    storeys.erase(std::unique(storeys.begin(), storeys.end()), storeys.end());
    for (const std::uint32_t s : storeys)
        if (s >= plan.storeys.size())
            throw InputError("P307", "",
                             "There is no storey " + std::to_string(s) + ": the plan has " +
                                 std::to_string(plan.storeys.size()) + ", counted from 0.");
    std::stable_sort(storeys.begin(), storeys.end(), [&](std::uint32_t l, std::uint32_t r) {
        return plan.storeys[l].elevation < plan.storeys[r].elevation;
    });
    return storeys;
}

class Arranger {
public:
    Arranger(const Plan& plan, const ArrangeOptions& options)
        : plan_(plan), options_(options), storeys_(chosen_storeys(plan, options)) {}

    Layout run() {
        const Site site = choose_site(plan_, storeys_, options_, layout_.findings);
        layout_.frame = site.frame;
        layout_.site_min = site.min;
        layout_.site_max = site.max;
        parts_ = outline_parts(plan_, storeys_, site.frame, options_, layout_.findings);
        add_site_box(site.min, site.max, parts_);
        for (const std::uint32_t s : storeys_)
            rings_.push_back(room_rings(plan_.storeys[s], site.frame, layout_.findings));

        overlay_ = overlay(parts_.segments, parts_.tags);
        divide_open_rooms();
        settle();
        open_slabs();
        name_lines();
        layout_.graph = std::move(overlay_.graph);
        layout_.map = std::move(overlay_.map);
        return std::move(layout_);
    }

private:
    [[nodiscard]] const Storey& storey(std::size_t s) const { return plan_.storeys[storeys_[s]]; }
    [[nodiscard]] double units2(double square_metres) const {
        return square_metres / (layout_.frame.unit * layout_.frame.unit);
    }

    void find_all_places() {
        owners_ = strongest_owners(overlay_, parts_.regions, storeys_.size());
        places_.clear();
        matches_.assign(storeys_.size(), {});
        for (std::uint32_t s = 0; s < storeys_.size(); ++s) {
            places_.push_back(find_places(overlay_, parts_.tags, owners_[s], s));
            if (rings_[s].rings.empty()) continue;
            matches_[s] = match_rooms(overlay_rooms(overlay_, places_[s], rings_[s].rings, 0), places_[s]);
        }
    }

    /// Places that several polygons name get borders between them, and all is laid out once more.
    void divide_open_rooms() {
        find_all_places();
        std::vector<std::vector<RoomBorder>> borders(storeys_.size());
        bool any = false;
        for (std::uint32_t s = 0; s < storeys_.size(); ++s) {
            const auto& named = matches_[s].polygons_of_place;
            if (std::none_of(named.begin(), named.end(), [](const auto& polygons) { return polygons.size() > 1; }))
                continue;
            const RoomOverlay rooms = overlay_rooms(overlay_, places_[s], rings_[s].rings, kBand / layout_.frame.unit);
            borders[s] = room_borders(rooms, matches_[s], std::int64_t(2 * units2(kSmallestPart)));
            any = any || !borders[s].empty();
        }
        if (!any) return;
        take_edges_as_segments();
        for (std::uint32_t s = 0; s < storeys_.size(); ++s) add_borders(s, borders[s]);
        const double deviation = overlay_.graph.max_deviation;
        overlay_ = overlay(parts_.segments, parts_.tags);
        overlay_.graph.max_deviation += deviation;
        find_all_places();
        if (drop_idle_borders()) find_all_places();
    }

    /// Borders end on edges of the graph, which lie up to half a unit beside the segments that they came from:
    /// so that the edges go in again, not the segments.
    void take_edges_as_segments() {
        std::vector<Segment> segments;
        std::vector<SegmentTag> tags;
        for (const NodedEdge& edge : overlay_.graph.edges) {
            const GridPoint a = overlay_.graph.vertices[edge.a];
            const GridPoint b = overlay_.graph.vertices[edge.b];
            for (std::uint32_t u = edge.first_use; u < edge.first_use + edge.use_count; ++u) {
                const EdgeUse& use = overlay_.graph.uses[u];
                segments.push_back(use.reversed ? Segment{b, a} : Segment{a, b});
                tags.push_back(parts_.tags[use.segment]);
            }
        }
        parts_.segments = std::move(segments);
        parts_.tags = std::move(tags);
    }

    void add_borders(std::uint32_t s, const std::vector<RoomBorder>& borders) {
        for (std::size_t i = 0; i < borders.size(); ++i) {
            const Segment& segment = borders[i].segment;
            if (i == 0 || borders[i].side != borders[i - 1].side)
                parts_.lines.push_back({segment.a, segment.b, LineSource{s, kNone, false}});
            parts_.lines.back().b = segment.b;
            parts_.segments.push_back(segment);
            parts_.tags.push_back({kNone, std::uint32_t(parts_.lines.size() - 1), s});
        }
    }

    /// Edges of borders alone that have one place on both sides, or solids, separate nothing.
    bool drop_idle_borders() {
        NodedGraph& graph = overlay_.graph;
        std::vector<bool> keep(graph.edges.size(), true);
        bool any = false;
        for (std::uint32_t e = 0; e < keep.size(); ++e) {
            bool needed = false;
            for (std::uint32_t u = graph.edges[e].first_use;
                 u < graph.edges[e].first_use + graph.edges[e].use_count && !needed; ++u) {
                const SegmentTag& tag = parts_.tags[graph.uses[u].segment];
                if (tag.border_storey == kNone) {
                    needed = true;
                } else {
                    const Places& places = places_[tag.border_storey];
                    needed = places.of_face[overlay_.map.face(2 * e)] != places.of_face[overlay_.map.face(2 * e + 1)];
                }
            }
            keep[e] = needed;
            any = any || !needed;
        }
        if (any) overlay_ = overlay_of(filtered(graph, keep), parts_.tags);
        return any;
    }

    void settle() {
        for (std::uint32_t s = 0; s < storeys_.size(); ++s) {
            StoreyLayout result;
            result.plan_storey = storeys_[s];
            result.owner = std::move(owners_[s]);
            StoreyRooms from;
            from.storey = &storey(s);
            from.frame = &layout_.frame;
            from.outlines = &parts_.outlines[s];
            from.rings = &rings_[s];
            from.match = rings_[s].rings.empty() ? nullptr : &matches_[s];
            from.places = &places_[s];
            settle_rooms(overlay_, from, result, layout_.findings);
            report_rooms(from, layout_.findings);
            layout_.storeys.push_back(std::move(result));
        }
    }

    /// Faces under stairs and shafts that are free in both storeys.
    void open_slabs() {
        const auto is_free = [](OwnerKind kind) { return !is_solid(kind) && kind != OwnerKind::Exterior; };
        for (std::uint32_t s = 0; s < storeys_.size(); ++s) {
            StoreyLayout& here = layout_.storeys[s];
            here.opens_up.assign(overlay_.map.face_count, kNone);
            const bool has_next = s + 1 < storeys_.size() && storeys_[s + 1] == storeys_[s] + 1;
            std::set<std::uint32_t> closed;
            for (std::uint32_t f = 1; f < overlay_.map.face_count; ++f)
                for (std::uint32_t i = overlay_.cover.first[f]; i < overlay_.cover.first[f + 1]; ++i) {
                    const Region& region = parts_.regions[overlay_.cover.entries[i].region];
                    if (region.storey != s) continue;
                    const bool stair = region.owner.kind == OwnerKind::Stair;
                    if (!stair && region.owner.kind != OwnerKind::Shaft) continue;
                    const std::uint32_t hole =
                        region.owner.element + (stair ? 0 : std::uint32_t(storey(s).stairs.size()));
                    if (!has_next) closed.insert(hole);
                    else if (is_free(here.owner[f].kind) && is_free(layout_.storeys[s + 1].owner[f].kind) &&
                             (here.opens_up[f] == kNone || holes_before(s, hole, here.opens_up[f])))
                        here.opens_up[f] = hole;
                }
            for (const std::uint32_t hole : closed) report_closed(s, hole);
        }
    }

    /// Stairs before shafts, then by id.
    [[nodiscard]] bool holes_before(std::size_t s, std::uint32_t l, std::uint32_t r) const {
        const auto stairs = std::uint32_t(storey(s).stairs.size());
        const auto key = [&](std::uint32_t hole) {
            return hole < stairs ? std::pair(0, storey(s).stairs[hole].id)
                                 : std::pair(1, storey(s).shafts[hole - stairs].id);
        };
        return key(l) < key(r);
    }

    void report_closed(std::size_t s, std::uint32_t hole) {
        const auto stairs = std::uint32_t(storey(s).stairs.size());
        const bool is_stair = hole < stairs;
        const std::string& id = is_stair ? storey(s).stairs[hole].id : storey(s).shafts[hole - stairs].id;
        const std::string& name = is_stair ? storey(s).stairs[hole].name : storey(s).shafts[hole - stairs].name;
        Finding finding;
        finding.code = "P330";
        finding.severity = Severity::Note;
        finding.sentence = std::string(is_stair ? "Stair" : "Shaft") + " \"" + (name.empty() ? id : name) +
                           "\" on storey \"" + storey(s).name + "\" ends at the ceiling: no storey above it is built.";
        finding.hint = "Choose the storey above too, if there is one.";
        finding.storey = storey(s).id;
        finding.elements.push_back({is_stair ? "stair" : "shaft", id, name});
        layout_.findings.push_back(std::move(finding));
    }

    /// The least line on each edge, lines that are straight continuations of each other counted as one.
    void name_lines() {
        const std::vector<std::uint32_t> group = straight_groups(parts_, overlay_.graph);
        for (const NodedEdge& edge : overlay_.graph.edges) {
            std::uint32_t least = kNone;
            for (std::uint32_t u = edge.first_use; u < edge.first_use + edge.use_count; ++u)
                least = std::min(least, group[parts_.tags[overlay_.graph.uses[u].segment].line]);
            layout_.edge_line.push_back(LineId(least));
        }
        layout_.use_line.reserve(overlay_.graph.uses.size());
        for (const EdgeUse& use : overlay_.graph.uses)
            layout_.use_line.push_back(LineId(parts_.tags[use.segment].line));
        layout_.lines.reserve(parts_.lines.size());
        for (const PlanLine& line : parts_.lines) layout_.lines.push_back(line.source);
    }

    const Plan& plan_;
    const ArrangeOptions& options_;
    std::vector<std::uint32_t> storeys_;  ///< indices into the plan's, by ascending elevation
    Parts parts_;
    std::vector<RoomRings> rings_;  ///< [storey]
    Overlay overlay_;
    std::vector<std::vector<Owner>> owners_;  ///< [storey][face]
    std::vector<Places> places_;              ///< [storey]
    std::vector<RoomMatch> matches_;          ///< [storey]
    Layout layout_;
};

}  // namespace

Layout arrange(const Plan& plan, const ArrangeOptions& options) { return Arranger(plan, options).run(); }

}  // namespace enfilade::plans

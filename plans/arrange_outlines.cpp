// Plan -> segments on the grid, each with the region that it bounds and the line that it lies on.

#include "plans/arrange_outlines.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

// Openings before walls before columns before stairs and shafts, within a storey.
constexpr std::uint32_t rank_of(OwnerKind kind) {
    switch (kind) {
        case OwnerKind::Opening: return 0u << 28;
        case OwnerKind::Wall: return 1u << 28;
        case OwnerKind::Column: return 2u << 28;
        case OwnerKind::Stair: return 3u << 28;
        case OwnerKind::Shaft: return 4u << 28;
        case OwnerKind::Room:
        case OwnerKind::Exterior: break;
    }
    return 5u << 28;
}

/// The lines of one wall's or opening's outline by part and facet.
class LineTable {
public:
    std::uint32_t* find(OutlinePart part, std::uint32_t facet) {
        for (auto& [key, line] : lines_)
            if (key == std::pair(part, facet)) return &line;
        return nullptr;
    }
    void add(OutlinePart part, std::uint32_t facet, std::uint32_t line) {
        lines_.push_back({std::pair(part, facet), line});
    }

private:
    std::vector<std::pair<std::pair<OutlinePart, std::uint32_t>, std::uint32_t>> lines_;
};

class Builder {
public:
    Builder(const Plan& plan, const std::vector<std::uint32_t>& storeys, const GridFrame& frame,
            std::vector<Finding>& findings)
        : plan_(plan), storeys_(storeys), frame_(frame), findings_(findings) {}

    Parts run(const ArrangeOptions& options) {
        OutlineOptions outline_options;
        outline_options.origin = {frame_.origin_x, frame_.origin_y};
        outline_options.sagitta = options.sagitta_mm / 1000;
        outline_options.join = 4 * frame_.unit;
        outline_options.flat = frame_.unit / 4;
        for (std::uint32_t s = 0; s < storeys_.size(); ++s) {
            parts_.outlines.push_back(outlines(storey(s), outline_options));
            add_walls(s);
        }
        for (std::uint32_t s = 0; s < storeys_.size(); ++s) add_openings(s);
        for (std::uint32_t s = 0; s < storeys_.size(); ++s) {
            add_polygons(s, storey(s).columns, OwnerKind::Column, "column");
            add_polygons(s, storey(s).stairs, OwnerKind::Stair, "stair");
            add_polygons(s, storey(s).shafts, OwnerKind::Shaft, "shaft");
        }
        return std::move(parts_);
    }

private:
    [[nodiscard]] const Storey& storey(std::uint32_t s) const { return plan_.storeys[storeys_[s]]; }

    [[nodiscard]] GridPoint grid(Point local) const {
        const auto round = [&](double d) { return std::int32_t(std::floor(d / frame_.unit + 0.5)); };
        return {round(local.x), round(local.y)};
    }

    std::uint32_t add_region(std::uint32_t s, OwnerKind kind, std::uint32_t element, std::uint32_t order) {
        parts_.regions.push_back({s, {kind, element}, rank_of(kind) + order});
        return std::uint32_t(parts_.regions.size() - 1);
    }

    std::uint32_t add_line(GridPoint a, GridPoint b, LineSource source) {
        parts_.lines.push_back({a, b, source});
        return std::uint32_t(parts_.lines.size() - 1);
    }

    void add_segment(GridPoint a, GridPoint b, std::uint32_t region, std::uint32_t line) {
        parts_.segments.push_back({a, b});
        parts_.tags.push_back({region, line, kNone});
    }

    void report_vanished(std::uint32_t s, const std::string& kind, const std::string& id, const std::string& name,
                         Point local) {
        Finding finding;
        finding.code = kind == "wall" ? "P302" : "P303";
        finding.sentence = "The " + kind + " " + (name.empty() ? id : "\"" + name + "\"") + " on storey \"" +
                           storey(s).name + "\" is smaller than the grid and was left out.";
        finding.hint = "Use a finer grid (--snap-mm), or check the units of the plan.";
        finding.storey = storey(s).id;
        finding.point = {local.x + frame_.origin_x, local.y + frame_.origin_y, storey(s).elevation};
        finding.elements.push_back({kind, id, name});
        findings_.push_back(std::move(finding));
    }

    /// Twice the area of the ring on the grid.
    [[nodiscard]] static std::int64_t area2(const std::vector<GridPoint>& ring) {
        std::int64_t sum = 0;
        for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += orientation(ring[0], ring[i], ring[i + 1]);
        return sum;
    }

    /// Adds the ring, and a line for each part that `lines` does not know yet.
    template <class SourceOf>
    void add_ring(const std::vector<OutlinePoint>& ring, std::uint32_t region, LineTable& lines, SourceOf source_of) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const GridPoint a = grid(ring[i].at);
            const GridPoint b = grid(ring[(i + 1) % ring.size()].at);
            const std::uint32_t* known = lines.find(ring[i].part, ring[i].facet);
            if (known != nullptr) {
                PlanLine& line = parts_.lines[*known];
                // The pieces of a straight side follow each other: the line runs on to the last.
                if (line.b == a) line.b = b;
                add_segment(a, b, region, *known);
                continue;
            }
            const std::uint32_t line = add_line(a, b, source_of(ring[i]));
            lines.add(ring[i].part, ring[i].facet, line);
            add_segment(a, b, region, line);
        }
    }

    void add_walls(std::uint32_t s) {
        const Storey& from = storey(s);
        const StoreyOutlines& outline = parts_.outlines[s];
        std::vector<std::uint32_t> order = by_id(from.walls);
        std::vector<std::uint32_t> strength = order;
        const auto units = [&](std::uint32_t w) { return std::llround(from.walls[w].thickness / frame_.unit); };
        std::stable_sort(strength.begin(), strength.end(),
                         [&](std::uint32_t l, std::uint32_t r) { return units(l) > units(r); });
        std::vector<std::uint32_t> place(order.size());
        for (std::uint32_t i = 0; i < strength.size(); ++i) place[strength[i]] = i;

        wall_lines_.push_back(std::vector<LineTable>(from.walls.size()));
        for (const std::uint32_t w : order) {
            const Wall& wall = from.walls[w];
            std::vector<GridPoint> ring;
            for (const OutlinePoint& p : outline.walls[w].ring) ring.push_back(grid(p.at));
            if (area2(ring) == 0) {
                const Point middle = (wall.start + wall.end) * 0.5 - Point{frame_.origin_x, frame_.origin_y};
                report_vanished(s, "wall", wall.id, wall.name, middle);
                continue;
            }
            const std::uint32_t region = add_region(s, OwnerKind::Wall, w, place[w]);
            const auto source_of = [&](const OutlinePoint& point) {
                return LineSource{s, w, is_left(point, outline.walls[w].ring)};
            };
            add_ring(outline.walls[w].ring, region, wall_lines_[s][w], source_of);
        }
        for (const Continuation& c : outline.continuations) {
            const std::uint32_t* l = wall_lines_[s][c.wall].find(c.side, 0);
            const std::uint32_t* r = wall_lines_[s][c.next_wall].find(c.next_side, 0);
            if (l != nullptr && r != nullptr) parts_.continuations.push_back({*l, *r});
        }
    }

    /// Ends count to the side that they lie on: the half beyond the joint's middle for joined ends.
    [[nodiscard]] static bool is_left(const OutlinePoint& point, const std::vector<OutlinePoint>& ring) {
        if (point.part == OutlinePart::Left) return true;
        if (point.part == OutlinePart::Right) return false;
        std::uint32_t last = 0;
        for (const OutlinePoint& p : ring)
            if (p.part == point.part) last = std::max(last, p.facet);
        if (last == 0) return true;
        return (point.part == OutlinePart::End) == (point.facet == last);
    }

    void add_openings(std::uint32_t s) {
        const Storey& from = storey(s);
        std::uint32_t place = 0;
        for (const std::uint32_t o : by_id(from.openings)) {
            const OpeningOutline& outline = parts_.outlines[s].openings[o];
            std::vector<GridPoint> ring;
            for (const OutlinePoint& p : outline.ring) ring.push_back(grid(p.at));
            if (area2(ring) == 0) {
                const Opening& opening = from.openings[o];
                Point middle;
                for (const Wall& wall : from.walls)
                    if (wall.id == opening.wall)
                        middle = (wall.start + wall.end) * 0.5 - Point{frame_.origin_x, frame_.origin_y};
                report_vanished(s, "opening", opening.id, opening.name, middle);
                continue;
            }
            // Sides on the host's faces are lines of the host; all others are the opening's own.
            LineTable& host = wall_lines_[s][outline.wall];
            LineTable lines;
            for (const OutlinePoint& p : outline.ring)
                if (p.part == OutlinePart::Left || p.part == OutlinePart::Right)
                    if (const std::uint32_t* line = host.find(p.part, p.facet))
                        if (lines.find(p.part, p.facet) == nullptr) lines.add(p.part, p.facet, *line);
            const std::uint32_t wall = outline.wall;
            add_ring(outline.ring, add_region(s, OwnerKind::Opening, o, place++), lines, [&](const OutlinePoint& p) {
                return LineSource{s, wall, p.part == OutlinePart::Left || p.part == OutlinePart::BeyondLeft};
            });
        }
    }

    template <class Element>
    void add_polygons(std::uint32_t s, const std::vector<Element>& elements, OwnerKind kind, const char* kind_name) {
        std::uint32_t place = 0;
        for (const std::uint32_t e : by_id(elements)) {
            const Element& element = elements[e];
            std::vector<GridPoint> ring;
            for (const Point p : element.polygon) {
                const GridPoint at = frame_.grid(p.x, p.y);
                if (ring.empty() || !(ring.back() == at)) ring.push_back(at);
            }
            while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
            bool has_extent = false;
            for (std::size_t i = 2; i < ring.size(); ++i)
                has_extent = has_extent || orientation(ring[0], ring[1], ring[i]) != 0;
            if (!has_extent) {
                const Point at = element.polygon.empty() ? Point{} : element.polygon.front();
                report_vanished(s, kind_name, element.id, element.name, at - Point{frame_.origin_x, frame_.origin_y});
                continue;
            }
            if (area2(ring) < 0) std::reverse(ring.begin(), ring.end());
            // The same ring from another corner is the same element.
            std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
            const std::uint32_t region = add_region(s, kind, e, place++);
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const GridPoint a = ring[i];
                const GridPoint b = ring[(i + 1) % ring.size()];
                add_segment(a, b, region, add_line(a, b, LineSource{s, kNone, false}));
            }
        }
    }

    const Plan& plan_;
    const std::vector<std::uint32_t>& storeys_;
    const GridFrame& frame_;
    std::vector<Finding>& findings_;
    Parts parts_;
    std::vector<std::vector<LineTable>> wall_lines_;  ///< [storey][wall]
};

}  // namespace

Parts outline_parts(const Plan& plan, const std::vector<std::uint32_t>& storeys, const GridFrame& frame,
                    const ArrangeOptions& options, std::vector<Finding>& findings) {
    return Builder(plan, storeys, frame, findings).run(options);
}

void add_site_box(GridPoint min, GridPoint max, Parts& parts) {
    const GridPoint ring[] = {min, {max.x, min.y}, max, {min.x, max.y}};
    parts.regions.push_back({kNone, {}, kNone});
    for (int i = 0; i < 4; ++i) {
        const GridPoint a = ring[i];
        const GridPoint b = ring[(i + 1) % 4];
        parts.lines.push_back({a, b, {}});
        parts.segments.push_back({a, b});
        parts.tags.push_back({std::uint32_t(parts.regions.size() - 1), std::uint32_t(parts.lines.size() - 1), kNone});
    }
}

}  // namespace enfilade::plans

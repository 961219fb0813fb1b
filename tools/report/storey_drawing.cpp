#include "tools/report/storey_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "modeler/outline.h"
#include "tools/console.h"
#include "tools/report/html_text.h"
#include "tools/report/name_layer.h"
#include "tools/report/object_signs.h"
#include "tools/report/plan_symbols.h"
#include "tools/report/wall_outline.h"

namespace enfilade::tools {
namespace {

using modeler::Label;
using modeler::SpacePart;

/// Drawings are in millimetres with y up, pages in metres with y down.
constexpr const char* to_page = " transform=\"scale(.001 -.001)\"";

std::string layer(const char* name, const std::string& content) {
    return std::string("<g class=\"layer layer-") + name + "\"" + to_page + ">\n" + content + "</g>\n";
}

/// Kinds of rooms that the page tints alike.
const char* tint_of(const std::string& kind) {
    static const std::map<std::string, const char*> tints = {
        {"corridor", "way"},  {"hall", "way"},     {"lobby", "way"},    {"stairwell", "way"},
        {"bathroom", "wet"},  {"toilet", "wet"},   {"kitchen", "wet"},  {"laundry", "wet"},
        {"storage", "store"}, {"closet", "store"}, {"garage", "store"}, {"utility", "store"}};
    const auto found = tints.find(kind);
    return found == tints.end() ? "room" : found->second;
}

class StoreyDrawer {
public:
    StoreyDrawer(const PlanView& view, const Passages& passages, std::uint32_t storey, const CellPaths* cells)
        : view_(view), storey_(storey), cells_(cells), doors_(door_paths(view, passages, storey)) {}

    std::string run(const std::set<std::string>& blamed) {
        std::string drawing = layer("grid", grid());
        drawing += layer("rooms", outdoors() + rooms());
        drawing += layer("stairs", stairs());
        const bool is_furnished = !view_.building().furnishing.empty();
        drawing += layer("furniture", path_tag("furniture", is_furnished ? object_paths(view_, storey_)
                                                                         : furniture_paths(view_, storey_)));
        drawing += layer("walls", walls());
        drawing += layer("windows", windows());
        drawing += layer("doors", doors());
        drawing += layer("marks", marks(blamed));
        if (cells_) drawing += cell_drawing(*cells_);
        return drawing + names_.text();
    }

private:
    std::string grid() const {
        const DrawnBox box = drawn_box(view_);
        const double extent = std::max(box.width, box.height);
        const std::int64_t step = extent < 150 ? 1000 : extent < 700 ? 5000 : 50000;
        // Far enough around that its end is seen by nobody who looks at the building.
        const auto around = std::int64_t(1000 * extent / double(step)) + 3;
        const auto down = [&](double metres) {
            return std::int64_t(std::floor(1000 * metres / double(step))) - around;
        };
        const auto up = [&](double metres) { return std::int64_t(std::ceil(1000 * metres / double(step))) + around; };
        const std::int64_t x0 = down(box.x), x1 = up(box.x + box.width);
        const std::int64_t y0 = down(-box.y - box.height), y1 = up(-box.y);
        SvgPath fine, coarse;
        for (std::int64_t x = x0; x <= x1; ++x)
            (x % 5 == 0 ? coarse : fine).segment({x * step, y0 * step}, {x * step, y1 * step});
        for (std::int64_t y = y0; y <= y1; ++y)
            (y % 5 == 0 ? coarse : fine).segment({x0 * step, y * step}, {x1 * step, y * step});
        return path_tag("grid fine", fine) + path_tag("grid", coarse);
    }

    std::string titled_room(const char* tint, const std::string& id, const std::string& name, const std::string& kind,
                            double area, const SvgPath& path, const std::string& cells = "") const {
        std::string title = name.empty() ? "Unnamed room" : escaped(name);
        title += ", " + area_text(area);
        if (kind != "room" && !kind.empty()) title += ", " + escaped(kind);
        if (!cells.empty()) title += ", " + cells;
        return std::string("<path class=\"room t-") + tint + "\" data-el=\"" + escaped(id) + "\" d=\"" + path.text() +
               "\"><title>" + title + "</title></path>\n";
    }

    /// Terraces and courtyards, which only the plan knows: for the building they are the exterior.
    std::string outdoors() {
        std::string text;
        const plans::Storey* plan = view_.plan_storey(storey_);
        if (!plan) return text;
        for (const plans::Room& room : plan->rooms) {
            if (room.kind != "terrace" && room.kind != "courtyard") continue;
            std::vector<Mm> ring;
            double twice = 0, x = 0, y = 0;
            for (std::size_t k = 0; k < room.polygon.size(); ++k) {
                const plans::Point a = room.polygon[k], b = room.polygon[(k + 1) % room.polygon.size()];
                twice += (a.x - room.polygon[0].x) * (b.y - room.polygon[0].y) -
                         (b.x - room.polygon[0].x) * (a.y - room.polygon[0].y);
                x += a.x, y += a.y;
                ring.push_back(view_.mm(a));
            }
            if (ring.size() < 3) continue;
            SvgPath path;
            path.ring(ring);
            const double area = std::abs(twice) / 2, n = double(ring.size());
            text += titled_room("out", room.id, room.name, room.kind, area, path);
            names_.add({ring}, view_.mm(x / n, y / n), {room.name, area_text(area), ""}, doors_.swept);
        }
        return text;
    }

    std::string rooms() {
        std::string text;
        SvgPath thresholds;
        for (const SpacePart& part : view_.parts(storey_)) {
            const modeler::Space& space = view_.space(part.space);
            if (space.label != Label::Room) {
                if (space.label != Label::Wall) view_.add(part, thresholds);
                continue;
            }
            SvgPath path;
            view_.add(part, path);
            const double area = modeler::area_m2(view_.building(), part);
            const std::string cells = cells_ ? counted(part.volumes.size(), "cell") : "";
            text += titled_room(tint_of(space.kind), space.id, space.name, space.kind, area, path, cells);
            const auto [x, y] = modeler::label_point(view_.building(), part);
            names_.add(view_.rings(part), view_.mm(x, y), {space.name, area_text(area), cells}, doors_.swept);
        }
        return path_tag("threshold", thresholds) + text + path_tag("seam", seams());
    }

    /// Where one room becomes another without a wall.
    SvgPath seams() const {
        const modeler::Building& building = view_.building();
        SvgPath path;
        for (const modeler::Face& face : building.faces) {
            if (face.direction != modeler::Direction::Side) continue;
            const modeler::Volume &front = building.volumes[face.front], &back = building.volumes[face.back];
            if (front.label != Label::Room || back.label != Label::Room || front.space == back.space) continue;
            if (view_.space(front.space).storey != storey_) continue;
            path.segment(view_.mm(building.points[building.edges[face.edge].a]),
                         view_.mm(building.points[building.edges[face.edge].b]));
        }
        return path;
    }

    std::string walls() const {
        const WallOutlines outlines = wall_outlines(view_, storey_);
        return path_tag("wall low", outlines.low) + path_tag("wall", outlines.cut) +
               path_tag("wall column", outlines.columns);
    }

    std::string windows() const {
        SvgPath frames, high;
        for (const SpacePart& part : view_.parts(storey_)) {
            if (view_.space(part.space).label != Label::Window) continue;
            const bool is_cut = view_.is_cut(storey_, view_.building().volumes[part.volumes.front()]);
            view_.add(part, is_cut ? frames : high);
        }
        return path_tag("window", frames) + path_tag("window high", high) +
               path_tag("pane", window_paths(view_, storey_));
    }

    std::string doors() const {
        return path_tag("sill", doors_.sills) + path_tag("passage", opening_paths(view_, storey_)) +
               path_tag("swing", doors_.swings) + path_tag("leaf", doors_.leaves);
    }

    std::string stairs() const {
        SvgPath footprints, shafts, wells;
        for (const SpacePart& part : view_.parts(storey_)) {
            const Label label = view_.space(part.space).label;
            if (label == Label::Stair) view_.add(part, footprints);
            if (label != Label::Shaft) continue;
            view_.add(part, shafts);
            const std::vector<Mm> ring = view_.ring(part.outer);
            if (ring.size() == 4) shafts.segment(ring[0], ring[2]), shafts.segment(ring[1], ring[3]);
        }
        for (const SpacePart& part : view_.wells(storey_)) view_.add(part, wells);
        const StairPaths paths = stair_paths(view_, storey_);
        return path_tag("stair", footprints) + path_tag("shaft", shafts) + path_tag("well", wells) +
               path_tag("tread", paths.treads) + path_tag("arrow", paths.arrows);
    }

    std::string marks(const std::set<std::string>& blamed) const {
        std::map<std::uint32_t, SvgPath> outlines;
        for (const SpacePart& part : view_.parts(storey_)) {
            const modeler::Space& space = view_.space(part.space);
            if (space.label != Label::Room && blamed.count(space.id)) view_.add(part, outlines[part.space]);
        }
        std::string text;
        for (const auto& [space, path] : outlines)
            text +=
                "<path class=\"mark\" data-el=\"" + escaped(view_.space(space).id) + "\" d=\"" + path.text() + "\"/>\n";
        return text;
    }

    static std::string cell_drawing(const CellPaths& cells) {
        return layer("cells", path_tag("cell", cells.cells)) + layer("portals", portal_tags(cells)) +
               layer("cuts", cut_tags(cells)) +
               layer("graph", path_tag("link", cells.links) + path_tag("node", cells.nodes));
    }

    const PlanView& view_;
    std::uint32_t storey_;
    const CellPaths* cells_;
    DoorPaths doors_;
    NameLayer names_;
};

}  // namespace

std::string storey_drawing(const PlanView& view, const Passages& passages, std::uint32_t storey, const CellPaths* cells,
                           const std::set<std::string>& blamed) {
    return StoreyDrawer(view, passages, storey, cells).run(blamed);
}

DrawnBox drawn_box(const PlanView& view) {
    MmBox box = view.box();
    if (box.empty()) {
        const modeler::Building& building = view.building();
        box.add(view.mm(plans::GridPoint{building.site_min[0], building.site_min[1]}));
        box.add(view.mm(plans::GridPoint{building.site_max[0], building.site_max[1]}));
    }
    const double margin = 0.8;
    return {double(box.low.x) / 1000 - margin, -double(box.high.y) / 1000 - margin,
            double(box.high.x - box.low.x) / 1000 + 2 * margin, double(box.high.y - box.low.y) / 1000 + 2 * margin};
}

std::string wall_ground(const PlanView& view, std::uint32_t storey) {
    const WallOutlines outlines = wall_outlines(view, storey);
    SvgPath windows;
    for (const SpacePart& part : view.parts(storey))
        if (view.space(part.space).label == Label::Window) view.add(part, windows);
    return "<g" + std::string(to_page) + ">" + path_tag("ground low", windows) + path_tag("ground low", outlines.low) +
           path_tag("ground", outlines.cut) + path_tag("ground", outlines.columns) + "</g>\n";
}

}  // namespace enfilade::tools

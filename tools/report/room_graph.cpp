#include "tools/report/room_graph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tools/console.h"
#include "tools/report/html_text.h"
#include "tools/report/storey_drawing.h"

namespace enfilade::tools {
namespace {

using modeler::Label;
using modeler::SpacePart;

/// From 6 on rooms have one colour: more shades cannot be told apart.
std::string depth_class(std::uint32_t depth) {
    return depth == unreachable ? "far" : "d" + std::to_string(std::min(depth, 6u));
}

std::string name_of(const modeler::Space& space) {
    if (!space.name.empty()) return space.name;
    return space.label == Label::Room ? "Unnamed room" : space.id;
}

std::string coordinate(std::int64_t mm) { return decimal(double(mm) / 1000, 2); }

class RoomGraph {
public:
    RoomGraph(const PlanView& view, const Passages& passages, std::uint32_t storey)
        : view_(view), passages_(passages), storey_(storey) {
        for (const SpacePart& part : view.parts(storey)) {
            const Label label = view.space(part.space).label;
            if (label != Label::Room && label != Label::Stair && label != Label::Shaft) continue;
            const auto [x, y] = modeler::label_point(view.building(), part);
            places_.emplace(part.space, view.mm(x, y));
        }
    }

    std::string run() {
        for (const Passage& passage : passages_.list) {
            const bool arrives = passage.kind == PassageKind::Stair && passage.storey + 1 == storey_;
            if ((passage.storey != storey_ && !arrives) || passage.kind == PassageKind::Window) continue;
            passage.kind == PassageKind::Stair ? add_stair(passage, arrives) : add_link(passage);
        }
        for (const auto& [space, at] : places_) add_node(space, at);
        return wall_ground(view_, storey_) + "<g class=\"glinks\" fill=\"none\">\n" + links_ +
               "</g>\n<g class=\"gnodes\">\n" + nodes_ + "</g>\n" +
               "<g class=\"names gnames\" data-size=\"0.24\" style=\"--size:.24px\">\n" + names_ + "</g>\n";
    }

private:
    [[nodiscard]] std::string title(std::uint32_t space) const {
        const std::uint32_t depth = passages_.depth[space];
        std::string text = escaped(tools::name_of(view_.space(space)));
        if (view_.space(space).area_m2 > 0) text += ", " + area_text(view_.space(space).area_m2);
        if (depth == unreachable) return text + ": no way leads there";
        return text + ": " + counted(depth, "door") + " from outside";
    }

    void add_node(std::uint32_t space, Mm at) {
        const modeler::Space& s = view_.space(space);
        const double radius = std::clamp(0.14 + 0.045 * std::sqrt(std::max(0.0, s.area_m2)), 0.2, 0.6);
        const std::uint32_t depth = passages_.depth[space];
        nodes_ += "<g class=\"gnode " + depth_class(depth) + (s.label == Label::Room ? "" : " way") + "\" data-el=\"" +
                  escaped(s.id) + "\" style=\"--r:" + decimal(radius, 2) + "\" transform=\"translate(" +
                  coordinate(at.x) + " " + coordinate(-at.y) + ")\"><title>" + title(space) + "</title><circle r=\"" +
                  decimal(radius, 2) + "\"/><text y=\"" + decimal(0.36 * radius, 2) + "\">" +
                  (depth == unreachable ? "?" : std::to_string(depth)) + "</text></g>\n";
        if (s.name.empty() || s.label != Label::Room) return;
        names_ += "<text x=\"" + coordinate(at.x) + "\" y=\"" + decimal(0.27 + radius - double(at.y) / 1000, 2) +
                  "\">" + escaped(s.name) + "</text>\n";
    }

    /// What has no place of its own: the outside before a door, the inside of a deep hole.
    void add_dot(const char* classes, const std::string& title, Mm at) {
        nodes_ += std::string("<g class=\"gdot ") + classes + "\" transform=\"translate(" + coordinate(at.x) + " " +
                  coordinate(-at.y) + ")\"><title>" + title + "</title><path d=\"m-.16-.16h.32v.32h-.32z\"/></g>\n";
    }

    void add_path(const char* kind, const std::string& title, std::initializer_list<Mm> points) {
        links_ += std::string("<path class=\"glink ") + kind + "\" d=\"";
        char letter = 'M';
        for (const Mm at : points) {
            links_ += letter + coordinate(at.x) + " " + coordinate(-at.y);
            letter = 'L';
        }
        links_ += "\"><title>" + title + "</title></path>\n";
    }

    void add_link(const Passage& passage) {
        const bool is_low = passage.space != UINT32_MAX && view_.space(passage.space).id.ends_with("/above");
        const char* kind = is_low                                 ? "low"
                           : passage.kind == PassageKind::Door    ? "door"
                           : passage.kind == PassageKind::Opening ? "opening"
                                                                  : "border";
        std::string what = "Open border";
        if (passage.space != UINT32_MAX) what = tools::name_of(view_.space(passage.space));
        const std::string ends =
            tools::name_of(view_.space(passage.from)) + " – " + tools::name_of(view_.space(passage.to));
        const Mm middle = {(passage.at_from.x + passage.at_to.x) / 2, (passage.at_from.y + passage.at_to.y) / 2};
        const Mm from = end(passage.from, middle, passage.at_from), to = end(passage.to, middle, passage.at_to);
        add_path(kind, escaped(what + ": " + ends), {from, middle, to});
    }

    /// Where a link ends: in the node of a room, else just beyond the hole.
    Mm end(std::uint32_t space, Mm middle, Mm at) {
        const auto place = places_.find(space);
        if (place != places_.end()) return place->second;
        const double dx = double(at.x - middle.x), dy = double(at.y - middle.y);
        const double length = std::max(1.0, std::hypot(dx, dy));
        const bool outside = view_.space(space).label == Label::Exterior;
        const double reach = outside ? 650 : 0;
        const Mm beyond = {at.x + std::llround(dx / length * reach), at.y + std::llround(dy / length * reach)};
        add_dot(outside ? "outside" : "hole", escaped(tools::name_of(view_.space(space))), beyond);
        return beyond;
    }

    void add_stair(const Passage& passage, bool arrives) {
        const std::uint32_t here = arrives ? passage.to : passage.from, there = arrives ? passage.from : passage.to;
        const auto place = places_.find(here);
        if (place == places_.end()) return;
        const Mm at = arrives ? passage.at_to : passage.at_from;
        const std::uint32_t other = arrives ? storey_ - 1 : storey_ + 1;
        const modeler::StoreyInfo& storey = view_.building().storeys[other];
        const std::string title =
            escaped((arrives ? "Down to " : "Up to ") + (storey.name.empty() ? storey.id : storey.name) + ": " +
                    tools::name_of(view_.space(there)));
        const Mm beside = {at.x, at.y + 550};
        add_path("stair", title, {place->second, beside});
        nodes_ += "<g class=\"gstair\" transform=\"translate(" + coordinate(beside.x) + " " + coordinate(-beside.y) +
                  ")\"><title>" + title + "</title><path d=\"" +
                  (arrives ? "m0 .24l-.24-.4h.48z" : "m0-.24l-.24.4h.48z") + "\"/></g>\n";
    }

    const PlanView& view_;
    const Passages& passages_;
    std::uint32_t storey_;
    std::map<std::uint32_t, Mm> places_;  ///< of spaces that are nodes
    std::string links_, nodes_, names_;
};

}  // namespace

std::string room_graph(const PlanView& view, const Passages& passages, std::uint32_t storey) {
    return RoomGraph(view, passages, storey).run();
}

std::string room_graph_caption(const PlanView& view, const Passages& passages, std::uint32_t storey) {
    std::set<std::uint32_t> rooms;
    for (const SpacePart& part : view.parts(storey))
        if (view.space(part.space).label == Label::Room) rooms.insert(part.space);
    std::size_t links = 0;
    for (const Passage& passage : passages.list)
        links += passage.storey == storey && passage.kind != PassageKind::Window;
    std::uint32_t deepest = 0;
    std::string lost;
    std::size_t lost_count = 0;
    for (const std::uint32_t room : rooms) {
        const std::uint32_t depth = passages.depth[room];
        if (depth != unreachable) {
            deepest = std::max(deepest, depth);
            continue;
        }
        if (++lost_count <= 8) lost += (lost_count == 1 ? "" : ", ") + escaped(name_of(view.space(room)));
    }
    std::string text = counted(rooms.size(), "room") + ", " + counted(links, "link") + "; " + counted(deepest, "door") +
                       " from outside at most.";
    if (lost_count > 0)
        text += " <strong>No way leads to</strong> " + lost +
                (lost_count > 8 ? " and " + counted(lost_count - 8, "more room") : "") + ".";
    return text;
}

}  // namespace enfilade::tools

#include "modeler/exports/dot.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "modeler/exports/scene_measure.h"
#include "modeler/exports/space_graph.h"
#include "plans/number_text.h"
#include "plans/utf8.h"

namespace enfilade::modeler {
namespace {

using plans::rounded_text;

constexpr std::uint32_t no_storey = UINT32_MAX;
constexpr double points_per_metre = 72 / 0.0254 / 40;  // 1:40
constexpr const char* head = R"(graph "enfilade" {
  graph [layout=neato, inputscale=72, splines=line, fontname="sans-serif", fontsize=10, color="#999999"];
  node [fontname="sans-serif", fontsize=9, style=filled, fillcolor="#ffffff", color="#444444"];
  edge [fontname="sans-serif", fontsize=7, color="#444444"];
)";

/// Inside double quotes: a quote and a backslash are escaped, line breaks are, other control characters left out.
std::string quoted(std::string_view text) {
    std::string out = "\"";
    for (const char c : plans::to_utf8(text)) {
        if (c == '"' || c == '\\') out += '\\';
        if (c == '\n') out += "\\n";
        else if (static_cast<unsigned char>(c) >= ' ' && c != '\x7F') out += c;
    }
    return out += '"';
}

const char* look_of(accel::Label label) {
    switch (label) {
        case accel::Label::Room: return "shape=box, fillcolor=\"#fdf6e3\"";
        case accel::Label::Door: return "shape=ellipse, fillcolor=\"#d9c2a3\"";
        case accel::Label::Window: return "shape=ellipse, fillcolor=\"#cfe8f3\"";
        case accel::Label::Stair:
        case accel::Label::Shaft: return "shape=box, fillcolor=\"#e3d7ee\"";
        case accel::Label::Exterior: return "shape=box, fillcolor=\"#dcebd0\", style=\"filled,rounded\"";
        default: return "shape=ellipse";
    }
}

const char* look_of(accel::PortalKind kind) {
    switch (kind) {
        case accel::PortalKind::Clear: return "style=solid";
        case accel::PortalKind::Virtual: return "style=dotted";
        case accel::PortalKind::Glass: return "style=dashed, color=\"#4a90b8\"";
    }
    return "style=solid";
}

class Writer {
public:
    explicit Writer(const accel::SceneView& scene) : scene_(scene), areas_(portal_areas(scene)) {
        double low = 0;
        double high = 0;
        bool is_first = true;
        for (std::size_t c = 0; c < scene.cells.size(); ++c) {
            if (scene.spaces[index(scene.cells[c].space)].storey_index == no_storey) continue;
            const double y = measure(scene, accel::CellId(c)).centre[1];
            low = is_first ? y : std::min(low, y);
            high = is_first ? y : std::max(high, y);
            is_first = false;
        }
        storey_step_ = high - low + 4;
    }

    std::string spaces() {
        const SpaceGraph graph = space_graph(scene_, areas_);
        // Storeys in the order of their first space; what belongs to none stands outside all clusters.
        std::vector<std::pair<std::string, std::vector<std::size_t>>> storeys = {{"", {}}};
        std::map<std::string, std::size_t, std::less<>> known = {{"", 0}};
        for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
            const std::string storey(scene_.string(scene_.spaces[graph.nodes[n].space].storey));
            const auto [at, is_new] = known.try_emplace(storey, storeys.size());
            if (is_new) storeys.push_back({storey, {}});
            storeys[at->second].second.push_back(n);
        }
        for (std::size_t k = 0; k < storeys.size(); ++k) {
            if (k > 0) open_cluster(k, storeys[k].first);
            for (const std::size_t n : storeys[k].second) {
                const SpaceNode& node = graph.nodes[n];
                const accel::Space& space = scene_.spaces[node.space];
                std::string label = name_of_space(space);
                if (space.label == accel::Label::Room) label += '\n' + rounded_text(node.measure.floor_area, 1) + " m²";
                add_node("s" + std::to_string(node.space), label, space.label, space.storey_index, node.measure);
            }
            if (k > 0) text_ += "  }\n";
        }
        for (const SpaceLink& link : graph.links)
            add_edge("s" + std::to_string(link.from), "s" + std::to_string(link.to), link.kind, link.opening);
        return std::move(text_ += "}\n");
    }

    std::string cells() {
        std::vector<std::vector<std::uint32_t>> members(scene_.spaces.size());
        for (std::uint32_t c = 0; c < scene_.cells.size(); ++c) members[index(scene_.cells[c].space)].push_back(c);
        for (std::size_t s = 0; s < members.size(); ++s) {
            if (members[s].empty()) continue;
            open_cluster(s, name_of_space(scene_.spaces[s]));
            for (const std::uint32_t c : members[s])
                add_node("c" + std::to_string(c), std::to_string(c), scene_.cells[c].label,
                         scene_.spaces[s].storey_index, measure(scene_, accel::CellId(c)));
            text_ += "  }\n";
        }
        for (std::size_t p = 0; p < scene_.portals.size(); ++p) {
            const accel::Portal& portal = scene_.portals[p];
            add_edge("c" + std::to_string(index(portal.front)), "c" + std::to_string(index(portal.back)), portal.kind(),
                     areas_[p]);
        }
        return std::move(text_ += "}\n");
    }

private:
    std::string name_of_space(const accel::Space& space) const {
        for (const accel::TextId text : {space.name, space.id})
            if (!scene_.string(text).empty()) return std::string(scene_.string(text));
        return accel::name_of(space.label);
    }
    void open_cluster(std::size_t number, const std::string& label) {
        text_ += "  subgraph cluster_" + std::to_string(number) + " {\n    label=" + quoted(label) + ";\n";
    }
    /// Storeys are drawn over each other, each as the plan has it.
    double rise_of(std::uint32_t storey) const { return storey == no_storey ? 0 : storey * storey_step_; }
    void add_node(const std::string& id, const std::string& label, accel::Label kind, std::uint32_t storey,
                  const CellMeasure& measure) {
        text_ += "    " + id + " [label=" + quoted(label) + ", " + look_of(kind) + ", pos=\"" +
                 rounded_text(measure.centre[0] * points_per_metre, 2) + ',' +
                 rounded_text((measure.centre[1] + rise_of(storey)) * points_per_metre, 2) + "!\"];\n";
    }
    void add_edge(const std::string& from, const std::string& to, accel::PortalKind kind, double opening) {
        text_ += "  " + from + " -- " + to + " [" + look_of(kind) + ", label=\"" + rounded_text(opening, 2) + "\"];\n";
    }

    const accel::SceneView& scene_;
    std::vector<double> areas_;
    double storey_step_ = 0;  ///< metres
    std::string text_ = head;
};

}  // namespace

std::string to_dot(const accel::SceneView& scene, GraphLevel level) {
    Writer writer(scene);
    return level == GraphLevel::Spaces ? writer.spaces() : writer.cells();
}

}  // namespace enfilade::modeler

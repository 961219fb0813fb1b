#pragma once
// FloorspaceJS texts made by hand: a story of rectangles that share their edges.

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "plans/read.h"

namespace enfilade::testing {

/// Grows a story as the editor writes it: vertices and edges are shared where they coincide.
class FloorText {
public:
    /// A space around these corners; its edges run from each corner to the next. Returns its number, from 0.
    std::size_t space(const std::string& name, const std::vector<std::pair<double, double>>& corners,
                      const std::string& more = "") {
        std::string edges, order;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const std::size_t a = vertex(corners[k]);
            const std::size_t b = vertex(corners[(k + 1) % corners.size()]);
            const bool forward = !edges_.contains({b, a});
            const std::size_t number = forward ? edge(a, b) : edges_.at({b, a});
            edges += (k > 0 ? ",\"e" : "\"e") + std::to_string(number) + "\"";
            order += (k > 0 ? "," : "") + std::string(forward ? "1" : "0");
        }
        const std::string n = std::to_string(spaces_.size());
        faces_.push_back("{\"id\":\"f" + n + "\",\"edge_ids\":[" + edges + "],\"edge_order\":[" + order + "]}");
        spaces_.push_back("{\"id\":\"s" + n + "\",\"name\":\"" + name + "\",\"face_id\":\"f" + n + "\"" +
                          (more.empty() ? "" : "," + more) + "}");
        return spaces_.size() - 1;
    }

    std::size_t box(const std::string& name, double x0, double y0, double x1, double y1, const std::string& more = "") {
        return space(name, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, more);
    }

    /// An edge between corners that stand already, by their places.
    [[nodiscard]] std::string edge_id(std::pair<double, double> a, std::pair<double, double> b) const {
        return "e" + std::to_string(edges_.at({vertices_.at(a), vertices_.at(b)}));
    }

    [[nodiscard]] std::size_t edges() const { return edges_.size(); }

    void window(const std::string& id, const std::string& definition, const std::string& edge,
                const std::string& alpha) {
        windows_.push_back("{\"id\":\"" + id + "\",\"window_definition_id\":\"" + definition + "\",\"edge_id\":\"" +
                           edge + "\",\"alpha\":" + alpha + "}");
    }
    void door(const std::string& id, const std::string& definition, const std::string& edge, const std::string& alpha) {
        doors_.push_back("{\"id\":\"" + id + "\",\"door_definition_id\":\"" + definition + "\",\"edge_id\":\"" + edge +
                         "\",\"alpha\":" + alpha + "}");
    }

    /// `members`: of the story, besides its geometry and what stands in it. `backwards`: all lists from their ends.
    [[nodiscard]] std::string story(const std::string& members =
                                        "\"id\":\"g\",\"name\":\"Ground\","
                                        "\"floor_to_ceiling_height\":3",
                                    bool backwards = false) const {
        const auto list = [&](const char* key, std::vector<std::string> items) {
            if (backwards) std::reverse(items.begin(), items.end());
            std::string text = "\"" + std::string(key) + "\":[";
            for (std::size_t k = 0; k < items.size(); ++k) text += (k > 0 ? ",\n" : "") + items[k];
            return text + "]";
        };
        return "{" + members + ",\n\"geometry\":{\"id\":\"geometry\"," + list("vertices", vertex_list_) + ",\n" +
               list("edges", edge_list_) + ",\n" + list("faces", faces_) + "},\n" + list("spaces", spaces_) +
               ",\n\"shading\":[],\n" + list("windows", windows_) + ",\n" + list("doors", doors_) + "}";
    }

private:
    std::size_t vertex(std::pair<double, double> at) {
        const auto [found, fresh] = vertices_.try_emplace(at, vertices_.size());
        if (fresh)
            vertex_list_.push_back("{\"id\":\"v" + std::to_string(found->second) + "\",\"x\":" +
                                   std::to_string(at.first) + ",\"y\":" + std::to_string(at.second) + "}");
        return found->second;
    }
    std::size_t edge(std::size_t a, std::size_t b) {
        const auto [found, fresh] = edges_.try_emplace({a, b}, edges_.size());
        if (fresh)
            edge_list_.push_back("{\"id\":\"e" + std::to_string(found->second) + "\",\"vertex_ids\":[\"v" +
                                 std::to_string(a) + "\",\"v" + std::to_string(b) + "\"]}");
        return found->second;
    }

    std::map<std::pair<double, double>, std::size_t> vertices_;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> edges_;
    std::vector<std::string> vertex_list_, edge_list_, faces_, spaces_, windows_, doors_;
};

/// Definitions "single" (2 x 1.5 at 0.9), "row" (1 x 1 at 1, every 2 m), "half" (ratio 0.5 at 0.8), door "door".
inline const std::string floor_definitions = R"("window_definitions":[
{"id":"single","name":"Single","window_definition_mode":"Single Window","width":2,"height":1.5,"sill_height":0.9},
{"id":"row","name":"Row","window_definition_mode":"Repeating Windows","width":1,"height":1,"sill_height":1,"window_spacing":1},
{"id":"half","name":"Half","window_definition_mode":"Window to Wall Ratio","wwr":0.5,"sill_height":0.8}],
"door_definitions":[{"id":"door","name":"Oak door","width":0.9,"height":2.1,"door_type":"Door"}])";

/// A file in metres with these stories.
inline std::string floor_plan(const std::vector<std::string>& stories,
                              const std::string& project = R"({"config":{"units":"si"},"north_axis":0})") {
    std::string text = "{\"project\":" + project + ",\n\"stories\":[";
    for (std::size_t k = 0; k < stories.size(); ++k) text += (k > 0 ? ",\n" : "") + stories[k];
    return text + "],\n" + floor_definitions + "}";
}

inline plans::Plan read_floor(const std::vector<std::string>& stories, const plans::ReadOptions& options = {}) {
    return plans::read_floorspace(floor_plan(stories), "floor.json", options);
}

/// The findings with this code.
inline std::vector<Finding> floor_findings(const plans::Plan& plan, std::string_view code) {
    std::vector<Finding> found;
    for (const Finding& finding : plan.findings)
        if (finding.code == code) found.push_back(finding);
    return found;
}

}  // namespace enfilade::testing

#include "modeler/exports/graphml.h"

#include <charconv>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "modeler/exports/scene_measure.h"
#include "modeler/exports/space_graph.h"
#include "modeler/exports/xml_text.h"

namespace enfilade::modeler {

namespace {

constexpr const char* head = R"(<?xml version="1.0" encoding="UTF-8"?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns"
    xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
    xsi:schemaLocation="http://graphml.graphdrawing.org/xmlns http://graphml.graphdrawing.org/xmlns/1.0/graphml.xsd">
  <key id="label" for="node" attr.name="label" attr.type="string"/>
  <key id="id" for="node" attr.name="id" attr.type="string"/>
  <key id="name" for="node" attr.name="name" attr.type="string"/>
  <key id="storey" for="node" attr.name="storey" attr.type="string"/>
  <key id="area" for="node" attr.name="area_m2" attr.type="double"/>
  <key id="volume" for="node" attr.name="volume_m3" attr.type="double"/>
  <key id="x" for="node" attr.name="x" attr.type="double"/>
  <key id="y" for="node" attr.name="y" attr.type="double"/>
  <key id="z" for="node" attr.name="z" attr.type="double"/>
  <key id="space" for="node" attr.name="space" attr.type="string"/>
  <key id="kind" for="edge" attr.name="kind" attr.type="string"/>
  <key id="opening" for="edge" attr.name="opening_m2" attr.type="double"/>
)";

std::string number(double value) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, value + 0.0).ptr};
}

class Writer {
public:
    explicit Writer(const accel::SceneView& scene) : scene_(scene), areas_(portal_areas(scene)) {
        for (std::size_t c = 0; c < scene.cells.size(); ++c) measures_.push_back(measure(scene, accel::CellId(c)));
    }

    std::string write() {
        write_spaces();
        write_cells();
        return std::move(text_ += "</graphml>\n");
    }

private:
    void data(const char* key, std::string_view value) {
        if (!value.empty()) text_ += "      <data key=\"" + std::string(key) + "\">" + xml_text(value) + "</data>\n";
    }
    void data(const char* key, double value) { data(key, std::string_view(number(value))); }

    void measure_data(const CellMeasure& measure) {
        data("area", measure.floor_area);
        data("volume", measure.volume);
        data("x", measure.centre[0]);
        data("y", measure.centre[1]);
        data("z", measure.centre[2]);
    }

    void edge(const std::string& from, const std::string& to, std::string_view kind, double opening) {
        text_ += "    <edge source=\"" + from + "\" target=\"" + to + "\">\n";
        data("kind", kind);
        data("opening", opening);
        text_ += "    </edge>\n";
    }

    static std::string space_node(std::uint32_t space) { return "s" + std::to_string(space); }
    static std::string cell_node(std::uint32_t cell) { return "c" + std::to_string(cell); }
    std::uint32_t space_of(accel::CellId cell) const { return std::uint32_t(index(scene_.cells[index(cell)].space)); }

    void write_spaces() {
        text_ += "  <graph id=\"spaces\" edgedefault=\"undirected\">\n";
        const SpaceGraph graph = space_graph(scene_, areas_);
        for (const SpaceNode& node : graph.nodes) {
            const accel::Space& space = scene_.spaces[node.space];
            text_ += "    <node id=\"" + space_node(node.space) + "\">\n";
            data("label", accel::name_of(space.label));
            data("id", scene_.string(space.id));
            data("name", scene_.string(space.name));
            data("storey", scene_.string(space.storey));
            measure_data(node.measure);
            text_ += "    </node>\n";
        }
        for (const SpaceLink& link : graph.links)
            edge(space_node(link.from), space_node(link.to), accel::name_of(link.kind), link.opening);
        text_ += "  </graph>\n";
    }

    void write_cells() {
        text_ += "  <graph id=\"cells\" edgedefault=\"undirected\">\n";
        for (std::uint32_t c = 0; c < measures_.size(); ++c) {
            text_ += "    <node id=\"" + cell_node(c) + "\">\n";
            data("label", accel::name_of(scene_.cells[c].label));
            data("space", space_node(space_of(accel::CellId(c))));
            measure_data(measures_[c]);
            text_ += "    </node>\n";
        }
        for (std::size_t p = 0; p < scene_.portals.size(); ++p) {
            const accel::Portal& portal = scene_.portals[p];
            edge(cell_node(std::uint32_t(index(portal.front))), cell_node(std::uint32_t(index(portal.back))),
                 accel::name_of(portal.kind()), areas_[p]);
        }
        text_ += "  </graph>\n";
    }

    const accel::SceneView& scene_;
    std::vector<double> areas_;
    std::vector<CellMeasure> measures_;
    std::string text_ = head;
};

}  // namespace

std::string to_graphml(const accel::SceneView& scene) { return Writer(scene).write(); }

}  // namespace enfilade::modeler

#include "tools/report/scene_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "modeler/space_parts.h"
#include "tools/console.h"
#include "tools/report/html_text.h"
#include "tools/report/name_layer.h"
#include "tools/report/object_signs.h"

namespace enfilade::tools {
namespace {

using accel::Label;

/// Soft, and of hues that cuts do not have at their strength.
constexpr std::array<const char*, 6> tints = {"#eef3fa", "#f0f5ea", "#f8f1ea", "#f2eef8", "#e9f4f3", "#f7f4e4"};

/// A tint for each space, none beside its like where that can be: by the boxes of what is already tinted.
std::vector<std::size_t> tint_spaces(const std::vector<SpaceOutline>& spaces) {
    constexpr std::int64_t wall = 600;  // mm: rooms that are this near are neighbours
    std::vector<std::size_t> tint(spaces.size(), 0);
    std::vector<MmBox> boxes(spaces.size());
    for (std::size_t i = 0; i < spaces.size(); ++i) {
        std::array<int, tints.size()> near = {};
        for (const std::vector<Mm>& ring : spaces[i].rings)
            for (const Mm at : ring) boxes[i].add(at);
        if (spaces[i].label != Label::Room) continue;
        for (std::size_t j = 0; j < i; ++j)
            if (spaces[j].label == Label::Room && boxes[i].low.x <= boxes[j].high.x + wall &&
                boxes[j].low.x <= boxes[i].high.x + wall && boxes[i].low.y <= boxes[j].high.y + wall &&
                boxes[j].low.y <= boxes[i].high.y + wall)
                ++near[tint[j]];
        tint[i] = std::size_t(std::min_element(near.begin(), near.end()) - near.begin());
    }
    return tint;
}

SvgPath path_of(const std::vector<std::vector<Mm>>& rings) {
    SvgPath path;
    for (const std::vector<Mm>& ring : rings) path.ring(ring);
    return path;
}

const char* class_of(Label label) {
    switch (label) {
        case Label::Room: return "room";
        case Label::Window: return "window";
        case Label::Stair:
        case Label::Shaft: return "stair";
        default: return "door";
    }
}

Mm place_of_name(const SpaceOutline& outline) {
    std::vector<modeler::OutlineSide> sides;
    for (const std::vector<Mm>& ring : outline.rings)
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Mm a = ring[k], b = ring[(k + 1) % ring.size()];
            sides.push_back({double(a.x), double(a.y), double(b.x), double(b.y)});
        }
    const auto [x, y] = modeler::label_point(std::move(sides));
    return {std::llround(x), std::llround(y)};
}

/// What names keep off where they can: the cuts of each space, in boxes no longer than a letter or two.
std::map<accel::SpaceId, std::vector<MmBox>> cut_boxes(const accel::SceneView& scene, const CellPlan& cells) {
    constexpr double step = 200;  // mm
    std::map<accel::SpaceId, std::vector<MmBox>> boxes;
    for (const CellSide& side : cells.sides) {
        if (side.kind != SideKind::Cut) continue;
        std::vector<MmBox>& of_space = boxes[scene.cells[side.front].space];
        const double dx = double(side.to.x - side.from.x), dy = double(side.to.y - side.from.y);
        const int parts = std::clamp(int(std::hypot(dx, dy) / step), 1, 500);
        const auto at = [&](int k) {
            return Mm{side.from.x + std::llround(dx * k / parts), side.from.y + std::llround(dy * k / parts)};
        };
        for (int k = 0; k < parts; ++k) {
            MmBox& box = of_space.emplace_back();
            box.add(at(k)), box.add(at(k + 1));
            // A level cut has a box all the same.
            box.add({box.low.x - 1, box.low.y - 1});
        }
    }
    return boxes;
}

}  // namespace

std::string scene_drawing(const accel::SceneView& scene, const ScenePlan& plan, std::uint32_t storey_index) {
    std::string text = "<g transform=\"scale(.001 -.001)\">\n";
    const SvgPath solid = path_of(plan.solid);
    text += path_tag(plan.is_underground ? "wall buried" : "wall", solid);
    const CellPaths outside = cell_paths(plan.outside), inside = cell_paths(plan.inside);
    if (const std::string cuts = cut_tags(outside); !cuts.empty()) text += "<g class=\"outside\">\n" + cuts + "</g>\n";
    NameLayer names;
    std::map<accel::SpaceId, std::vector<MmBox>> cut_off = cut_boxes(scene, plan.inside);
    const std::vector<std::size_t> tint = tint_spaces(plan.spaces);
    for (std::size_t k = 0; k < plan.spaces.size(); ++k) {
        const SpaceOutline& outline = plan.spaces[k];
        const accel::Space& space = scene.spaces[index(outline.space)];
        std::string classes = class_of(outline.label);
        if (outline.label == Label::Room) classes += " t" + std::to_string(tint[k]);
        const std::string cells = counted(outline.cells, "cell"), measure = area_text(space.area_m2) + " · " + cells;
        text += "<path class=\"" + classes + "\" data-space=\"" + escaped(scene.string(space.id)) + "\" d=\"" +
                path_of(outline.rings).text() + "\"><title>" + escaped(scene.string(space.name)) +
                (outline.label == Label::Room ? ", " + measure : ", " + cells) + "</title></path>\n";
        if (outline.label == Label::Room && space.storey_index == storey_index && !outline.rings.empty())
            names.add(outline.rings, place_of_name(outline), {std::string(scene.string(space.name)), measure, ""},
                      cut_off[outline.space]);
    }
    text +=
        path_tag("cell", inside.cells) + portal_tags(inside) + "<g class=\"inside\">\n" + cut_tags(inside) + "</g>\n";
    text += path_tag("object", object_paths(scene, storey_index));
    return text + "</g>\n" + names.text();
}

std::string scene_style(double pixels_per_mm) {
    const auto width = [&](double pixels) { return "stroke-width: " + decimal(pixels / pixels_per_mm, 1) + "; "; };
    std::string text =
        "text { font-family: 'DejaVu Sans', 'Noto Sans', Arial, sans-serif; fill: #23272d; }\n"
        ".sheet-title { font-size: 18px; font-weight: 600; }\n.panel-title { font-size: 15px; font-weight: 600; }\n"
        ".line { font-size: 13px; fill: #4a515b; }\n.key { font-size: 12px; fill: #4a515b; }\n"
        ".bound { text-anchor: middle; }\n.paper { fill: #fff; }\n.outdoors { fill: #f4f3ee; }\n"
        ".ground { fill: #ddd6ca; }\npath { fill: none; }\n";
    text += ".wall { fill: #363b43; stroke: #363b43; stroke-linejoin: round; " + width(0.6) + "}\n";
    // Below ground nothing says where a wall ends and the earth begins: it is drawn as thick as walls are.
    text += ".wall.buried { fill: none; stroke-width: 500; }\n";
    for (std::size_t k = 0; k < tints.size(); ++k)
        text += ".room.t" + std::to_string(k) + " { fill: " + tints[k] + "; }\n";
    text += ".door { fill: #dff0e4; }\n.window { fill: #d9ebf3; }\n.stair { fill: #ecebe6; }\n";
    text += ".cell { stroke: #7d8590; stroke-linecap: round; " + width(0.5) + "}\n";
    text += ".object { fill: #fff; fill-opacity: .55; stroke: #55504a; stroke-linejoin: round; " + width(0.8) + "}\n";
    text += ".portal { stroke-linecap: round; " + width(1.5) + "}\n";
    text +=
        ".portal.clear { stroke: #2e8b57; }\n.portal.glass { stroke: #2f8fb5; }\n.portal.shut { stroke: #7a4a2a; }\n";
    text += ".portal.border { stroke: #5f6670; stroke-dasharray: " + decimal(1 / pixels_per_mm, 1) + " " +
            decimal(3 / pixels_per_mm, 1) + "; }\n";
    text += plain_area_style();
    text += ".cut { stroke-linecap: round; " + width(1.6) + "}\n.outside .cut { " + width(1) + "opacity: .45; }\n";
    text +=
        ".swatch { stroke-width: 10; }\n.legend-line { stroke-width: 2.4; }\n"
        ".legend-line.border { stroke-dasharray: 1.5 4.5; }\n";
    text += ".scalebar path { stroke: #23272d; stroke-width: 1.4; }\n";
    text +=
        ".names text { text-anchor: middle; font-weight: 500; paint-order: stroke; stroke: #fff; stroke-opacity: .85; "
        "stroke-width: .2em; stroke-linejoin: round; }\n.names .area { font-size: .78em; fill: #4a515b; }\n";
    return text;
}

}  // namespace enfilade::tools

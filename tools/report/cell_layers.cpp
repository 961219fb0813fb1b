#include "tools/report/cell_layers.h"

#include <algorithm>
#include <cmath>

#include "modeler/face_label.h"

namespace enfilade::tools {

using modeler::Direction;
using modeler::Face;
using modeler::FaceKind;
using modeler::Volume;

namespace {
/// All portals between two cells: their areas, and their middles times their lengths. Convex cells meet in one plane,
/// so to a ray they are one.
struct Joint {
    double area = 0, length = 0, x = 0, y = 0;
};
using CellPair = std::pair<std::uint32_t, std::uint32_t>;

SvgPath* path_of(CellPaths& paths, SideKind kind, double area) {
    switch (kind) {
        case SideKind::Solid: return nullptr;
        case SideKind::Leaf: return &paths.leaves;
        case SideKind::Clear: return &paths.clear;
        case SideKind::Glass: return &paths.glass;
        case SideKind::Seam: return &paths.border;
        case SideKind::Cut: return &paths.cuts[area_class(area)];
    }
    return nullptr;
}
}  // namespace

SideKind side_kind(accel::PortalKind kind, bool same_space) {
    if (kind == accel::PortalKind::Glass) return SideKind::Glass;
    if (kind == accel::PortalKind::Clear) return SideKind::Clear;
    return same_space ? SideKind::Cut : SideKind::Seam;
}

std::size_t CellPaths::size() const {
    std::size_t bytes =
        cells.size() + clear.size() + border.size() + glass.size() + leaves.size() + nodes.size() + links.size();
    for (const SvgPath& path : cuts) bytes += path.size();
    return bytes;
}

CellCounts count_cells(const modeler::Building& building) {
    const modeler::OpeningFaces openings(building);
    CellCounts counts;
    for (const Volume& volume : building.volumes) counts.cells += carries_light(volume.label);
    for (const Face& face : building.faces) counts.portals += modeler::face_kind(building, openings, face).is_portal;
    return counts;
}

CellPlan cell_plan(const PlanView& view, std::uint32_t storey) {
    const modeler::Building& building = view.building();
    const modeler::OpeningFaces openings(building);
    const std::int32_t level = view.cut_level(storey);
    CellPlan plan;
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v)
        if (carries_light(building.volumes[v].label) && view.is_cut(storey, building.volumes[v]))
            plan.middles.emplace(v, view.middle(building.pieces[building.volumes[v].piece]));
    for (const Face& face : building.faces) {
        if (face.direction != Direction::Side || face.z_low > level || face.z_high <= level) continue;
        const Volume &front = building.volumes[face.front], &back = building.volumes[face.back];
        if (!carries_light(front.label) && !carries_light(back.label)) continue;
        const plans::GridPoint a = building.points[building.edges[face.edge].a];
        const plans::GridPoint b = building.points[building.edges[face.edge].b];
        const FaceKind kind = modeler::face_kind(building, openings, face);
        CellSide side{view.mm(a), view.mm(b), face.front, face.back};
        if (kind.forced) side.kind = SideKind::Leaf;
        else if (kind.is_portal) side.kind = side_kind(kind.portal, front.space == back.space);
        const double unit = building.frame.unit;
        side.area_m2 = std::hypot(double(b.x) - a.x, double(b.y) - a.y) * unit * (face.z_high - face.z_low) * unit;
        plan.sides.push_back(side);
    }
    return plan;
}

CellPaths cell_paths(const CellPlan& plan) {
    CellPaths paths;
    std::map<CellPair, Joint> joints;
    const auto is_portal = [](const CellSide& side) { return side.kind > SideKind::Leaf; };
    for (const CellSide& side : plan.sides) {
        if (!is_portal(side)) continue;
        Joint& joint = joints[std::minmax(side.front, side.back)];
        const Mm a = side.from, b = side.to;
        const double length = std::hypot(double(b.x - a.x), double(b.y - a.y)) + 1e-6;
        joint.area += side.area_m2, joint.length += length;
        joint.x += length * double(a.x + b.x) / 2, joint.y += length * double(a.y + b.y) / 2;
    }
    for (const auto& [cell, middle] : plan.middles) paths.nodes.dot(middle);
    for (const CellSide& side : plan.sides) {
        paths.cells.segment(side.from, side.to);
        const double area = is_portal(side) ? joints.at(std::minmax(side.front, side.back)).area : 0;
        if (SvgPath* path = path_of(paths, side.kind, area)) path->segment(side.from, side.to);
    }
    if (plan.middles.empty()) return paths;
    for (const auto& [cells, joint] : joints) {
        paths.links.move(plan.middles.at(cells.first));
        paths.links.line({std::llround(joint.x / joint.length), std::llround(joint.y / joint.length)});
        paths.links.line(plan.middles.at(cells.second));
    }
    return paths;
}

std::string portal_tags(const CellPaths& paths) {
    return path_tag("portal clear", paths.clear) + path_tag("portal border", paths.border) +
           path_tag("portal glass", paths.glass) + path_tag("portal shut", paths.leaves);
}

std::string cut_tags(const CellPaths& paths) {
    std::string text;
    for (std::size_t k = 0; k < paths.cuts.size(); ++k) text += path_tag("cut a" + std::to_string(k), paths.cuts[k]);
    return text;
}

}  // namespace enfilade::tools

#include "tools/report/cell_layers.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "modeler/face_label.h"

namespace enfilade::tools {

using modeler::Direction;
using modeler::Face;
using modeler::FaceKind;
using modeler::Volume;

namespace {
/// All portals between two cells: their middles times their lengths.
struct Joint {
    double length = 0, x = 0, y = 0;
};
}  // namespace

std::size_t CellPaths::size() const {
    return cells.size() + clear.size() + border.size() + glass.size() + leaves.size() + nodes.size() + links.size();
}

CellCounts count_cells(const modeler::Building& building) {
    const modeler::OpeningFaces openings(building);
    CellCounts counts;
    for (const Volume& volume : building.volumes) counts.cells += carries_light(volume.label);
    for (const Face& face : building.faces) counts.portals += modeler::face_kind(building, openings, face).is_portal;
    return counts;
}

CellPaths cell_paths(const PlanView& view, std::uint32_t storey) {
    const modeler::Building& building = view.building();
    const modeler::OpeningFaces openings(building);
    const std::int32_t level = view.cut_level(storey);
    CellPaths paths;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Joint> joints;  // by cells
    for (const Volume& volume : building.volumes)
        if (carries_light(volume.label) && view.is_cut(storey, volume))
            paths.nodes.dot(view.middle(building.pieces[volume.piece]));
    for (const Face& face : building.faces) {
        if (face.direction != Direction::Side || face.z_low > level || face.z_high <= level) continue;
        const Volume &front = building.volumes[face.front], &back = building.volumes[face.back];
        if (!carries_light(front.label) && !carries_light(back.label)) continue;
        const Mm a = view.mm(building.points[building.edges[face.edge].a]);
        const Mm b = view.mm(building.points[building.edges[face.edge].b]);
        paths.cells.segment(a, b);
        const FaceKind kind = modeler::face_kind(building, openings, face);
        if (kind.forced) paths.leaves.segment(a, b);
        if (!kind.is_portal) continue;
        SvgPath& portal = kind.portal == accel::PortalKind::Clear     ? paths.clear
                          : kind.portal == accel::PortalKind::Virtual ? paths.border
                                                                      : paths.glass;
        portal.segment(a, b);
        Joint& joint = joints[std::minmax(face.front, face.back)];
        const double length = std::hypot(double(b.x - a.x), double(b.y - a.y)) + 1e-6;
        joint.length += length;
        joint.x += length * double(a.x + b.x) / 2, joint.y += length * double(a.y + b.y) / 2;
    }
    for (const auto& [cells, joint] : joints) {
        paths.links.move(view.middle(building.pieces[building.volumes[cells.first].piece]));
        paths.links.line({std::llround(joint.x / joint.length), std::llround(joint.y / joint.length)});
        paths.links.line(view.middle(building.pieces[building.volumes[cells.second].piece]));
    }
    return paths;
}

}  // namespace enfilade::tools

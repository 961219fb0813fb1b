#include "modeler/place.h"

#include <algorithm>
#include <cctype>

namespace enfilade::modeler {
namespace {

std::array<double, 3> world(const Building& building, double x, double y, double z) {
    return {building.frame.origin_x + building.frame.unit * x, building.frame.origin_y + building.frame.unit * y,
            building.frame.origin_z + building.frame.unit * z};
}

void add_element(const Building& building, std::uint32_t space_index, Finding& finding) {
    const Space& space = building.spaces[space_index];
    std::string kind = accel::name_of(space.label);
    std::transform(kind.begin(), kind.end(), kind.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    for (const ElementRef& known : finding.elements)
        if (known.id == space.id && known.kind == kind) return;
    finding.elements.push_back({kind, space.id, space.name});
    if (finding.storey.empty() && space.storey < building.storeys.size())
        finding.storey = building.storeys[space.storey].id;
}

}  // namespace

std::string title(const Space& space) {
    std::string kind = accel::name_of(space.label);
    std::transform(kind.begin(), kind.end(), kind.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return kind + " \"" + (space.name.empty() ? space.id : space.name) + "\"";
}

void place_at_volume(const Building& building, std::uint32_t volume, Finding& finding) {
    if (volume >= building.volumes.size()) return;
    const Volume& v = building.volumes[volume];
    add_element(building, v.space, finding);
    if (finding.point || v.piece >= building.pieces.size()) return;
    const Piece& piece = building.pieces[v.piece];
    double x = 0, y = 0;
    for (std::uint32_t k = 0; k < piece.corner_count; ++k) {
        const plans::GridPoint p = building.points[building.corners[piece.first_corner + k].vertex];
        x += p.x, y += p.y;
    }
    finding.point = world(building, x / piece.corner_count, y / piece.corner_count, (double(v.z_low) + v.z_high) / 2);
}

void place_at_face(const Building& building, std::uint32_t face, Finding& finding) {
    if (face >= building.faces.size()) return;
    const Face& f = building.faces[face];
    if (f.direction == Direction::Side && !finding.point) {
        const PlanEdge& edge = building.edges[f.edge];
        const plans::GridPoint a = building.points[edge.a], b = building.points[edge.b];
        finding.point =
            world(building, (double(a.x) + b.x) / 2, (double(a.y) + b.y) / 2, (double(f.z_low) + f.z_high) / 2);
    }
    place_at_volume(building, f.front, finding);
    place_at_volume(building, f.back, finding);
}

void place_at_space(const Building& building, std::uint32_t space, Finding& finding) {
    if (space < building.spaces.size()) add_element(building, space, finding);
}

void place_at_vertex(const Building& building, std::uint32_t vertex, Finding& finding) {
    if (finding.point || vertex >= building.vertices.size()) return;
    const auto& v = building.vertices[vertex];
    finding.point = world(building, v[0], v[1], v[2]);
}

}  // namespace enfilade::modeler

// D2: the graph of cells and portals, and the map, say the same.

#include "modeler/constraints/constraints.h"
#include "modeler/face_label.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

/// `volume`: one beside the face in the map; of a row that is wrong neither may be.
void blame_face(const Building& building, std::uint32_t face, std::uint32_t volume, std::string sentence, Blame& blame,
                CheckReport& report) {
    Finding finding{.code = "D2", .severity = Severity::Error, .sentence = std::move(sentence)};
    finding.hint = "The exported graph would differ from the checked model: report the plan.";
    if (building.faces[face].direction == Direction::Up) place_at_volume(building, volume, finding);
    place_at_face(building, face, finding);
    blame.face[face] = true;
    report.findings.push_back(std::move(finding));
}

}  // namespace

void check_portals(const Building& building, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("D2");
    if (blame.whole_map) {
        ++report.suppressed;
        return;
    }
    const gmap::MapArrays& arrays = building.map.arrays();
    const OpeningFaces openings(building);
    std::vector<bool> in_map(building.faces.size(), false);
    const auto suppress = [&](std::uint32_t f, std::uint32_t a, std::uint32_t b) {
        const bool known = blame.face[f] || blame.volume[a] || blame.volume[b];
        report.suppressed += known;
        return known;
    };
    for (std::uint32_t d = 0; d < arrays.alpha[3].size(); ++d) {
        const std::uint32_t e = arrays.alpha[3][d];
        if (e == UINT32_MAX || e <= d) continue;
        const std::uint32_t f = arrays.cell_id[2][d];
        if (f >= building.faces.size()) {
            blame.whole_map = true;
            report.findings.push_back({.code = "D2",
                                       .severity = Severity::Error,
                                       .sentence = "The map has a face that the building does not know."});
            return;
        }
        if (in_map[f]) continue;
        in_map[f] = true;
        const std::uint32_t a = arrays.cell_id[3][d], b = arrays.cell_id[3][e];
        const Face& face = building.faces[f];
        const bool same = (face.front == a && face.back == b) || (face.front == b && face.back == a);
        const bool joins_cells = carries_light(building.volumes[a].label) && carries_light(building.volumes[b].label);
        const FaceKind kind = face_kind(building, openings, face);
        if (same && joins_cells == (kind.is_portal || kind.forced.has_value())) continue;
        if (suppress(f, a, b)) continue;
        blame_face(building, f, a,
                   same ? "A face between " + title(building.spaces[building.volumes[a].space]) + " and " +
                              title(building.spaces[building.volumes[b].space]) +
                              " is a portal in only one of graph and map."
                        : "A face joins " + title(building.spaces[building.volumes[a].space]) + " and " +
                              title(building.spaces[building.volumes[b].space]) +
                              " in the map, but other volumes in the graph.",
                   blame, report);
    }
    for (std::uint32_t f = 0; f < building.faces.size(); ++f)
        if (!in_map[f] && face_kind(building, openings, building.faces[f]).is_portal &&
            !suppress(f, building.faces[f].front, building.faces[f].back))
            blame_face(building, f, building.faces[f].front, "A portal of the graph has no face in the map.", blame,
                       report);
}

}  // namespace enfilade::modeler

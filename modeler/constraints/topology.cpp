// T1-T7.

#include <algorithm>
#include <array>

#include "gmap/validate.h"
#include "modeler/constraints/constraints.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

Finding finding_of(const Building& building, const gmap::Defect& defect, Blame& blame) {
    Finding finding{.code = defect.code, .severity = Severity::Error, .sentence = defect.sentence};
    finding.hint =
        "The model itself is broken here: look at the walls around this place, and report the plan if they are sound.";
    const auto vertex = gmap::index(defect.vertex), face = gmap::index(defect.face),
               volume = gmap::index(defect.volume);
    place_at_vertex(building, std::uint32_t(vertex), finding);
    if (volume < building.volumes.size()) {
        place_at_volume(building, std::uint32_t(volume), finding);
        blame.volume[volume] = true;
    }
    if (face < building.faces.size()) {
        place_at_face(building, std::uint32_t(face), finding);
        blame.face[face] = true;
    }
    if (volume >= building.volumes.size() && face >= building.faces.size()) blame.whole_map = true;
    if (defect.blamed == gmap::Blamed::Component) blame.whole_map = true;  // no inside, no outside
    return finding;
}

/// A cell at fault spoils those that it bounds: what the later constraints would say of them is the same fault. A
/// broken link spoils the cells at both of its ends.
void blame_incident(const Building& building, const std::vector<gmap::Defect>& defects, Blame& blame) {
    const gmap::MapArrays& arrays = building.map.arrays();
    std::array<std::vector<bool>, 4> at_fault;
    for (std::size_t i = 0; i < 4; ++i) at_fault[i].assign(arrays.cell_bound[i], false);
    const auto mark = [&](std::size_t dimension, std::size_t cell) {
        if (cell < at_fault[dimension].size()) at_fault[dimension][cell] = true;
    };
    const auto blame_dart = [&](std::uint32_t d) {
        if (const std::uint32_t f = arrays.cell_id[2][d]; f < blame.face.size()) blame.face[f] = true;
        if (const std::uint32_t v = arrays.cell_id[3][d]; v < blame.volume.size()) blame.volume[v] = true;
    };
    for (const gmap::Defect& defect : defects) {
        switch (defect.blamed) {
            case gmap::Blamed::Vertex: mark(0, gmap::index(defect.vertex)); break;
            case gmap::Blamed::Edge: mark(1, gmap::index(defect.edge)); break;
            case gmap::Blamed::Face: mark(2, gmap::index(defect.face)); break;
            case gmap::Blamed::Volume: mark(3, gmap::index(defect.volume)); break;
            case gmap::Blamed::Component: break;
        }
        if (defect.code != "T1" || !building.map.contains(defect.dart)) continue;
        const std::uint32_t d = std::uint32_t(gmap::index(defect.dart));
        blame_dart(d);
        for (const auto& alpha : arrays.alpha) blame_dart(alpha[d]);
    }
    for (std::uint32_t v = 0; v < std::min(at_fault[0].size(), blame.vertex.size()); ++v)
        if (at_fault[0][v]) blame.vertex[v] = true;
    std::vector<bool> in_map(building.faces.size(), false);
    for (std::uint32_t d = 0; d < arrays.alpha[0].size(); ++d) {
        if (arrays.alpha[0][d] == UINT32_MAX) continue;
        if (const std::uint32_t f = arrays.cell_id[2][d]; f < in_map.size()) in_map[f] = true;
        bool spoilt = false;
        for (std::size_t i = 0; i < 3; ++i) spoilt = spoilt || at_fault[i][arrays.cell_id[i][d]];
        if (spoilt) blame_dart(d);
    }
    // A face that goes by another's id is missing between volumes that are blamed for it.
    for (std::uint32_t f = 0; f < in_map.size(); ++f)
        if (!in_map[f] && (blame.volume[building.faces[f].front] || blame.volume[building.faces[f].back]))
            blame.face[f] = true;
}

}  // namespace

void check_topology(const Building& building, Blame& blame, CheckReport& report) {
    for (const char* code : {"T1", "T2", "T3", "T4", "T5", "T6", "T7"}) report.codes_checked.emplace_back(code);
    for (const gmap::Defect& defect : building.map_defects)
        report.findings.push_back(finding_of(building, defect, blame));
    const gmap::Validation validation = gmap::validate(building.map);
    report.suppressed += validation.suppressed;
    for (const gmap::Defect& defect : validation.defects) {
        // The builder left darts free where it refused a key: the map's own complaint about them is the same fault.
        if (!building.map_defects.empty() && (defect.code == "T2" || defect.code == "T4")) {
            ++report.suppressed;
            continue;
        }
        report.findings.push_back(finding_of(building, defect, blame));
    }
    if (!building.map_defects.empty()) blame_incident(building, building.map_defects, blame);
    if (!validation.defects.empty()) blame_incident(building, validation.defects, blame);
}

}  // namespace enfilade::modeler

// T1-T7.

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
    return finding;
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
}

}  // namespace enfilade::modeler

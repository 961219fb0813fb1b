#include "modeler/check.h"

#include <algorithm>

#include "modeler/constraints/constraints.h"
#include "plans/read.h"

namespace enfilade::modeler {

bool Blame::any() const {
    return whole_map || std::find(volume.begin(), volume.end(), true) != volume.end() ||
           std::find(face.begin(), face.end(), true) != face.end();
}

std::size_t CheckReport::count(const std::string& code) const {
    return std::size_t(
        std::count_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.code == code; }));
}

CheckReport check(const Building& building, const CheckOptions& options) {
    CheckReport report;
    const plans::Plan plan = building.plan_json.empty() ? plans::Plan{} : plans::read_json(building.plan_json, "");
    const MapFaces faces(building);
    const FaceRings rings(building.map, building.vertices);
    const SpaceIndex spaces(building, plan);
    const Subject subject{building, plan, options, faces, rings, spaces};
    Blame blame{std::vector<bool>(building.volumes.size(), false), std::vector<bool>(building.faces.size(), false),
                std::vector<bool>(building.vertices.size(), false), std::vector<bool>(building.spaces.size(), false)};
    check_topology(building, blame, report);
    check_storeys(subject, blame, report);
    check_vertices(subject, blame, report);
    check_rings(subject, blame, report);
    check_planarity(subject, blame, report);
    check_shells(subject, blame, report);
    check_partition(building, blame, report);
    check_thickness(subject, blame, report);
    check_directions(subject, blame, report);
    if (building.convex) check_convexity(building, blame, report);
    check_curves(subject, blame, report);
    check_tiling(subject, blame, report);
    check_labels(subject, blame, report);
    check_openings(subject, blame, report);
    check_room_bounds(subject, blame, report);
    check_stairs(subject, blame, report);
    check_access(subject, blame, report);
    check_objects(subject, blame, report);
    check_lamps(subject, report);
    check_nodes(subject, blame, report);
    check_portals(building, blame, report);
    report.findings.insert(report.findings.end(), building.findings.begin(), building.findings.end());
    return report;
}

}  // namespace enfilade::modeler

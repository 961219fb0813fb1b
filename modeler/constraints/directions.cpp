// G7: sides of volumes are upright, floors and ceilings level.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <unordered_map>

#include "base/disjoint_sets.h"
#include "modeler/constraints/star_blame.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

bool is_side(const Building& building, std::uint32_t face) {
    return face < building.faces.size() && building.faces[face].direction == Direction::Side;
}

/// Degrees by which a face leans off the direction that its row gives it.
double lean(const Building& building, const FaceRings& rings, std::uint32_t face) {
    const auto plane = plane_corners(rings.ring(face), rings.points());
    if (!plane) return 0;
    const auto n = normal_of(rings.point((*plane)[0]), rings.point((*plane)[1]), rings.point((*plane)[2]));
    const double from_level =
        std::atan2(std::hypot(double(n[0]), double(n[1])), std::abs(double(n[2]))) * 180 / std::numbers::pi;
    return is_side(building, face) ? 90 - from_level : from_level;
}

/// Faces that hang together in vertices, by their lowest.
std::vector<std::vector<std::uint32_t>> clusters(const FaceRings& rings, const std::vector<std::uint32_t>& faces) {
    DisjointSets sets(faces.size());
    std::unordered_map<std::uint32_t, std::uint32_t> at_vertex;
    for (std::uint32_t k = 0; k < faces.size(); ++k)
        for (const std::uint32_t v : rings.ring(faces[k])) sets.join(at_vertex.try_emplace(v, k).first->second, k);
    std::vector<std::vector<std::uint32_t>> found = sets.groups();
    for (auto& cluster : found)
        for (std::uint32_t& k : cluster) k = faces[k];
    return found;
}

void report_leaning(const Subject& subject, std::uint32_t face, CheckReport& report) {
    const Building& building = subject.building;
    const FaceRings& rings = subject.rings;
    const auto sides = rings.volumes(face);
    char angle[32];
    std::snprintf(angle, sizeof angle, "%.3g", lean(building, rings, face));
    Finding finding{.code = "G7", .severity = Severity::Error};
    finding.sentence = std::string(is_side(building, face) ? "A side face between " : "A floor or ceiling between ") +
                       title(building.spaces[building.volumes[sides[0]].space]) + " and " +
                       title(building.spaces[building.volumes[sides[1]].space]) + " is off the " +
                       (is_side(building, face) ? "vertical" : "horizontal") + " by " + angle + " degrees.";
    finding.hint = "All walls of the model stand upright and all floors lie level: report the plan.";
    std::array<double, 3> sum = {};
    for (const std::uint32_t v : rings.ring(face))
        for (std::size_t i = 0; i < 3; ++i) sum[i] += rings.point(v)[i];
    const double count = double(rings.ring(face).size());
    const plans::GridFrame& frame = building.frame;
    finding.point = {frame.origin_x + frame.unit * sum[0] / count, frame.origin_y + frame.unit * sum[1] / count,
                     frame.origin_z + frame.unit * sum[2] / count};
    for (const std::uint32_t v : sides) place_at_volume(building, v, finding);
    report.findings.push_back(std::move(finding));
}

}  // namespace

void check_directions(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("G7");
    if (blame.whole_map) {
        ++report.suppressed;
        return;
    }
    const FaceRings& rings = subject.rings;
    std::vector<std::uint32_t> leaning;
    for (std::uint32_t f = 0; f < rings.size(); ++f) {
        // An upright face that its row calls a floor is a wrong row: S1.
        if (rings.lie(f) != Lie::Tilted) continue;
        if (f < blame.face.size() && blame.face[f]) ++report.suppressed;
        else leaning.push_back(f);
    }
    StarBlame stars(subject, blame);
    for (const std::vector<std::uint32_t>& cluster : clusters(rings, leaning)) {
        const std::uint32_t worst =
            *std::max_element(cluster.begin(), cluster.end(), [&](std::uint32_t a, std::uint32_t b) {
                return lean(subject.building, rings, a) < lean(subject.building, rings, b);
            });
        report_leaning(subject, worst, report);
        for (const std::uint32_t f : cluster) stars.blame(rings.ring(f));
    }
}

}  // namespace enfilade::modeler

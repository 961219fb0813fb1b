// G3: every face is flat, by distance and by normal.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "modeler/constraints/culprits.h"
#include "modeler/constraints/star_blame.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

/// How far a face is from flat.
struct Bend {
    std::uint32_t vertex = UINT32_MAX;  ///< the corner farthest from the plane of the others
    double distance = 0;                ///< grid units
    double degrees = 0;                 ///< between that plane and the triangle of the corner with its neighbours
};

double degrees_between(const std::array<std::int64_t, 3>& a, const std::array<std::int64_t, 3>& b) {
    double dot = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        dot += double(a[i]) * double(b[i]);
        aa += double(a[i]) * double(a[i]);
        bb += double(b[i]) * double(b[i]);
    }
    if (aa == 0 || bb == 0) return 0;
    return std::acos(std::min(1.0, std::abs(dot) / std::sqrt(aa * bb))) * 180 / std::numbers::pi;
}

/// Seen from the plane of the ring without `suspect` (or, without one, of its first corners).
Bend bend_of(const FaceRings& rings, std::uint32_t face, std::uint32_t suspect) {
    const auto ring = rings.ring(face);
    Bend bend;
    const auto plane = plane_corners(ring, rings.points(), suspect);
    if (!plane) return bend;
    const Point3& a = rings.point((*plane)[0]);
    const auto normal = normal_of(a, rings.point((*plane)[1]), rings.point((*plane)[2]));
    const double length = std::hypot(double(normal[0]), double(normal[1]), double(normal[2]));
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const double distance = std::abs(double(height_over(a, normal, rings.point(ring[k])))) / length;
        if (distance <= bend.distance) continue;
        const std::uint32_t before = ring[k > 0 ? k - 1 : ring.size() - 1];
        const std::uint32_t after = ring[k + 1 < ring.size() ? k + 1 : 0];
        bend = {ring[k], distance,
                degrees_between(normal, normal_of(rings.point(before), rings.point(ring[k]), rings.point(after)))};
    }
    return bend;
}

}  // namespace

void check_planarity(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("G3");
    if (blame.whole_map) {
        ++report.suppressed;
        return;
    }
    const Building& building = subject.building;
    const FaceRings& rings = subject.rings;
    std::vector<FaceFault> faults;
    for (std::uint32_t f = 0; f < rings.size(); ++f) {
        if (rings.lie(f) != Lie::Bent) continue;
        if (f < blame.face.size() && blame.face[f]) ++report.suppressed;
        else faults.push_back({f, bent_corners(rings.ring(f), rings.points()), true});
    }
    StarBlame stars(subject, blame);
    for (const Culprit& culprit : culprits(building, rings, faults)) {
        const FaceFault& first = faults[culprit.faults.front()];
        if (first.face < blame.face.size() && blame.face[first.face]) {
            ++report.suppressed;
            continue;
        }
        std::uint32_t face = first.face;
        Bend worst = bend_of(rings, face, culprit.vertex);
        for (const std::uint32_t k : culprit.faults)
            if (const Bend bend = bend_of(rings, faults[k].face, culprit.vertex); bend.distance > worst.distance)
                worst = bend, face = faults[k].face;
        const std::uint32_t at = culprit.vertex != UINT32_MAX ? culprit.vertex : worst.vertex;
        char angle[32];
        std::snprintf(angle, sizeof angle, "%.2g", worst.degrees);
        Finding finding{.code = "G3", .severity = Severity::Error};
        finding.sentence = "A face at " + stars.names(at) + " is not flat: one of its corners lies " +
                           millimetres(building, worst.distance) +
                           " out of the plane of the others, and the surface turns by " + angle + " degrees there.";
        finding.hint = "Look at the levels and the ends of the walls that meet here.";
        stars.place(at, finding);
        if (culprit.vertex == UINT32_MAX) stars.blame(rings.ring(face));
        else stars.blame(std::span(&culprit.vertex, 1));
        report.findings.push_back(std::move(finding));
    }
}

}  // namespace enfilade::modeler

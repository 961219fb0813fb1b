// G2: every face is bounded by one simple ring, and so is a disc.

#include <algorithm>

#include "modeler/constraints/culprits.h"
#include "modeler/constraints/ring_crossings.h"
#include "modeler/constraints/star_blame.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

struct CrossedRing {
    std::uint32_t face = 0;
    std::vector<RingCrossing> crossings;
};

std::vector<CrossedRing> crossed_rings(const FaceRings& rings, const Blame& blame, CheckReport& report) {
    std::vector<CrossedRing> crossed;
    std::vector<plans::GridPoint> flat;
    for (std::uint32_t f = 0; f < rings.size(); ++f) {
        if (rings.lie(f) == Lie::NoRing || rings.lie(f) == Lie::Bent) continue;  // a bent face has no plane: G3
        rings.flatten(f, flat);
        std::vector<RingCrossing> crossings = ring_crossings(flat);
        if (crossings.empty()) continue;
        if (f < blame.face.size() && blame.face[f]) ++report.suppressed;
        else crossed.push_back({f, std::move(crossings)});
    }
    return crossed;
}

/// The vertices at which an edge of every crossing ends: moving one of them may undo all.
std::vector<std::uint32_t> common_ends(std::span<const std::uint32_t> ring,
                                       const std::vector<RingCrossing>& crossings) {
    const auto ends = [&](const RingCrossing& c) {
        std::vector<std::uint32_t> four;
        for (const std::size_t k : {c.first, c.second}) {
            four.push_back(ring[k]);
            four.push_back(ring[k + 1 < ring.size() ? k + 1 : 0]);
        }
        std::sort(four.begin(), four.end());
        four.erase(std::unique(four.begin(), four.end()), four.end());
        return four;
    };
    std::vector<std::uint32_t> common = ends(crossings[0]);
    for (const RingCrossing& c : crossings) {
        const std::vector<std::uint32_t> four = ends(c);
        std::erase_if(common, [&](std::uint32_t v) { return !std::binary_search(four.begin(), four.end(), v); });
    }
    return common;
}

std::string what_is_it(const Subject& subject, std::uint32_t face) {
    const Building& building = subject.building;
    std::string text;
    for (const std::uint32_t v : subject.rings.volumes(face))
        if (v < building.volumes.size())
            text += (text.empty() ? "between " : " and ") + title(building.spaces[building.volumes[v].space]);
    return text;
}

}  // namespace

void check_rings(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("G2");
    if (blame.whole_map) {
        ++report.suppressed;
        return;
    }
    const FaceRings& rings = subject.rings;
    const std::vector<CrossedRing> crossed = crossed_rings(rings, blame, report);
    if (crossed.empty()) return;
    std::vector<FaceFault> faults;
    for (const CrossedRing& c : crossed) faults.push_back({c.face, common_ends(rings.ring(c.face), c.crossings), true});
    for (std::uint32_t f = 0; f < rings.size(); ++f)
        if (rings.lie(f) == Lie::Bent) faults.push_back({f, bent_corners(rings.ring(f), rings.points()), false});
    StarBlame stars(subject, blame);
    for (const Culprit& culprit : culprits(subject.building, rings, faults)) {
        const FaceFault& fault = faults[culprit.faults.front()];
        if (fault.face < blame.face.size() && blame.face[fault.face]) {
            ++report.suppressed;
            continue;
        }
        const CrossedRing& ring = crossed[culprit.faults.front()];
        const std::uint32_t at =
            culprit.vertex != UINT32_MAX ? culprit.vertex : rings.ring(ring.face)[ring.crossings.front().first];
        Finding finding{.code = "G2", .severity = Severity::Error};
        finding.sentence = "The outline of a face " + what_is_it(subject, ring.face) + " crosses or touches itself.";
        finding.hint = "Look for walls that nearly coincide here: the face is no area with one border.";
        stars.place(at, finding);
        if (culprit.vertex == UINT32_MAX) stars.blame(rings.ring(ring.face));
        else stars.blame(std::span(&culprit.vertex, 1));
        report.findings.push_back(std::move(finding));
    }
}

}  // namespace enfilade::modeler

// G4: no two faces of a volume's shell meet but in the edges and vertices that they share.

#include <algorithm>
#include <map>

#include "base/disjoint_sets.h"
#include "modeler/constraints/face_meeting.h"
#include "modeler/constraints/prism_shell.h"
#include "modeler/constraints/star_blame.h"
#include "modeler/map_geometry.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

struct ShellMeeting {
    std::uint32_t volume = 0;
    std::array<std::uint32_t, 2> faces = {};  ///< the one with fewer corners first
    std::array<double, 3> point = {};         ///< grid units
};

void find_meetings(const FaceRings& rings, std::uint32_t volume, std::vector<ShellMeeting>& meetings) {
    const auto faces = rings.faces_of(volume);
    std::vector<FlatFace> flat;
    std::vector<GridBox> boxes;
    flat.reserve(faces.size());
    for (const std::uint32_t f : faces) {
        flat.emplace_back(rings.ring(f), rings.points());
        boxes.push_back(flat.back().box);
    }
    const std::size_t first = meetings.size();
    BoxTree(boxes).for_each_touching_pair([&](std::uint32_t i, std::uint32_t j) {
        const auto point = meeting_point(flat[i], flat[j], rings.points());
        if (!point) return;
        if (flat[j].ring.size() < flat[i].ring.size()) std::swap(i, j);
        meetings.push_back({volume, {faces[i], faces[j]}, *point});
    });
    std::sort(meetings.begin() + std::ptrdiff_t(first), meetings.end(),
              [](const ShellMeeting& a, const ShellMeeting& b) { return a.faces < b.faces; });
}

/// The face that is pushed through the other one: the smaller one; either where they have as many corners.
std::span<const std::uint32_t> pushed_faces(const FaceRings& rings, const ShellMeeting& meeting) {
    const bool alike = rings.ring(meeting.faces[0]).size() == rings.ring(meeting.faces[1]).size();
    return std::span(meeting.faces).first(alike ? 2 : 1);
}

/// Meetings whose smaller faces hang together in vertices are one fault: something is pushed through something else,
/// and each of its sides meets what it is pushed through.
std::vector<std::vector<std::uint32_t>> faults_of(const FaceRings& rings, const std::vector<ShellMeeting>& meetings) {
    DisjointSets faults(meetings.size());
    std::map<std::uint32_t, std::uint32_t> at_vertex;
    for (std::uint32_t k = 0; k < meetings.size(); ++k)
        for (const std::uint32_t f : pushed_faces(rings, meetings[k]))
            for (const std::uint32_t v : rings.ring(f)) faults.join(at_vertex.try_emplace(v, k).first->second, k);
    return faults.groups();
}

/// What is pushed through something turns what it is pushed through inside out: volumes that hang together with a
/// blamed one and are not positive are of the same fault.
void blame_inside_out(const Subject& subject, Blame& blame) {
    const auto volumes = volumes6(subject.building.map, subject.building.vertices);
    if (!volumes || volumes->size() < blame.volume.size()) return;
    std::vector<std::uint32_t> queue;
    for (std::uint32_t v = 0; v < blame.volume.size(); ++v)
        if (blame.volume[v]) queue.push_back(v);
    while (!queue.empty()) {
        const std::uint32_t v = queue.back();
        queue.pop_back();
        for (const std::uint32_t f : subject.rings.faces_of(v))
            for (const std::uint32_t w : subject.rings.volumes(f)) {
                if (w >= blame.volume.size() || blame.volume[w] || (*volumes)[w] > 0) continue;
                if (subject.building.volumes[w].label == Label::Outside) continue;
                blame.volume[w] = true;
                queue.push_back(w);
            }
    }
}

std::string beyond(const Subject& subject, const ShellMeeting& meeting, std::size_t k) {
    const auto& sides = subject.rings.volumes(meeting.faces[k]);
    const std::uint32_t other = sides[0] == meeting.volume ? sides[1] : sides[0];
    return title(subject.building.spaces[subject.building.volumes[other].space]);
}

void report_fault(const Subject& subject, const ShellMeeting& meeting, CheckReport& report) {
    const Building& building = subject.building;
    const plans::GridFrame& frame = building.frame;
    Finding finding{.code = "G4", .severity = Severity::Error};
    finding.sentence = "The surface of " + title(building.spaces[building.volumes[meeting.volume].space]) +
                       " meets itself: its face towards " + beyond(subject, meeting, 0) + " runs into that towards " +
                       beyond(subject, meeting, 1) + ".";
    finding.hint = "Something here reaches through its neighbour: look at the heights and at walls that overlap.";
    finding.point = {frame.origin_x + frame.unit * meeting.point[0], frame.origin_y + frame.unit * meeting.point[1],
                     frame.origin_z + frame.unit * meeting.point[2]};
    place_at_volume(building, meeting.volume, finding);
    for (const std::uint32_t f : meeting.faces)
        for (const std::uint32_t v : subject.rings.volumes(f)) place_at_volume(building, v, finding);
    report.findings.push_back(std::move(finding));
}

}  // namespace

void check_shells(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("G4");
    if (blame.whole_map) {
        ++report.suppressed;
        return;
    }
    const FaceRings& rings = subject.rings;
    PrismShells prisms(rings);
    std::vector<ShellMeeting> meetings;
    const std::uint32_t volumes = std::min(rings.volume_bound(), std::uint32_t(subject.building.volumes.size()));
    for (std::uint32_t v = 0; v < volumes; ++v) {
        if (blame.volume[v]) ++report.suppressed;
        else if (!prisms.is_prism(v)) find_meetings(rings, v, meetings);
    }
    if (meetings.empty()) return;
    StarBlame stars(subject, blame);
    for (const std::vector<std::uint32_t>& fault : faults_of(rings, meetings)) {
        report_fault(subject, meetings[fault.front()], report);
        for (const std::uint32_t k : fault) {
            for (const std::uint32_t f : pushed_faces(rings, meetings[k])) stars.blame(rings.ring(f));
            for (const std::uint32_t f : meetings[k].faces) {
                if (f < blame.face.size()) blame.face[f] = true;
                for (const std::uint32_t v : rings.volumes(f)) blame.volume[v] = true;
            }
        }
    }
    blame_inside_out(subject, blame);
}

}  // namespace enfilade::modeler

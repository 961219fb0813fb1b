#include <algorithm>

#include "modeler/meshes/mesh_map.h"

namespace enfilade::modeler {
namespace {

using Ring = std::vector<std::uint32_t>;

/// Without corners that repeat the one before, and without spikes (... x a x ...), until nothing changes.
Ring cleaned(std::span<const std::uint32_t> written) {
    Ring ring;
    for (const std::uint32_t v : written) {
        if (!ring.empty() && ring.back() == v) continue;
        if (ring.size() >= 2 && ring[ring.size() - 2] == v) ring.pop_back();
        else ring.push_back(v);
    }
    std::size_t begin = 0, end = ring.size();
    for (bool changed = true; changed && end - begin >= 2;) {
        changed = true;
        if (ring[begin] == ring[end - 1]) --end;
        else if (end - begin >= 3 && ring[begin] == ring[end - 2]) end -= 2;
        else if (end - begin >= 3 && ring[begin + 1] == ring[end - 1]) ++begin, --end;
        else changed = false;
    }
    if (end - begin < 3) return {};
    return Ring(ring.begin() + std::ptrdiff_t(begin), ring.begin() + std::ptrdiff_t(end));
}

bool repeats_before(std::span<const std::uint32_t> ring) {
    for (std::size_t k = 0; k < ring.size(); ++k)
        if (ring[k] == ring[(k + 1) % ring.size()]) return true;
    return false;
}

/// A vertex that stands in the ring more than once, or none.
std::uint32_t repeated(std::span<const std::uint32_t> ring, Ring& scratch) {
    if (ring.size() == 3)  // by far the most
        return ring[0] == ring[1] || ring[0] == ring[2] ? ring[0] : ring[1] == ring[2] ? ring[1] : UINT32_MAX;
    scratch.assign(ring.begin(), ring.end());
    std::sort(scratch.begin(), scratch.end());
    const auto twice = std::adjacent_find(scratch.begin(), scratch.end());
    return twice == scratch.end() ? UINT32_MAX : *twice;
}

void report_short(std::uint32_t f, std::span<const std::uint32_t> ring, const char* which, MeshReport& report) {
    Finding finding{.code = "T6", .severity = Severity::Error};
    finding.sentence = "Face " + report.face(f) + " has " + which + std::to_string(ring.size()) +
                       (ring.size() == 1 ? " corner" : " corners") + ", fewer than three.";
    finding.hint = "Leave it out, or give it its missing corners.";
    if (!ring.empty()) report.put_at(finding, report.mesh().points[ring[0]]);
    report.name_face(finding, f);
    report.add(std::move(finding), "faces of fewer than three corners");
}

void report_repeat(std::uint32_t f, std::span<const std::uint32_t> ring, std::uint32_t v, MeshReport& report) {
    Finding finding{.code = "G2", .severity = Severity::Error};
    const bool consecutive = repeats_before(ring);
    finding.sentence =
        "Face " + report.face(f) + " names vertex " + report.vertex(v) +
        (consecutive ? " twice in a row." : " more than once: its ring touches or crosses itself there.");
    finding.hint = consecutive ? "Name it once." : "Split the face there into faces with simple rings.";
    report.put_at(finding, report.mesh().points[v]);
    report.name_face(finding, f);
    report.name_vertex(finding, v);
    report.add(std::move(finding), "faces that name a vertex more than once");
}

/// Rings of a face that share more than one vertex with the others cut it into parts.
void inspect_rings(std::uint32_t f, MeshReport& report) {
    const Mesh& mesh = report.mesh();
    Ring all(mesh.face(f).begin(), mesh.face(f).end());
    for (const MeshHole& hole : mesh.holes_of(f)) {
        Ring shared;
        for (const std::uint32_t v : mesh.hole(hole))
            if (std::find(all.begin(), all.end(), v) != all.end()) shared.push_back(v);
        all.insert(all.end(), mesh.hole(hole).begin(), mesh.hole(hole).end());
        if (shared.size() < 2) continue;
        report.blame.face[f] = true;
        for (const std::uint32_t v : all) report.blame.vertex[v] = true;
        Finding finding{.code = "G2", .severity = Severity::Error};
        finding.sentence = "A hole of face " + report.face(f) + " shares vertices " + report.vertices(shared) +
                           " with its other rings, which leaves several parts of the face.";
        finding.hint = "Draw each part as a face of its own.";
        report.put_at(finding, mesh.points[shared[0]]);
        report.name_face(finding, f);
        return report.add(std::move(finding), "faces that are no discs");
    }
}

}  // namespace

CleanRings::CleanRings(const MeshBody& body, MeshReport& report)
    : mesh_(report.mesh()), rough_(body.face_count), body_(body) {
    Ring scratch;
    const auto inspect = [&](std::uint32_t f, std::span<const std::uint32_t> ring, const char* which) {
        std::uint32_t twice = UINT32_MAX;
        if (ring.size() < 3) report_short(f, ring, which, report);
        else if (twice = repeated(ring, scratch); twice != UINT32_MAX) report_repeat(f, ring, twice, report);
        else return;
        rough_[f - body.first_face] = true;
        report.blame.face[f] = true;
        for (const std::uint32_t v : ring) report.blame.vertex[v] = true;
    };
    for (std::uint32_t f = body.first_face; f < body.first_face + body.face_count; ++f) {
        inspect(f, mesh_.face(f), "");
        if (mesh_.holes.empty() || mesh_.holes_of(f).empty()) continue;
        for (const MeshHole& hole : mesh_.holes_of(f)) inspect(f, mesh_.hole(hole), "a hole of ");
        if (!report.blame.face[f]) inspect_rings(f, report);
    }
}

std::vector<std::uint32_t> CleanRings::outer(std::uint32_t face) const {
    const auto written = mesh_.face(face);
    if (rough_[face - body_.first_face]) return cleaned(written);
    return {written.begin(), written.end()};
}

std::vector<std::uint32_t> CleanRings::inner(const MeshHole& hole) const {
    const auto written = mesh_.hole(hole);
    if (rough_[hole.face - body_.first_face]) return cleaned(written);
    return {written.begin(), written.end()};
}

}  // namespace enfilade::modeler

// What the kernel says of the pieces of a mesh that look sound, in terms of the mesh.

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include "gmap/validate.h"
#include "modeler/meshes/mesh_topology.h"

namespace enfilade::modeler {
namespace {

/// The tuples of the pieces without a fault, and the face of the map that each of their faces is.
std::pair<gmap::CellTuples, std::vector<std::uint32_t>> sound_tuples(const MeshTopology& topology) {
    const gmap::CellTuples& all = topology.map.tuples;
    std::pair<gmap::CellTuples, std::vector<std::uint32_t>> result;
    gmap::CellTuples& sound = result.first;
    sound.vertex_count = all.vertex_count;
    sound.volume_count = all.volume_count;
    sound.ring_first = {0};
    for (std::uint32_t f = 0; f < topology.map.face.size(); ++f) {
        if (topology.faults[topology.map.piece(f)] != 0) continue;
        sound.ring.insert(sound.ring.end(), all.ring.begin() + all.ring_first[f],
                          all.ring.begin() + all.ring_first[f + 1]);
        sound.ring_first.push_back(static_cast<std::uint32_t>(sound.ring.size()));
        sound.face_volumes.push_back(all.face_volumes[f]);
        result.second.push_back(f);
    }
    return result;
}

/// V - E + F of each piece, with a face of each.
struct PieceCounts {
    explicit PieceCounts(const MeshMap& map)
        : euler(map.piece_count, 0), faces(map.piece_count, 0), first_face(map.piece_count, UINT32_MAX) {
        std::vector<bool> seen(map.vertex.size(), false);
        for (std::uint32_t f = 0; f < map.face.size(); ++f) {
            const std::uint32_t p = map.piece(f);
            ++euler[p];
            if (first_face[p] == UINT32_MAX) first_face[p] = f;
            for (std::uint32_t r = map.tuples.ring_first[f]; r < map.tuples.ring_first[f + 1]; ++r) {
                if (map.entries[map.edge[r]][0] == r) --euler[p];
                if (seen[map.tuples.ring[r]]) continue;
                seen[map.tuples.ring[r]] = true;
                ++euler[p];
            }
            if (f == 0 || map.face[f] != map.face[f - 1]) ++faces[p];
        }
    }

    std::vector<std::int64_t> euler;
    std::vector<std::uint32_t> faces;       ///< of the mesh
    std::vector<std::uint32_t> first_face;  ///< of the map
};

class Translator {
public:
    Translator(const MeshTopology& topology, const PieceCounts& counts, MeshReport& report)
        : map_(topology.map), counts_(counts), report_(report) {}

    /// `f`: a face of the map; `v`: a vertex of it, or none.
    void translate(const gmap::Defect& defect, std::uint32_t f, std::uint32_t v) {
        const std::uint32_t p = map_.piece(f);
        const bool of_volume = defect.blamed == gmap::Blamed::Volume || defect.blamed == gmap::Blamed::Component;
        // A shell is seen from inside and from outside: one fault.
        const std::uint32_t cell = of_volume ? p : defect.blamed == gmap::Blamed::Face ? f : v;
        if (!seen_.emplace(defect.code, static_cast<int>(defect.blamed), cell).second) return;
        if (report_.blame.face[map_.face[f]]) return report_.suppress();
        if (defect.code == "T7" && of_volume) report_handles(p);
        else if (defect.code == "T6" && of_volume) report_small(p);
        else report_other(defect, f, v);
    }

private:
    Finding finding_at(const char* code, Severity severity, std::uint32_t f) const {
        Finding finding{.code = code, .severity = severity};
        const std::uint32_t v = map_.vertex[map_.tuples.ring[map_.tuples.ring_first[f]]];
        if (v != UINT32_MAX) report_.put_at(finding, report_.mesh().points[v]);
        report_.name_face(finding, map_.face[f]);
        return finding;
    }

    void report_handles(std::uint32_t p) {
        const std::uint32_t f = counts_.first_face[p];
        const std::int64_t handles = (2 - counts_.euler[p]) / 2;
        Finding finding = finding_at("T7", Severity::Note, f);
        finding.sentence = "The surface of face " + report_.face(map_.face[f]) + " has " + std::to_string(handles) +
                           (handles == 1 ? " handle" : " handles") + ", as a ring has one: V - E + F is " +
                           std::to_string(counts_.euler[p]) + " instead of 2.";
        finding.hint = "A solid may have handles; only a volume that has to be a ball may not.";
        report_.add(std::move(finding), "surfaces with handles");
    }

    void report_small(std::uint32_t p) {
        const std::uint32_t f = counts_.first_face[p];
        Finding finding = finding_at("T6", Severity::Error, f);
        finding.sentence = "The surface of face " + report_.face(map_.face[f]) + " has " +
                           std::to_string(counts_.faces[p]) + (counts_.faces[p] == 1 ? " face" : " faces") +
                           ", fewer than the four of a tetrahedron.";
        finding.hint = "Leave it out, or give it its missing faces.";
        report_.add(std::move(finding), "surfaces of fewer than four faces");
    }

    void report_other(const gmap::Defect& defect, std::uint32_t f, std::uint32_t v) {
        Finding finding = finding_at(defect.code.c_str(), Severity::Error, f);
        const std::string vertex = v == UINT32_MAX || map_.vertex[v] == UINT32_MAX
                                       ? std::string()
                                       : " at vertex " + report_.vertex(map_.vertex[v]);
        if (defect.code == "T4" && defect.blamed == gmap::Blamed::Edge) {
            finding.sentence = "Face " + report_.face(map_.face[f]) + " meets itself along an edge" + vertex + ".";
            finding.hint = "Split the face, or give a hole as a ring of its own.";
        } else {
            finding.sentence = "The topology is not sound at face " + report_.face(map_.face[f]) + vertex + ".";
            finding.hint = "Look at the faces around this place.";
        }
        report_.add(std::move(finding), "places where the topology is not sound");
    }

    const MeshMap& map_;
    const PieceCounts& counts_;
    MeshReport& report_;
    std::set<std::tuple<std::string, int, std::uint32_t>> seen_;
};

}  // namespace

void check_map(const MeshTopology& topology, MeshReport& report) {
    const auto is_faulty = [](std::uint8_t faults) { return faults != 0; };
    const bool all_sound = std::none_of(topology.faults.begin(), topology.faults.end(), is_faulty);
    const bool none_sound = std::all_of(topology.faults.begin(), topology.faults.end(), is_faulty);
    if (none_sound) return;
    std::optional<gmap::Map> part;
    std::vector<std::uint32_t> faces;
    if (!all_sound) {
        auto [tuples, kept] = sound_tuples(topology);
        std::vector<gmap::Defect> refused;
        part = gmap::build_map(tuples, refused);
        faces = std::move(kept);
    }
    const gmap::Validation validation = gmap::validate(all_sound ? topology.map.map : *part);
    if (validation.is_sound()) return;
    report.suppress(validation.suppressed);
    const PieceCounts counts(topology.map);
    Translator translator(topology, counts, report);
    for (const gmap::Defect& defect : validation.defects) {
        if (defect.face == gmap::none<gmap::FaceId>) continue;
        const auto f = static_cast<std::uint32_t>(defect.face);
        const bool has_vertex = defect.vertex != gmap::none<gmap::VertexId>;
        translator.translate(defect, all_sound ? f : faces[f],
                             has_vertex ? static_cast<std::uint32_t>(defect.vertex) : UINT32_MAX);
    }
}

}  // namespace enfilade::modeler

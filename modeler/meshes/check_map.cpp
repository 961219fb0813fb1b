// What the kernel says of the pieces of a mesh that look sound, in terms of the mesh.

#include <map>
#include <set>
#include <tuple>

#include "gmap/validate.h"
#include "modeler/meshes/mesh_topology.h"

namespace enfilade::modeler {
namespace {

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
        finding.sentence = "The topology is not sound at face " + report_.face(map_.face[f]) + vertex + ".";
        finding.hint = "Look at the faces around this place.";
        report_.add(std::move(finding), "places where the topology is not sound");
    }

    const MeshMap& map_;
    const PieceCounts& counts_;
    MeshReport& report_;
    std::set<std::tuple<std::string, int, std::uint32_t>> seen_;
};

/// Maps of some of the faces, validated, and translated back.
class PartValidator {
public:
    PartValidator(const MeshTopology& topology, const PieceCounts& counts, MeshReport& report)
        : map_(topology.map), report_(report), translator_(topology, counts, report) {}

    void whole() {
        judge(
            map_.map, [](std::uint32_t f) { return f; }, [](std::uint32_t v) { return v; });
    }

    /// `faces`: of the map, whole pieces of it.
    void part(const std::vector<std::uint32_t>& faces) {
        if (faces.empty()) return;
        local_.resize(map_.vertex.size(), UINT32_MAX);
        std::vector<std::uint32_t> vertices;
        gmap::CellTuples tuples;
        tuples.volume_count = 0;
        tuples.ring_first = {0};
        std::uint32_t before = UINT32_MAX;
        std::map<std::uint32_t, std::uint32_t> volume;  // of each piece
        for (const std::uint32_t f : faces) {
            for (std::uint32_t r = map_.tuples.ring_first[f]; r < map_.tuples.ring_first[f + 1]; ++r) {
                const std::uint32_t v = map_.tuples.ring[r];
                if (local_[v] == UINT32_MAX) local_[v] = std::uint32_t(vertices.size()), vertices.push_back(v);
                tuples.ring.push_back(local_[v]);
            }
            tuples.ring_first.push_back(std::uint32_t(tuples.ring.size()));
            if (before != map_.piece(f)) {
                before = map_.piece(f);
                if (volume.try_emplace(before, tuples.volume_count).second) tuples.volume_count += 2;
            }
            tuples.face_volumes.push_back({volume[before], volume[before] + 1});
        }
        tuples.vertex_count = std::uint32_t(vertices.size());
        std::vector<gmap::Defect> refused;
        judge(
            gmap::build_map(tuples, refused), [&](std::uint32_t f) { return faces[f]; },
            [&](std::uint32_t v) { return vertices[v]; });
        for (const std::uint32_t v : vertices) local_[v] = UINT32_MAX;
    }

private:
    template <class FaceOf, class VertexOf>
    void judge(const gmap::Map& map, const FaceOf& face_of, const VertexOf& vertex_of) {
        const gmap::Validation validation = gmap::validate(map);
        report_.suppress(validation.suppressed);
        for (const gmap::Defect& defect : validation.defects) {
            if (defect.face == gmap::none<gmap::FaceId>) continue;
            const bool has_vertex = defect.vertex != gmap::none<gmap::VertexId>;
            translator_.translate(defect, face_of(static_cast<std::uint32_t>(defect.face)),
                                  has_vertex ? vertex_of(static_cast<std::uint32_t>(defect.vertex)) : UINT32_MAX);
        }
    }

    const MeshMap& map_;
    MeshReport& report_;
    Translator translator_;
    std::vector<std::uint32_t> local_;  ///< [vertex of the map]
};

void mark_folded(MeshTopology& topology) {
    const MeshMap& map = topology.map;
    for (std::uint32_t e = 0; e < map.uses.size(); ++e)
        if (map.uses[e] == 2 && map.entry_face[map.entries[e][0]] == map.entry_face[map.entries[e][1]])
            topology.faults[map.piece(map.entry_face[map.entries[e][0]])] |= folded_piece;
}

}  // namespace

void check_map(MeshTopology& topology, MeshReport& report) {
    const MeshMap& map = topology.map;
    mark_folded(topology);
    const PieceCounts counts(map);
    // The kernel looks for a defect's cells in the whole map: pieces that have one are given to it by themselves.
    std::vector<std::uint32_t> special(map.piece_count, UINT32_MAX);
    std::uint32_t special_count = 0;
    bool all_plain = true;
    for (std::uint32_t p = 0; p < map.piece_count; ++p) {
        const bool is_special = topology.faults[p] == 0 && (counts.euler[p] != 2 || counts.faces[p] < 4);
        if (is_special) special[p] = special_count++;
        all_plain = all_plain && !is_special && topology.faults[p] == 0;
    }
    PartValidator validator(topology, counts, report);
    if (all_plain) return validator.whole();
    std::vector<std::uint32_t> plain;
    std::vector<std::vector<std::uint32_t>> specials(special_count);
    for (std::uint32_t f = 0; f < map.face.size(); ++f) {
        const std::uint32_t p = map.piece(f);
        if (topology.faults[p] != 0) continue;
        if (special[p] == UINT32_MAX) plain.push_back(f);
        else specials[special[p]].push_back(f);
    }
    validator.part(plain);
    for (const std::vector<std::uint32_t>& faces : specials) {
        validator.part(faces);
        if (counts.faces[map.piece(faces.front())] >= 4) continue;
        for (const std::uint32_t f : faces) report.blame.face[map.face[f]] = true;  // they lie on each other
    }
}

}  // namespace enfilade::modeler

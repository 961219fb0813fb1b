// T4 of meshes: faces given twice, edges with more than two faces.

#include <algorithm>

#include "base/disjoint_sets.h"
#include "modeler/meshes/mesh_topology.h"

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t nothing = UINT32_MAX;

using Ring = std::vector<std::uint32_t>;

/// The ring from its lowest vertex on, towards the lower of its neighbours: the same for every way to write it.
Ring canonical(const MeshMap& map, std::uint32_t face) {
    Ring ring(map.tuples.ring.begin() + map.tuples.ring_first[face],
              map.tuples.ring.begin() + map.tuples.ring_first[face + 1]);
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    if (ring.back() < ring[1]) std::reverse(ring.begin() + 1, ring.end());
    return ring;
}

bool all_crowded(const MeshMap& map, std::uint32_t face) {
    for (std::uint32_t r = map.tuples.ring_first[face]; r < map.tuples.ring_first[face + 1]; ++r)
        if (map.uses[map.edge[r]] < 3) return false;
    return true;
}

/// Groups of equal faces, each ascending.
std::vector<std::vector<std::uint32_t>> equal_faces(const MeshMap& map) {
    std::vector<std::pair<Ring, std::uint32_t>> keyed;
    for (std::uint32_t f = 0; f < map.face.size(); ++f)
        if (all_crowded(map, f)) keyed.emplace_back(canonical(map, f), f);
    std::sort(keyed.begin(), keyed.end());
    std::vector<std::vector<std::uint32_t>> groups;
    for (std::size_t k = 0; k < keyed.size(); ++k) {
        const bool again = k > 0 && keyed[k].first == keyed[k - 1].first;
        if (!again) groups.emplace_back();
        groups.back().push_back(keyed[k].second);
    }
    std::erase_if(groups, [](const auto& group) { return group.size() < 2; });
    std::sort(groups.begin(), groups.end());
    return groups;
}

void report_repeat(const MeshMap& map, std::uint32_t first, std::uint32_t again, MeshReport& report) {
    const std::uint32_t f = map.face[first], g = map.face[again];
    Finding finding{.code = "T4", .severity = Severity::Error};
    finding.sentence = "Face " + report.face(g) + " has the same vertices as face " + report.face(f) + ".";
    finding.hint = "Leave one of them out.";
    report.put_at(finding, report.mesh().points[map.vertex[map.tuples.ring[map.tuples.ring_first[again]]]]);
    report.name_face(finding, g);
    report.name_face(finding, f);
    report.add(std::move(finding), "faces that repeat another");
}

/// The faces at each edge that has more than two.
struct CrowdedEdges {
    explicit CrowdedEdges(const MeshMap& map) {
        std::vector<std::uint32_t> number(map.uses.size(), nothing);
        for (std::uint32_t e = 0; e < map.uses.size(); ++e)
            if (map.uses[e] > 2) number[e] = std::uint32_t(edges.size()), edges.push_back(e);
        faces.resize(edges.size());
        if (edges.empty()) return;
        for (std::uint32_t r = 0; r < map.edge.size(); ++r)
            if (number[map.edge[r]] != nothing) faces[number[map.edge[r]]].push_back(map.face[map.entry_face[r]]);
    }

    std::vector<std::uint32_t> edges;
    std::vector<std::vector<std::uint32_t>> faces;  ///< of the mesh
};

/// Edges that share vertices are one chain.
std::vector<std::vector<std::uint32_t>> chains(const MeshMap& map, const CrowdedEdges& crowded) {
    DisjointSets sets(crowded.edges.size());
    std::vector<std::uint32_t> at_vertex(map.vertex.size(), nothing);
    for (std::uint32_t k = 0; k < crowded.edges.size(); ++k) {
        const std::uint32_t r = map.entries[crowded.edges[k]][0];
        for (const std::uint32_t v : {map.tuples.ring[r], map.tuples.ring[map.next(r)]}) {
            if (at_vertex[v] == nothing) at_vertex[v] = k;
            sets.join(k, at_vertex[v]);
        }
    }
    return sets.groups();
}

void report_chain(const MeshMap& map, const CrowdedEdges& crowded, const std::vector<std::uint32_t>& chain,
                  MeshReport& report) {
    const std::uint32_t r = map.entries[crowded.edges[chain.front()]][0];
    const auto [v, w] = std::minmax({map.vertex[map.tuples.ring[r]], map.vertex[map.tuples.ring[map.next(r)]]});
    const auto& faces = crowded.faces[chain.front()];
    Finding finding{.code = "T4", .severity = Severity::Error};
    const std::string edge = "The edge between vertices " + report.vertex(v) + " and " + report.vertex(w) + " has " +
                             std::to_string(faces.size()) + " faces: " + report.faces(faces) + ".";
    finding.sentence = chain.size() == 1
                           ? edge
                           : std::to_string(chain.size()) + " edges in a chain have more than two faces each. " + edge;
    finding.hint = "Within one solid an edge has two faces: separate what only touches, leave out what lies inside.";
    const auto &p = report.mesh().points[v], &q = report.mesh().points[w];
    report.put_at(finding, {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
    for (std::size_t k = 0; k < std::min<std::size_t>(faces.size(), 6); ++k) report.name_face(finding, faces[k]);
    report.name_vertex(finding, v);
    report.name_vertex(finding, w);
    report.add(std::move(finding), "chains of edges with more than two faces");
}

}  // namespace

bool find_repeated_faces(const MeshMap& map, const MeshBody& body, MeshReport& report, std::vector<bool>& left_out) {
    const auto groups = equal_faces(map);
    if (groups.empty()) return false;
    // Only what leaves a sound place behind is a repetition; else the faces meet others there, which is told as such.
    std::vector<std::uint32_t> left = map.uses;
    for (const auto& group : groups)
        for (std::size_t k = 1; k < group.size(); ++k)
            for (std::uint32_t r = map.tuples.ring_first[group[k]]; r < map.tuples.ring_first[group[k] + 1]; ++r)
                --left[map.edge[r]];
    bool found = false;
    left_out.assign(body.face_count, false);
    for (const auto& group : groups) {
        bool sound = true;
        for (std::uint32_t r = map.tuples.ring_first[group[0]]; r < map.tuples.ring_first[group[0] + 1]; ++r)
            sound = sound && left[map.edge[r]] <= 2;
        if (!sound) continue;
        found = true;
        for (std::size_t k = 1; k < group.size(); ++k) {
            left_out[map.face[group[k]] - body.first_face] = true;
            report.blame.face[map.face[group[k]]] = true;
            report.blame.crowded[map.face[group[0]]] = true;  // which way the one that is kept looks is chance
            report_repeat(map, group[0], group[k], report);
        }
    }
    return found;
}

void check_crowding(MeshTopology& topology, MeshReport& report) {
    const MeshMap& map = topology.map;
    const CrowdedEdges crowded(map);
    for (const auto& chain : chains(map, crowded)) {
        bool known = false;
        for (const std::uint32_t k : chain) {
            topology.faults[map.piece(map.entry_face[map.entries[crowded.edges[k]][0]])] |= crowded_piece;
            for (const std::uint32_t f : crowded.faces[k]) {
                known = known || report.blame.face[f];
                report.blame.crowded[f] = true;
            }
        }
        if (known) report.suppress();
        else report_chain(map, crowded, chain, report);
    }
}

}  // namespace enfilade::modeler

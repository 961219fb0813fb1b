// T2 of meshes.

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/disjoint_sets.h"
#include "modeler/meshes/mesh_topology.h"
#include "modeler/meshes/point_index.h"

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t nothing = UINT32_MAX;

/// Edges with one face, joined to loops through the faces at their ends.
class Loops {
public:
    Loops(const MeshMap& map, const Mesh& mesh) : map_(map), mesh_(mesh), number_(map.uses.size(), nothing) {
        for (std::uint32_t e = 0; e < map.uses.size(); ++e)
            if (map.uses[e] == 1) number_[e] = std::uint32_t(edges_.size()), edges_.push_back(e);
        find_twins();
        sets_.reset(edges_.size());
        next_.assign(edges_.size(), nothing);
        std::unordered_map<std::uint32_t, std::uint32_t> ends;  // at places where the way round is blocked
        for (std::uint32_t k = 0; k < edges_.size(); ++k)
            for (std::uint32_t end = 0; end < 2; ++end) link(k, end, ends);
    }

    [[nodiscard]] const std::vector<std::uint32_t>& edges() const { return edges_; }
    [[nodiscard]] bool has_twin(std::uint32_t k) const { return twin_[k]; }
    [[nodiscard]] std::uint32_t next(std::uint32_t k) const { return next_[k]; }
    /// The vertex of the mesh at an end of an edge, in the direction of its face; none on a cut.
    [[nodiscard]] std::uint32_t vertex(std::uint32_t e, std::uint32_t end) const {
        const std::uint32_t r = map_.entries[e][0];
        return map_.vertex[map_.tuples.ring[end == 0 ? r : map_.next(r)]];
    }
    /// The edges of each loop, in order of their first edge.
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> loops() { return sets_.groups(); }

private:
    /// To the next edge of the same kind: seams go on with seams, the edges of a hole past the seams that end at it.
    void link(std::uint32_t k, std::uint32_t end, std::unordered_map<std::uint32_t, std::uint32_t>& ends) {
        const std::uint32_t edge = beyond(edges_[k], end);
        const std::uint32_t other = edge == nothing ? nothing : number_[edge];
        if (other != nothing && twin_[other] == twin_[k]) {
            sets_.join(k, other);
            if (end == 1) next_[k] = other;
        } else if (!twin_[k]) {
            const auto [at, is_new] = ends.try_emplace(place_[k][end], k);
            if (!is_new) sets_.join(k, at->second);
        }
    }

    /// The edge with one face that is reached by turning around an end through the faces; none where an edge with more
    /// than two faces is in the way.
    [[nodiscard]] std::uint32_t beyond(std::uint32_t e, std::uint32_t end) const {
        gmap::DartId d = map_.dart(map_.entries[e][0], end);
        for (;;) {
            d = map_.map.alpha<1>(d);
            const auto edge = static_cast<std::uint32_t>(map_.map.edge(d));
            if (map_.uses[edge] == 1) return edge;
            if (map_.uses[edge] > 2) return nothing;
            d = map_.map.alpha<2>(d);
        }
    }

    /// An edge has a twin where another one joins the same two places: it is a seam of vertices that were split.
    void find_twins() {
        twin_.assign(edges_.size(), false);
        std::vector<MeshPoint> places;
        PointIndex index(edges_.size());
        std::vector<std::array<std::uint32_t, 3>> keys;  // places of both ends, edge
        place_.resize(edges_.size());
        for (std::uint32_t k = 0; k < edges_.size(); ++k) {
            std::array<std::uint32_t, 2>& at = place_[k];
            for (std::uint32_t end = 0; end < 2; ++end) {
                const MeshPoint& p = mesh_.points[vertex(edges_[k], end)];
                at[end] = index.find_or_add(p, places);
                if (at[end] == places.size()) places.push_back(p);
            }
            keys.push_back({std::min(at[0], at[1]), std::max(at[0], at[1]), k});
        }
        std::sort(keys.begin(), keys.end());
        for (std::size_t i = 1; i < keys.size(); ++i)
            if (keys[i][0] == keys[i - 1][0] && keys[i][1] == keys[i - 1][1])
                twin_[keys[i][2]] = twin_[keys[i - 1][2]] = true;
    }

    const MeshMap& map_;
    const Mesh& mesh_;
    std::vector<std::uint32_t> edges_;
    std::vector<std::uint32_t> number_;  ///< [edge] into edges_
    DisjointSets sets_;
    std::vector<std::uint32_t> next_;
    std::vector<bool> twin_;
    std::vector<std::array<std::uint32_t, 2>> place_;  ///< of the ends; equal points have one
};

/// Vertices along a loop, beginning at its first edge; where it cannot be walked, as its edges come.
std::vector<std::uint32_t> walk(const Loops& loops, const std::vector<std::uint32_t>& loop) {
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t k = loop.front(); k != nothing && vertices.size() < loop.size(); k = loops.next(k)) {
        vertices.push_back(loops.vertex(loops.edges()[k], 0));
        if (loops.next(k) == loop.front()) break;
    }
    if (vertices.size() == loop.size()) return vertices;
    vertices.clear();
    for (const std::uint32_t k : loop)
        for (std::uint32_t end = 0; end < 2; ++end) vertices.push_back(loops.vertex(loops.edges()[k], end));
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

struct Measure {
    double length = 0;
    MeshPoint centre{};
};

Measure measure(const Loops& loops, const std::vector<std::uint32_t>& loop, const Mesh& mesh) {
    Measure result;
    for (const std::uint32_t k : loop) {
        const MeshPoint& p = mesh.points[loops.vertex(loops.edges()[k], 0)];
        const MeshPoint& q = mesh.points[loops.vertex(loops.edges()[k], 1)];
        result.length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
        for (std::size_t i = 0; i < 3; ++i) result.centre[i] += (p[i] + q[i]) / (2 * double(loop.size()));
    }
    return result;
}

std::string edges_text(std::size_t count) { return std::to_string(count) + (count == 1 ? " edge" : " edges"); }

void report_hole(const MeshMap& map, const Loops& loops, const std::vector<std::uint32_t>& loop, const Measure& size,
                 MeshReport& report) {
    const std::uint32_t face = map.face[map.entry_face[map.entries[loops.edges()[loop.front()]][0]]];
    const std::vector<std::uint32_t> around = walk(loops, loop);
    Finding finding{.code = "T2", .severity = Severity::Error};
    finding.sentence = "A hole of " + edges_text(loop.size()) + ", " + short_number(size.length) +
                       " round, along vertices " + report.vertices(around) + ": " +
                       (loop.size() == 1 ? "this edge has" : "these edges have") + " one face only.";
    finding.hint = "Close it with faces.";
    report.put_at(finding, size.centre);
    report.name_face(finding, face);
    for (const std::uint32_t v : around) {
        if (finding.elements.size() > 8) break;
        report.name_vertex(finding, v);
    }
    report.add(std::move(finding), "holes");
}

void report_seams(const MeshMap& map, const Loops& loops, const std::vector<std::vector<std::uint32_t>>& seams,
                  MeshReport& report) {
    std::size_t edges = 0;
    for (const auto& loop : seams) edges += loop.size();
    const std::uint32_t first = loops.edges()[seams.front().front()];
    const std::uint32_t v = loops.vertex(first, 0), w = loops.vertex(first, 1);
    Finding finding{.code = "T2", .severity = Severity::Error};
    finding.sentence =
        edges_text(edges) + " in " + std::to_string(seams.size()) + (seams.size() == 1 ? " loop" : " loops") +
        " have one face only, but lie on one another: vertices are there twice. First between vertices " +
        report.vertex(v) + " and " + report.vertex(w) + ".";
    finding.hint = "Weld the vertices (--weld 0) or export the mesh without splitting them.";
    report.put_at(finding, report.mesh().points[v]);
    report.name_face(finding, map.face[map.entry_face[map.entries[first][0]]]);
    report.name_vertex(finding, v);
    report.name_vertex(finding, w);
    report.add(std::move(finding), "seams");
}

}  // namespace

void check_holes(MeshTopology& topology, MeshReport& report, MeshCount& count) {
    const MeshMap& map = topology.map;
    Loops loops(map, report.mesh());
    if (loops.edges().empty()) return;
    std::vector<std::vector<std::uint32_t>> seams;
    for (const auto& loop : loops.loops()) {
        const bool is_seam = loops.has_twin(loop.front());
        count.holes += is_seam ? 0 : 1;
        count.boundary_edges += loop.size();
        bool known = false;  // the edges of a face that is blamed for its ring
        for (const std::uint32_t k : loop) {
            const std::uint32_t face = map.face[map.entry_face[map.entries[loops.edges()[k]][0]]];
            topology.faults[map.piece(map.entry_face[map.entries[loops.edges()[k]][0]])] |= open_piece;
            known = known || report.blame.face[face];
            for (std::uint32_t end = 0; end < 2; ++end) report.blame.rim[loops.vertex(loops.edges()[k], end)] = true;
        }
        if (known) report.suppress();
        else if (is_seam) seams.push_back(loop);
        else report_hole(map, loops, loop, measure(loops, loop, report.mesh()), report);
    }
    if (!seams.empty()) report_seams(map, loops, seams, report);
}

}  // namespace enfilade::modeler

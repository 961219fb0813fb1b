// T3 and T5 of meshes: can inside be told from outside, and is there one umbrella a vertex?

#include <algorithm>
#include <numeric>

#include "base/disjoint_sets.h"
#include "modeler/meshes/mesh_topology.h"

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t nothing = UINT32_MAX;

/// Faces joined by edges; each knows whether it runs as its root does.
class SidesUnion {
public:
    explicit SidesUnion(std::size_t count) : parent_(count), turned_(count, 0) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    /// The root, and whether the face runs against it.
    std::pair<std::uint32_t, bool> find(std::uint32_t f) {
        std::uint32_t root = f;
        std::uint8_t turned = 0;
        for (; parent_[root] != root; root = parent_[root]) turned ^= turned_[root];
        for (std::uint8_t rest = turned; parent_[f] != f;) {  // point straight to the root
            const std::uint32_t up = parent_[f];
            const std::uint8_t own = turned_[f];
            parent_[f] = root;
            turned_[f] = rest;
            rest ^= own;
            f = up;
        }
        return {root, turned != 0};
    }
    /// False where both are joined already, the other way round.
    bool join(std::uint32_t a, std::uint32_t b, bool against) {
        const auto [root_a, turned_a] = find(a);
        const auto [root_b, turned_b] = find(b);
        if (root_a == root_b) return (turned_a != turned_b) == against;
        const std::uint32_t low = std::min(root_a, root_b), high = std::max(root_a, root_b);
        parent_[high] = low;
        turned_[high] = std::uint8_t((turned_a != turned_b) != against);
        return true;
    }

private:
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint8_t> turned_;
};

void report_one_sided(const MeshMap& map, std::uint32_t entry, std::size_t faces, MeshReport& report) {
    const std::uint32_t f = map.face[map.entry_face[entry]], v = map.vertex[map.tuples.ring[entry]];
    Finding finding{.code = "T3", .severity = Severity::Error};
    finding.sentence = std::to_string(faces) + " connected faces have no inside and outside: going round from face " +
                       report.face(f) + " one comes back to its other side, as on a Klein bottle.";
    finding.hint = "Cut the surface where it passes through itself.";
    if (v != nothing) report.put_at(finding, report.mesh().points[v]);
    report.name_face(finding, f);
    report.add(std::move(finding), "surfaces without inside and outside");
}

}  // namespace

void check_sides(MeshTopology& topology, MeshReport& report, MeshCount& count) {
    const MeshMap& map = topology.map;
    MeshPatches& patches = topology.patches;
    SidesUnion sides(map.face.size());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> conflicts;  // face, entry
    for (std::uint32_t e = 0; e < map.uses.size(); ++e) {
        if (map.uses[e] != 2) continue;
        const auto [a, b] = map.entries[e];
        const bool same_direction = map.tuples.ring[a] == map.tuples.ring[b];
        count.turned_edges += same_direction ? 1 : 0;
        if (!sides.join(map.entry_face[a], map.entry_face[b], same_direction))
            conflicts.emplace_back(map.entry_face[a], a);
    }
    std::vector<std::uint32_t> number(map.face.size(), nothing);
    std::vector<std::size_t> size;
    patches.patch.resize(map.face.size());
    patches.turned.resize(map.face.size());
    for (std::uint32_t f = 0; f < map.face.size(); ++f) {
        const auto [root, turned] = sides.find(f);
        if (number[root] == nothing) number[root] = patches.count++, size.push_back(0);
        patches.patch[f] = number[root];
        patches.turned[f] = turned;
        ++size[number[root]];
    }
    patches.one_sided.assign(patches.count, false);
    for (const auto& [face, entry] : conflicts) {
        const std::uint32_t patch = patches.patch[face];
        topology.faults[map.piece(face)] |= one_sided_piece;
        if (patches.one_sided[patch]) continue;
        patches.one_sided[patch] = true;
        if (report.blame.face[map.face[face]]) report.suppress();
        else report_one_sided(map, entry, size[patch], report);
    }
}

namespace {

/// Corners of faces joined across edges: those of a vertex that stay apart are its umbrellas.
class Umbrellas {
public:
    explicit Umbrellas(const MeshMap& map) : map_(map), corners_(map.edge.size()) {
        for (std::uint32_t e = 0; e < map.uses.size(); ++e) {
            if (map.uses[e] != 2) continue;
            auto [a, b] = map.entries[e];
            std::uint32_t a_end = map.next(a), b_end = map.next(b);
            if (map.tuples.ring[a] != map.tuples.ring[b]) std::swap(b, b_end);
            corners_.join(a, b);
            corners_.join(a_end, b_end);
        }
    }

    /// The lowest corner of the umbrella.
    std::uint32_t find(std::uint32_t corner) { return corners_.find(corner); }

    /// Vertices with more than one, ascending, with a corner of each umbrella.
    [[nodiscard]] std::vector<std::pair<std::uint32_t, std::vector<std::uint32_t>>> crowded_vertices() {
        std::vector<std::uint32_t> first(map_.vertex.size(), nothing);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> more;  // vertex, root
        for (std::uint32_t r = 0; r < corners_.size(); ++r) {
            if (find(r) != r) continue;
            std::uint32_t& root = first[map_.tuples.ring[r]];
            if (root == nothing) root = r;
            else more.emplace_back(map_.tuples.ring[r], r);
        }
        std::sort(more.begin(), more.end());
        std::vector<std::pair<std::uint32_t, std::vector<std::uint32_t>>> result;
        for (const auto& [v, root] : more) {
            if (result.empty() || result.back().first != v) result.push_back({v, {first[v]}});
            result.back().second.push_back(root);
        }
        return result;
    }

private:
    const MeshMap& map_;
    DisjointSets corners_;
};

void report_vertex(const MeshMap& map, std::uint32_t v, const std::vector<std::uint32_t>& corners, MeshReport& report) {
    std::vector<std::uint32_t> faces;
    for (const std::uint32_t r : corners) faces.push_back(map.face[map.entry_face[r]]);
    std::sort(faces.begin(), faces.end());
    Finding finding{.code = "T5", .severity = Severity::Error};
    finding.sentence = "At vertex " + report.vertex(map.vertex[v]) +
                       " the surface touches itself: " + std::to_string(corners.size()) +
                       " groups of faces share it and no edge (faces " + report.faces(faces) + ").";
    finding.hint = "Give each of them a vertex of its own, or join them by more than a point.";
    report.put_at(finding, report.mesh().points[map.vertex[v]]);
    report.name_vertex(finding, map.vertex[v]);
    for (std::size_t k = 0; k < std::min<std::size_t>(faces.size(), 6); ++k) report.name_face(finding, faces[k]);
    report.add(std::move(finding), "vertices at which the surface touches itself");
}

void report_pieces(const MeshMap& map, MeshReport& report) {
    std::vector<std::uint32_t> firsts;
    std::vector<bool> seen(map.piece_count, false);
    for (std::uint32_t f = 0; f < map.face.size(); ++f) {
        if (seen[map.piece(f)]) continue;
        seen[map.piece(f)] = true;
        firsts.push_back(map.face[f]);
    }
    Finding finding{.code = "T5", .severity = Severity::Error};
    finding.sentence = "This shell is in " + std::to_string(map.piece_count) +
                       " pieces that share no vertex; they begin with faces " + report.faces(firsts) + ".";
    finding.hint = "Make each piece a solid of its own, or an inner shell.";
    report.put_at(finding, report.mesh().points[report.mesh().face(firsts[1])[0]]);
    for (std::size_t k = 0; k < std::min<std::size_t>(firsts.size(), 6); ++k) report.name_face(finding, firsts[k]);
    report.add(std::move(finding), "shells in pieces");
}

/// How the umbrellas of a vertex may end: at nothing, or at edges that are reported themselves.
struct Rims {
    std::size_t closed = 0;
    bool crowded = false;
};

Rims rims(const MeshMap& map, Umbrellas& umbrellas, const std::vector<std::uint32_t>& roots,
          const std::vector<std::uint32_t>& corners) {
    Rims result;
    for (const std::uint32_t root : roots) {
        bool open = false;
        for (const std::uint32_t r : corners) {
            if (umbrellas.find(r) != root) continue;
            for (const std::uint32_t e : {map.edge[r], map.edge[map.before(r)]}) {
                open = open || map.uses[e] == 1;
                result.crowded = result.crowded || map.uses[e] > 2;
            }
        }
        result.closed += open ? 0 : 1;
    }
    return result;
}

}  // namespace

void check_umbrellas(MeshTopology& topology, const MeshBody& body, MeshReport& report) {
    const MeshMap& map = topology.map;
    if (body.is_shell && map.piece_count > 1) report_pieces(map, report);
    Umbrellas umbrellas(map);
    const auto suspects = umbrellas.crowded_vertices();
    if (suspects.empty()) return;
    std::vector<std::uint32_t> number(map.vertex.size(), nothing);
    for (std::uint32_t k = 0; k < suspects.size(); ++k) number[suspects[k].first] = k;
    std::vector<std::vector<std::uint32_t>> corners(suspects.size());
    for (std::uint32_t r = 0; r < map.edge.size(); ++r)
        if (number[map.tuples.ring[r]] != nothing) corners[number[map.tuples.ring[r]]].push_back(r);
    for (std::size_t k = 0; k < suspects.size(); ++k) {
        const auto& [v, roots] = suspects[k];
        topology.faults[map.piece(map.entry_face[roots.front()])] |= pinched_piece;
        const Rims found = rims(map, umbrellas, roots, corners[k]);
        const bool at_ring_fault =
            map.vertex[v] != nothing && report.blame.vertex[map.vertex[v]] && found.closed == roots.size();
        // Two open umbrellas are two holes that meet, or one that nearly closed: the holes are reported.
        if (found.crowded || found.closed == 0 || at_ring_fault) report.suppress();
        else report_vertex(map, v, roots, report);
    }
}

}  // namespace enfilade::modeler

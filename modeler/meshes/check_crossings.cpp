// G4 of meshes.

#include <algorithm>
#include <unordered_map>

#include "base/disjoint_sets.h"
#include "modeler/meshes/mesh_solids.h"

namespace enfilade::modeler {
namespace {

/// Faces that cross, and those that share a place with them, are one fault: the crossings of each, in order of their
/// first.
std::vector<std::vector<std::uint32_t>> clusters_of(const std::vector<Crossing>& crossings,
                                                    const MeshTriangles& triangles,
                                                    const std::vector<std::uint32_t>& place) {
    DisjointSets clusters(crossings.size());
    std::unordered_map<std::uint32_t, std::uint32_t> at;
    for (std::uint32_t k = 0; k < crossings.size(); ++k)
        for (const std::uint32_t t : {crossings[k].a, crossings[k].b})
            for (const std::uint32_t v : triangles.corners[t])
                if (const auto [known, is_new] = at.try_emplace(place[v], k); !is_new) clusters.join(k, known->second);
    return clusters.groups();
}

/// A point near both triangles: the middle of the box in which their boxes overlap.
std::array<double, 3> place_of(const Mesh& mesh, const MeshTriangles& triangles, const Crossing& crossing) {
    std::array<double, 3> point{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto range = [&](std::uint32_t t) {
            const auto [a, b, c] = triangles.corners[t];
            return std::minmax({mesh.points[a][i], mesh.points[b][i], mesh.points[c][i]});
        };
        const auto [low_a, high_a] = range(crossing.a);
        const auto [low_b, high_b] = range(crossing.b);
        point[i] = (std::max(low_a, low_b) + std::min(high_a, high_b)) / 2;
    }
    return point;
}

void report_cluster(const std::vector<Crossing>& crossings, const std::vector<std::uint32_t>& cluster,
                    const MeshTriangles& triangles, MeshReport& report) {
    std::vector<std::uint32_t> faces;
    for (const std::uint32_t k : cluster) {
        faces.push_back(triangles.face[crossings[k].a]);
        faces.push_back(triangles.face[crossings[k].b]);
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    const Crossing& first = crossings[cluster.front()];
    const std::uint32_t f = triangles.face[first.a], g = triangles.face[first.b];
    Finding finding{.code = "G4", .severity = Severity::Error};
    finding.sentence = "Faces " + report.face(f) + " and " + report.face(g) +
                       " meet where they share no corner or side: the surface goes through itself or touches itself.";
    if (faces.size() > 2)
        finding.sentence +=
            " " + std::to_string(faces.size()) + " faces do so around here (" + report.faces(faces) + ").";
    finding.hint = "Move the surface apart here, or cut the faces where they meet.";
    report.put_at(finding, place_of(report.mesh(), triangles, first));
    for (const std::uint32_t face : {f, g}) report.name_face(finding, face);
    for (const std::uint32_t face : faces) report.blame.face[face] = true;
    report.add(std::move(finding), "places where a surface goes through itself");
}

/// Faces that share a side with one that has no triangles: they meet across it without being at fault.
std::vector<bool> beside_missing(const MeshTriangles& triangles, const Mesh& mesh) {
    std::vector<bool> corner(mesh.points.size(), false), result(mesh.face_count(), false);
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
        if (triangles.missing[f])
            for (const std::uint32_t v : mesh.face(f)) corner[v] = true;
    for (const MeshHole& hole : mesh.holes)
        if (triangles.missing[hole.face])
            for (const std::uint32_t v : mesh.hole(hole)) corner[v] = true;
    for (std::size_t t = 0; t < triangles.face.size(); ++t) {
        int at = 0;
        for (const std::uint32_t v : triangles.corners[t]) at += corner[v] ? 1 : 0;
        if (at >= 2) result[triangles.face[t]] = true;
    }
    return result;
}

}  // namespace

void check_crossings(const Crossings& crossings, const MeshTriangles& triangles, const MeshPieces& pieces,
                     const std::vector<std::uint32_t>& place, MeshReport& report, MeshCount& count) {
    report.applied({"G4"});
    count.crossing_pairs = crossings.within.size();
    const std::vector<bool> beside = beside_missing(triangles, report.mesh());
    std::vector<Crossing> own;
    for (const Crossing& crossing : crossings.within) {
        const std::uint32_t f = triangles.face[crossing.a], g = triangles.face[crossing.b];
        const bool known = report.blame.face[f] || report.blame.face[g] ||
                           (report.blame.crowded[f] && report.blame.crowded[g]) ||
                           (beside[f] && beside[g] && !crossing.pierces);
        // A closed surface with one side has to go through itself in space: T3 says it all.
        if (known || pieces.pieces[pieces.piece[f]].one_sided) report.suppress();
        else own.push_back(crossing);
    }
    for (const auto& cluster : clusters_of(own, triangles, place)) report_cluster(own, cluster, triangles, report);
    if (crossings.complete) return;
    Finding finding{.code = "G4", .severity = Severity::Warning};
    finding.sentence = "The search for crossings was ended: there are far too many.";
    finding.hint = "Mend those that are listed, then check again.";
    report.add(std::move(finding), "ended searches");
}

}  // namespace enfilade::modeler

// G1 of meshes.

#include <algorithm>

#include "modeler/meshes/mesh_readers.h"
#include "modeler/meshes/mesh_triangles.h"

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t nothing = UINT32_MAX;

void report_group(const std::vector<std::uint32_t>& group, MeshReport& report) {
    Finding finding{.code = "G1", .severity = Severity::Error};
    finding.sentence = "Vertices " + report.vertices(group) +
                       (report.options().coincident > 0 ? " lie within " + short_number(report.options().coincident) +
                                                              " of each other, in one connected surface."
                                                        : " lie at one place, in one connected surface.");
    finding.hint =
        "Where the surface touches itself, separate it; where the vertices mean the same, weld them (--weld 0).";
    report.put_at(finding, report.mesh().points[group.front()]);
    for (std::size_t k = 0; k < std::min<std::size_t>(group.size(), 6); ++k) report.name_vertex(finding, group[k]);
    report.add(std::move(finding), "places with more than one vertex");
}

void report_unused(const std::vector<std::uint32_t>& unused, MeshReport& report) {
    Finding finding{.code = "G1", .severity = Severity::Note};
    finding.sentence = unused.size() == 1 ? "Vertex " + report.vertex(unused[0]) + " belongs to no face."
                                          : std::to_string(unused.size()) +
                                                " vertices belong to no face: " + report.vertices(unused) + ".";
    finding.hint = "They do no harm; leave them out where size matters.";
    report.put_at(finding, report.mesh().points[unused.front()]);
    for (std::size_t k = 0; k < std::min<std::size_t>(unused.size(), 6); ++k) report.name_vertex(finding, unused[k]);
    report.add(std::move(finding), "lists of vertices without faces");
}

}  // namespace

void check_places(const std::vector<std::uint32_t>& place, const std::vector<std::uint32_t>& piece, MeshReport& report,
                  MeshCount& count) {
    const Mesh& mesh = report.mesh();
    report.applied({"G1"});
    std::vector<std::uint32_t> piece_of(mesh.points.size(), nothing);  // of the first face that uses the vertex
    const auto use = [&](std::span<const std::uint32_t> ring, std::uint32_t p) {
        for (const std::uint32_t v : ring)
            if (piece_of[v] == nothing) piece_of[v] = p;
    };
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t p = piece[f] == nothing ? nothing - 1 : piece[f];
        use(mesh.face(f), p);
    }
    for (const MeshHole& hole : mesh.holes) use(mesh.hole(hole), piece[hole.face]);
    std::vector<std::uint32_t> unused;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> doubled;  // place, vertex
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
        const bool is_merged = !mesh.merged.empty() && mesh.merged[v];
        if (piece_of[v] == nothing && !is_merged) unused.push_back(v);
        if (place[v] == v || is_merged) continue;
        ++count.duplicate_vertices;
        doubled.emplace_back(place[v], v);
    }
    count.unused_vertices = unused.size();
    // The vertices of a city model serve geometries that are no solids too.
    if (!unused.empty() && mesh.format != MeshFormat::CityJson) report_unused(unused, report);
    std::sort(doubled.begin(), doubled.end());
    for (std::size_t begin = 0, end = 0; begin < doubled.size(); begin = end) {
        while (end < doubled.size() && doubled[end].first == doubled[begin].first) ++end;
        std::vector<std::uint32_t> group{doubled[begin].first};
        for (std::size_t k = begin; k < end; ++k) group.push_back(doubled[k].second);
        std::erase_if(group, [&](std::uint32_t v) { return piece_of[v] == nothing; });
        std::stable_sort(group.begin(), group.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return piece_of[a] < piece_of[b]; });
        for (std::size_t i = 0, j = 0; i < group.size(); i = j) {
            while (j < group.size() && piece_of[group[j]] == piece_of[group[i]]) ++j;
            if (j - i < 2) continue;
            const std::vector<std::uint32_t> same(group.begin() + std::ptrdiff_t(i), group.begin() + std::ptrdiff_t(j));
            // Split vertices along a seam are told with the seam.
            const auto is_known = [&](std::uint32_t v) { return report.blame.rim[v] || report.blame.vertex[v]; };
            if (std::any_of(same.begin(), same.end(), is_known)) report.suppress();
            else report_group(same, report);
        }
    }
}

}  // namespace enfilade::modeler

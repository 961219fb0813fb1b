#include "modeler/check.h"
#include "modeler/meshes/mesh.h"
#include "modeler/meshes/mesh_readers.h"
#include "modeler/meshes/mesh_solids.h"
#include "modeler/meshes/mesh_topology.h"
#include "modeler/meshes/mesh_triangles.h"

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t nothing = UINT32_MAX;

class MeshChecker {
public:
    MeshChecker(const Mesh& mesh, const MeshOptions& options, CheckReport& report, MeshCount& count)
        : mesh_(mesh), report_(mesh, options, report), count_(count), maps_(mesh) {
        pieces_.piece.assign(mesh.face_count(), nothing);
        pieces_.turned.assign(mesh.face_count(), false);
    }

    void run() {
        count_.vertices = mesh_.points.size();
        count_.faces = mesh_.face_count();
        report_.applied({"T1", "T2", "T3", "T4", "T5", "T6", "T7"});
        if (mesh_.solids.empty()) check_body({0, std::uint32_t(mesh_.face_count()), false}, nothing, 0, 0);
        for (std::uint32_t s = 0; s < mesh_.solids.size(); ++s) {
            const MeshSolid& solid = mesh_.solids[s];
            if (solid.shell_count == 0) report_empty(solid, 0);
            for (std::uint32_t k = 0; k < solid.shell_count; ++k) {
                const MeshShell& shell = mesh_.shells[solid.first_shell + k];
                if (shell.face_count == 0) report_empty(solid, k);
                else check_body({shell.first_face, shell.face_count, true}, s, k, solid.composite);
            }
        }
        count_.pieces = pieces_.pieces.size();
        const std::vector<std::uint32_t> place = vertex_places(mesh_, 0);
        const double near = report_.options().coincident;
        check_places(near > 0 ? vertex_places(mesh_, near) : place, pieces_.piece, report_, count_);
        const MeshTriangles triangles = check_faces(place, report_, count_);
        const Crossings crossings = find_crossings(mesh_, triangles, pieces_, place);
        check_crossings(crossings, triangles, pieces_, place, report_, count_);
        check_solids(triangles, pieces_, place, crossings, report_);
        report_.finish();
    }

private:
    void report_empty(const MeshSolid& solid, std::uint32_t shell) {
        Finding finding{.code = "T6", .severity = Severity::Error};
        finding.sentence =
            solid.name + (shell == 0 ? "" : ", void " + std::to_string(shell - 1)) + " has no face at all.";
        finding.hint = "Leave it out, or give it its faces.";
        finding.elements.push_back({"solid", solid.object, solid.name});
        report_.add(std::move(finding), "shells without faces");
    }

    void check_body(const MeshBody& body, std::uint32_t solid, std::uint32_t shell, std::uint32_t group) {
        const CleanRings rings(body, report_);
        MeshTopology topology;
        topology.map = maps_.build(body, rings, {});
        for (const std::uint32_t uses : topology.map.uses) count_.crowded_edges += uses > 2 ? 1 : 0;
        std::vector<bool> left_out;
        if (find_repeated_faces(topology.map, body, report_, left_out))
            topology.map = maps_.build(body, rings, left_out);
        topology.faults.assign(topology.map.piece_count, 0);
        check_holes(topology, report_, count_);
        check_crowding(topology, report_);
        check_sides(topology, report_, count_);
        check_umbrellas(topology, body, report_);
        check_map(topology, report_);
        keep_pieces(topology, solid, shell, group);
    }

    void keep_pieces(const MeshTopology& topology, std::uint32_t solid, std::uint32_t shell, std::uint32_t group) {
        const auto first = static_cast<std::uint32_t>(pieces_.pieces.size());
        for (std::uint32_t p = 0; p < topology.map.piece_count; ++p)
            pieces_.pieces.push_back(
                {nothing, solid, shell, group, topology.faults[p] == 0, (topology.faults[p] & one_sided_piece) != 0});
        for (std::uint32_t f = 0; f < topology.map.face.size(); ++f) {
            const std::uint32_t face = topology.map.face[f];
            pieces_.piece[face] = first + topology.map.piece(f);
            pieces_.turned[face] = topology.patches.turned[f];
            std::uint32_t& first_face = pieces_.pieces[pieces_.piece[face]].first_face;
            first_face = std::min(first_face, face);
        }
    }

    const Mesh& mesh_;
    MeshReport report_;
    MeshCount& count_;
    MeshMapBuilder maps_;
    MeshPieces pieces_;
};

}  // namespace

CheckReport check_mesh(const Mesh& mesh, const MeshOptions& options, MeshCount* count) {
    CheckReport report;
    report.findings = mesh.findings;
    MeshCount own;
    MeshChecker(mesh, options, report, count == nullptr ? own : *count).run();
    return report;
}

}  // namespace enfilade::modeler

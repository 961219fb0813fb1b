// Random polyhedra: sound ones pass, each kind of fault gives its code and no other; and what is said of the topology
// of any soup of faces agrees with what the kernel says of its map.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "gmap/validate.h"
#include "modeler/meshes/mesh_topology.h"
#include "tests/modeler/meshes/polyhedra.h"

namespace enfilade::modeler::test {
namespace {

/// A ball with bumps: seen from its middle no face hides another, so it never goes through itself.
Polyhedron any_ball() {
    const auto rings = *rc::gen::inRange<std::uint32_t>(2, 7), around = *rc::gen::inRange<std::uint32_t>(3, 10);
    std::vector<double> radii;
    for (std::uint32_t k = 0; k < rings * around + 2; ++k) radii.push_back(*rc::gen::inRange(500, 1500) / 100.0);
    return ball(rings, around, [&](std::size_t k) { return radii[k]; });
}

std::size_t any_face(const Polyhedron& p) { return *rc::gen::inRange<std::size_t>(0, p.faces.size()); }

RC_GTEST_PROP(RandomMesh, IsSoundWithoutAFault, ()) {
    Polyhedron p = any_ball();
    if (*rc::gen::arbitrary<bool>()) {
        Polyhedron other = any_ball();
        for (Point& point : other.points) point[0] += 40;
        p = beside(p, other);
    }
    RC_ASSERT(codes_of(p) == Codes{});
}

RC_GTEST_PROP(RandomMesh, LosesAFace, ()) {
    Polyhedron p = any_ball();
    p.faces.erase(p.faces.begin() + std::ptrdiff_t(any_face(p)));
    const CheckReport report = check_mesh(p.mesh());
    RC_ASSERT(codes(report) == Codes{"T2"});
    RC_ASSERT(report.findings.size() == 1u);
}

RC_GTEST_PROP(RandomMesh, RepeatsAFace, ()) {
    Polyhedron p = any_ball();
    Ring again = p.faces[any_face(p)];
    if (*rc::gen::arbitrary<bool>()) std::reverse(again.begin(), again.end());
    std::rotate(again.begin(), again.begin() + *rc::gen::inRange(0, 3), again.end());
    p.faces.push_back(again);
    const CheckReport report = check_mesh(p.mesh());
    RC_ASSERT(codes(report) == Codes{"T4"});
    RC_ASSERT(report.findings.size() == 1u);
}

RC_GTEST_PROP(RandomMesh, TurnsAFace, ()) {
    Polyhedron p = any_ball();
    p.flip(any_face(p));
    const CheckReport report = check_mesh(p.mesh());
    RC_ASSERT(codes(report) == Codes{"T3 warning"});
    RC_ASSERT(report.findings.size() == 1u);
}

RC_GTEST_PROP(RandomMesh, SplitsAVertex, ()) {
    Polyhedron p = any_ball();
    Ring& face = p.faces[any_face(p)];
    std::uint32_t& corner = face[*rc::gen::inRange<std::size_t>(0, 3)];
    p.points.push_back(p.points[corner]);
    corner = std::uint32_t(p.points.size() - 1);
    const CheckReport report = check_mesh(p.mesh());
    RC_ASSERT(codes(report) == Codes{"T2"});
    RC_ASSERT(report.findings.size() == 1u);
}

RC_GTEST_PROP(RandomMesh, NamesACornerTwice, ()) {
    Polyhedron p = any_ball();
    Ring& face = p.faces[any_face(p)];
    const std::size_t k = *rc::gen::inRange<std::size_t>(0, 3);
    face.insert(face.begin() + std::ptrdiff_t(k), face[k]);
    RC_ASSERT(codes_of(p) == Codes{"G2"});
}

RC_GTEST_PROP(RandomMesh, TouchesASecondOneAtAVertex, ()) {
    Polyhedron p = any_ball();
    const Polyhedron other = any_ball();
    // The upper pole of one is the lower pole of the other, which stands on it.
    const Point top = p.points.back(), foot = other.points.front();
    double highest = 0, lowest = 0;
    for (const Point& q : p.points) highest = std::max(highest, q[2]);
    for (const Point& q : other.points) lowest = std::min(lowest, q[2]);
    RC_PRE(top[2] == highest && foot[2] == lowest);
    Polyhedron moved = other;
    for (Point& q : moved.points) q = {q[0] + top[0] - foot[0], q[1] + top[1] - foot[1], q[2] + top[2] - foot[2]};
    moved.points.front() = top;
    RC_ASSERT(codes_of(beside(p, moved)) == Codes{});
    RC_ASSERT(codes_of(sewn(beside(p, moved))) == (Codes{"T5", "G1 note"}));
}

RC_GTEST_PROP(RandomMesh, GoesThroughItself, ()) {
    Polyhedron p = any_ball();
    const std::size_t v = *rc::gen::inRange<std::size_t>(0, p.points.size());
    for (double& x : p.points[v]) x *= -10;  // past the other side
    const Codes found = codes_of(p);
    // Seldom its faces come out around all the others: then nothing crosses, but inside is outside.
    RC_CLASSIFY(found == Codes{"G4"}, "goes through itself");
    RC_ASSERT(found == Codes{"G4"} || found == Codes{"G5 warning"});
}

RC_GTEST_PROP(RandomMesh, GoesThroughAnother, ()) {
    const Polyhedron p = any_ball();
    Polyhedron other = any_ball();
    const double apart = *rc::gen::element(2.0, 4.0, 6.0);
    for (Point& q : other.points) q[0] += apart;
    const CheckReport report = check_mesh(beside(p, other).mesh());
    RC_ASSERT(codes(report) == Codes{"G5"});
    RC_ASSERT(report.findings.size() == 1u);
}

/// Any faces on a handful of vertices: hardly one of them is sound.
RC_GTEST_PROP(RandomMesh, HasTheTopologyThatTheKernelSees, ()) {
    Polyhedron p;
    for (int k = 0; k < 7; ++k) p.points.push_back({std::cos(k * 1.7), std::sin(k * 2.3), std::cos(k * 0.9 + 1)});
    if (*rc::gen::arbitrary<bool>()) {  // a tetrahedron, or two that share a vertex, to have sound ones at all
        p.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
        if (*rc::gen::arbitrary<bool>()) p.faces.insert(p.faces.end(), {{4, 6, 5}, {4, 5, 3}, {5, 6, 3}, {6, 4, 3}});
    }
    const int more = *rc::gen::inRange(0, 6);
    for (int f = 0; f < more; ++f) {
        const auto corners = *rc::gen::inRange<std::size_t>(3, 5);
        const auto ring = *rc::gen::unique<Ring>(corners, rc::gen::inRange<std::uint32_t>(0, 7));
        p.faces.push_back(ring);
    }
    RC_PRE(!p.faces.empty());
    const Mesh mesh = p.mesh();
    const CheckReport report = check_mesh(mesh);
    const bool said_sound = std::none_of(report.findings.begin(), report.findings.end(), [](const Finding& finding) {
        return finding.code.starts_with('T') && finding.severity == Severity::Error;
    });
    CheckReport unused;
    MeshReport collector(mesh, {}, unused);
    const MeshBody body{0, std::uint32_t(mesh.face_count()), false};
    const MeshMap map = MeshMapBuilder(mesh).build(body, CleanRings(body, collector), {});
    const gmap::Validation validation = gmap::validate(map.map);
    const bool is_sound = std::all_of(validation.defects.begin(), validation.defects.end(),
                                      [](const gmap::Defect& defect) { return defect.code == "T7"; });
    RC_CLASSIFY(is_sound, "sound");
    RC_ASSERT(said_sound == is_sound);
}

}  // namespace
}  // namespace enfilade::modeler::test

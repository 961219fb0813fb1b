#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/modeler/meshes/mesh_texts.h"

namespace enfilade::modeler::test {
namespace {

/// A mesh of one triangle a point, whatever else it is.
std::string points_text(const std::vector<std::array<double, 3>>& points) {
    std::string text = "v 1e9 0 0\nv 1e9 1 0\n";
    for (const auto& p : points)
        text += "v " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
    for (std::size_t k = 0; k < points.size(); ++k) text += "f 1 2 " + std::to_string(k + 3) + "\n";
    return text;
}

Mesh welded(const std::string& text, double distance) { return read_mesh(text, "a.obj", {.weld = distance}); }

TEST(Weld, LeavesIndicesAloneUnlessAskedTo) {
    EXPECT_EQ(rings(read_mesh(points_text({{0, 0, 0}, {0, 0, 0}}), "a.obj")),
              (std::vector<Ring>{{0, 1, 2}, {0, 1, 3}}));
}

TEST(Weld, JoinsEqualPointsToTheLowest) {
    const Mesh mesh = welded(points_text({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0.001}}), 0);
    EXPECT_EQ(rings(mesh), (std::vector<Ring>{{0, 1, 2}, {0, 1, 3}, {0, 1, 2}, {0, 1, 5}}));
    ASSERT_EQ(mesh.findings.size(), 1u);
    EXPECT_EQ(mesh.findings[0].code, "P811");
    EXPECT_EQ(mesh.findings[0].severity, Severity::Note);
    EXPECT_EQ(mesh.findings[0].sentence, "1 of 6 vertices were welded to one at the same place.");
}

TEST(Weld, JoinsPointsWithinTheDistance) {
    const Mesh mesh = welded(points_text({{0, 0, 0}, {0.009, 0, 0}, {0, 0, 0.011}}), 0.01);
    EXPECT_EQ(rings(mesh), (std::vector<Ring>{{0, 1, 2}, {0, 1, 2}, {0, 1, 4}}));
}

TEST(Weld, WarnsOfChains) {
    const Mesh mesh = welded(points_text({{0, 0, 0}, {0.009, 0, 0}, {0.018, 0, 0}, {0.027, 0, 0}}), 0.01);
    EXPECT_EQ(mesh.findings[0].severity, Severity::Warning);
    EXPECT_NE(mesh.findings[0].sentence.find("1 chains"), std::string::npos) << mesh.findings[0].sentence;
}

TEST(Weld, LeavesOutFacesThatCollapse) {
    const Mesh mesh = welded("v 0 0 0\nv 1 0 0\nv 1 0 1e-5\nv 0 1 0\nf 1 2 3\nf 1 2 3 4\n", 0.001);
    EXPECT_EQ(rings(mesh), (std::vector<Ring>{{}, {0, 1, 3}}));
    EXPECT_NE(mesh.findings[0].sentence.find("2 faces lost corners"), std::string::npos);
}

RC_GTEST_PROP(Weld, JoinsExactlyWhatIsNear, ()) {
    std::vector<std::array<double, 3>> points;
    const int count = *rc::gen::inRange(1, 60);
    for (int k = 0; k < count; ++k) {
        std::array<double, 3> p;
        for (double& x : p) x = *rc::gen::inRange(-20, 20) / 16.0;
        points.push_back(p);
    }
    const double distance = *rc::gen::element(0.0625, 0.125, 0.2, 0.5);
    // The sets that pairs of near points make, the slow way.
    std::vector<std::uint32_t> lowest(points.size());
    for (std::uint32_t k = 0; k < lowest.size(); ++k) lowest[k] = k;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t a = 0; a < points.size(); ++a)
            for (std::size_t b = 0; b < points.size(); ++b) {
                const double apart =
                    std::hypot(points[a][0] - points[b][0], points[a][1] - points[b][1], points[a][2] - points[b][2]);
                if (apart <= distance && lowest[b] < lowest[a]) lowest[a] = lowest[b], changed = true;
            }
    }
    const Mesh mesh = welded(points_text(points), distance);
    for (std::size_t k = 0; k < points.size(); ++k) RC_ASSERT(mesh.face(k)[2] == lowest[k] + 2);
}

}  // namespace
}  // namespace enfilade::modeler::test

// A small solid for each of val3dity's errors (docs/checks.md has the table): ours answers with the code that stands
// there.

#include <gtest/gtest.h>

#include "tests/modeler/meshes/city_texts.h"
#include "tests/modeler/meshes/polyhedra.h"

namespace enfilade::modeler::test {
namespace {

std::string points(const std::vector<Point>& list) {
    std::string text;
    for (const Point& p : list)
        text += ",[" + std::to_string(p[0]) + "," + std::to_string(p[1]) + "," + std::to_string(p[2]) + "]";
    return text;
}

const std::string ten = box_vertices({0, 0, 0}, {10, 10, 10});

/// The box of 10 m whose top surface is `top` instead; `more` vertices follow its eight.
Codes with_top(const std::string& top, const std::vector<Point>& more = {}, const std::string& also = "") {
    std::string shell = box_shell(0);
    const std::string old = "[[4,5,7,6]]";
    shell.replace(shell.find(old), old.size(), top + also);
    return codes(
        check_mesh(read_mesh(city(object("A", geometry("Solid", "[" + shell + "]")), ten + points(more)), "a.json")));
}

Codes with_shells(const std::string& shells, const std::string& vertices) {
    return codes(check_mesh(read_mesh(city(object("A", geometry("Solid", shells)), vertices), "a.json")));
}

Codes composite(const std::string& solids, const std::string& vertices) {
    return codes(check_mesh(read_mesh(city(object("A", geometry("CompositeSolid", solids)), vertices), "a.json")));
}

/// A box with a square tunnel from bottom to top; the inner rings as given.
Codes tunnel(const std::string& bottom_hole, const std::string& top_hole) {
    const std::string shell = "[[[0,2,3,1],[" + bottom_hole + "]],[[4,5,7,6],[" + top_hole +
                              "]],[[0,1,5,4]],[[2,6,7,3]],[[0,4,6,2]],[[1,3,7,5]],"
                              "[[8,12,13,9]],[[9,13,15,11]],[[11,15,14,10]],[[10,14,12,8]]]";
    return with_shells("[" + shell + "]", ten + "," + box_vertices({3, 3, 0}, {7, 7, 10}));
}

TEST(Val3dity, SoundSolid) { EXPECT_EQ(with_top("[[4,5,7,6]]"), Codes{}); }

TEST(Val3dity, E101TooFewPoints) { EXPECT_EQ(with_top("[[4,5,7,6]]", {}, ",[[4,5]]"), Codes{"T6"}); }

TEST(Val3dity, E102ConsecutivePointsSame) { EXPECT_EQ(with_top("[[4,5,5,7,6]]"), Codes{"G2"}); }

TEST(Val3dity, E102ConsecutivePointsAtOnePlace) {
    std::string shell = box_shell(0);
    shell.replace(shell.find("[[4,5,7,6]]"), 11, "[[4,5,8,7,6]]");
    shell.replace(shell.find("[[1,3,7,5]]"), 11, "[[1,3,7,8,5]]");
    EXPECT_EQ(with_shells("[" + shell + "]", ten + points({{10, 10, 10}})), Codes{"G1"});
}

TEST(Val3dity, E104SelfIntersection) {
    EXPECT_EQ(with_top("[[4,5,7,6,8,9]]", {{5, 2, 10}, {-5, 5, 10}}).front().substr(0, 1), "T") << "it is open too";
    // A bow tie between the corners of a notch: closed, but its top ring crosses itself.
    EXPECT_EQ(with_top("[[4,5,8,7,6,9]]", {{-3, 4, 10}, {13, 6, 10}}, ",[[5,7,8]],[[6,4,9]]"), Codes{"G2"});
}

TEST(Val3dity, E201IntersectionRings) {
    EXPECT_EQ(with_top("[[4,5,7,6],[8,9,10,11]]", {{2, 2, 10}, {2, 8, 10}, {12, 8, 10}, {12, 2, 10}}, ",[[8,11,10,9]]"),
              Codes{"G2"});
}

TEST(Val3dity, E202DuplicatedRings) { EXPECT_EQ(with_top("[[4,5,7,6],[6,7,5,4]]"), Codes{"G2"}); }

TEST(Val3dity, E203NotPlanarByDistance) {
    EXPECT_EQ(with_top("[[4,5,7,6,8]]", {{0, 5, 10.1}}, ",[[4,8,6]]"), Codes{"G3"});
    EXPECT_EQ(with_top("[[4,5,7,6,8]]", {{0, 5, 10.005}}, ",[[4,8,6]]"), Codes{});
}

TEST(Val3dity, E204NotPlanarByNormals) {
    // A fold 6 mm high and 8 mm wide in the top and in the wall beside it.
    std::string shell = box_shell(0);
    shell.replace(shell.find("[[4,5,7,6]]"), 11, "[[4,5,7,6,8,9,10]]");
    shell.replace(shell.find("[[0,4,6,2]]"), 11, "[[0,4,10,9,8,6,2]]");
    const std::string fold = points({{0, 5.004, 10}, {0, 5, 10.006}, {0, 4.996, 10}});
    EXPECT_EQ(with_shells("[" + shell + "]", ten + fold), Codes{"G3"});
}

TEST(Val3dity, E205InteriorDisconnected) {
    // A hole that touches the outer ring at two corners cuts the face in two; below it a pit.
    EXPECT_EQ(with_top("[[4,5,7,6],[4,8,7]]", {{3, 7, 10}}, ",[[4,7,8]]"), Codes{"G2"});
}

TEST(Val3dity, E206InnerRingOutside) {
    EXPECT_EQ(with_top("[[4,5,7,6],[8,9,10]]", {{12, 2, 10}, {12, 8, 10}, {18, 8, 10}}, ",[[8,10,9]]"), Codes{"G2"});
}

TEST(Val3dity, E207InnerRingsNested) {
    EXPECT_EQ(
        with_top("[[4,5,7,6],[8,9,10],[11,12,13]]",
                 {{2, 2, 10}, {2, 8, 10}, {8, 8, 10}, {3, 4, 10}, {3, 7, 10}, {5, 7, 10}}, ",[[8,10,9]],[[11,13,12]]"),
        Codes{"G2"});
}

TEST(Val3dity, E208OrientationOfInnerRings) {
    EXPECT_EQ(tunnel("8,9,11,10", "12,14,15,13"), Codes{"T7 note"}) << "inner rings run against the outer one";
    // The other way round nothing changes for the solid: rings carry no side in a generalized map.
    EXPECT_EQ(tunnel("10,11,9,8", "13,15,14,12"), Codes{"T7 note"});
}

TEST(Val3dity, E301TooFewPolygons) { EXPECT_EQ(with_shells("[[[[0,1,2]],[[2,1,0]]]]", ten), Codes{"T6"}); }

TEST(Val3dity, E302NotClosed) {
    EXPECT_EQ(with_top("[[4,5,8,6]]", {{9, 9, 9}}), (Codes{"T2", "G3"}));
    EXPECT_EQ(with_top("[[4,5,7]]"), Codes{"T2"});
}

TEST(Val3dity, E303NonManifoldVertex) {
    std::string both = box_shell(0);
    both.back() = ',';
    const std::string upper =
        box_vertices({10, 10, 10}, {20, 20, 20});  // its first corner is the last one of the other
    EXPECT_EQ(with_shells("[" + both + box_shell(7).substr(1) + "]", ten + upper.substr(upper.find("],") + 1)),
              Codes{"T5"});
}

TEST(Val3dity, E304NonManifoldEdge) {
    EXPECT_EQ(with_top("[[4,5,7,6]]", {{15, 5, 15}, {15, 5, 20}}, ",[[5,7,8]],[[7,5,9]],[[5,8,9]],[[7,9,8]]"),
              Codes{"T4"});
}

TEST(Val3dity, E305MultipleComponents) {
    std::string both = box_shell(0);
    both.back() = ',';
    const std::string vertices = ten + "," + box_vertices({20, 0, 0}, {30, 10, 10});
    EXPECT_EQ(with_shells("[" + both + box_shell(8).substr(1) + "]", vertices), Codes{"T5"});
}

TEST(Val3dity, E306SelfIntersection) {
    EXPECT_EQ(with_top("[[4,5,8]],[[5,7,8]],[[7,6,8]],[[6,4,8]]", {{5, 5, -5}}), Codes{"G4"});
    EXPECT_EQ(with_top("[[4,5,8]],[[5,7,8]],[[7,6,8]],[[6,4,8]]", {{5, 5, 5}}), Codes{});
}

TEST(Val3dity, E307WrongOrientation) {
    EXPECT_EQ(with_top("[[6,7,5,4]]"), Codes{"T3 warning"});
    EXPECT_EQ(with_shells("[" + box_shell(0, true) + "]", ten), Codes{"G5 warning"});
}

TEST(Val3dity, E401IntersectionShells) {
    EXPECT_EQ(with_shells("[" + box_shell(0) + "," + box_shell(8, true) + "]",
                          ten + "," + box_vertices({5, 5, 5}, {15, 7, 7})),
              Codes{"G5"});
}

TEST(Val3dity, E402DuplicatedShells) {
    EXPECT_EQ(with_shells("[" + box_shell(0) + "," + box_shell(0, true) + "]", ten), Codes{"G5"});
}

TEST(Val3dity, E403InnerShellOutside) {
    EXPECT_EQ(with_shells("[" + box_shell(0) + "," + box_shell(8, true) + "]",
                          ten + "," + box_vertices({20, 2, 2}, {25, 7, 7})),
              Codes{"G5"});
}

TEST(Val3dity, E405WrongOrientationShell) {
    const std::string vertices = ten + "," + box_vertices({2, 2, 2}, {5, 7, 7});
    EXPECT_EQ(with_shells("[" + box_shell(0) + "," + box_shell(8, true) + "]", vertices), Codes{});
    EXPECT_EQ(with_shells("[" + box_shell(0) + "," + box_shell(8) + "]", vertices), Codes{"G5 warning"});
}

TEST(Val3dity, E501IntersectionSolids) {
    const auto second = [](Point low, Point high) {
        return composite("[[" + box_shell(0) + "],[" + box_shell(8) + "]]", ten + "," + box_vertices(low, high));
    };
    EXPECT_EQ(second({10, 0, 0}, {20, 10, 10}), Codes{}) << "they share a side";
    EXPECT_EQ(second({5, 5, 5}, {15, 15, 15}), Codes{"G5"});
    EXPECT_EQ(second({2, 2, 2}, {4, 4, 4}), Codes{"G5"});
    EXPECT_EQ(second({5, 0, 0}, {15, 10, 10}), Codes{"G5"}) << "all sides on sides";
}

TEST(Val3dity, E502DuplicatedSolids) {
    EXPECT_EQ(composite("[[" + box_shell(0) + "],[" + box_shell(0) + "]]", ten), Codes{"G5"});
}

TEST(Val3dity, E902EmptyPrimitive) {
    for (const char* shells : {"[]", "[[]]"}) EXPECT_EQ(with_shells(shells, ten), Codes{"T6"}) << shells;
    EXPECT_EQ(with_shells("[" + box_shell(0) + ",[]]", ten), Codes{"T6"});
}

TEST(Val3dity, SolidsOfDifferentObjectsAreNotCompared) {
    const std::string solid = geometry("Solid", "[" + box_shell(0) + "]");
    EXPECT_EQ(
        codes(check_mesh(read_mesh(city(object("A", solid + "," + solid) + "," + object("B", solid), ten), "a.json"))),
        Codes{});
}

TEST(Val3dity, FindingsNameTheObjectTheSolidAndItsFace) {
    std::string open = box_shell(0);
    open.replace(open.find("[[4,5,7,6]],"), 12, "");
    const CheckReport report = check_mesh(read_mesh(city(object("A", geometry("Solid", "[" + box_shell(0) + "]")) +
                                                             "," + object("B", geometry("Solid", "[" + open + "]")),
                                                         ten),
                                                    "a.json"));
    ASSERT_EQ(report.findings.size(), 1u);
    const auto& elements = report.findings[0].elements;
    EXPECT_EQ(elements.at(0).kind, "solid");
    EXPECT_EQ(elements.at(0).id, "B");
    EXPECT_EQ(elements.at(0).name, "Building \"B\", LoD 2.2");
    EXPECT_EQ(elements.at(1).kind, "face");
    EXPECT_EQ(elements.at(1).id, "1") << "counted in its shell";
}

}  // namespace
}  // namespace enfilade::modeler::test

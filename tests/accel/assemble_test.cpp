#include "accel/assemble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "accel/certificate.h"
#include "accel/stats.h"
#include "accel/validate.h"
#include "base/error.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::accel {
namespace {

SceneInput small_office() { return test::synthetic_office({.rooms_per_row = 2, .rows = 2}); }

/// The code with which `assemble` refuses, "" if it does not.
std::string refusal(const SceneInput& input) {
    try {
        (void)assemble(input);
        return "";
    } catch (const InputError& error) {
        EXPECT_FALSE(std::string(error.what()).empty());
        return error.code;
    }
}

TEST(Assemble, KeepsEveryElementAndItsOrder) {
    const SceneInput input = small_office();
    const Scene scene = assemble(input);
    const SceneView& view = scene.view();
    ASSERT_EQ(view.cells.size(), input.cells.size());
    ASSERT_EQ(view.section_count(), input.sections.size());
    ASSERT_EQ(view.side_faces.size(), input.side_faces.size());
    ASSERT_EQ(view.portals.size(), input.portals.size());
    ASSERT_EQ(view.source_face_count(), input.source_faces.size());
    for (std::size_t c = 0; c < input.cells.size(); ++c) {
        EXPECT_EQ(view.cells[c].volume, input.cells[c].volume);
        EXPECT_EQ(view.cells[c].label, input.cells[c].label);
        EXPECT_EQ(view.cells[c].first_section, input.cells[c].first_section);
    }
    EXPECT_EQ(view.string(view.spaces[1].name), input.spaces[1].name);
    EXPECT_EQ(view.string(view.materials[3].name), "material 3");
}

TEST(Assemble, HoldsGridPointsExactlyAsFloats) {
    const SceneInput input = small_office();
    const Scene scene = assemble(input);
    for (std::size_t s = 0; s < input.sections.size(); ++s) {
        EXPECT_EQ(double{scene.view().section_x[s]} / input.unit, input.sections[s].x);
        EXPECT_EQ(double{scene.view().section_y[s]} / input.unit, input.sections[s].y);
    }
}

TEST(Assemble, StaysUnder300BytesACell) {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 10, .rows = 6}));
    EXPECT_LE(stats(scene).bytes_per_cell(), 300);
}

TEST(Assemble, GivesTheSameBytesForTheSameInput) {
    const SceneInput input = small_office();
    const Scene a = assemble(input), b = assemble(input);
    EXPECT_TRUE(std::ranges::equal(a.bytes(), b.bytes()));
}

TEST(Assemble, RefusesACoordinateThatAFloatCannotHold) {
    SceneInput input = small_office();
    input.sections[5].x = (1 << 24) + 1;
    EXPECT_EQ(refusal(input), "F11");
}

TEST(Assemble, RefusesAUnitThatIsNoPowerOfTwo) {
    for (const double unit : {0.001, 0.0, -0.5, std::nan("")}) {
        SceneInput input = small_office();
        input.unit = unit;
        EXPECT_EQ(refusal(input), "F13") << unit;
    }
}

TEST(Assemble, RefusesAStackThatDoesNotEndAtTheCeiling) {
    SceneInput input = small_office();
    input.side_faces.back().z_top += 1;
    EXPECT_EQ(refusal(input), "F13");
}

TEST(Assemble, RefusesIndicesOutOfRange) {
    SceneInput input = small_office();
    input.side_faces[3].target = {false, 1u << 20};
    EXPECT_EQ(refusal(input), "F10");
    input = small_office();
    input.side_faces[3].target = {true, 1u << 20};
    EXPECT_EQ(refusal(input), "F10");
    input = small_office();
    input.cells[1].first_section += 1;
    EXPECT_NE(refusal(input), "");
    input = small_office();
    input.cells[1].space = 1u << 20;
    EXPECT_EQ(refusal(input), "F4");
}

TEST(Assemble, RefusesAPortalSeenFromOneSideOnly) {
    SceneInput input = small_office();
    for (InputSideFace& face : input.side_faces)
        if (face.target.is_portal) {
            face.target = {false, 0};
            break;
        }
    EXPECT_EQ(refusal(input), "F6");
}

TEST(Assemble, RefusesASceneWithoutCells) { EXPECT_EQ(refusal(SceneInput{}), "F10"); }

TEST(Assemble, CertifiesTheArraysItWrote) {
    SceneInput input = small_office();
    input.model = {{"alpha0", 4, std::vector<std::byte>(16)}, {"plan", 1, std::vector<std::byte>(5)}};
    input.certificate = {"0.1.0", "{\"snap_mm\":\n1}", {{"T1", 0}, {"G8", 2}}};
    const Scene scene = assemble(input);
    const std::optional<Certificate> read = certificate(scene);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->program_version, "0.1.0");
    EXPECT_EQ(read->options, "{\"snap_mm\": 1}");
    EXPECT_EQ(read->code_counts, input.certificate.code_counts);
    EXPECT_EQ(read->model_sha256, hex(model_hash(scene.arrays())));
    ASSERT_EQ(read->trace_sha256.size(), 17u);
    for (const auto& [name, hash] : read->trace_sha256) EXPECT_EQ(hash, hex(sha256(scene.find(name)->bytes))) << name;
}

}  // namespace
}  // namespace enfilade::accel

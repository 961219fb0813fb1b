// D3: what was checked is what is traced.

#include "modeler/certify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "accel/certificate.h"
#include "accel/scene_file.h"
#include "base/error.h"
#include "modeler/build.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "tests/support/changed_scene.h"
#include "tests/support/small_plans.h"

namespace enfilade::modeler {
namespace {

accel::Scene scene_of(const plans::Plan& plan) {
    const Building convex = convexify(build(plan));
    return export_scene(convex, check(convex), "{}");
}

std::vector<Finding> d3_of(const Certification& certification) {
    std::vector<Finding> found;
    for (const Finding& finding : certification.report->findings)
        if (finding.severity != Severity::Note) {
            EXPECT_EQ(finding.code, "D3") << finding.sentence;
            found.push_back(finding);
        }
    return found;
}

TEST(Certify, AnUntouchedSceneIsCertified) {
    for (const plans::Plan& plan : {testing::two_rooms(), testing::two_storeys()}) {
        const Certification certification = certify(scene_of(plan));
        EXPECT_EQ(certification.verdict, "certified");
        EXPECT_TRUE(d3_of(certification).empty());
        EXPECT_EQ(certification.report->codes_checked.back(), "D3");
    }
}

TEST(Certify, AStrippedSceneIsUncertified) {
    const Certification certification = certify(accel::strip(scene_of(testing::one_room())));
    EXPECT_EQ(certification.verdict, "uncertified: no model group");
    EXPECT_FALSE(certification.report.has_value());
}

TEST(Certify, NamesTheRoomOfAFaceThatShowsAnotherSurface) {
    const accel::Scene scene = scene_of(testing::two_rooms());
    std::uint32_t face = 0;
    const auto room_sees = [&](std::uint32_t f) {
        return scene.view().spaces[index(scene.view().source_faces[f].space)].label == Label::Room;
    };
    while (!room_sees(face) || scene.view().source_faces[face].surface != accel::Surface::WallPaper) ++face;
    const accel::Scene other = testing::changed(scene, "source_faces", [&](std::byte* data, std::size_t) {
        accel::SourceFace row;
        std::memcpy(&row, data + face * sizeof row, sizeof row);
        row.surface = accel::Surface::Facade;
        std::memcpy(data + face * sizeof row, &row, sizeof row);
    });
    const Certification certification = certify(other);
    EXPECT_EQ(certification.verdict, "differs at source_faces[" + std::to_string(face) + "]");
    const auto found = d3_of(certification);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].severity, Severity::Error);
    ASSERT_FALSE(found[0].elements.empty());
    EXPECT_EQ(found[0].elements[0].id,
              scene.view().string(scene.view().spaces[index(scene.view().source_faces[face].space)].id));
    EXPECT_TRUE(found[0].point.has_value());
    EXPECT_EQ(found[0].storey, "ground");
}

TEST(Certify, NamesTheCellWhoseLabelDiffers) {
    const accel::Scene scene = scene_of(testing::two_rooms());
    std::uint32_t cell = 0;
    while (scene.view().cells[cell].label != Label::Door) ++cell;
    const accel::Scene other = testing::changed(scene, "cells", [&](std::byte* data, std::size_t) {
        accel::Cell row;
        std::memcpy(&row, data + cell * sizeof row, sizeof row);
        row.label = Label::Opening;
        std::memcpy(data + cell * sizeof row, &row, sizeof row);
    });
    const Certification certification = certify(other);
    EXPECT_EQ(certification.verdict, "differs at cells[" + std::to_string(cell) + "]");
    const auto found = d3_of(certification);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].elements[0].kind, "door");
    // Inside the door: 1 m or 0.75 m wide, 2 m high.
    const Building building = convexify(build(testing::two_rooms()));
    const Volume& volume = building.volumes[scene.view().cells[cell].volume];
    EXPECT_EQ(found[0].elements[0].id, building.spaces[volume.space].id);
    EXPECT_NEAR((*found[0].point)[2], 1, 1e-3);
}

TEST(Certify, NamesTheRoomOfASectionThatMoved) {
    const accel::Scene scene = scene_of(testing::one_room());
    std::uint32_t cell = 0;
    while (scene.view().cells[cell].label != Label::Room) ++cell;
    const std::uint32_t section = scene.view().cells[cell].first_section + 1;
    // A grid unit: both cells at this corner would have to move for it to be seen as a leak.
    const Building building = convexify(build(testing::one_room()));
    accel::Scene other;
    try {
        other = testing::changed(scene, "section_x", [&](std::byte* data, std::size_t) {
            float x = 0;
            std::memcpy(&x, data + 4 * section, 4);
            x += float(building.frame.unit);
            std::memcpy(data + 4 * section, &x, 4);
        });
    } catch (const std::exception&) {
        GTEST_SKIP() << "reading refuses such a scene already";
    }
    const Certification certification = certify(other);
    EXPECT_EQ(certification.verdict, "differs at section_x[" + std::to_string(section) + "]");
    const auto found = d3_of(certification);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].elements[0].kind, "room");
}

TEST(Certify, ACertificateOfAnotherCheckIsNone) {
    const Building convex = convexify(build(testing::one_room()));
    CheckReport report = check(convex);
    report.findings.push_back({.code = "G5", .severity = Severity::Note, .sentence = "One more than there is."});
    const Certification certification = certify(export_scene(convex, report, "{}"));
    EXPECT_EQ(certification.verdict, "differs at certificate");
    const auto found = d3_of(certification);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].sentence.find("counts 1 finding of G5"), std::string::npos) << found[0].sentence;
}

/// Its sides would be looked for without end.
TEST(Certify, RefusesAModelWhoseCornersNameOtherEdges) {
    const accel::Scene scene = scene_of(testing::two_rooms());
    const Building building = convexify(build(testing::two_rooms()));
    std::uint32_t refused = 0;
    for (std::uint32_t corner = 0; corner < building.corners.size(); ++corner) {
        const accel::Scene other = testing::changed(scene, "m.corners", [&](std::byte* data, std::size_t) {
            // Rows of vertex, half-edge, line; the half-edge is turned round.
            data[12 * corner + 4] ^= std::byte{1};
        });
        try {
            EXPECT_NE(certify(other).verdict, "certified") << corner;
        } catch (const InputError&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 0u);
}

TEST(Certify, AModelThatWasChangedAfterwardsIsNotTheCertifiedOne) {
    const accel::Scene scene = scene_of(testing::one_room());
    // A name in the tables of the model: the exported scene shows it as well, another model would not.
    const accel::Scene other = testing::changed(scene, "m.meta", [](std::byte* data, std::size_t size) {
        char* const text = reinterpret_cast<char*>(data);
        const std::string_view all(text, size), key = "\"sagitta\":";
        const std::size_t at = all.find(key);
        ASSERT_NE(at, std::string_view::npos);
        char& digit = text[at + key.size() + 4];
        digit = digit == '1' ? '2' : '1';
    });
    const Certification certification = certify(other);
    EXPECT_EQ(certification.verdict, "differs at certificate");
    const auto found = d3_of(certification);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].sentence.find("another model"), std::string::npos) << found[0].sentence;
}

}  // namespace
}  // namespace enfilade::modeler

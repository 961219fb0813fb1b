// G4: no two faces of a volume's shell meet but in what they share.

#include <gtest/gtest.h>

#include "modeler/constraints/face_meeting.h"
#include "modeler/constraints/prism_shell.h"
#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/face_oracle.h"
#include "tests/support/faults_geometry.h"
#include "tests/support/map_surgery.h"

namespace enfilade::modeler {
namespace {

/// The level face over a room, the first one found.
std::uint32_t ceiling_of_room(const Building& building) {
    for (std::uint32_t f = 0; f < building.faces.size(); ++f)
        if (building.faces[f].direction == Direction::Up &&
            building.volumes[building.faces[f].back].label == Label::Room)
            return f;
    return 0;
}

/// The ceiling of a room of 4 m x 3 m between axes comes down in one point to this height over its floor.
Building with_spike(double height) {
    Building building = build(testing::one_room());
    testing::raise_spike(building, ceiling_of_room(building),
                         {building.frame.grid_x(2), building.frame.grid_y(1.5), building.frame.grid_z(height)});
    return building;
}

TEST(Shells, FindsEachFaceThatIsPushedThroughAnother) { testing::expect_found(testing::inject_g4, 20); }

TEST(Shells, FindsACeilingThatReachesThroughTheFloor) {
    const Building building = with_spike(-0.1);
    const CheckReport report = check(building);
    ASSERT_EQ(report.count("G4"), 1u);
    for (const Finding& finding : report.findings) EXPECT_EQ(finding.code, "G4") << finding.sentence;
    const Finding& finding = report.findings.front();
    EXPECT_EQ(finding.severity, Severity::Error);
    EXPECT_EQ(finding.storey, "ground");
    ASSERT_TRUE(finding.point.has_value());
    EXPECT_NEAR((*finding.point)[0], 2, 0.1);
    EXPECT_NEAR((*finding.point)[1], 1.5, 0.1);
    EXPECT_NEAR((*finding.point)[2], 0, 0.001);
}

TEST(Shells, FindsACeilingThatTouchesTheFloor) { EXPECT_EQ(check(with_spike(0)).count("G4"), 1u); }

TEST(Shells, AcceptACeilingAUnitAboveTheFloor) { EXPECT_EQ(check(with_spike(1.0 / 8192)).count("G4"), 0u); }

TEST(Shells, OfSoundBuildingsArePrisms) {
    for (const plans::Plan& plan : {testing::two_rooms(), testing::two_storeys(), testing::ring_room()})
        for (const Building& building : {build(plan), convexify(build(plan))}) {
            const FaceRings rings(building.map, building.vertices);
            PrismShells prisms(rings);
            for (std::uint32_t v = 0; v < building.volumes.size(); ++v) EXPECT_TRUE(prisms.is_prism(v)) << v;
        }
}

/// All pairs of faces of one volume, without boxes and without a word about prisms.
bool meets_itself(const FaceRings& rings, std::uint32_t volume) {
    const auto faces = rings.faces_of(volume);
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t j = i + 1; j < faces.size(); ++j)
            if (meeting_point(FlatFace(rings.ring(faces[i]), rings.points()),
                              FlatFace(rings.ring(faces[j]), rings.points()), rings.points()))
                return true;
    return false;
}

/// Moves a level, a point of the plan over all levels, or raises a spike.
void distort(Building& building, plans::Random& random) {
    const Point3 at = building.vertices[random.below(std::uint32_t(building.vertices.size()))];
    const std::int32_t step = std::int32_t(random.uniform(-8000, 8000));
    const double kind = random.uniform();
    if (kind < 0.3) {
        for (Point3& p : building.vertices)
            if (p[2] == at[2]) p[2] += step;
    } else if (kind < 0.6) {
        for (Point3& p : building.vertices)
            if (p[0] == at[0] && p[1] == at[1]) p[random.below(2)] += step;
    } else {
        Point3 apex = at;
        for (std::int32_t& x : apex) x += std::int32_t(random.uniform(-8000, 8000));
        testing::raise_spike(building, random.below(std::uint32_t(building.faces.size())), apex);
    }
}

/// Plan points and levels are moved at random, so that prisms are bent, folded and pushed into each other: whatever is
/// still called a prism has no two faces that meet.
TEST(PrismShells, HaveNoFacesThatMeet) {
    std::uint32_t prisms_seen = 0, others = 0, meeting = 0;
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        plans::Random random{3, seed};
        Building building = build(seed % 2 == 0 ? testing::ring_room() : testing::two_rooms());
        if (random.chance(0.5)) building = convexify(building);
        distort(building, random);
        const testing::FaceOracle oracle(building);
        const FaceRings rings(building.map, building.vertices);
        PrismShells prisms(rings);
        for (std::uint32_t v = 0; v < building.volumes.size(); ++v) {
            const auto faces = rings.faces_of(v);
            const bool judged = std::all_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
                const auto& ring = oracle.faces()[f].ring;
                return oracle.is_flat(f) && oracle.is_simple(f) &&
                       std::all_of(ring.begin(), ring.end(), [&](std::uint32_t w) { return oracle.is_alone(w); });
            });
            if (!judged) continue;
            const bool meets = meets_itself(rings, v), is_prism = prisms.is_prism(v);
            EXPECT_FALSE(is_prism && meets) << "seed " << seed << ", volume " << v;
            prisms_seen += is_prism;
            others += !is_prism && !meets;
            meeting += meets;
        }
    }
    EXPECT_GT(prisms_seen, 100u);
    EXPECT_GT(others, 10u);
    EXPECT_GT(meeting, 10u);
}

}  // namespace
}  // namespace enfilade::modeler

#include "gmap/attribute.h"

#include "gmap/close.h"
#include "gmap/insert.h"
#include "gmap/sew.h"
#include "maps.h"

namespace enfilade::gmap {
namespace {

TEST(Attribute, IsCopiedToBothPartsOfASplitFace) {
    Map map = cube();
    Attribute<FaceId, std::string> names(map);
    const DartId d{0};
    names[map.face(d)] = "ceiling";
    const auto changes = insert_edge(map, d, map.alpha<0, 1, 0>(d));
    ASSERT_TRUE(changes);
    names.follow(*changes);
    EXPECT_EQ(names[map.face(d)], "ceiling");
    EXPECT_EQ(names[map.face(map.alpha<2>(changes->dart))], "ceiling");
}

TEST(Attribute, FollowsItsOwnPolicy) {
    Map map = cube();
    AttributePolicy<double> policy;
    policy.on_split = [](double& kept) { return kept /= 2; };
    policy.on_merge = [](const double& kept, const double& gone) { return kept + gone; };
    Attribute<FaceId, double> areas(map, 1.0, policy);
    const DartId d{0};
    const auto split = insert_edge(map, d, map.alpha<0, 1, 0>(d));
    ASSERT_TRUE(split);
    areas.follow(*split);
    EXPECT_EQ(areas[map.face(d)], 0.5);
    EXPECT_EQ(areas[map.face(map.alpha<2>(split->dart))], 0.5);
    const auto merged = remove_edge(map, split->dart);
    ASSERT_TRUE(merged);
    areas.follow(*merged);
    EXPECT_EQ(areas[map.face(d)], 1.0);
}

TEST(Attribute, OfVolumesSurvivesMergingAndClosing) {
    Map map = grid(3, 1, 1);
    AttributePolicy<int> policy;
    policy.created = -1;
    policy.on_merge = [](const int& kept, const int& gone) { return kept + gone; };
    Attribute<VolumeId, int> counts(map, 1, policy);
    const auto merged = remove_face(map, dart_between(map, 0, 1));
    ASSERT_TRUE(merged);
    counts.follow(*merged);
    EXPECT_EQ(counts[VolumeId{0}], 2);
    const auto removed = remove_volume(map, map.representatives<3>()[3]);
    ASSERT_TRUE(removed);
    counts.follow(*removed);
    const Changes closed = close(map);
    counts.follow(closed);
    EXPECT_EQ(counts[map.volume(closed.dart)], -1);
    EXPECT_EQ(counts[VolumeId{2}], 1);
}

TEST(Attribute, OfAVertexIsCreatedWithIt) {
    Map map = cube();
    AttributePolicy<float> policy;
    policy.created = 2.5F;
    Attribute<VertexId, float> heights(map, 0.0F, policy);
    const auto changes = insert_vertex(map, DartId{0});
    ASSERT_TRUE(changes);
    heights.follow(*changes);
    EXPECT_EQ(heights[map.vertex(changes->dart)], 2.5F);
    EXPECT_EQ(heights[VertexId{0}], 0.0F);
}

TEST(Attribute, FollowsARenumbering) {
    Map map = grid(3, 1, 1);
    Attribute<VolumeId, std::string> names(map);
    for (std::uint32_t v = 0; v < 4; ++v) names[VolumeId{v}] = std::string(1, static_cast<char>('a' + v));
    const auto changes = remove_volume(map, map.representatives<3>()[1]);
    ASSERT_TRUE(changes);
    names.follow(*changes);
    const DartId last = map.representatives<3>()[3];
    const Renumbering renumbering = map.compact();
    names.follow(renumbering);
    EXPECT_EQ(names.size(), 3u);
    EXPECT_EQ(names[VolumeId{1}], "c");
    EXPECT_EQ(names[map.volume(renumbering.darts[index(last)])], "d");
    EXPECT_TRUE(all_ids_are_orbits(map));
}

TEST(Attribute, IsCountedApartFromTheMap) {
    const Map map = grid(2, 2, 2);
    const Attribute<FaceId, std::uint32_t> materials(map);
    EXPECT_EQ(materials.size(), map.face_count());
    EXPECT_EQ(materials.memory_bytes(), 4 * map.face_count());
}

}  // namespace
}  // namespace enfilade::gmap

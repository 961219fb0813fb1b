// Lists of cells and volumes of their own show the same objects in the same places, and both are sound.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "base/id.h"
#include "modeler/certify.h"
#include "modeler/check.h"
#include "modeler/export_scene.h"
#include "modeler/exports/city_json.h"
#include "modeler/exports/dot.h"
#include "modeler/exports/hbjson.h"
#include "modeler/exports/indoor_gml.h"
#include "modeler/model_group.h"
#include "modeler/objects/object_box.h"
#include "modeler/objects/object_groups.h"
#include "modeler/objects/put_objects.h"
#include "plans/random.h"
#include "tests/support/furnished_scenes.h"

namespace enfilade::modeler {
namespace {

using accel::SceneView;
using test::FurnishedHouse;

constexpr FurnishedHouse houses[] = {FurnishedHouse::Townhouse, FurnishedHouse::Office, FurnishedHouse::Curved};

/// The objects listed by the cell that holds a point, by id.
std::set<std::string> seen_at(const SceneView& scene, const std::array<double, 3>& at) {
    std::set<std::string> ids;
    const auto cell = accel::locate(scene, at);
    if (!cell) return ids;
    for (std::uint32_t i = scene.cell_object_offsets[index(*cell)]; i < scene.cell_object_offsets[index(*cell) + 1];
         ++i)
        ids.emplace(scene.string(scene.objects[index(scene.cell_objects[i])].id));
    return ids;
}

TEST(BothWays, PlacesInsideBoxesSeeTheSameObjects) {
    for (const FurnishedHouse which : houses) {
        const Building bare = test::house(which);
        const Building list = test::furnished(bare, 11, 100, ObjectCells::List);
        const Building cut = test::furnished(bare, 11, 100, ObjectCells::Cut);
        const accel::Scene whole = accel::assemble(scene_input(list)), parted = accel::assemble(scene_input(cut));
        plans::Random random{3};
        std::size_t asked = 0;
        for (const FurnishedObject& object : list.furnishing.objects) {
            // A millimetre inside its box: what is nearer to its sides may be a neighbour's, or cut off at a wall.
            FurnishedObject inner = object;
            inner.position[2] += 1e-3;
            for (double& length : inner.size) length -= 2e-3;
            const ObjectBox box = box_of(inner);
            for (int sample = 0; sample < 50; ++sample) {
                const double u = random.uniform(), v = random.uniform(), w = random.uniform();
                const auto& [a, b, c, d] = box.footprint;
                const std::array<double, 3> at = {a.x + u * (b.x - a.x) + v * (d.x - a.x) - bare.frame.origin_x,
                                                  a.y + u * (b.y - a.y) + v * (d.y - a.y) - bare.frame.origin_y,
                                                  box.z_low + w * (box.z_high - box.z_low) - bare.frame.origin_z};
                const bool in_list = seen_at(whole.view(), at).contains(object.id);
                const bool in_cut = seen_at(parted.view(), at).contains(object.id);
                ASSERT_EQ(in_list, in_cut) << object.id << " at " << at[0] << ' ' << at[1] << ' ' << at[2];
                asked += in_list;
            }
        }
        EXPECT_GT(asked, 2500u) << "most places inside boxes are in rooms";
    }
}

/// Square metres of solid faces by surface and material.
std::map<std::pair<int, std::string>, double> areas_of(const SceneView& scene) {
    std::map<std::pair<int, std::string>, double> areas;
    for (std::size_t f = 0; f < scene.source_face_count(); ++f) {
        const accel::SourceFace& face = scene.source_faces[f];
        double sum[3] = {0, 0, 0};
        const std::uint32_t first = face.first_vertex, end = scene.source_faces[f + 1].first_vertex;
        for (std::uint32_t v = first; v < end; ++v) {
            const accel::Vertex &a = scene.vertices[v], &b = scene.vertices[v + 1 < end ? v + 1 : first];
            sum[0] += double(a.y) * b.z - double(a.z) * b.y;
            sum[1] += double(a.z) * b.x - double(a.x) * b.z;
            sum[2] += double(a.x) * b.y - double(a.y) * b.x;
        }
        areas[{int(face.surface), std::string(scene.string(scene.materials[index(face.material)].name))}] +=
            std::hypot(sum[0], sum[1], sum[2]) / 2;
    }
    return areas;
}

TEST(BothWays, WallsAndFloorsAroundObjectsLookAsTheyDid) {
    for (const FurnishedHouse which : houses) {
        const Building bare = test::house(which);
        const accel::Scene empty = accel::assemble(scene_input(bare));
        const accel::Scene full = accel::assemble(scene_input(test::furnished(bare, 12, 150, ObjectCells::Cut)));
        const auto before = areas_of(empty.view()), after = areas_of(full.view());
        ASSERT_EQ(before.size(), after.size());
        for (const auto& [look, area] : before) {
            ASSERT_TRUE(after.contains(look)) << look.second;
            EXPECT_NEAR(after.at(look), area, 0.01) << look.second;
        }
        std::size_t panes = 0, panes_after = 0;
        for (const accel::Portal& portal : empty.view().portals) panes += portal.kind() == accel::PortalKind::Glass;
        for (const accel::Portal& portal : full.view().portals)
            panes_after += portal.kind() == accel::PortalKind::Glass;
        EXPECT_GE(panes_after, panes);
    }
}

TEST(BothWays, AreSoundOnAnyPlacement) {
    for (const FurnishedHouse which : houses) {
        const Building bare = test::house(which);
        for (std::uint64_t seed = 20; seed < 24; ++seed)
            for (const ObjectCells cells : {ObjectCells::List, ObjectCells::Cut}) {
                const Building building = test::furnished(bare, seed, 60, cells);
                const accel::Scene scene = export_scene(building, check(building), "{}");
                const Certification certification = certify(scene);
                EXPECT_EQ(certification.verdict, "certified");
                for (const Finding& finding : certification.report->findings)
                    EXPECT_NE(finding.severity, Severity::Error) << finding.code << ' ' << finding.sentence;
            }
    }
}

TEST(BothWays, NearlyAllObjectsBecomeVolumes) {
    const Building bare = test::house(FurnishedHouse::Office);
    Furnishing furnishing = test::random_furnishing(bare, 2, 80);
    furnishing.cells = ObjectCells::Cut;
    std::vector<Finding> findings;
    const Building cut = put_objects(bare, furnishing, findings);
    std::size_t volumes = 0, listed = 0;
    std::set<std::string> spaces;
    for (const Space& space : cut.spaces)
        if (space.label == Label::Object) spaces.insert(space.id);
    for (const FurnishedObject& object : cut.furnishing.objects) {
        (object.volume.empty() ? listed : volumes) += 1;
        EXPECT_TRUE(object.volume.empty() || spaces.contains(object.volume)) << object.volume;
    }
    EXPECT_GT(volumes, 70u);
    EXPECT_EQ(findings.size(), listed);
    for (const Finding& finding : findings) EXPECT_EQ(finding.code, "P509");
}

TEST(BothWays, GroupsShareNoPlace) {
    const Building bare = test::house(FurnishedHouse::Curved);
    const Furnishing furnishing = test::random_furnishing(bare, 5, 120);
    std::vector<std::uint32_t> all(furnishing.objects.size());
    for (std::uint32_t k = 0; k < all.size(); ++k) all[k] = k;
    const std::vector<ObjectGroup> groups = group_objects(furnishing.objects, all, bare.frame);
    std::set<std::uint32_t> held;
    for (const ObjectGroup& group : groups) {
        EXPECT_EQ(group.box.id, furnishing.objects[group.objects.front()].id);
        for (const std::uint32_t k : group.objects) {
            EXPECT_TRUE(held.insert(k).second);
            EXPECT_EQ(furnishing.objects[k].space, group.box.space);
        }
    }
    EXPECT_EQ(held.size(), all.size());
    EXPECT_LT(groups.size(), all.size()) << "some overlap";
}

TEST(BothWays, AnotherOrderIsTheSameBuilding) {
    const Building bare = test::house(FurnishedHouse::Townhouse);
    Furnishing furnishing = test::random_furnishing(bare, 9, 40);
    for (const ObjectCells cells : {ObjectCells::List, ObjectCells::Cut}) {
        furnishing.cells = cells;
        Furnishing other = furnishing;
        std::reverse(other.objects.begin(), other.objects.end());
        std::vector<Finding> findings;
        const Building one = put_objects(bare, furnishing, findings), two = put_objects(bare, other, findings);
        EXPECT_TRUE(
            std::ranges::equal(accel::assemble(scene_input(one)).bytes(), accel::assemble(scene_input(two)).bytes()));
    }
}

TEST(BothWays, OtherProgramsGetTheirFiles) {
    const Building bare = test::house(FurnishedHouse::Townhouse);
    for (const ObjectCells cells : {ObjectCells::List, ObjectCells::Cut}) {
        const Building building = test::furnished(bare, 4, 40, cells);
        EXPECT_FALSE(to_indoorgml(building).empty());
        EXPECT_FALSE(to_cityjson(building).empty());
        EXPECT_FALSE(to_hbjson(building).empty());
        EXPECT_FALSE(to_dot(accel::assemble(scene_input(building)).view()).empty());
    }
}

}  // namespace
}  // namespace enfilade::modeler

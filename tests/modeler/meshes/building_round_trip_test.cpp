// The volumes of our own buildings, written as text and read as somebody's mesh: sound.

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "modeler/build.h"
#include "modeler/convexify.h"
#include "plans/read.h"
#include "tests/modeler/meshes/polyhedra.h"
#include "tests/support/small_plans.h"

namespace enfilade::modeler::test {
namespace {

/// The rings of one volume, each counter-clockwise seen from outside, or all of them clockwise.
std::vector<Ring> rings_of(const gmap::Map& map, gmap::DartId start) {
    std::vector<Ring> rings;
    std::vector<bool> seen(map.dart_bound(), false);
    std::vector<gmap::DartId> open{start};
    while (!open.empty()) {
        const gmap::DartId first = open.back();
        open.pop_back();
        if (seen[gmap::index(first)]) continue;
        Ring& ring = rings.emplace_back();
        gmap::DartId d = first;
        do {
            seen[gmap::index(d)] = true;
            ring.push_back(std::uint32_t(map.vertex(d)));
            open.push_back(map.alpha<0, 2>(d));
            d = map.alpha<0, 1>(d);
        } while (d != first);
    }
    return rings;
}

/// All volumes but the outside, each with vertices of its own.
std::vector<Polyhedron> volumes(const Building& building) {
    std::vector<Polyhedron> result;
    const std::vector<gmap::DartId> darts = building.map.representatives<3>();
    for (std::size_t v = 0; v + 1 < building.volumes.size(); ++v) {
        Polyhedron p;
        std::map<std::uint32_t, std::uint32_t> local;
        for (Ring ring : rings_of(building.map, darts[v])) {
            for (std::uint32_t& corner : ring) {
                const auto [at, is_new] = local.try_emplace(corner, std::uint32_t(p.points.size()));
                if (is_new) {
                    const auto& at_grid = building.vertices[corner];
                    p.points.push_back({building.frame.unit * at_grid[0], building.frame.unit * at_grid[1],
                                        building.frame.unit * at_grid[2]});
                }
                corner = at->second;
            }
            p.faces.push_back(ring);
        }
        result.push_back(std::move(p));
    }
    return result;
}

std::string off_text(const Polyhedron& p) {
    std::ostringstream out;
    out.precision(17);
    out << "OFF\n" << p.points.size() << " " << p.faces.size() << " 0\n";
    for (const Point& q : p.points) out << q[0] << " " << q[1] << " " << q[2] << "\n";
    for (const Ring& face : p.faces) {
        out << face.size();
        for (const std::uint32_t v : face) out << " " << v;
        out << "\n";
    }
    return out.str();
}

std::string obj_text(const Polyhedron& p) {
    std::ostringstream out;
    out.precision(17);
    for (const Point& q : p.points) out << "v " << q[0] << " " << q[1] << " " << q[2] << "\n";
    for (const Ring& face : p.faces) {
        out << "f";
        for (const std::uint32_t v : face) out << " " << v + 1;
        out << "\n";
    }
    return out.str();
}

void expect_sound(const Building& building) {
    std::size_t number = 0;
    for (const Polyhedron& volume : volumes(building)) {
        const std::string label = building.name + ", volume " + std::to_string(number++);
        const Mesh off = read_mesh(off_text(volume), "volume.off"), obj = read_mesh(obj_text(volume), "volume.obj");
        EXPECT_EQ(off.ring, obj.ring) << label;
        const CheckReport report = check_mesh(off);
        EXPECT_TRUE(report.sound()) << label << ": " << report.findings.front().sentence;
        EXPECT_EQ(report.count("T3") + report.count("T7"), 0u) << label;
        EXPECT_EQ(check_mesh(obj).sound(), report.sound()) << label;
    }
}

TEST(BuildingRoundTrip, SmallBuildingsAreSound) {
    for (const plans::Plan& plan :
         {testing::one_room(), testing::two_rooms(), testing::ring_room(), testing::two_storeys()}) {
        const Building building = build(plan);
        expect_sound(building);
        expect_sound(convexify(building));
    }
}

TEST(BuildingRoundTrip, AnOfficeOf46RoomsIsSound) {
    const auto plan = plans::read(std::filesystem::path(ENFILADE_SOURCE_DIR) / "plans" / "examples" / "office-46.json");
    expect_sound(build(plan));
}

TEST(BuildingRoundTrip, AllVolumesTogetherTouchWithoutOverlap) {
    Polyhedron all;
    const Building building = convexify(build(testing::two_rooms()));
    for (const Polyhedron& volume : volumes(building)) all = beside(all, volume);
    const CheckReport report = check_mesh(read_mesh(off_text(all), "all.off"));
    EXPECT_TRUE(report.sound()) << report.findings.front().sentence;
}

}  // namespace
}  // namespace enfilade::modeler::test

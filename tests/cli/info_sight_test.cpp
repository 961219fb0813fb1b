// `enfilade info --visible-from`: what a room sees.

#include <random>
#include <set>

#include "accel/locate.h"
#include "accel/scene_file.h"
#include "render/trace_rays.h"
#include "tests/cli/program.h"

namespace enfilade::test {
namespace {

using nlohmann::json;

class InfoSight : public OfficeTest {
protected:
    /// The spaces that `info` says are seen.
    static json sight(const std::string& room) {
        const Outcome outcome = run({"info", "office.enf", "--visible-from", room, "--json"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return json::parse(outcome.out)["visible_from"]["spaces"];
    }
    static json rooms() { return json::parse(run({"info", "office.enf", "--json"}).out)["rooms"]; }
};

TEST_F(InfoSight, IsMutualBetweenRooms) {
    std::set<std::pair<std::string, std::string>> sees;
    for (const json& room : rooms())
        for (const json& other : sight(room["id"]))
            if (other["label"] == "room" && other["view_share"] > 0)
                sees.insert({room["id"].get<std::string>(), other["id"].get<std::string>()});
    EXPECT_GT(sees.size(), 10u);
    for (const json& room : rooms()) {
        std::set<std::string> seen;
        for (const json& other : sight(room["id"])) seen.insert(other["id"].get<std::string>());
        for (const auto& [from, to] : sees)
            if (to == room["id"]) {
                EXPECT_TRUE(seen.contains(from)) << from << " sees " << to << ", so it is seen from there";
            }
    }
}

TEST_F(InfoSight, HoldsEverythingThatRaysMeet) {
    const accel::Scene scene = accel::open(folder() / "office.enf");
    const accel::SceneView& view = scene.view();
    std::mt19937_64 random(3);
    for (const json& room : rooms()) {
        std::set<std::string> seen = {room["id"].get<std::string>()};
        for (const json& space : sight(room["id"])) seen.insert(space["id"].get<std::string>());
        std::size_t traced = 0;
        for (std::uint32_t c = 0; c < view.cells.size(); ++c) {
            const accel::Cell& cell = view.cells[c];
            if (view.string(view.spaces[index(cell.space)].id) != room["id"].get<std::string>()) continue;
            const std::uint32_t a = cell.first_section;
            const auto middle = [&](const accel::ArrayView<float>& v) {
                return double(v[a] + v[a + 1] + v[a + 2]) / 3;
            };
            const render::Vec3d p = {middle(view.section_x), middle(view.section_y),
                                     0.5 * (cell.z_floor + cell.z_ceiling)};
            for (int k = 0; k < 2000; ++k, ++traced) {
                std::normal_distribution<double> normal;
                const render::RayHit hit = render::trace_ray(
                    view, {p, {normal(random), normal(random), 0.2 * normal(random)}, accel::CellId{c}});
                EXPECT_TRUE(
                    seen.contains(std::string(view.string(view.spaces[index(view.cells[index(hit.cell)].space)].id))));
            }
        }
        EXPECT_GT(traced, 0u);
    }
}

TEST_F(InfoSight, CountsDoorsOnTheWayAndCells) {
    std::size_t neighbours = 0;
    for (const json& room : rooms())
        for (const json& space : sight(room["id"])) {
            EXPECT_GE(space["cells_seen"], 1);
            EXPECT_LE(space["cells_seen"], space["cells"]);
            EXPECT_NE(space["id"], room["id"]);
            if (space["label"] == "door" && space["openings"] == 0) ++neighbours;
            if (space["label"] == "exterior") {
                EXPECT_GE(space["openings"], 1);
            }
        }
    EXPECT_GE(neighbours, rooms().size()) << "every room has a door, which it sees";
}

TEST_F(InfoSight, IsSaidAsATableAndTheSameEachTime) {
    const std::string room = rooms()[0]["name"];
    const Outcome first = run({"info", "office.enf", "--visible-from", room});
    EXPECT_EQ(first.exit_code, 0);
    EXPECT_TRUE(first.out.starts_with(room)) << first.out;
    EXPECT_NE(first.out.find(" of 11 other rooms"), std::string::npos) << first.out;
    EXPECT_EQ(run({"info", "office.enf", "--visible-from", room}).out, first.out);
}

TEST_F(InfoSight, KnowsARoomByTheSentenceOfRender) {
    std::string room = rooms()[0]["name"];
    room.back() = 'x';
    const Outcome info = run({"info", "office.enf", "--visible-from", room});
    const Outcome render = run({"render", "office.enf", "-o", "x.png", "--room", room});
    EXPECT_EQ(info.exit_code, 2);
    EXPECT_EQ(line_count(info.err), 1u) << info.err;
    EXPECT_NE(info.err.find("There is no room \"" + room + "\" (did you mean"), std::string::npos) << info.err;
    EXPECT_EQ(info.err, render.err);
}

}  // namespace
}  // namespace enfilade::test

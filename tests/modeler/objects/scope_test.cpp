// Whatever ray a picture is made of, it stays in the scope of its eye.

#include <gtest/gtest.h>

#include <cmath>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "modeler/objects/scope.h"
#include "render/executor.h"
#include "render/look.h"
#include "render/mirror.h"
#include "tests/render/walk_paths.h"
#include "tests/support/building_scenes.h"

namespace enfilade::modeler {
namespace {

using accel::CellId;
using accel::SceneView;
using render::Vec3d;
using render::Vec3f;
using Walked = test::WalkedPath<float>;

const render::Look look;

ScopeLight light_of_pictures() {
    const Vec3f& sun = look.sun_direction;
    return {{sun.x, sun.y, sun.z}, double{look.ambient_reach}, {}, true};
}

/// The rays of pictures, by the walk that traces them, and how often they leave a scope.
class Judge {
public:
    Judge(const SceneView& scene, std::mt19937_64& random) : scene_(scene), random_(random) {}

    void judge(const Scope& scope, const std::vector<std::array<double, 3>>& lamps, const Vec3f& eye,
               std::uint32_t cell, const Vec3d& direction) {
        render::Ray<float> ray;
        if (!render::make_ray(eye, render::vec_cast<float>(direction), ray)) return;
        Walked walked = test::follow(scene_, ray, cell);
        check(scope, walked, "sight");
        light(scope, lamps, ray, walked);
        if (!render::is_mirror_hit(scene_, walked.end)) return;
        const render::Ray<float> image = render::mirrored(ray, scene_.cells[walked.end.cell].z_floor);
        walked = test::follow(scene_, image, walked.end.cell);
        check(scope, walked, "mirrors");
        light(scope, lamps, image, walked);
    }

    [[nodiscard]] std::size_t misses() const { return misses_; }
    [[nodiscard]] const std::string& first() const { return first_; }
    [[nodiscard]] std::size_t sunlit() const { return sunlit_; }
    [[nodiscard]] std::size_t lamplit() const { return lamplit_; }

private:
    void check(const Scope& scope, const Walked& walked, const char* what) {
        for (const std::uint32_t cell : walked.path.cells) {
            if (std::ranges::binary_search(scope.cells, CellId{cell})) continue;
            if (misses_++ == 0) first_ = std::string(what) + ": cell " + std::to_string(cell);
        }
    }

    void light(const Scope& scope, const std::vector<std::array<double, 3>>& lamps, const render::Ray<float>& ray,
               const Walked& hit) {
        const std::uint32_t cell = hit.end.cell;
        Vec3f p = ray.origin + render::parameter(scene_, ray, hit.end) * ray.direction;
        p.z = std::clamp(p.z, scene_.cells[cell].z_floor, scene_.cells[cell].z_ceiling);
        for (int k = 0; k < 4; ++k) short_ray(scope, p, cell);
        render::Ray<float> sun;
        if (render::make_ray(p, look.sun_direction, sun)) {
            const Walked walked = test::follow(scene_, sun, cell);
            if (scene_.source_faces[walked.end.target.bits].surface == accel::Surface::Sky) {
                ++sunlit_;
                check(scope, walked, "sun");
            }
        }
        for (const std::array<double, 3>& lamp : lamps) lamp_ray(scope, lamp, p, cell);
    }

    void short_ray(const Scope& scope, const Vec3f& p, std::uint32_t cell) {
        render::Ray<float> ray;
        if (!render::make_ray(p, render::vec_cast<float>(test::random_direction(random_)), ray)) return;
        Walked walked;
        walked.path.cells.push_back(cell);
        Vec3f throughput = {1, 1, 1};
        const float metres = look.ambient_reach / render::length(ray.direction);
        (void)render::walk(scene_, ray, cell, render::Limit<float>{metres}, throughput, walked.path);
        check(scope, walked, "corners");
    }

    /// What stands before something solid hides no lamp from what lies behind that.
    void lamp_ray(const Scope& scope, const std::array<double, 3>& lamp, const Vec3f& p, std::uint32_t cell) {
        const Vec3f to = {float(lamp[0]), float(lamp[1]), float(lamp[2])};
        render::Ray<float> ray;
        const Vec3f way = to - p;
        if (!render::make_ray(p, way, ray)) return;
        Walked walked;
        walked.path.cells.push_back(cell);
        Vec3f throughput = {1, 1, 1};
        const float whole = render::length(way) / render::length(ray.direction);
        const auto end =
            render::walk(scene_, ray, cell, render::ToPoint<float>{whole, render::no_cell}, throughput, walked.path);
        if (end.status != render::WalkStatus::Reached) return;
        ++lamplit_;
        check(scope, walked, "lamps");
    }

    const SceneView& scene_;
    std::mt19937_64& random_;
    std::size_t misses_ = 0, sunlit_ = 0, lamplit_ = 0;
    std::string first_;
};

/// Under the middle of some cells' ceilings.
std::vector<std::array<double, 3>> lamps_of(const SceneView& scene) {
    std::vector<std::array<double, 3>> lamps;
    for (std::uint32_t c = 0; c < scene.cells.size(); c += 7) {
        const Vec3d middle = test::centre_of(scene, c);
        if (scene.cells[c].label == accel::Label::Room)
            lamps.push_back({middle.x, middle.y, double{scene.cells[c].z_ceiling} - 0.1});
    }
    return lamps;
}

class Scopes : public testing::TestWithParam<test::BuildingScene> {
protected:
    accel::Scene scene = accel::assemble(test::scene_of(GetParam()));
    const SceneView& view = scene.view();
    std::mt19937_64 random{20261122};

    [[nodiscard]] Vec3d direction() {
        Vec3d d = test::random_direction(random);
        if (random() % 2 == 0) d.z *= 0.1;
        return d;
    }
};

TEST_P(Scopes, OfPointsHoldAllRaysOfTheirPictures) {
    Judge judge(view, random);
    ScopeLight light = light_of_pictures();
    light.lamps = lamps_of(view);
    for (int k = 0; k < 8; ++k) {
        const auto cell = std::uint32_t(random() % view.cells.size());
        const Vec3d eye = test::random_point(view, cell, random);
        const Scope scope = scope_of(view, {{}, {{CellId{cell}, {eye.x, eye.y, eye.z}}}}, light);
        for (int r = 0; r < 1000; ++r) judge.judge(scope, light.lamps, render::vec_cast<float>(eye), cell, direction());
    }
    EXPECT_EQ(judge.misses(), 0u) << judge.first();
    EXPECT_GT(judge.sunlit(), 0u);
    if (light.lamps.size() > 3) {
        EXPECT_GT(judge.lamplit(), 0u);
    }
}

TEST_P(Scopes, OfRoomsHoldAllRaysFromAnywhereInThem) {
    Judge judge(view, random);
    const ScopeLight light = light_of_pictures();
    for (int k = 0; k < 2; ++k) {
        std::uint32_t cell = 0;
        do cell = std::uint32_t(random() % view.cells.size());
        while (view.cells[cell].label != accel::Label::Room);
        const accel::SpaceId room = view.cells[cell].space;
        const Scope scope = scope_of(view, {{room}, {}}, light);
        EXPECT_TRUE(std::ranges::binary_search(scope.spaces, room));
        for (const CellId c : scope.cells)
            EXPECT_TRUE(std::ranges::binary_search(scope.spaces, view.cells[index(c)].space));
        std::vector<std::uint32_t> cells;
        for (std::uint32_t c = 0; c < view.cells.size(); ++c)
            if (view.cells[c].space == room) cells.push_back(c);
        for (int r = 0; r < 1500; ++r) {
            const std::uint32_t from = cells[random() % cells.size()];
            const Vec3d eye = test::random_point(view, from, random);
            judge.judge(scope, {}, render::vec_cast<float>(eye), from, direction());
        }
    }
    EXPECT_EQ(judge.misses(), 0u) << judge.first();
}

TEST_P(Scopes, AreTheSameOnAnyNumberOfThreads) {
    ScopeLight light = light_of_pictures();
    light.lamps = lamps_of(view);
    const ScopeEyes eyes = {{view.cells[view.cells.size() / 2].space}, {}};
    const Scope alone = scope_of(view, eyes, light);
    const Scope together = scope_of(view, eyes, light, *render::make_executor());
    EXPECT_EQ(alone.cells, together.cells);
    EXPECT_EQ(alone.spaces, together.spaces);
    EXPECT_EQ(alone.seen + alone.darkening + alone.sunlit + alone.lamplit, alone.cells.size());
}

TEST_P(Scopes, GrowWithWhatIsAskedOfThem) {
    const auto cell = std::uint32_t(view.cells.size() / 3);
    const Vec3d eye = test::centre_of(view, cell);
    const ScopeEyes eyes = {{}, {{CellId{cell}, {eye.x, eye.y, eye.z}}}};
    const Scope bare = scope_of(view, eyes, {});
    ScopeLight light = light_of_pictures();
    const Scope lit = scope_of(view, eyes, light);
    EXPECT_TRUE(std::ranges::includes(lit.cells, bare.cells));
    light.lamps = lamps_of(view);
    EXPECT_TRUE(std::ranges::includes(scope_of(view, eyes, light).cells, lit.cells));
}

INSTANTIATE_TEST_SUITE_P(Buildings, Scopes, testing::ValuesIn(test::building_scenes()),
                         [](const auto& building) { return building.param.name; });

/// What scopes are for: in a long building little of it.
TEST(ScopesOfALongBuilding, HoldASmallPartOfIt) {
    const accel::Scene scene =
        accel::assemble(test::scene_of({"office", ENFILADE_SOURCE_DIR "/plans/examples/office-135.json"}));
    const SceneView& view = scene.view();
    std::size_t rooms = 0;
    double share = 0;
    for (std::uint32_t s = 0; s < view.spaces.size(); s += 5) {
        if (view.spaces[s].label != accel::Label::Room) continue;
        ++rooms;
        share += double(scope_of(view, {{accel::SpaceId{s}}, {}}, light_of_pictures()).spaces.size()) /
                 double(view.spaces.size());
    }
    EXPECT_LT(share / double(rooms), 0.3);
}

}  // namespace
}  // namespace enfilade::modeler

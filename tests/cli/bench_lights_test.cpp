// What the benchmark of lit pictures is made of: its lamps, its counts of rays, and rows that say what the issue asks.

#include <gtest/gtest.h>

#include <algorithm>

#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/generate.h"
#include "tools/bench_lights.h"

namespace enfilade::tools {
namespace {

class BenchLights : public testing::Test {
protected:
    static constexpr int side = 64;
    accel::Scene rooms_ = [] {
        const modeler::Building building = modeler::convexify(modeler::build(plans::generate({.rooms = 20})));
        return modeler::export_scene(building, modeler::check(building), "{}");
    }();
    LitScene lit_{"20 rooms", rooms_.view(), 24, LampPlaces::Rooms};
    std::vector<PreparedView> views_ = prepared(lit_.view, floor_views(lit_.view, 3, side));
    Console console_{true, false};
    Bench bench_{console_, true, "no/folder"};

    [[nodiscard]] const BenchRow* find(const std::string& part) const {
        const auto row = std::ranges::find_if(bench_.rows(),
                                              [&](const BenchRow& r) { return r.row.find(part) != std::string::npos; });
        return row == bench_.rows().end() ? nullptr : &*row;
    }
};

TEST_F(BenchLights, ShadowRaysArePairsOfPixelsAndLampsOfTheirCells) {
    const LitViews views(lit_, views_, side, nullptr);
    EXPECT_EQ(views.primary_rays(), 3.0 * side * side);
    EXPECT_LE(views.lit_pixels(), views.primary_rays());
    EXPECT_GT(views.lit_pixels(), views.primary_rays() / 2);
    EXPECT_GT(views.shadow_rays(), 0);
    EXPECT_LT(views.shadow_rays(), views.lit_pixels() * double(lit_.lamps.size()));
    // With every lamp in every list, each lit pixel asks for all.
    LitScene all("20 rooms", rooms_.view(), 24, LampPlaces::Rooms);
    all.lists = render::all_lamps(all.view);
    EXPECT_EQ(LitViews(all, views_, side, nullptr).shadow_rays(), views.lit_pixels() * double(lit_.lamps.size()));
}

TEST_F(BenchLights, EmbreeDrawsThePictureThatWeDraw) {
    const render::EmbreeReference embree(rooms_.view());
    const LitViews views(lit_, views_, side, nullptr);
    const render::Lamps tree = lit_.asked(render::LampSearch::Tree);
    render::Framebuffer ours(side, side), theirs(side, side), known(side, side);
    views.draw(render::Tracer::Scalar, &tree, ours, 1);
    const auto seen = views.first_hits(embree);
    views.draw_by(embree, {{.lanes = 16}}, {}, theirs, 1);
    views.draw_by(embree, {{.lanes = 16}}, seen, known, 1);
    // The sky behind a pane is no lit place: known hits leave it out, and Embree's panes do not tint it.
    for (std::size_t i = 0; i < known.rgba.size(); ++i)
        if (known.rgba[i] == 0xff000000u) ours.rgba[i] = theirs.rgba[i] = known.rgba[i];
    EXPECT_LT(unlike_per_million(ours, theirs), 5'000);
    EXPECT_LT(unlike_per_million(theirs, known), 2'000);
    EXPECT_GT(unlike_per_million(ours, render::Framebuffer(side, side)), 500'000);
}

TEST_F(BenchLights, SearchesHaveTheirRowsAndOnePicture) {
    bench_lit_searches(bench_, lit_);
    const BenchRow* tree = find("scalar tree, lit pictures");
    ASSERT_NE(tree, nullptr);
    ASSERT_TRUE(tree->goal.has_value());
    EXPECT_EQ(tree->goal->text(), "ratio >= 1.7");
    EXPECT_EQ(tree->reference, "scalar pvs");
    ASSERT_NE(find("light rays that lists remove"), nullptr);
    EXPECT_GT(find("light rays that lists remove")->value, 10);
    for (const char* way : {"scalar pvs", "scalar tree", "packet naive", "packet pvs", "packet tree"}) {
        ASSERT_NE(find(std::string(way) + ": pixels unlike scalar naive's"), nullptr) << way;
        EXPECT_LT(find(std::string(way) + ": pixels unlike scalar naive's")->value, 500) << way;
    }
}

TEST_F(BenchLights, PicturesAreComparedWithEmbreeAndWithoutLamps) {
    const render::EmbreeReference embree(rooms_.view());
    bench_lit_pictures(bench_, lit_, embree, true);
    ASSERT_NE(find("packet tree, shadow rays and shading"), nullptr);
    EXPECT_EQ(find("packet tree, shadow rays and shading")->goal->text(), "ratio >= 60");
    EXPECT_EQ(find("simd tree, shadow rays and shading")->goal->text(), "ratio >= 25");
    EXPECT_NE(find("packet tree, shadow rays and shading")->reference.find("Embree from known hits"),
              std::string::npos);
    EXPECT_EQ(find("packet tree, primary and shadow rays")->goal->text(), "ratio >= 0.8");
    EXPECT_LT(find("scalar tree: pixels unlike Embree's")->value, 2'000);
}

TEST_F(BenchLights, ListsAreJudged) {
    bench_lamp_lists(bench_, lit_, 1);
    for (const char* row : {"lists and trees, build", "lamps in lists, of those that are seen", "missed by lists",
                            "cells that rays of lamps find unlisted", "no edge near"}) {
        ASSERT_NE(find(row), nullptr) << row;
        EXPECT_TRUE(find(row)->goal.has_value()) << row;
        EXPECT_EQ(find(row)->met(), true) << row;
    }
}

}  // namespace
}  // namespace enfilade::tools

// The program that judges a card, on this machine's cores.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "accel/assemble.h"
#include "accel/scene_file.h"
#include "base/error.h"
#include "render/cuda/card.h"
#include "tests/support/synthetic_scene.h"
#include "tests/support/temporary_folder.h"
#include "tools/gpu/command_line.h"
#include "tools/gpu/markdown.h"
#include "tools/gpu/own_colours.h"
#include "tools/gpu/picture_difference.h"
#include "tools/gpu/ray_batch.h"
#include "tools/gpu/tried_scene.h"

namespace enfilade::tools::gpu {
namespace {

struct Said {
    int code;
    std::string out, log;
};

Said run_with(const std::vector<std::string>& arguments) {
    std::ostringstream out, log;
    const int code = run(arguments, out, log);
    return {code, out.str(), log.str()};
}

class GpuCheck : public testing::Test {
protected:
    GpuCheck() {
        accel::write(accel::assemble(test::synthetic_office({.rooms_per_row = 3, .storeys = 1, .turn = 0.3})),
                     scene_file());
    }
    [[nodiscard]] std::filesystem::path scene_file() const { return folder_.path() / "office.enf"; }
    void write_views(const std::string& text) const { std::ofstream(folder_.path() / "office.views") << text; }

private:
    test::TemporaryFolder folder_;
};

TEST_F(GpuCheck, FindsTheHostsAnswersRight) {
    const Said said = run_with({"check", "--on", "host", "--side", "40", scene_file().string()});
    EXPECT_EQ(said.code, 0) << said.out;
    EXPECT_NE(said.out.find("| office | Lambert"), std::string::npos) << said.out;
    EXPECT_NE(said.out.find("All answers are right."), std::string::npos);
    EXPECT_EQ(said.out.find("WRONG"), std::string::npos);
}

TEST_F(GpuCheck, JudgesLampsAndShadowRays) {
    write_views("lamps 5 hanging\n");
    const Said said = run_with({"check", "--on", "host", "--side", "24", "--views", "1", scene_file().string()});
    EXPECT_EQ(said.code, 0) << said.out;
    EXPECT_NE(said.out.find("shadow rays"), std::string::npos) << said.out;
}

TEST_F(GpuCheck, MeasuresNothingOnTheHost) {
    write_views("lamps 5 hanging\n");
    const Said said = run_with({"bench", "--on", "host", scene_file().string()});
    EXPECT_EQ(said.code, 0);
    for (const char* title : {"## Limits", "## Frames of", "## Pictures as batches", "## Streams", "## Goals"})
        EXPECT_NE(said.out.find(title), std::string::npos) << title;
    EXPECT_NE(said.out.find("nothing was measured"), std::string::npos);
    EXPECT_EQ(said.out.find("| met"), std::string::npos);
}

TEST_F(GpuCheck, ReadsViewsAndLampsBesideTheScene) {
    write_views("# two views\nview a 2 2 1.6 3 4 1.5 60\nview b 2 2 1.6 4 3 1.5 75  # wide\nlamps 5 hanging\n");
    const TriedScene scene = open_tried_scene(scene_file());
    ASSERT_EQ(scene.views.size(), 2u);
    EXPECT_EQ(scene.views[1].name, "b");
    EXPECT_EQ(scene.views[0].camera.fov_deg, 60);
    EXPECT_EQ(scene.view().lights.count, 5u);
    EXPECT_EQ(view_line("a", scene.views[0].camera, scene.view()), "view a 2 2 1.6 3 4 1.5 60\n");
}

TEST_F(GpuCheck, SaysWhichLineOfTheViewsIsWrong) {
    for (const auto& [text, code] :
         {std::pair<std::string, std::string>{"view a 2 2 1.6 3 4 1.5 60\nview b 2 2\n", "F134"},
          {"\nviews a 2 2 1.6 3 4 1.5 60\n", "F134"},
          {"\nlamps 5 nowhere\n", "F134"},
          {"\nview b 2 2 99999 3 4 1.5 60\n", "F135"},
          {"\nview b 2 2 1.6 3 4 1.5 60 7\n", "F134"}}) {
        write_views(text);
        try {
            (void)open_tried_scene(scene_file());
            ADD_FAILURE() << "accepted: " << text;
        } catch (const InputError& error) {
            EXPECT_EQ(error.code, code) << text;
            EXPECT_EQ(error.line, 2) << text;
        }
    }
}

TEST_F(GpuCheck, RefusesArgumentsThatAreNone) {
    for (const std::vector<std::string>& wrong :
         std::vector<std::vector<std::string>>{{},
                                               {"chec"},
                                               {"check"},
                                               {"check", "--on", "mars", "x.enf"},
                                               {"check", "--side", "0", "x.enf"},
                                               {"--fast"}})
        EXPECT_THROW((void)run_with(wrong), InputError);
    EXPECT_EQ(run_with({"--help"}).code, 0);
}

TEST_F(GpuCheck, SaysWhyThereIsNoCard) {
    if (!render::cuda::cards().empty()) GTEST_SKIP() << "this machine has a card";
    EXPECT_THROW((void)run_with({"card"}), render::cuda::CudaError);
    EXPECT_THROW((void)run_with({"check", scene_file().string()}), render::cuda::CudaError);
}

TEST_F(GpuCheck, GivesEveryFaceAColourWithGreen) {
    const accel::Scene scene = accel::open(scene_file());
    const OwnColours coloured(scene.view());
    const accel::SceneView& view = coloured.view();
    for (std::size_t f = 0; f + 2 < view.source_faces.size(); ++f) {
        EXPECT_NE(view.source_faces[f].material, view.source_faces[f + 1].material);
        EXPECT_GE(view.materials[index(view.source_faces[f].material)].colour[1], 0.3f);
    }
}

class PictureDifferences : public testing::Test {
protected:
    PictureDifferences() : expected_(4, 4) {
        for (std::size_t i = 0; i < 16; ++i) expected_.rgba[i] = i % 4 < 2 ? 0xff202020u : 0xff808080u;
        actual_ = expected_;
    }
    render::Framebuffer expected_, actual_;
};

TEST_F(PictureDifferences, AreNoneOfAPictureAndItself) {
    const PictureDifference found = difference(expected_, actual_, 1);
    EXPECT_EQ(found.pixels, 16u);
    EXPECT_EQ(found.exact, 16u);
    EXPECT_EQ(found.same, 16u);
    EXPECT_EQ(found.first, "");
}

TEST_F(PictureDifferences, TellRoundingEdgesLeaksAndFaultsApart) {
    actual_.rgba[0] = 0xff202120u;   // a step
    actual_.rgba[1] = 0xff808080u;   // what the pixel beside it shows
    actual_.rgba[4] = 0xffff00ffu;   // nothing
    actual_.rgba[11] = 0xff802080u;  // a colour from among those of other pixels, but none beside it
    const PictureDifference found = difference(expected_, actual_, 1);
    EXPECT_EQ(found.exact, 12u);
    EXPECT_EQ(found.same, 13u);
    EXPECT_EQ(found.at_edges, 1u);
    EXPECT_EQ(found.leaks, 1u);
    EXPECT_EQ(found.unexplained, 1u);
    EXPECT_NE(found.first.find("(0, 1)"), std::string::npos) << found.first;
}

TEST(RandomOrders, HaveEachRayOnce) {
    const accel::SerialExecutor one;
    RayBatch rays("some", 1000);
    for (std::size_t i = 0; i < rays.size(); ++i) rays.set(i, {static_cast<float>(i), 0, 0}, {1, 0, 0}, {});
    std::vector<float> places = shuffled(rays, 3, one).origin[0];
    EXPECT_NE(places, rays.origin[0]);
    std::sort(places.begin(), places.end());
    EXPECT_EQ(places, rays.origin[0]);
}

TEST(MarkdownTables, HaveColumnsAsWideAsTheirCells) {
    MarkdownTable table({"a", "long"});
    table.add({"1|2", "x"});
    EXPECT_EQ(table.text(), "| a    | long |\n|------|------|\n| 1\\|2 | x    |\n");
}

TEST(MarkdownNumbers, AreShortAndNeverTooGood) {
    EXPECT_EQ(grouped(1234567), "1,234,567");
    EXPECT_EQ(three_digits(0.012345), "0.0123");
    EXPECT_EQ(three_digits(4.5678), "4.57");
    EXPECT_EQ(three_digits(123456), "123,000");
    EXPECT_EQ(share_text(999'999, 1'000'000), "99.9999 %");
    EXPECT_EQ(share_text(9'999'999, 10'000'000), "99.9999 %");
    EXPECT_EQ(share_text(5, 5), "100 %");
}

}  // namespace
}  // namespace enfilade::tools::gpu

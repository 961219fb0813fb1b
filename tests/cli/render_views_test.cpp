// Pictures of all views of a file.

#include <algorithm>

#include "accel/scene_file.h"
#include "render/image_file.h"
#include "tests/cli/program.h"
#include "tools/floor_views.h"
#include "tools/output_file.h"
#include "tools/picture_files.h"
#include "tools/view_file.h"

namespace enfilade::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class RenderViews : public OfficeTest {
protected:
    static void SetUpTestSuite() {
        OfficeTest::SetUpTestSuite();
        const accel::Scene scene = accel::open(folder() / "office.enf");
        std::vector<tools::SavedView> views;
        const std::vector<std::string> names = {"Entrance hall, 2", "../../etc", "Büro"};
        for (const render::Camera& camera : tools::floor_views(scene.view(), 3, 1024))
            views.push_back(tools::as_saved({names[views.size()], camera, {}}, scene.view()));
        text_ = tools::view_file_text(views, scene.view());
        tools::write_text(folder() / "tour.json", text_);
    }
    static Outcome render(const std::string& output, std::vector<std::string> more = {}) {
        std::vector<std::string> words = {"render", "office.enf", "--views", "tour.json", "-o",
                                          output,   "--size",     "24x16",   "--spp",     "1"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    /// The names of what is in a folder, hidden files included.
    static std::vector<std::string> listing(const fs::path& path) {
        std::vector<std::string> names;
        for (const fs::directory_entry& entry : fs::directory_iterator(path))
            names.push_back(entry.path().filename().string());
        std::ranges::sort(names);
        return names;
    }
    static inline std::string text_;
};

TEST_F(RenderViews, AFolderIsMadeAndHoldsAPictureOfEach) {
    const Outcome outcome = render("tour/");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(listing(folder() / "tour"),
              (std::vector<std::string>{"01-entrance-hall-2.png", "02-etc.png", "03-büro.png"}));
    EXPECT_NE(outcome.out.find("3 pictures of 24 x 16 pixels"), std::string::npos) << outcome.out;
    for (const std::string& name : listing(folder() / "tour"))
        EXPECT_EQ(render::read_image(folder() / "tour" / name).width, 24);
    // Again, over what is there.
    EXPECT_EQ(render("tour").exit_code, 0);
    EXPECT_EQ(listing(folder() / "tour").size(), 3u);
}

TEST_F(RenderViews, ANumberInTheNameCountsThePictures) {
    fs::create_directory(folder() / "numbered");
    ASSERT_EQ(render("numbered/view-%03d.exr").exit_code, 0);
    EXPECT_EQ(listing(folder() / "numbered"),
              (std::vector<std::string>{"view-001.exr", "view-002.exr", "view-003.exr"}));
}

TEST_F(RenderViews, APictureIsThatOfTheSameCamera) {
    const Outcome outcome = render("same-%d.png", {"--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json said = json::parse(outcome.out);
    ASSERT_EQ(said["pictures"].size(), 3u);
    const json& second = said["pictures"][1];
    EXPECT_EQ(second["file"], "same-2.png");
    EXPECT_EQ(second["name"], "../../etc");
    const json saved = json::parse(text_)["views"][1];
    EXPECT_EQ(second["cell"], saved["cell"]);
    const auto point = [](const json& p) {
        return std::to_string(p[0].get<double>()) + ',' + std::to_string(p[1].get<double>()) + ',' +
               std::to_string(p[2].get<double>());
    };
    ASSERT_EQ(run({"render", "office.enf", "-o", "alone.png", "--size", "24x16", "--spp", "1", "--fov-deg", "75",
                   "--camera", point(saved["eye"]) + ':' + point(saved["target"])})
                  .exit_code,
              0);
    EXPECT_EQ(read_bytes(folder() / "alone.png"), read_bytes(folder() / "same-2.png"));
    EXPECT_EQ(said["statistics"]["pixels"], 3 * 24 * 16);
}

TEST_F(RenderViews, NamesThatAreTooFewAreRefusedBeforeTheWork) {
    const Outcome outcome = render("one.png");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("tour-%02d.png"), std::string::npos) << outcome.err;
    EXPECT_EQ(render("absent/folder/").exit_code, 3);
    EXPECT_EQ(render("absent/%d.png").exit_code, 3);
    EXPECT_EQ(render("tour-%02d.gif").exit_code, 2);
    EXPECT_FALSE(fs::exists(folder() / "one.png"));
    EXPECT_FALSE(fs::exists(folder() / "absent"));
}

TEST_F(RenderViews, AViewInAWallLeavesNothingBehind) {
    std::string text = text_;
    const std::size_t eye = text.rfind("\"eye\": [") + 8;
    text.replace(eye, text.find(',', eye) - eye, "99999");  // outside the site
    tools::write_text(folder() / "lost.json", text);
    const Outcome outcome = run({"render", "office.enf", "--views", "lost.json", "-o", "lost/", "--size", "24x16"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("lost.json:6:"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("\"Büro\""), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(folder() / "lost"));
}

TEST_F(RenderViews, AStaleCellIsAWarningAndThePictureTheSame) {
    ASSERT_EQ(render("fresh-%d.png").exit_code, 0);
    std::string text = text_;
    for (std::size_t at = 0; (at = text.find("\"cell\": ", at)) != std::string::npos; ++at)
        text.replace(at + 8, text.find('}', at) - at - 8, "4000000000");
    tools::write_text(folder() / "stale.json", text);
    const std::vector<std::string> words = {"render",       "office.enf", "--views", "stale.json", "-o",
                                            "stale-%d.png", "--size",     "24x16",   "--spp",      "1"};
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("3 views of 3"), std::string::npos) << outcome.err;
    for (const char* number : {"1", "2", "3"})
        EXPECT_EQ(read_bytes(folder() / ("fresh-" + std::string(number) + ".png")),
                  read_bytes(folder() / ("stale-" + std::string(number) + ".png")));
    std::vector<std::string> quiet = words;
    quiet.emplace_back("--quiet");
    const Outcome silent = run(quiet);
    EXPECT_EQ(silent.exit_code, 0);
    EXPECT_EQ(silent.out + silent.err, "");
}

TEST_F(RenderViews, AFileThatIsAbsentOrNoViewFileIsRefused) {
    const Outcome absent = run({"render", "office.enf", "--views", "absent.json", "-o", "x/"});
    EXPECT_EQ(absent.exit_code, 3);
    EXPECT_EQ(line_count(absent.err), 1u) << absent.err;
    EXPECT_EQ(run({"render", "office.enf", "--views", "office.json", "-o", "x/"}).exit_code, 2);
    EXPECT_EQ(run({"render", "office.enf", "--views", "tour.json", "--room", "A", "-o", "x/"}).exit_code, 2);
    EXPECT_EQ(run({"render", "office.enf", "--views", "tour.json", "--camera", "aerial", "-o", "x/"}).exit_code, 2);
    EXPECT_FALSE(fs::exists(folder() / "x"));
}

TEST(PicturePaths, DependOnTheViewsAlone) {
    const std::vector<std::string> names = {"Hall", "", "\x01/\\",
                                            "Very long name of a very long corridor with no end in sight at all"};
    EXPECT_EQ(tools::picture_paths("out/", names),
              (std::vector<fs::path>{"out/01-hall.png", "out/02.png", "out/03.png",
                                     "out/04-very-long-name-of-a-very-long-corridor-with-no-end-in-sight.png"}));
    EXPECT_EQ(tools::picture_paths("a%2d%d.png", std::vector<std::string>{"x"}), (std::vector<fs::path>{"a 1%d.png"}));
    EXPECT_EQ(tools::picture_paths("100%.png", std::vector<std::string>{"x"}), (std::vector<fs::path>{"100%.png"}));
    EXPECT_EQ(tools::picture_paths("many/", std::vector<std::string>(150)).back(), "many/150.png");
}

}  // namespace
}  // namespace enfilade::test

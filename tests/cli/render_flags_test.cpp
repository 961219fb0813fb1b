// Which tracer makes a picture, and what it says about its rays.

#include "render/image_file.h"
#include "render/kernel.h"
#include "tests/cli/program.h"

namespace enfilade::test {
namespace {

using nlohmann::json;

class RenderFlags : public OfficeTest {
protected:
    /// Renders a small picture from inside the first room to `picture`.
    static Outcome picture_of(const std::string& picture, const std::vector<std::string>& words) {
        const json info = json::parse(run({"info", "office.enf", "--json"}).out);
        std::vector<std::string> all = {"render", "office.enf",           "-o",     picture,
                                        "--room", info["rooms"][0]["id"], "--size", "48x32"};
        all.insert(all.end(), words.begin(), words.end());
        return run(all);
    }
};

TEST_F(RenderFlags, PacketsAreTheDefault) {
    const Outcome outcome = picture_of("default.png", {"--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json said = json::parse(outcome.out);
    EXPECT_EQ(said["tracer"], "packet");
    EXPECT_EQ(said["real"], "float");
    EXPECT_EQ(said["packets"], json({{"largest", 64}, {"smallest", 8}}));
    EXPECT_EQ(said["mirror_floor"], 0);
    EXPECT_EQ(said["shading"], "look");
    EXPECT_EQ(said["walked_by"], "scalar") << "rays of ambient light go one by one, and so do those they start from";
}

TEST_F(RenderFlags, EveryTracerMakesThePicture) {
    for (const char* tracer : {"scalar", "simd", "packet", "oracle"}) {
        const std::string picture = std::string(tracer) + ".png";
        const Outcome outcome =
            picture_of(picture, {"--tracer", tracer, "--shading", "lambert", "--spp", "1", "--json"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(json::parse(outcome.out)["tracer"], tracer);
        EXPECT_EQ(json::parse(outcome.out)["walked_by"], tracer);
        const render::Image image = render::read_image(folder() / picture);
        EXPECT_EQ(image.width, 48);
        // Lambert's lamp lights every wall of the room: no black picture, whoever traces it.
        double sum = 0;
        for (const float v : image.rgb) sum += double(v);
        EXPECT_GT(sum / double(image.rgb.size()), 0.05) << tracer;
    }
}

TEST_F(RenderFlags, PacketsFillMostOfAPlainPicture) {
    if (enfilade::render::detail::lane_kernels() == nullptr) GTEST_SKIP() << "this build has no Highway";
    const std::vector<std::string> plain = {"--shading", "lambert", "--spp", "1", "--json"};
    const json counts = json::parse(picture_of("plain.png", plain).out)["statistics"];
    EXPECT_GT(counts["packets"], 0);
    EXPECT_GT(counts["pixels_filled_whole"], 0);
    EXPECT_LE(counts["pixels_filled_whole"], 48 * 32);
    EXPECT_EQ(counts["leaks"], 0);
}

TEST_F(RenderFlags, DoublePrecisionChoosesTheScalarTracer) {
    const Outcome outcome = picture_of("double.png", {"--real", "double", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(json::parse(outcome.out)["tracer"], "scalar");
    EXPECT_EQ(json::parse(outcome.out)["real"], "double");
    EXPECT_FALSE(json::parse(outcome.out).contains("packets"));
}

TEST_F(RenderFlags, RefusesWhatIsWrongOrContradictsItselfBeforeTheWork) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
        {{"--tracer", "magic"}, "magic"},
        {{"--real", "half"}, "half"},
        {{"--real", "double", "--tracer", "packet"}, "--tracer scalar"},
        {{"--real", "double", "--tracer", "simd"}, "--tracer scalar"},
        {{"--real", "float", "--tracer", "oracle"}, "oracle"},
        {{"--packets", "64"}, "LARGEST:SMALLEST"},
        {{"--packets", "64:"}, "LARGEST:SMALLEST"},
        {{"--packets", "48:8"}, "powers of two"},
        {{"--packets", "8:8"}, "16"},
        {{"--packets", "512:8"}, "256"},
        {{"--packets", "64:2"}, "4"},
        {{"--packets", "16:32"}, "smallest"},
        {{"--packets", "99999999999:8"}, "powers of two"},
        {{"--packets", "64:8", "--tracer", "scalar"}, "--tracer packet"},
        {{"--packets", "64:8", "--real", "double"}, "--tracer packet"},
        {{"--mirror-floor", "1.5"}, "0.25"},
        {{"--mirror-floor", "nan"}, "0.25"},
        {{"--mirror-floor", "-0.5"}, "0.25"},
        {{"--mirror-floor", "shiny"}, "0.25"},
        {{"--stats", "--tracer", "oracle"}, "--stats"},
    };
    for (const auto& [words, part] : wrong) {
        // The scene does not exist: a flag is refused before it is looked for.
        std::vector<std::string> all = {"render", "absent.enf", "-o", "wrong.png"};
        all.insert(all.end(), words.begin(), words.end());
        const Outcome outcome = run(all);
        EXPECT_EQ(outcome.exit_code, 2) << words.back() << outcome.err;
        EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
        EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
    EXPECT_FALSE(std::filesystem::exists(folder() / "wrong.png"));
}

TEST_F(RenderFlags, AMirrorTakesAShareOrTheUsualOne) {
    for (const auto& [words, share] : std::vector<std::pair<std::vector<std::string>, double>>{
             {{"--mirror-floor"}, 0.25}, {{"--mirror-floor", "0.5"}, 0.5}, {{"--mirror-floor", "0"}, 0}}) {
        std::vector<std::string> all = words;
        all.emplace_back("--json");
        const Outcome outcome = picture_of("mirror.png", all);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(json::parse(outcome.out)["mirror_floor"], share);
    }
}

TEST_F(RenderFlags, SaysWhatHappenedToTheRays) {
    const Outcome outcome = picture_of("stats.png", {"--tracer", "scalar", "--stats", "--spp", "1"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* part : {"rays walked", "cells entered", "sides tested", "recoveries", "leaks"})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << outcome.out;
    const Outcome silent = picture_of("stats.png", {"--quiet"});
    EXPECT_EQ(silent.out + silent.err, "");
    const json counts = json::parse(picture_of("stats.png", {"--json", "--tracer", "scalar"}).out)["statistics"];
    EXPECT_EQ(counts["pixels"], 48 * 32);
    EXPECT_GE(counts["rays"], 48 * 32);
    EXPECT_EQ(counts["leaks"], 0);
    EXPECT_GE(counts["cells"], 48 * 32) << "every pixel's ray enters a cell";
    EXPECT_GE(counts["side_tests"], 3 * counts["cells"].get<int>()) << "a cell has three sides or more";
}

}  // namespace
}  // namespace enfilade::test

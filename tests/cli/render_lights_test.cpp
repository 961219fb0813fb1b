// Pictures lit by the lamps of a scene: which flags make them, and what is said of them.

#include <cmath>
#include <fstream>

#include "tests/cli/office_pictures.h"

namespace enfilade::test {
namespace {

using nlohmann::json;

class RenderLights : public OfficePictures {
protected:
    static Outcome lit(const std::string& picture, const Words& words) {
        return rendered(picture, joined(flags, words));
    }
    static json said(const std::string& picture, const Words& words) { return told(picture, joined(flags, words)); }

private:
    static inline const Words flags = {"--size", "48x32"};
};

TEST_F(RenderLights, AllSearchesMakeOnePicture) {
    for (const char* shading : {"look", "lambert"}) {
        render::Image truth;
        for (const char* search : {"naive", "pvs", "tree"}) {
            const std::string picture = std::string(search) + shading + ".exr";
            const json lights = said(picture, {"--lights", search, "--shading", shading})["lights"];
            EXPECT_EQ(lights["search"], search);
            EXPECT_GE(lights["lamps"], 12) << "an office has a lamp in every room";
            EXPECT_EQ(lights["trees"].is_null(), std::string(search) == "naive");
            if (truth.rgb.empty()) truth = image(picture);
            ASSERT_GT(mean(truth), 0);
            const render::Image shown = image(picture);
            std::size_t others = 0;
            for (std::size_t i = 0; i < shown.rgb.size(); ++i)
                others += std::abs(shown.rgb[i] - truth.rgb[i]) > 2e-3f * truth.rgb[i] + 1e-6f ? 1 : 0;
            EXPECT_LE(others, shown.rgb.size() / 100) << search << ' ' << shading;
        }
    }
}

TEST_F(RenderLights, EachStepOfExposureHalvesTheLight) {
    for (const char* ev : {"6", "7"})
        EXPECT_EQ(said(std::string(ev) + ".exr", {"--lights", "tree", "--shading", "lambert", "--spp", "1",
                                                  "--exposure", ev})["lights"]["exposure_ev"],
                  std::stod(ev));
    const render::Image bright = image("6.exr"), dim = image("7.exr");
    std::size_t halved = 0, other = 0;
    for (std::size_t i = 0; i < bright.rgb.size(); ++i) {
        if (std::abs(bright.rgb[i] - 2 * dim.rgb[i]) <= 2e-3f * bright.rgb[i]) ++halved;
        else other += bright.rgb[i] == dim.rgb[i] ? 0 : 1;  // the evening sky in the window is as dim in all pictures
    }
    EXPECT_EQ(other, 0u);
    EXPECT_GT(halved, bright.rgb.size() / 2);
}

TEST_F(RenderLights, WithoutExposureFilesOfNumbersHoldCandelaPerSquareMetre) {
    EXPECT_EQ(said("cd.exr", {"--lights", "tree", "--shading", "lambert"})["lights"]["unit"], "candela/m2");
    EXPECT_EQ(said("white.exr", {"--lights", "tree", "--shading", "lambert", "--exposure", "0"})["lights"]["unit"],
              "white");
    EXPECT_NEAR(mean(image("cd.exr")) / mean(image("white.exr")), 1.2, 0.01) << "white at 0 EV is 1.2 cd/m2";
}

TEST_F(RenderLights, AutomaticExposureKeepsThePictureBetweenBlackAndWhite) {
    const json lights = said("auto.png", {"--lights", "tree"})["lights"];
    EXPECT_FALSE(lights["is_exposure_chosen"]);
    const render::Image shown = image("auto.png");
    std::size_t white = 0;
    for (const float v : shown.rgb) white += v >= 1 ? 1 : 0;
    EXPECT_LT(white, shown.rgb.size() / 10);
    EXPECT_GT(mean(shown), 0.05);
    // What is said can be asked for: the same picture.
    (void)said("asked.png", {"--lights", "tree", "--exposure", std::to_string(double(lights["exposure_ev"]))});
    EXPECT_EQ(image("asked.png"), shown);
}

TEST_F(RenderLights, AmbientLightBrightensTheEvening) {
    const Words evening = {"--lights", "tree", "--exposure", "6", "--ambient"};
    Words none = evening, some = evening;
    none.emplace_back("0");
    some.emplace_back("20");
    EXPECT_EQ(said("some.png", some)["lights"]["ambient_lux"], 20);
    (void)said("none.png", none);
    EXPECT_GT(mean(image("some.png")), mean(image("none.png")) + 0.005);
}

TEST_F(RenderLights, LampsAreForEveryWayToLook) {
    for (const Words& words : std::vector<Words>{{"--tracer", "scalar"},
                                                 {"--tracer", "simd"},
                                                 {"--tracer", "packet"},
                                                 {"--real", "double"},
                                                 {"--no-objects"},
                                                 {"--mirror-floor"},
                                                 {"--spp", "1", "--shading", "lambert"}}) {
        Words all = {"--lights", "tree"};
        all.insert(all.end(), words.begin(), words.end());
        EXPECT_GE(said("any.png", all)["lights"]["lamps"], 12) << words.front();
    }
    const Outcome outcome = run({"render", "office.enf", "-o", "cut.png", "--camera", "dollhouse:0", "--lights", "tree",
                                 "--size", "48x32", "--stats"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* part : {"exposure", "EV", "beams", "planes", "lamps: "})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << outcome.out;
}

TEST_F(RenderLights, NoClustersChangeNothingAndSmallOnesLittle) {
    const Words plain = {"--lights", "pvs", "--shading", "lambert"};
    const auto with = [&](const char* search, const char* error) {
        Words words = {"--lights", search, "--shading", "lambert", "--light-clusters", error};
        return words;
    };
    EXPECT_TRUE(said("plain.exr", plain)["lights"]["clusters"].is_null());
    const render::Image truth = image("plain.exr");
    const json none = said("none.exr", with("pvs", "0"))["lights"];
    EXPECT_EQ(none["clusters"]["clusters"], 0);
    EXPECT_EQ(image("none.exr"), truth);
    for (const char* search : {"pvs", "tree"}) {
        const json some = said("some.exr", with(search, "0.2"))["lights"]["clusters"];
        EXPECT_EQ(some["error"], 0.2);
        EXPECT_GT(some["bytes"], 0);
        EXPECT_NEAR(mean(image("some.exr")), mean(truth), 0.05 * mean(truth)) << search;
    }
    (void)said("many.exr", with("pvs", "0.9"));
    EXPECT_NEAR(mean(image("many.exr")), mean(truth), 0.5 * mean(truth));
}

TEST_F(RenderLights, ClustersOfManyLampsStandForThem) {
    // A row of lamps under a ceiling, many to the metre.
    json plan = json::parse(std::ifstream(folder() / "office.json"));
    const json light = plan["storeys"][0]["lights"][0];
    for (int k = 1; k <= 200; ++k) {
        json copy = light;
        copy["id"] = "row-" + std::to_string(k);
        copy["position"][0] = double(light["position"][0]) + 0.004 * k;
        plan["storeys"][0]["lights"].push_back(copy);
    }
    std::ofstream(folder() / "row.json") << plan;
    const Outcome built = run({"build", "row.json", "-o", "row.enf"});
    ASSERT_EQ(built.exit_code, 0) << built.err;
    const auto rendered = [&](const std::string& picture, Words words) {
        words.insert(words.begin(), {"render", "row.enf", "-o", picture, "--camera", "dollhouse:0", "--size", "48x32",
                                     "--shading", "lambert", "--json"});
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return json::parse(outcome.out, nullptr, false)["lights"];
    };
    for (const char* search : {"pvs", "tree"}) {
        const json all = rendered("all.exr", {"--lights", search});
        const json some = rendered("joined.exr", {"--lights", search, "--light-clusters", "0.7"});
        EXPECT_GT(some["clusters"]["clusters"], 0);
        EXPECT_LT(some["clusters"]["cell_lights"], all["trees"]["cell_lights"]) << search;
        EXPECT_NEAR(mean(image("joined.exr")), mean(image("all.exr")), 0.05 * mean(image("all.exr"))) << search;
        EXPECT_NE(image("joined.exr"), image("all.exr")) << "the lamps that stand for others shine";
    }
}

TEST_F(RenderLights, OneExposureServesAllViewsOfARun) {
    ASSERT_EQ(run({"tour", "office.enf", "-o", "lit.views.json", "--views", "3"}).exit_code, 0);
    const Outcome outcome = run({"render", "office.enf", "--views", "lit.views.json", "-o", "lit/", "--size", "24x16",
                                 "--spp", "1", "--lights", "tree", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(json::parse(outcome.out)["pictures"].size(), 3u);
    EXPECT_TRUE(json::parse(outcome.out)["lights"]["exposure_ev"].is_number());
}

TEST_F(RenderLights, ASceneWithoutLampsSaysWhatToDo) {
    // A plan like the office's, its lamps taken away.
    const auto plan = json::parse(std::ifstream(folder() / "office.json"));
    json dark = plan;
    for (json& storey : dark["storeys"]) storey.erase("lights");
    std::ofstream(folder() / "dark.json") << dark;
    ASSERT_EQ(run({"build", "dark.json", "-o", "dark.enf"}).exit_code, 0);
    const Words look = {"render", "dark.enf", "-o", "dark.png", "--camera", "exterior", "--size", "48x32"};
    Words asked = look;
    asked.insert(asked.end(), {"--lights", "tree"});
    const Outcome outcome = run(asked);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("--lamps"), std::string::npos) << outcome.err;
    const render::Image with = image("dark.png");
    ASSERT_EQ(run(look).exit_code, 0);
    EXPECT_EQ(image("dark.png"), with);
}

TEST_F(RenderLights, RefusesWhatIsWrongOrMeansNothingBeforeTheWork) {
    const std::vector<std::pair<Words, std::string>> wrong = {
        {{"--lights", "bright"}, "bright"},
        {{"--lights", "tree", "--exposure", "dark"}, "exposure value"},
        {{"--lights", "tree", "--exposure", "nan"}, "exposure value"},
        {{"--lights", "tree", "--exposure", "1e9"}, "exposure value"},
        {{"--lights", "tree", "--ambient", "-1"}, "lux"},
        {{"--lights", "tree", "--ambient", "nan"}, "lux"},
        {{"--lights", "tree", "--ambient", "5", "--shading", "lambert"}, "--ambient"},
        {{"--lights", "tree", "--tracer", "oracle"}, "oracle"},
        {{"--lights", "tree", "--show", "cells"}, "--show cells"},
        {{"--exposure", "6"}, "--lights tree"},
        {{"--ambient", "6"}, "--lights tree"},
        {{"--lights", "none", "--exposure", "6"}, "--lights tree"},
        {{"--lights", "tree", "--light-clusters", "1"}, "under 1"},
        {{"--lights", "tree", "--light-clusters", "-0.1"}, "under 1"},
        {{"--lights", "tree", "--light-clusters", "nan"}, "under 1"},
        {{"--lights", "tree", "--light-clusters", "small"}, "small"},
        {{"--lights", "naive", "--light-clusters", "0.1"}, "--lights tree"},
        {{"--lights", "none", "--light-clusters", "0.1"}, "--lights tree"},
        {{"--light-clusters", "0.1"}, "--lights tree"},
    };
    for (const auto& [words, part] : wrong) {
        Words all = {"render", "absent.enf", "-o", "wrong.png"};
        all.insert(all.end(), words.begin(), words.end());
        const Outcome outcome = run(all);
        EXPECT_EQ(outcome.exit_code, 2) << words.back() << outcome.err;
        EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
        EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
    const Outcome mesh = run({"render", "bunny.obj", "-o", "wrong.png", "--lights", "tree"});
    EXPECT_EQ(mesh.exit_code, 2);
    EXPECT_NE(mesh.err.find("no lamps"), std::string::npos) << mesh.err;
}

}  // namespace
}  // namespace enfilade::test

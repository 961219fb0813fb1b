// Pictures with the light that goes from surface to surface: which flags make them, and what is said of them. And how
// bright pictures are made.

#include <cmath>
#include <limits>

#include "tests/cli/office_pictures.h"
#include "tools/exposure.h"

namespace enfilade::test {
namespace {

using nlohmann::json;

class RenderPaths : public OfficePictures {
protected:
    static Outcome traced(const std::string& picture, const Words& words) {
        return rendered(picture, joined(flags, words));
    }
    static json said(const std::string& picture, const Words& words) { return told(picture, joined(flags, words)); }

private:
    static inline const Words flags = {"--size", "32x24", "--spp", "16", "--integrator", "path"};
};

TEST_F(RenderPaths, BringLightThatLampsDoNotSendThemselves) {
    const Words lamps = {"--lights", "tree", "--shading", "lambert", "--exposure", "6"};
    Words direct = lamps;
    direct.insert(direct.end(), {"--bounces", "0"});
    const json all = said("all.exr", lamps), once = said("once.exr", direct);
    EXPECT_EQ(all["paths"]["bounces"], 32);
    EXPECT_EQ(once["paths"]["bounces"], 0);
    EXPECT_GT(mean(image("all.exr")), 1.15 * mean(image("once.exr"))) << "walls are light";
    // Without bounces it is the picture of direct light.
    ASSERT_EQ(run({"render", "office.enf", "-o", "direct.exr", "--room", "Office 0.004", "--size", "32x24", "--spp",
                   "16", "--lights", "tree", "--shading", "lambert", "--exposure", "6"})
                  .exit_code,
              0);
    EXPECT_NEAR(mean(image("once.exr")) / mean(image("direct.exr")), 1, 0.05);
}

TEST_F(RenderPaths, SayHowNoisyTheyAre) {
    const Outcome outcome = traced("noise.png", {"--lights", "tree"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* part : {"16 samples a pixel", "noise", "exposure"})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << outcome.out;
    const json picture = said("noise.png", {"--lights", "tree"})["paths"]["pictures"][0];
    EXPECT_EQ(picture["samples"], 16);
    EXPECT_GT(picture["noise"], 0);
    EXPECT_LT(picture["noise"], 1);
}

TEST_F(RenderPaths, AreTheSameBytesAgainAndOtherNoiseByAnotherSeed) {
    const Words lit = {"--lights", "tree", "--exposure", "6", "--threads"};
    Words one = lit, two = lit, seeded = lit;
    one.emplace_back("1");
    two.emplace_back("2");
    seeded.insert(seeded.end(), {"2", "--seed", "7"});
    for (const auto& [name, words] : {std::pair("one.exr", one), std::pair("two.exr", two), std::pair("7.exr", seeded)})
        ASSERT_EQ(traced(name, words).exit_code, 0);
    EXPECT_EQ(image("one.exr"), image("two.exr"));
    EXPECT_NE(image("one.exr"), image("7.exr"));
    EXPECT_NEAR(mean(image("one.exr")) / mean(image("7.exr")), 1, 0.1);
}

TEST_F(RenderPaths, ByDayTheSkyLightsRoomsThroughTheirWindows) {
    const json day = said("day.png", {});
    EXPECT_TRUE(day["lights"].is_null());
    EXPECT_TRUE(day["paths"]["exposure_ev"].is_number());
    EXPECT_GT(mean(image("day.png")), 0.05);
    const Outcome cut = run({"render", "office.enf", "-o", "cut.png", "--camera", "dollhouse:0", "--size", "32x24",
                             "--spp", "4", "--integrator", "path"});
    EXPECT_EQ(cut.exit_code, 0) << cut.err;
}

TEST_F(RenderPaths, RefuseWhatMeansNothingToThemBeforeTheWork) {
    const std::vector<std::pair<Words, std::string>> wrong = {
        {{"--integrator", "magic"}, "magic"},
        {{"--noise", "0.1"}, "--integrator path"},
        {{"--bounces", "3"}, "--integrator path"},
        {{"--seed", "3"}, "--integrator path"},
        {{"--integrator", "path", "--tracer", "simd"}, "--tracer simd"},
        {{"--integrator", "path", "--tracer", "oracle"}, "--tracer oracle"},
        {{"--integrator", "path", "--real", "double"}, "--real double"},
        {{"--integrator", "path", "--packets", "64:8"}, "--packets"},
        {{"--integrator", "path", "--show", "cells"}, "--show cells"},
        {{"--integrator", "path", "--shading", "lambert"}, "--lights tree"},
        {{"--integrator", "path", "--lights", "tree", "--ambient", "3"}, "--ambient"},
        {{"--integrator", "path", "--noise", "2"}, "--noise"},
        {{"--integrator", "path", "--noise", "nan"}, "--noise"},
        {{"--integrator", "path", "--bounces", "1001"}, "1000"},
        {{"--spp", "0"}, "--spp"},
    };
    for (const auto& [words, part] : wrong) {
        Words all = {"render", "absent.enf", "-o", "wrong.png"};
        all.insert(all.end(), words.begin(), words.end());
        const Outcome outcome = run(all);
        EXPECT_EQ(outcome.exit_code, 2) << words.back() << outcome.err;
        EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
        EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    }
}

/// A picture of that luminance, and a black half.
render::Image half_lit(float luminance) {
    render::Image image(20, 10);
    for (std::size_t i = 0; i < image.rgb.size() / 2; ++i) image.rgb[i] = luminance;
    return image;
}

TEST(Exposure, PutsNearlyAllLitPixelsUnderWhite) {
    for (const float luminance : {1e-3f, 1.0f, 77.0f, 1e4f}) {
        const std::vector<render::Image> images = {half_lit(luminance)};
        EXPECT_NEAR(double{luminance} / tools::white_luminance(tools::metered_ev(images, 0)), 1, 0.04);
    }
}

TEST(Exposure, IsTheUsualOneWhereNothingIsLitOrNothingIsANumber) {
    const std::vector<render::Image> dark = {half_lit(0)},
                                     infinite = {half_lit(std::numeric_limits<float>::infinity())},
                                     none = {half_lit(std::numeric_limits<float>::quiet_NaN())};
    for (const auto* images : {&dark, &infinite, &none}) EXPECT_EQ(tools::metered_ev(*images, 6), 6);
}

TEST(Exposure, ValuesAndLuminancesAreEachOthersInverse) {
    for (const double ev : {-20.0, 0.0, 6.3, 30.0})
        EXPECT_NEAR(tools::exposure_value(tools::white_luminance(ev)), ev, 1e-12);
    EXPECT_NEAR(tools::white_luminance(7) / tools::white_luminance(6), 2, 1e-12);
}

}  // namespace
}  // namespace enfilade::test

// --tracer cuda: by a card where there is one, refused with one sentence where there is none, and by this machine's
// cores that play a card (--device host).

#include "render/cuda/card.h"
#include "tests/cli/office_pictures.h"

namespace enfilade::test {
namespace {

using nlohmann::json;

class RenderDevice : public OfficePictures {
protected:
    /// A small one.
    static Outcome drawn(const std::string& picture, const Words& flags) {
        return rendered(picture, joined({"--size", "48x32"}, flags));
    }
};

TEST_F(RenderDevice, WithoutACardItEndsWithThreeAndOneSentence) {
    if (render::cuda::why_no_card(0).empty()) GTEST_SKIP() << "there is a card";
    const Outcome outcome = drawn("none.png", {"--tracer", "cuda"});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("--tracer"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder() / "none.png"));
}

TEST_F(RenderDevice, ACardThatIsNotThereIsNamed) {
    const Outcome outcome = drawn("none.png", {"--tracer", "cuda", "--device", "77"});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
}

TEST_F(RenderDevice, ThisMachinesCoresDrawWhatTheScalarTracerDraws) {
    const std::vector<Words> looks = {{"--shading", "lambert", "--spp", "1"},
                                      {"--shading", "lambert", "--spp", "4", "--mirror-floor", "0.5"},
                                      {"--shading", "look"},
                                      {"--shading", "look", "--real", "double"},
                                      {"--shading", "lambert", "--lights", "tree", "--exposure", "6"}};
    for (const Words& look : looks) {
        SCOPED_TRACE(look[1] + ' ' + look.back());
        const Outcome scalar = drawn("scalar.exr", joined(look, {"--tracer", "scalar"}));
        ASSERT_EQ(scalar.exit_code, 0) << scalar.err;
        const Outcome device = drawn("device.exr", joined(look, {"--tracer", "cuda", "--device", "host", "--json"}));
        ASSERT_EQ(device.exit_code, 0) << device.err;
        EXPECT_EQ(json::parse(device.out)["walked_by"], "cuda");
        EXPECT_EQ(json::parse(device.out)["device"], "this machine's cores");
        EXPECT_EQ(image("device.exr"), image("scalar.exr"));
    }
}

TEST_F(RenderDevice, ThisMachinesCoresDrawDollhousesAndTours) {
    const Words dollhouse = {"render", "office.enf", "--size", "48x32", "--camera", "dollhouse", "-o"};
    ASSERT_EQ(run(joined(dollhouse, {"scalar.exr"})).exit_code, 0);
    ASSERT_EQ(run(joined(dollhouse, {"device.exr", "--tracer", "cuda", "--device", "host"})).exit_code, 0);
    EXPECT_EQ(image("device.exr"), image("scalar.exr"));
    ASSERT_EQ(run({"tour", "office.enf", "-o", "views.json", "--views", "3"}).exit_code, 0);
    const Words tour = {"render", "office.enf", "--size", "24x16", "--views", "views.json", "-o"};
    ASSERT_EQ(run(joined(tour, {"scalar-%d.exr"})).exit_code, 0);
    ASSERT_EQ(run(joined(tour, {"device-%d.exr", "--tracer", "cuda", "--device", "host"})).exit_code, 0);
    for (const char* number : {"1", "2", "3"})
        EXPECT_EQ(image(std::string("device-") + number + ".exr"), image(std::string("scalar-") + number + ".exr"));
}

TEST_F(RenderDevice, WhatMeansNothingToACardIsRefused) {
    const std::vector<std::pair<Words, std::string>> wrong = {
        {{"--device", "0"}, "--tracer cuda"},
        {{"--tracer", "packet", "--device", "host"}, "--tracer cuda"},
        {{"--tracer", "cuda", "--device", "-1"}, "card's number"},
        {{"--tracer", "cuda", "--device", "gpu"}, "card's number"},
        {{"--tracer", "cuda", "--device", "host", "--stats"}, "--stats"},
        {{"--tracer", "cuda", "--device", "host", "--integrator", "path"}, "--tracer cuda"},
        {{"--tracer", "cuda", "--device", "host", "--show", "cells"}, "--show cells"},
    };
    for (const auto& [words, named] : wrong) {
        const Outcome outcome = drawn("wrong.png", words);
        EXPECT_EQ(outcome.exit_code, 2) << words.back();
        EXPECT_NE(outcome.err.find(named), std::string::npos) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(folder() / "wrong.png"));
    }
}

}  // namespace
}  // namespace enfilade::test

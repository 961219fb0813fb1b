// Who looks inside of objects: `--object-accel`, and the flags of octrees.

#include <cmath>

#include "render/image_file.h"
#include "tests/cli/program.h"

namespace enfilade::test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

Words operator+(Words a, const Words& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

class ObjectAccelFlag : public OfficeTest {
protected:
    static void SetUpTestSuite() {
        OfficeTest::SetUpTestSuite();
        const Outcome furnished = run({"build", "office.json", "-o", "full.enf", "--furnish", "--json"});
        ASSERT_EQ(furnished.exit_code, 0) << furnished.err;
        room_ = json::parse(furnished.out).at("furniture").at("rooms").at(0).at("id");
    }
    /// What --json says of a small picture of a furnished room.
    static json picture(const std::string& file, const Words& more) {
        const Outcome outcome =
            run(Words{"render", "full.enf", "-o", file, "--size", "64x64", "--room", room_, "--json"} + more);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return json::parse(outcome.out, nullptr, false);
    }
    static inline std::string room_;
};

/// The share of numbers that differ by more than dithering does.
double unlike(const std::filesystem::path& a, const std::filesystem::path& b) {
    const render::Image one = render::read_image(a), other = render::read_image(b);
    EXPECT_EQ(one.rgb.size(), other.rgb.size());
    std::size_t differing = 0;
    for (std::size_t i = 0; i < one.rgb.size(); ++i) differing += std::abs(one.rgb[i] - other.rgb[i]) > 0.02f;
    return double(differing) / double(one.rgb.size());
}

TEST_F(ObjectAccelFlag, EveryKindGivesThePicture) {
    for (const char* shading : {"look", "lambert"}) {
        (void)picture("plain.exr", {"--object-accel", "plain", "--shading", shading});
        for (const char* kind : {"bvh", "octree"}) {
            (void)picture("other.exr", {"--object-accel", kind, "--shading", shading});
            EXPECT_LT(unlike(folder() / "plain.exr", folder() / "other.exr"), 0.005) << kind << ' ' << shading;
        }
        (void)picture("bare.exr", {"--no-objects", "--shading", shading});
        EXPECT_GT(unlike(folder() / "plain.exr", folder() / "bare.exr"), 0.02) << "there is furniture to be seen";
    }
}

TEST_F(ObjectAccelFlag, ThePictureDoesNotDependOnTheOptionsOfTheOctree) {
    (void)picture("usual.exr", {"--object-accel", "octree"});
    for (const Words& options :
         {Words{"--octree-depth", "3"}, Words{"--octree-leaf", "2"}, Words{"--octree-balance"},
          Words{"--octree-depth", "20", "--octree-leaf", "1", "--octree-balance"}, Words{"--octree-layout", "ropes"},
          Words{"--octree-layout", "stored", "--octree-real", "double", "--octree-balance"}}) {
        (void)picture("other.exr", Words{"--object-accel", "octree"} + options);
        EXPECT_EQ(unlike(folder() / "usual.exr", folder() / "other.exr"), 0) << options[0];
    }
}

TEST_F(ObjectAccelFlag, TheFastestThatWasBuiltIsTheDefault) {
    const json objects = picture("default.png", {}).at("objects");
    const bool has_embree = picture("bvh.png", {"--object-accel", "bvh"}).at("objects").at("accel") == "embree";
    EXPECT_EQ(objects.at("accel"), has_embree ? "embree" : "octree");
    EXPECT_EQ(objects.contains("octree"), !has_embree);
}

TEST_F(ObjectAccelFlag, SaysWhatWasBuilt) {
    const json objects = picture("said.png", {"--object-accel", "octree"}).at("objects");
    EXPECT_EQ(objects.at("accel"), "octree");
    const double triangles = objects.at("triangles"), bytes = objects.at("bytes");
    EXPECT_GT(triangles, 100);
    EXPECT_DOUBLE_EQ(objects.at("bytes_per_triangle"), bytes / triangles);
    EXPECT_GE(objects.at("seconds"), 0);
    const json octree = objects.at("octree");
    EXPECT_GT(octree.at("trees"), 0);
    EXPECT_GT(octree.at("leaves"), octree.at("empty_leaves"));
    EXPECT_GE(octree.at("references_per_triangle"), 1);
    EXPECT_GE(octree.at("depth"), 1);
    const json usual = {
        {"layout", "linked"}, {"real", "float"}, {"depth", nullptr}, {"leaf", nullptr}, {"balance", false}};
    EXPECT_EQ(octree.at("asked"), usual);
    const json other = {{"layout", "stored"}, {"real", "double"}, {"depth", 6}, {"leaf", 9}, {"balance", true}};
    EXPECT_EQ(picture("said.png", {"--object-accel", "octree", "--octree-layout", "stored", "--octree-real", "double",
                                   "--octree-depth", "6", "--octree-leaf", "9", "--octree-balance"})
                  .at("objects")
                  .at("octree")
                  .at("asked"),
              other);
    EXPECT_EQ(picture("said.png", {"--object-accel", "plain"}).at("objects").at("accel"), "plain");
    EXPECT_TRUE(picture("said.png", {"--no-objects"}).at("objects").is_null());
    const Outcome text = run({"render", "full.enf", "-o", "said.png", "--size", "16x16", "--room", room_,
                              "--object-accel", "octree", "--stats"});
    for (const char* part :
         {"octree, built in", "linked, float, depth by the mesh", "a triangle", "leaves", "references", "depth"})
        EXPECT_NE(text.out.find(part), std::string::npos) << part << '\n' << text.out;
}

TEST_F(ObjectAccelFlag, OptionsOfTheOctreeDoWhatTheySay) {
    const auto octree = [](const Words& options) {
        return picture("any.png", Words{"--object-accel", "octree"} + options).at("objects").at("octree");
    };
    const json usual = octree({}), shallow = octree({"--octree-depth", "2"}), fine = octree({"--octree-leaf", "2"});
    EXPECT_LE(shallow.at("depth"), 2);
    EXPECT_LT(shallow.at("leaves"), usual.at("leaves"));
    EXPECT_GT(fine.at("leaves"), usual.at("leaves"));
    EXPECT_GT(octree({"--octree-balance", "--octree-leaf", "2"}).at("leaves"), fine.at("leaves"));
}

TEST_F(ObjectAccelFlag, WrongFlagsAreRefusedBeforeTheWork) {
    const std::vector<std::pair<Words, std::string>> wrong = {
        {{"--object-accel", "kd"}, "octree"},
        {{"--octree-depth", "5"}, "--object-accel octree"},
        {{"--octree-leaf", "5", "--object-accel", "bvh"}, "--object-accel octree"},
        {{"--octree-balance", "--object-accel", "plain"}, "--object-accel octree"},
        {{"--octree-layout", "ropes"}, "--object-accel octree"},
        {{"--octree-layout", "boxes", "--object-accel", "octree"}, "--octree-layout"},
        {{"--octree-real", "double", "--object-accel", "octree"}, "--octree-layout"},
        {{"--octree-real", "half", "--octree-layout", "ropes", "--object-accel", "octree"}, "--octree-real"},
        {{"--octree-depth", "0", "--object-accel", "octree"}, "--octree-depth"},
        {{"--octree-depth", "21", "--object-accel", "octree"}, "--octree-depth"},
        {{"--octree-depth", "-1", "--object-accel", "octree"}, "--octree-depth"},
        {{"--octree-depth", "deep", "--object-accel", "octree"}, "--octree-depth"},
        {{"--octree-leaf", "0", "--object-accel", "octree"}, "--octree-leaf"},
        {{"--octree-leaf", "1000000", "--object-accel", "octree"}, "--octree-leaf"},
    };
    for (const Words& command : {Words{"render", "absent.enf", "-o", "wrong.png"},
                                 Words{"trace", "absent.enf", "absent.npy", "-o", "wrong.npy"}}) {
        for (const auto& [words, part] : wrong) {
            const Outcome outcome = run(command + words);
            EXPECT_EQ(outcome.exit_code, 2) << words[0];
            EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
            EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
        }
    }
    EXPECT_FALSE(std::filesystem::exists(folder() / "wrong.png"));
}

TEST_F(ObjectAccelFlag, FlagsThatChangeNothingAreRefused) {
    const Words render = {"render", "absent.enf", "-o", "wrong.png"};
    const Words trace = {"trace", "absent.enf", "absent.npy", "-o", "wrong.npy"};
    const std::vector<std::pair<Words, std::string>> idle = {
        {render + Words{"--tracer", "oracle"}, "oracle"},    {render + Words{"--no-objects"}, "--no-objects"},
        {render + Words{"--show", "cells"}, "--show cells"}, {trace + Words{"--query", "all"}, "--query all"},
        {trace + Words{"--no-objects"}, "--no-objects"},
    };
    for (const auto& [words, part] : idle) {
        for (const Words& flags : {Words{"--object-accel", "octree"}, Words{"--object-accel", "plain"},
                                   Words{"--object-accel", "octree", "--octree-depth", "3"}}) {
            const Outcome outcome = run(words + flags);
            EXPECT_EQ(outcome.exit_code, 2) << part;
            EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
            EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
            EXPECT_NE(outcome.err.find("--object-accel changes nothing"), std::string::npos) << outcome.err;
        }
    }
    EXPECT_NE(run(render + Words{"--object-accel", "bvh", "--octree-depth", "5"}).err.find("instead of bvh"),
              std::string::npos);
}

}  // namespace
}  // namespace enfilade::test

#include "accel/scene_file.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <fstream>

#include "accel/assemble.h"
#include "accel/certificate.h"
#include "accel/scene_image.h"
#include "accel/validate.h"
#include "base/error.h"
#include "tests/support/synthetic_scene.h"
#include "tests/support/temporary_folder.h"

namespace enfilade::accel {
namespace {

namespace fs = std::filesystem;

Scene modelled_scene() {
    SceneInput input = test::synthetic_office({.rooms_per_row = 2, .rows = 2});
    input.origin = {1e6, -2e6, 30};
    input.model = {{"alpha0", 4, std::vector<std::byte>(16, std::byte{7})}};
    input.certificate.program_version = "test";
    return assemble(input);
}

std::vector<std::byte> bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::vector<std::byte> bytes(fs::file_size(path));
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return bytes;
}

TEST(SceneFile, ComesBackAsTheSameBytes) {
    const test::TemporaryFolder folder;
    const Scene scene = modelled_scene();
    write(scene, folder.path() / "a.enf");
    const Scene again = open(folder.path() / "a.enf", {.verify_hashes = true});
    EXPECT_TRUE(std::ranges::equal(scene.bytes(), again.bytes()));
    EXPECT_EQ(again.view().origin[1], -2e6);
    EXPECT_TRUE(again.has_model());
    write(again, folder.path() / "b.enf");
    EXPECT_EQ(bytes_of(folder.path() / "a.enf"), bytes_of(folder.path() / "b.enf"));
}

TEST(SceneFile, LeavesNoTemporaryFile) {
    const test::TemporaryFolder folder;
    write(modelled_scene(), folder.path() / "a.enf");
    write(modelled_scene(), folder.path() / "a.enf");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
    EXPECT_THROW(write(modelled_scene(), folder.path() / "no_such_folder" / "a.enf"), IoError);
}

TEST(SceneFile, StrippedKeepsTheTraceAndTheCertificate) {
    const Scene scene = modelled_scene();
    const Scene stripped = strip(scene);
    EXPECT_FALSE(stripped.has_model());
    EXPECT_EQ(stripped.find("alpha0"), nullptr);
    EXPECT_TRUE(validate(stripped.view()).empty());
    EXPECT_TRUE(damaged_arrays(stripped).empty());
    EXPECT_TRUE(std::ranges::equal(stripped.find("cells")->bytes, scene.find("cells")->bytes));
    EXPECT_EQ(certificate(stripped)->model_sha256, hex(model_hash(scene.arrays())));
}

TEST(SceneFile, CarriesSectionsThatItDoesNotKnow) {
    const Scene scene = modelled_scene();
    std::vector<SceneArray> arrays(scene.arrays().begin(), scene.arrays().end());
    const std::array<std::byte, 3> payload = {std::byte{1}, std::byte{2}, std::byte{3}};
    arrays.push_back({"octrees", 63, Group::Trace, 1, payload, sha256(payload)});
    const Scene::Storage image = detail::lay_out(scene.view().unit, {0, 0, 0}, arrays);
    const Scene again = read({image.bytes.get(), image.size}, {.verify_hashes = true});
    ASSERT_NE(again.find("octrees"), nullptr);
    EXPECT_TRUE(std::ranges::equal(strip(again).find("octrees")->bytes, payload));
}

TEST(SceneFile, AlignsArraysAndPadsThemWithZeros) {
    const Scene scene = modelled_scene();
    for (const SceneArray& array : scene.arrays()) {
        EXPECT_EQ((array.bytes.data() - scene.bytes().data()) % 64, 0) << array.name;
        const std::byte* end = array.bytes.data() + array.bytes.size();
        ASSERT_LE(end + 64, scene.bytes().data() + scene.bytes().size());
        for (int i = 0; i < 64; ++i) EXPECT_EQ(end[i], std::byte{0});
    }
}

TEST(SceneFile, RefusesWhatIsNoFile) {
    const test::TemporaryFolder folder;
    EXPECT_THROW((void)open(folder.path() / "absent.enf"), IoError);
    EXPECT_THROW((void)open(folder.path()), IoError);
    std::ofstream(folder.path() / "empty.enf").close();
    EXPECT_THROW((void)open(folder.path() / "empty.enf"), InputError);
    std::ofstream(folder.path() / "text.enf") << std::string(1000, 'x');
    try {
        (void)open(folder.path() / "text.enf");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.code, "F1");
        EXPECT_EQ(error.file, (folder.path() / "text.enf").string());
    }
}

TEST(SceneFile, NamesTheArrayWhoseHashIsWrong) {
    const Scene scene = modelled_scene();
    std::vector<std::byte> bytes(scene.bytes().begin(), scene.bytes().end());
    const SceneArray& colours = *scene.find("materials");
    bytes[static_cast<std::size_t>(colours.bytes.data() - scene.bytes().data())] ^= std::byte{1};
    const Scene damaged = read(bytes);
    EXPECT_EQ(damaged_arrays(damaged), std::vector<std::string>{"materials"});
    EXPECT_THROW((void)read(bytes, {.verify_hashes = true}), InputError);
}

}  // namespace
}  // namespace enfilade::accel

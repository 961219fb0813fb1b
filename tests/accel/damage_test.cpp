// A damaged or hostile file is refused, or is a scene on which everything ends: never a crash.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "accel/scene_file.h"
#include "accel/scene_image.h"
#include "accel/sha256.h"
#include "accel/stats.h"
#include "accel/validate.h"
#include "base/error.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::accel {
namespace {

std::vector<std::byte> sound_bytes() {
    const Scene scene = assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2}));
    return {scene.bytes().begin(), scene.bytes().end()};
}

/// A view of a copy of the scene whose array `name` can be written to.
class Editable {
public:
    Editable() : bytes_(sound_bytes()), scene_(read(bytes_)) {}
    template <class T>
    T& at(const char* name, std::size_t i) {
        const SceneArray& array = *scene_.find(name);
        return reinterpret_cast<T*>(const_cast<std::byte*>(array.bytes.data()))[i];
    }
    [[nodiscard]] const SceneView& view() const { return scene_.view(); }
    /// The code of the first defect, "" if there is none.
    [[nodiscard]] std::string defect() const {
        const std::vector<Defect> defects = validate(scene_.view());
        return defects.empty() ? "" : defects.front().code;
    }

private:
    std::vector<std::byte> bytes_;
    Scene scene_;
};

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(Validate, FindsNothingInASoundScene) { EXPECT_EQ(Editable().defect(), ""); }

TEST(Validate, FindsATargetOutOfRange) {
    Editable scene;
    scene.at<SideFace>("side_faces", 4).target = Target::solid(1u << 29);
    EXPECT_EQ(scene.defect(), "F6");
}

TEST(Validate, FindsANeighbourThatTheOtherSideDoesNotKnow) {
    Editable scene;
    for (std::size_t f = 0;; ++f) {
        Target& target = scene.at<SideFace>("side_faces", f).target;
        if (!target.is_portal()) continue;
        target.bits ^= 1;
        break;
    }
    EXPECT_EQ(scene.defect(), "F6");
}

TEST(Validate, FindsNaNInEveryArrayOfNumbers) {
    const auto defect_with = [](const auto& edit) {
        Editable scene;
        edit(scene);
        return scene.defect();
    };
    EXPECT_NE(defect_with([](Editable& s) { s.at<float>("section_x", 2) = nan; }), "");
    EXPECT_NE(defect_with([](Editable& s) { s.at<float>("section_y", 2) = nan; }), "");
    EXPECT_NE(defect_with([](Editable& s) { s.at<SideFace>("side_faces", 2).z_top = nan; }), "");
    EXPECT_NE(defect_with([](Editable& s) { s.at<Cell>("cells", 2).z_floor = nan; }), "");
    EXPECT_NE(defect_with([](Editable& s) { s.at<Cell>("cells", 2).z_ceiling = nan; }), "");
    EXPECT_NE(defect_with([](Editable& s) { s.at<Vertex>("vertices", 2).z = nan; }), "");
    EXPECT_NE(defect_with([](Editable& s) { s.at<Vertex>("tints", 0).x = nan; }), "");
    EXPECT_NE(defect_with([](Editable& s) { s.at<Material>("materials", 0).colour[1] = nan; }), "");
    EXPECT_NE(defect_with([](Editable& s) { s.at<LocatorNode>("locator_nodes", 0).high[1] = nan; }), "");
}

TEST(Validate, FindsALocatorThatWouldLoop) {
    Editable scene;
    scene.at<LocatorNode>("locator_nodes", 1).skip = 1;
    EXPECT_EQ(scene.defect(), "F4");
}

TEST(Validate, FindsSharesOfSectionsAndRingsThatOverlap) {
    Editable cells;
    cells.at<Cell>("cells", 1).section_count += 1;
    EXPECT_EQ(cells.defect(), "F4");
    Editable rings;
    rings.at<SourceFace>("source_faces", 1).first_vertex = 0;
    EXPECT_EQ(rings.defect(), "F4");
    Editable names;
    names.at<std::uint32_t>("text_offsets", 1) = 1u << 30;
    EXPECT_EQ(names.defect(), "F4");
}

/// Reads bytes whose header hash is mended, so that the damage comes through to the arrays.
bool is_refused(std::vector<std::byte> bytes) {
    FileHeader header;
    if (bytes.size() >= sizeof header) {
        std::memcpy(&header, bytes.data(), sizeof header);
        const std::size_t table = header.section_count * sizeof(SectionEntry);
        if (header.section_count < 1000 && sizeof header + table <= bytes.size()) {
            header.header_sha256 = {};
            std::memcpy(bytes.data(), &header, sizeof header);
            header.header_sha256 = sha256(std::span(bytes).first(sizeof header + table));
            std::memcpy(bytes.data(), &header, sizeof header);
        }
    }
    const SerialExecutor serial;
    try {
        const Scene scene = read(bytes, {.executor = &serial});
        (void)stats(scene);
        (void)locate(scene.view(), {1, 1, 1});
        return false;
    } catch (const InputError& error) {
        EXPECT_FALSE(error.code.empty());
        return true;
    }
}

TEST(DamagedFile, CutAnywhereIsRefused) {
    const std::vector<std::byte> sound = sound_bytes();
    for (std::size_t size = 0; size < sound.size(); size += 1 + size / 16)
        EXPECT_TRUE(is_refused({sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(size)})) << size;
}

TEST(DamagedFile, HeaderOrTableWithAFlippedBitIsRefused) {
    const std::vector<std::byte> sound = sound_bytes();
    const std::size_t end = sizeof(FileHeader) + 18 * sizeof(SectionEntry);
    for (std::size_t i = 0; i < end; ++i) {
        std::vector<std::byte> bytes = sound;
        bytes[i] ^= std::byte{1} << (i % 8);
        EXPECT_THROW((void)read(bytes), InputError) << "byte " << i;
    }
}

TEST(DamagedFile, WithMendedHashNeverCrashes) {
    const std::vector<std::byte> sound = sound_bytes();
    std::mt19937_64 random(42);
    int refused = 0;
    for (int round = 0; round < 3000; ++round) {
        std::vector<std::byte> bytes = sound;
        const std::size_t first_array = sizeof(FileHeader) + 18 * sizeof(SectionEntry);
        for (std::uint64_t k = random() % 4 + 1; k > 0; --k) {
            const std::size_t limit = round % 2 == 0 ? first_array : bytes.size();
            const std::size_t at = random() % (limit - 4);
            const std::uint32_t values[] = {0,          1,          0x7fffffff,
                                            0xffffffff, 0x7fc00000, static_cast<std::uint32_t>(random())};
            std::memcpy(bytes.data() + at, &values[random() % 6], 4);
        }
        refused += is_refused(std::move(bytes));
    }
    EXPECT_GT(refused, 1500);
}

TEST(DamagedFile, OneThreadAndManyFindTheSameDefects) {
    Editable scene;
    scene.at<SideFace>("side_faces", 9).z_top = nan;
    scene.at<Cell>("cells", 5).floor = Target::solid(1u << 29);
    const auto one = validate(scene.view(), SerialExecutor());
    const auto many = validate(scene.view(), ThreadExecutor(4));
    ASSERT_EQ(one.size(), many.size());
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].sentence, many[i].sentence);
}

}  // namespace
}  // namespace enfilade::accel

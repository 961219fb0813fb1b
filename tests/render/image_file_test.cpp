#include "render/image_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "tests/support/temporary_folder.h"

namespace enfilade::render {
namespace {

Image ramp() {
    Image image(16, 9);
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        image.rgb[i] = static_cast<float>(i) / static_cast<float>(image.rgb.size());
    return image;
}

TEST(ImageFile, ComesBackFromPngToAStepOfItsEncoding) {
    const test::TemporaryFolder folder;
    write_image(ramp(), folder.path() / "a.png");
    const Image again = read_image(folder.path() / "a.png");
    EXPECT_EQ(to_srgb8(again), to_srgb8(ramp()));
}

TEST(ImageFile, ComesBackFromExrAsLinearHalves) {
    const test::TemporaryFolder folder;
    write_image(ramp(), folder.path() / "a.exr");
    const Image again = read_image(folder.path() / "a.exr");
    for (std::size_t i = 0; i < again.rgb.size(); ++i) EXPECT_NEAR(again.rgb[i], ramp().rgb[i], 0.0005);
}

TEST(ImageFile, LeavesOnlyTheFileItWasAskedFor) {
    const test::TemporaryFolder folder;
    write_image(ramp(), folder.path() / "a.png");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
    EXPECT_THROW(write_image(ramp(), folder.path() / "a.nothing"), InputError);
    EXPECT_THROW(write_image(ramp(), folder.path() / "absent" / "a.png"), IoError);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

}  // namespace
}  // namespace enfilade::render

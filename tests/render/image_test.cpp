#include "render/image.h"

#include <gtest/gtest.h>

#include <cmath>

namespace enfilade::render {
namespace {

TEST(Image, IsEncodedAsSrgb) {
    Image image(4, 1);
    image.rgb = {0, 1, 0.5f, 0.002f, -3, 7, std::nanf(""), 0.2158605f, 0.0031308f, 0, 0, 0};
    const std::vector<std::uint8_t> expected = {0, 255, 188, 7, 0, 255, 0, 128, 10, 0, 0, 0};
    EXPECT_EQ(to_srgb8(image), expected);
}

}  // namespace
}  // namespace enfilade::render

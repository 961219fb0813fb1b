#pragma once
// Pictures out of files, as textures.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "accel/scene_input.h"

namespace enfilade::modeler {

struct Picture {
    std::uint32_t width = 0, height = 0;
    std::vector<std::array<std::uint8_t, 4>> pixels;  ///< [width * height] sRGB and alpha, rows from the top
};

/// A PNG or JPEG; nothing for what is neither, is damaged, or has more than 2^26 pixels. block_of: of a JPEG that wide
/// and high the side (1, 2, 4 or 8 pixels) of blocks that are averaged as they are read, before they are made linear.
[[nodiscard]] std::optional<Picture> read_picture(
    std::string_view bytes, const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& block_of);

/// A PNG or JPEG with all its levels, scaled down to `most_a_side` texels a side. nullptr for what is neither, is
/// damaged, or has more than 2^26 pixels. JPEGs far larger than that are averaged in blocks of 2, 4 or 8 pixels a side
/// as they are read, before their light is made linear. (libpng and libjpeg, not OpenImageIO: linked to that, every
/// command would start a third of a second later.) \pre most_a_side > 0
[[nodiscard]] std::shared_ptr<const accel::InputTexture> read_texture(std::string name, std::string_view bytes,
                                                                      std::uint32_t most_a_side);

}  // namespace enfilade::modeler

#pragma once
// Pictures out of files, as textures.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "accel/scene_input.h"

namespace enfilade::modeler {

/// A PNG or JPEG with all its levels, scaled down to `most_a_side` texels a side. nullptr for what is neither, is
/// damaged, or has more than 2^26 pixels. JPEGs far larger than that are averaged in blocks of 2, 4 or 8 pixels a side
/// as they are read, before their light is made linear. (libpng and libjpeg, not OpenImageIO: linked to that, every
/// command would start a third of a second later.) \pre most_a_side > 0
[[nodiscard]] std::shared_ptr<const accel::InputTexture> read_texture(std::string name, std::string_view bytes,
                                                                      std::uint32_t most_a_side);

}  // namespace enfilade::modeler

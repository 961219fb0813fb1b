#pragma once
// Pictures to files.

#include <filesystem>

#include "render/image.h"

namespace enfilade::render {

/// Writes `image` by the ending of `path`: .exr as linear halves, .png as 8-bit sRGB. The file appears under its name
/// when it is complete. \throws InputError (R4) for another ending, IoError if it cannot be written.
void write_image(const Image& image, const std::filesystem::path& path);

/// Reads what `write_image` wrote (8-bit files back to linear). \throws IoError
[[nodiscard]] Image read_image(const std::filesystem::path& path);

}  // namespace enfilade::render

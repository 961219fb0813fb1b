#include "modeler/catalogue/picture.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <utility>
#include <vector>

#include "accel/texture_chain.h"

// Behind cstdio, which it needs and does not include.
#include <jpeglib.h>

namespace enfilade::modeler {
namespace {

constexpr std::uint64_t max_pixels = std::uint64_t{1} << 26;

using BlockOf = std::function<std::uint32_t(std::uint32_t, std::uint32_t)>;

bool read_png(std::string_view bytes, Picture& picture) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    struct Free {
        void operator()(png_image* held) const { png_image_free(held); }
    };
    const std::unique_ptr<png_image, Free> holder(&image);
    if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) return false;
    if (std::uint64_t{image.width} * image.height > max_pixels) return false;
    image.format = PNG_FORMAT_RGBA;
    picture.width = image.width;
    picture.height = image.height;
    picture.pixels.resize(std::size_t{image.width} * image.height);
    return png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr) != 0;
}

struct JpegError {
    jpeg_error_mgr manager;  // first: libjpeg hands it back
    std::jmp_buf jump;
};

[[noreturn]] void leave_jpeg(j_common_ptr info) { std::longjmp(reinterpret_cast<JpegError*>(info->err)->jump, 1); }
void say_nothing(j_common_ptr) {}
void count_warning(j_common_ptr info, int level) {
    if (level < 0) ++info->err->num_warnings;
}

/// Header and scale. Nothing in it has a destructor: errors leave it by longjmp.
bool begin_jpeg(jpeg_decompress_struct& info, JpegError& error, std::string_view bytes, const BlockOf& block_of) {
    if (setjmp(error.jump) != 0) return false;
    jpeg_create_decompress(&info);
    jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    jpeg_read_header(&info, TRUE);
    if (std::uint64_t{info.image_width} * info.image_height > max_pixels) return false;
    if (info.jpeg_color_space == JCS_CMYK || info.jpeg_color_space == JCS_YCCK) return false;
    info.scale_num = 1;
    info.scale_denom = block_of(info.image_width, info.image_height);
    info.out_color_space = JCS_RGB;
    info.dct_method = JDCT_ISLOW;
    jpeg_start_decompress(&info);
    return true;
}

/// One row after the other. row: of 3 * output_width bytes
bool read_rows(jpeg_decompress_struct& info, JpegError& error, std::uint8_t* row,
               std::array<std::uint8_t, 4>* const pixels) {
    if (setjmp(error.jump) != 0) return false;
    while (info.output_scanline < info.output_height) {
        std::array<std::uint8_t, 4>* const to = pixels + std::size_t{info.output_scanline} * info.output_width;
        JSAMPROW rows[1] = {row};
        jpeg_read_scanlines(&info, rows, 1);
        for (std::size_t k = 0; k < info.output_width; ++k) to[k] = {row[3 * k], row[3 * k + 1], row[3 * k + 2], 255};
    }
    return true;
}

bool read_jpeg(std::string_view bytes, const BlockOf& block_of, Picture& picture) {
    jpeg_decompress_struct info{};
    JpegError error{};
    info.err = jpeg_std_error(&error.manager);
    error.manager.error_exit = leave_jpeg;
    error.manager.output_message = say_nothing;
    error.manager.emit_message = count_warning;
    std::vector<std::uint8_t> row;
    bool is_read = begin_jpeg(info, error, bytes, block_of);
    if (is_read) {
        picture.width = info.output_width;
        picture.height = info.output_height;
        picture.pixels.resize(std::size_t{picture.width} * picture.height);
        row.resize(std::size_t{3} * picture.width);
        is_read = read_rows(info, error, row.data(), picture.pixels.data());
    }
    jpeg_destroy_decompress(&info);
    return is_read;
}

}  // namespace

std::optional<Picture> read_picture(std::string_view bytes, const BlockOf& block_of) {
    Picture picture;
    bool is_read = false;
    if (bytes.starts_with("\x89PNG")) is_read = read_png(bytes, picture);
    else if (bytes.starts_with("\xFF\xD8")) is_read = read_jpeg(bytes, block_of, picture);
    if (!is_read || picture.pixels.empty()) return std::nullopt;
    return picture;
}

std::shared_ptr<const accel::InputTexture> read_texture(std::string name, std::string_view bytes,
                                                        std::uint32_t most_a_side) {
    // Twice as many as will be left: the rest is averaged as light.
    const std::optional<Picture> picture = read_picture(bytes, [&](std::uint32_t width, std::uint32_t height) {
        std::uint32_t block = 1;
        while (block < 8 && std::max(width, height) / (2 * block) >= 2 * most_a_side) block *= 2;
        return block;
    });
    if (!picture) return nullptr;
    return std::make_shared<const accel::InputTexture>(
        accel::texture_chain(std::move(name), picture->width, picture->height, picture->pixels, most_a_side));
}

}  // namespace enfilade::modeler

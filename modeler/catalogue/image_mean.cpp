#include "modeler/catalogue/image_mean.h"

#include <png.h>

#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

// Behind cstdio, which it needs and does not include.
#include <jpeglib.h>

namespace enfilade::modeler {
namespace {

constexpr std::uint64_t max_pixels = std::uint64_t{1} << 26;

double linear_of(double value) { return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4); }

/// Sums up pixels; integers, so that the order of rows does not matter.
class Mean {
public:
    Mean() {
        for (std::size_t k = 0; k < 256; ++k)
            linear_[k] = static_cast<std::uint32_t>(std::lround(linear_of(double(k) / 255) * 65535));
    }
    void add(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t alpha) {
        sum_[0] += std::uint64_t{linear_[r]} * alpha;
        sum_[1] += std::uint64_t{linear_[g]} * alpha;
        sum_[2] += std::uint64_t{linear_[b]} * alpha;
        weight_ += alpha;
    }
    [[nodiscard]] std::optional<std::array<float, 3>> colour() const {
        if (weight_ == 0) return std::nullopt;
        std::array<float, 3> mean;
        for (std::size_t k = 0; k < 3; ++k) mean[k] = static_cast<float>(double(sum_[k]) / double(weight_) / 65535);
        return mean;
    }

private:
    std::array<std::uint32_t, 256> linear_{};
    std::array<std::uint64_t, 3> sum_{};
    std::uint64_t weight_ = 0;
};

std::optional<std::array<float, 3>> png_mean(std::string_view bytes) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    struct Free {
        void operator()(png_image* held) const { png_image_free(held); }
    };
    const std::unique_ptr<png_image, Free> holder(&image);
    if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) return std::nullopt;
    if (std::uint64_t{image.width} * image.height > max_pixels) return std::nullopt;
    image.format = PNG_FORMAT_RGBA;
    std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) == 0) return std::nullopt;
    Mean mean;
    for (std::size_t k = 0; k + 3 < pixels.size(); k += 4)
        mean.add(pixels[k], pixels[k + 1], pixels[k + 2], pixels[k + 3]);
    return mean.colour();
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

/// Nothing in it has a destructor: errors leave it by longjmp.
bool add_jpeg(jpeg_decompress_struct& info, JpegError& error, std::string_view bytes, std::uint8_t* row,
              std::size_t row_bytes, Mean& mean) {
    if (setjmp(error.jump) != 0) return false;
    jpeg_create_decompress(&info);
    jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    jpeg_read_header(&info, TRUE);
    if (std::uint64_t{info.image_width} * info.image_height > max_pixels) return false;
    const bool is_large = info.image_width > 64 && info.image_height > 64;
    info.scale_num = 1;
    info.scale_denom = is_large ? 8 : 1;
    if (info.jpeg_color_space == JCS_CMYK || info.jpeg_color_space == JCS_YCCK) return false;
    info.out_color_space = JCS_RGB;
    info.dct_method = JDCT_ISLOW;
    jpeg_start_decompress(&info);
    if (std::size_t{info.output_width} * 3 > row_bytes) return false;
    while (info.output_scanline < info.output_height) {
        JSAMPROW rows[1] = {row};
        jpeg_read_scanlines(&info, rows, 1);
        for (std::size_t k = 0; k < info.output_width; ++k) mean.add(row[3 * k], row[3 * k + 1], row[3 * k + 2], 255);
    }
    return true;
}

std::optional<std::array<float, 3>> jpeg_mean(std::string_view bytes) {
    jpeg_decompress_struct info{};
    JpegError error{};
    info.err = jpeg_std_error(&error.manager);
    error.manager.error_exit = leave_jpeg;
    error.manager.output_message = say_nothing;
    error.manager.emit_message = count_warning;
    std::vector<std::uint8_t> row(3 * std::size_t{65536});  // JPEG's widest
    Mean mean;
    const bool is_read = add_jpeg(info, error, bytes, row.data(), row.size(), mean);
    jpeg_destroy_decompress(&info);
    return is_read ? mean.colour() : std::nullopt;
}

}  // namespace

std::array<float, 3> linear_colour(const std::array<double, 3>& srgb) {
    std::array<float, 3> linear;
    for (std::size_t k = 0; k < 3; ++k) linear[k] = static_cast<float>(linear_of(srgb[k]));
    return linear;
}

std::optional<std::array<float, 3>> mean_colour(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG")) return png_mean(bytes);
    if (bytes.starts_with("\xFF\xD8")) return jpeg_mean(bytes);
    return std::nullopt;
}

}  // namespace enfilade::modeler

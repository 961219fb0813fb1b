#include "render/image_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <half.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <memory>
#include <string>
#include <system_error>

#include "base/error.h"

namespace enfilade::render {
namespace {

constexpr std::array<const char*, 3> channels = {"R", "G", "B"};

/// "name.part123.png": the ending stays, for whoever looks into the folder meanwhile.
std::filesystem::path temporary_name(const std::filesystem::path& path) {
    return path.parent_path() /
           (path.stem().string() + ".part" + std::to_string(::getpid()) + path.extension().string());
}

void write_png(const Image& image, const std::filesystem::path& path) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = png_uint_32(image.width);
    png.height = png_uint_32(image.height);
    png.format = PNG_FORMAT_RGB;
    if (png_image_write_to_file(&png, path.c_str(), 0, to_srgb8(image).data(), 0, nullptr) == 0)
        throw IoError("cannot write " + path.string() + ": " + png.message);
}

Image read_png(const std::filesystem::path& path) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    std::vector<std::uint8_t> bytes;
    if (png_image_begin_read_from_file(&png, path.c_str()) != 0) {
        png.format = PNG_FORMAT_RGB;
        bytes.resize(PNG_IMAGE_SIZE(png));
        png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr);
    }
    if (PNG_IMAGE_FAILED(png)) {
        png_image_free(&png);
        throw IoError("cannot read " + path.string() + ": " + png.message);
    }
    Image image(int(png.width), int(png.height));
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        const float v = float(bytes[i]) / 255;
        image.rgb[i] = v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
    }
    return image;
}

void write_exr(const Image& image, const std::filesystem::path& path) {
    // What is brighter than the largest number of 16 bits is written as that: files hold no infinities.
    static constexpr float largest = 65504;
    std::vector<Imath::half> halves(image.rgb.size());
    std::ranges::transform(image.rgb, halves.begin(), [](float v) { return Imath::half(std::min(v, largest)); });
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < 3; ++c) {
        header.channels().insert(channels[c], Imf::Channel(Imf::HALF));
        char* base = reinterpret_cast<char*>(const_cast<Imath::half*>(halves.data() + c));
        frame.insert(channels[c], Imf::Slice(Imf::HALF, base, 3 * sizeof(Imath::half),
                                             3 * sizeof(Imath::half) * std::size_t(image.width)));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(image.height);
}

Image read_exr(const std::filesystem::path& path) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    Image image(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
    const std::ptrdiff_t row = 3 * std::ptrdiff_t(image.width);
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < 3; ++c) {
        // OpenEXR wants the address that pixel (0, 0) would have, wherever the window begins.
        float* base = image.rgb.data() + c - 3 * window.min.x - row * window.min.y;
        frame.insert(channels[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(base), 3 * sizeof(float),
                                             std::size_t(row) * sizeof(float)));
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    return image;
}

void write_to(const Image& image, const std::filesystem::path& path) {
    if (path.extension() == ".png") return write_png(image, path);
    try {
        write_exr(image, path);
    } catch (const std::exception& error) {
        throw IoError("cannot write " + path.string() + ": " + error.what());
    }
}

}  // namespace

void write_image(const Image& image, const std::filesystem::path& path) {
    if (path.extension() != ".png" && path.extension() != ".exr")
        throw InputError("R4", path.string(), "no image format has this ending; use .png or .exr");
    const std::filesystem::path temporary = temporary_name(path);
    std::error_code ignored;
    try {
        write_to(image, temporary);
        std::filesystem::rename(temporary, path);
    } catch (const std::filesystem::filesystem_error& error) {
        std::filesystem::remove(temporary, ignored);
        throw IoError("cannot create " + path.string() + ": " + error.code().message());
    } catch (...) {
        std::filesystem::remove(temporary, ignored);
        throw;
    }
}

Image read_image(const std::filesystem::path& path) {
    if (path.extension() == ".png") return read_png(path);
    try {
        return read_exr(path);
    } catch (const std::exception& error) {
        throw IoError("cannot read " + path.string() + ": " + error.what());
    }
}

}  // namespace enfilade::render

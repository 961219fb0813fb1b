#include "render/image_file.h"

#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <cmath>
#include <memory>
#include <string>
#include <system_error>

#include "base/error.h"

namespace enfilade::render {
namespace {

/// "name.part123.png": the ending stays, because the writer is chosen by it.
std::filesystem::path temporary_name(const std::filesystem::path& path) {
    return path.parent_path() /
           (path.stem().string() + ".part" + std::to_string(::getpid()) + path.extension().string());
}

void write_to(const Image& image, const std::filesystem::path& path, OIIO::ImageOutput& output, bool is_float) {
    OIIO::ImageSpec spec(image.width, image.height, 3, is_float ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", is_float ? "Linear" : "sRGB");
    spec.attribute("compression", "zip");
    if (!output.open(path.string(), spec)) throw IoError("cannot create " + path.string() + ": " + output.geterror());
    const bool written = is_float ? output.write_image(OIIO::TypeDesc::FLOAT, image.rgb.data())
                                  : output.write_image(OIIO::TypeDesc::UINT8, to_srgb8(image).data());
    if (!written || !output.close()) throw IoError("cannot write " + path.string() + ": " + output.geterror());
}

}  // namespace

void write_image(const Image& image, const std::filesystem::path& path) {
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(path.string());
    if (!output) {
        (void)OIIO::geterror();
        throw InputError("R4", path.string(), "no image format has this ending; use .png or .exr");
    }
    const bool is_float = path.extension() == ".exr";
    const std::filesystem::path temporary = temporary_name(path);
    std::error_code ignored;
    try {
        write_to(image, temporary, *output, is_float);
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
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string());
    if (!input) throw IoError("cannot read " + path.string() + ": " + OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.nchannels < 3) throw IoError("cannot read " + path.string() + ": it has no three colours");
    Image image(spec.width, spec.height);
    if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, image.rgb.data()))
        throw IoError("cannot read " + path.string() + ": " + input->geterror());
    if (spec.format == OIIO::TypeDesc::UINT8)
        for (float& v : image.rgb) v = v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
    return image;
}

}  // namespace enfilade::render

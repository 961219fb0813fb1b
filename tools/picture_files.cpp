#include "tools/picture_files.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "render/image_file.h"

namespace enfilade::tools {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_slug = 60;

bool is_folder(const fs::path& output) {
    std::error_code ignored;
    return output.filename().empty() || fs::is_directory(output, ignored);
}

std::string padded(std::size_t number, std::size_t digits, char filler) {
    const std::string text = std::to_string(number);
    return std::string(digits > text.size() ? digits - text.size() : 0, filler) + text;
}

/// "Entrance hall, 2" as "entrance-hall-2": what every file system and every shell takes. Letters beyond ASCII are
/// kept as they are.
std::string slug(std::string_view name) {
    std::string text;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || byte >= 0x80) {
            text += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
        } else if (!text.empty() && text.back() != '-') {
            text += '-';
        }
    }
    if (text.size() > longest_slug) {
        std::size_t end = longest_slug;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;  // no half letter
        text.resize(end);
    }
    while (!text.empty() && text.back() == '-') text.pop_back();
    return text;
}

/// "%02d" in a name: where, and how numbers are written there.
struct NumberField {
    std::size_t begin, end;
    std::size_t digits;
    char filler;
};

std::optional<NumberField> number_field(const std::string& name) {
    for (std::size_t at = name.find('%'); at != std::string::npos; at = name.find('%', at + 1)) {
        std::size_t end = at + 1;
        NumberField field{at, 0, 1, ' '};
        if (end < name.size() && name[end] == '0') {
            field.filler = '0';
            ++end;
        }
        if (end < name.size() && name[end] >= '1' && name[end] <= '9') field.digits = std::size_t(name[end++] - '0');
        if (end < name.size() && name[end] == 'd') {
            field.end = end + 1;
            return field;
        }
    }
    return std::nullopt;
}

/// Makes the folder that the output names, where it is missing; returns it if so.
fs::path make_folder(const fs::path& output) {
    if (!output.filename().empty()) return {};
    const fs::path folder = output.parent_path();
    std::error_code error;
    if (folder.empty() || fs::exists(folder, error)) return {};
    if (!fs::create_directory(folder, error))
        throw IoError("The folder " + folder.string() + " cannot be made: is its own folder there, and writable?");
    return folder;
}

}  // namespace

void check_picture_name(const fs::path& output) {
    const std::string extension = output.extension().string();
    if (!is_folder(output) && extension != ".png" && extension != ".exr")
        throw InputError("F113", output.string(), "Pictures are written as .png or .exr: end the name so.");
}

std::vector<fs::path> picture_paths(const fs::path& output, std::span<const std::string> view_names) {
    check_picture_name(output);
    const std::string name = output.filename().string();
    const bool in_folder = is_folder(output);
    const std::optional<NumberField> field = in_folder ? std::nullopt : number_field(name);
    if (!in_folder && !field) {
        if (view_names.size() == 1) return {output};
        throw InputError("F136", output.string(),
                         std::to_string(view_names.size()) +
                             " views need as many names: give a folder, like \"tour/\", or a name with a number in it, "
                             "like \"tour-%02d.png\".");
    }
    const std::size_t digits = std::max<std::size_t>(2, std::to_string(view_names.size()).size());
    std::vector<fs::path> paths;
    for (std::size_t k = 0; k < view_names.size(); ++k) {
        if (in_folder) {
            const std::string text = slug(view_names[k]);
            paths.push_back(output / (padded(k + 1, digits, '0') + (text.empty() ? "" : '-' + text) + ".png"));
        } else {
            paths.push_back(
                output.parent_path() /
                (name.substr(0, field->begin) + padded(k + 1, field->digits, field->filler) + name.substr(field->end)));
        }
    }
    return paths;
}

PictureFiles::PictureFiles(const fs::path& output, std::span<const std::string> view_names)
    : paths_(picture_paths(output, view_names)) {
    made_folder_ = make_folder(output);
    try {
        for (const fs::path& path : paths_) files_.push_back(std::make_unique<OutputFile>(path));
    } catch (...) {
        std::error_code ignored;
        files_.clear();
        if (!made_folder_.empty()) fs::remove(made_folder_, ignored);
        throw;
    }
}

PictureFiles::~PictureFiles() {
    files_.clear();
    std::error_code ignored;
    if (!made_folder_.empty()) fs::remove(made_folder_, ignored);  // fails, as it should, where pictures are in it
}

void PictureFiles::write(std::size_t picture, const render::Image& image) {
    render::write_image(image, files_[picture]->temporary());
}

void PictureFiles::commit() {
    for (const std::unique_ptr<OutputFile>& file : files_) file->commit();
}

}  // namespace enfilade::tools

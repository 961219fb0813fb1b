#include "plans/read.h"

#include <fstream>

#include "base/error.h"
#include "plans/floorspace/detect.h"

namespace enfilade::plans {
namespace {

constexpr std::uintmax_t max_file_bytes = std::uintmax_t{4} << 30;

std::string read_bytes(const std::filesystem::path& file) {
    std::error_code error;
    if (std::filesystem::is_directory(file, error))
        throw IoError("The plan " + file.string() + " is a folder; name a file in it.");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw IoError("The plan " + file.string() + " cannot be opened; check its name and its permissions.");
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (!error && size > max_file_bytes)
        throw InputError("P108", file.string(), "The file is larger than 4 GiB, which no plan needs.");
    std::string bytes;
    if (!error) bytes.reserve(size);
    char block[1 << 16];
    while (stream.read(block, sizeof block) || stream.gcount() > 0) {
        bytes.append(block, static_cast<std::size_t>(stream.gcount()));
        if (bytes.size() > max_file_bytes)
            throw InputError("P108", file.string(), "The file is larger than 4 GiB, which no plan needs.");
    }
    if (stream.bad()) throw IoError("Reading the plan " + file.string() + " failed half way.");
    return bytes;
}

bool is_zip(std::string_view bytes) { return bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06"); }

/// JSON begins with a bracket or a comment, after a byte order mark and space.
bool looks_like_json(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return false;
    const std::string_view rest = bytes.substr(first);
    return rest.starts_with("{") || rest.starts_with("//") || rest.starts_with("/*");
}

/// Text and binary DXF, and DWG, which the reader of drawings refuses with its reason.
bool looks_like_drawing(std::string_view bytes) {
    if (bytes.starts_with("AutoCAD Binary DXF") || bytes.starts_with("AC10")) return true;
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    const std::size_t code = bytes.find_first_not_of(" \t\r\n");
    if (code == std::string_view::npos) return false;
    const std::string_view line = bytes.substr(code, bytes.find_first_of("\r\n", code) - code);
    return line == "999" || (line == "0" && bytes.substr(0, 256).find("SECTION") != std::string_view::npos);
}

/// What the file seems to be, for the refusal.
std::string guess(std::string_view bytes) {
    if (bytes.empty()) return "The file is empty";
    if (bytes.starts_with("<") || bytes.starts_with("\xEF\xBB\xBF<")) return "This is an XML file, not a plan";
    if (bytes.starts_with("ISO-10303-21")) return "IFC files are not read yet";
    return "This is no plan in a known format";
}

}  // namespace

Plan read(const std::filesystem::path& file, const ReadOptions& options) {
    const std::string bytes = read_bytes(file);
    if (is_zip(bytes)) return read_sweet_home(std::as_bytes(std::span(bytes)), file.string());
    if (looks_like_json(bytes))
        return is_floorspace(bytes) ? read_floorspace(bytes, file.string(), options) : read_json(bytes, file.string());
    if (looks_like_drawing(bytes)) return read_dxf(bytes, file.string(), options);
    throw InputError("P109", file.string(),
                     guess(bytes) +
                         "; the formats known are Enfilade's own JSON, FloorspaceJS JSON, DXF drawings and Sweet Home "
                         "3D homes (.sh3d).");
}

}  // namespace enfilade::plans

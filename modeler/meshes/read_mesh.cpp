#include <algorithm>
#include <cctype>
#include <fstream>

#include "base/error.h"
#include "modeler/meshes/mesh.h"
#include "modeler/meshes/mesh_readers.h"
#include "modeler/meshes/mesh_text.h"

namespace enfilade::modeler {
namespace {

constexpr std::uintmax_t max_file_bytes = std::uintmax_t{4} << 30;

std::string read_bytes(const std::filesystem::path& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        throw InputError("P801", path.string(), "This is a folder: name the mesh file in it.");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw InputError("P801", path.string(), "The file cannot be opened.");
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error && size > max_file_bytes)
        throw InputError("P800", path.string(), "A mesh file larger than 4 GiB is not read.");
    std::string bytes;
    if (!error) bytes.reserve(size);
    char block[1 << 16];
    while (stream.read(block, sizeof block) || stream.gcount() > 0) {
        bytes.append(block, static_cast<std::size_t>(stream.gcount()));
        if (bytes.size() > max_file_bytes)
            throw InputError("P800", path.string(), "A mesh file larger than 4 GiB is not read.");
    }
    return bytes;
}

std::string extension_of(const std::string& name) {
    const std::size_t slash = name.find_last_of("/\\");
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return {};
    std::string extension = name.substr(dot + 1);
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// The first word that is no `#` comment.
std::string_view first_word(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    static const std::string no_name;
    MeshText text(bytes, no_name);
    text.set_comments(true);
    return text.next() ? text.word() : std::string_view();
}

bool is_off_word(std::string_view word) {
    return word.ends_with("OFF") && word.find_first_not_of("STCN4nOF") == std::string_view::npos;
}

bool is_obj_word(std::string_view word) {
    static constexpr std::string_view words[] = {"v", "vn", "vt", "f", "o", "g", "mtllib", "usemtl", "s"};
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

Mesh read_any(std::string_view bytes, const std::string& name, bool tolerant) {
    const std::string extension = extension_of(name);
    const std::string_view word = first_word(bytes);
    if (bytes.starts_with("\x1F\x8B"))
        throw InputError("P801", name, "The file is compressed: unpack it first (gunzip).");
    if (bytes.starts_with("PK\x03\x04")) throw InputError("P801", name, "The file is an archive: unpack it first.");
    if (word == "ply") return read_ply(bytes, name, tolerant);
    if (word.starts_with('{')) return read_city_json(bytes, name);
    if (is_off_word(word)) return read_off(bytes, name, tolerant);
    if (is_binary_stl(bytes) || word == "solid") return read_stl(bytes, name, tolerant);
    if (extension == "obj") return read_obj(bytes, name, tolerant);
    if (extension == "off") return read_off(bytes, name, tolerant);
    if (extension == "stl") return read_stl(bytes, name, tolerant);
    if (is_obj_word(word)) return read_obj(bytes, name, tolerant);
    // Tolerant readers are asked by catalogues, which read glTF themselves, and no buildings.
    throw InputError("P801", name,
                     std::string("This is no mesh that is read here: ") +
                         (tolerant ? "OBJ, glTF, GLB, PLY, OFF and STL are." : "OBJ, OFF, PLY, STL and CityJSON are."));
}

}  // namespace

std::span<const MeshHole> Mesh::holes_of(std::size_t f) const {
    struct ByFace {
        bool operator()(const MeshHole& hole, std::size_t face) const { return hole.face < face; }
        bool operator()(std::size_t face, const MeshHole& hole) const { return face < hole.face; }
    };
    const auto range = std::equal_range(holes.begin(), holes.end(), f, ByFace());
    return std::span(holes).subspan(static_cast<std::size_t>(range.first - holes.begin()),
                                    static_cast<std::size_t>(range.second - range.first));
}

Mesh read_mesh(std::string_view bytes, const std::string& name, const MeshOptions& options) {
    Mesh mesh = read_any(bytes, name, options.tolerant);
    if (mesh.points.size() >= UINT32_MAX) throw InputError("P800", name, "A mesh has fewer than 2^32 vertices.");
    if (mesh.face_count() == 0 && mesh.solids.empty() && mesh.findings.empty())
        throw InputError("P807", name, "The file has no face.");
    if (options.weld >= 0 && !options.tolerant) weld(mesh, options.weld);
    return mesh;
}

Mesh read_mesh(const std::filesystem::path& path, const MeshOptions& options) {
    return read_mesh(read_bytes(path), path.string(), options);
}

}  // namespace enfilade::modeler

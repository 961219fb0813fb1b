#include "modeler/catalogue/read_model.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "modeler/catalogue/face_triangles.h"
#include "modeler/meshes/mesh.h"

namespace enfilade::modeler {
namespace {

constexpr std::array<std::string_view, 6> extensions = {"obj", "gltf", "glb", "ply", "off", "stl"};
constexpr std::array<std::string_view, 9> known_others = {"3ds", "dae", "lws",   "lwo", "fbx",
                                                          "kmz", "max", "blend", "skp"};

[[noreturn]] void refuse(const FileTree& files, const std::string& name, const std::string& sentence) {
    throw InputError("K107", files.title(), "The model " + name + " cannot be used: " + sentence);
}

/// Of other programs' formats, the one that the bytes are, or that the name says; empty: none that is known.
std::string other_format(std::string_view extension, std::string_view bytes) {
    if (bytes.starts_with("MM") && bytes.size() > 16 && extension != "obj") return "3DS";
    if (bytes.substr(0, 1000).find("<COLLADA") != std::string_view::npos) return "Collada";
    if (bytes.starts_with("LWSC") || bytes.starts_with("FORM")) return "LightWave";
    if (std::find(known_others.begin(), known_others.end(), extension) != known_others.end())
        return "." + std::string(extension);
    return {};
}

RawMesh read_polygons(const std::string& name, std::string_view bytes) {
    const Mesh mesh = read_mesh(bytes, name, MeshOptions{.tolerant = true});
    if (mesh.format == MeshFormat::CityJson) throw InputError("K107", name, "CityJSON holds buildings, not furniture.");
    RawMesh raw = triangulated(mesh);
    raw.up = UpAxis::Z;
    return raw;
}

bool is_gltf(std::string_view extension, std::string_view bytes) {
    return bytes.starts_with("glTF") || extension == "gltf" || extension == "glb";
}

bool is_off_ply_or_stl(std::string_view extension) {
    return extension == "off" || extension == "ply" || extension == "stl";
}

/// The first model in an archive: OBJ before the others, as Sweet Home 3D writes them.
std::string model_within(const FileTree& archive) {
    for (const std::string_view extension : extensions)
        for (const std::string& name : archive.names())
            if (extension_of_name(name) == extension) return name;
    for (const std::string& name : archive.names())
        if (extension_of_name(name) == "zip") return name;
    return {};
}

RawMesh read_bytes(const FileTree& files, const std::string& name, std::string bytes, ReadImages images,
                   std::uint32_t texture_side, int depth) {
    const std::string extension = extension_of_name(name);
    if (bytes.starts_with("PK\x03\x04")) {
        if (depth == 0) refuse(files, name, "it is an archive within archives within archives.");
        const auto archive = open_archive(std::move(bytes), files.title() + ", " + name);
        const std::string inner = model_within(*archive);
        if (inner.empty()) refuse(files, name, "the archive holds no OBJ, glTF, GLB, PLY, OFF or STL file.");
        return read_bytes(*archive, inner, archive->read(inner).value(), images, texture_side, depth - 1);
    }
    if (is_gltf(extension, bytes)) return read_gltf_model(files, name, bytes, images, texture_side);
    if (const std::string other = other_format(extension, bytes); !other.empty())
        refuse(files, name, other + " files are not read; save it as OBJ or glTF.");
    if (is_off_ply_or_stl(extension) || bytes.starts_with("ply")) return read_polygons(name, bytes);
    return read_obj_model(files, name, bytes, images, texture_side);
}

std::string why_empty(const RawMesh& mesh) {
    if (mesh.dropped > 0)
        return "each of its triangles has a corner that does not exist, is no number or lies beyond 1e12: "
               "export it again, in a larger unit if its numbers are that large.";
    if (mesh.lines > 0) return "its faces have fewer than three corners.";
    return "it has no face.";
}

}  // namespace

bool has_model_extension(std::string_view name) {
    const std::string extension = extension_of_name(name);
    return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

RawMesh read_model(const FileTree& files, const std::string& name, ReadImages images, std::uint32_t texture_side) {
    auto bytes = files.read(name);
    if (!bytes) refuse(files, name, files.why_absent(name));
    RawMesh mesh;
    try {
        mesh = read_bytes(files, name, std::move(*bytes), images, texture_side, 2);
    } catch (const InputError& error) {
        if (error.code.starts_with('K')) throw;
        throw InputError("K107", files.title(), error.line, error.column,
                         "The model " + name + " cannot be used: " + error.what());
    }
    if (mesh.triangles.empty())
        throw InputError(mesh.dropped > 0 ? "K107" : "K109", files.title(),
                         "The model " + name + " cannot be used: " + why_empty(mesh));
    return mesh;
}

}  // namespace enfilade::modeler

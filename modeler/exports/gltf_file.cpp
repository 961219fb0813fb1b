#include "modeler/exports/gltf_file.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/error.h"

namespace enfilade::modeler {

namespace {

// Numbers of the glTF 2.0 specification.
constexpr int array_buffer = 34962;
constexpr int element_array_buffer = 34963;
constexpr int type_float = 5126;
constexpr int type_unsigned_int = 5125;
constexpr std::uint32_t magic = 0x46546C67;
constexpr std::uint32_t chunk_json = 0x4E4F534A;
constexpr std::uint32_t chunk_binary = 0x004E4942;

}  // namespace

GltfFile::GltfFile() {
    json_["asset"] = {{"version", "2.0"}, {"generator", "Enfilade"}};
    json_["scene"] = 0;
    for (const char* list : {"scenes", "nodes", "meshes", "materials", "accessors", "bufferViews", "buffers"})
        json_[list] = Json::array();
}

std::size_t GltfFile::add(const char* list, Json element) {
    json_[list].push_back(std::move(element));
    return json_[list].size() - 1;
}

void GltfFile::use_extension(std::string_view name) {
    Json& used = json_["extensionsUsed"];
    if (std::find(used.begin(), used.end(), name) == used.end()) used.push_back(name);
}

std::size_t GltfFile::add_positions(std::span<const Point3> points) {
    Point3 low = points[0];
    Point3 high = points[0];
    for (const Point3& p : points)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    const std::size_t at = add_normals(points);
    json_["accessors"][at]["min"] = low;
    json_["accessors"][at]["max"] = high;
    return at;
}

std::size_t GltfFile::add_normals(std::span<const Point3> normals) {
    return accessor(std::as_bytes(normals), array_buffer, type_float, "VEC3", normals.size());
}

std::size_t GltfFile::add_indices(std::span<const std::uint32_t> indices) {
    return accessor(std::as_bytes(indices), element_array_buffer, type_unsigned_int, "SCALAR", indices.size());
}

/// Puts `bytes` (whole 4-byte numbers) into the buffer; returns the index of the accessor.
std::size_t GltfFile::accessor(std::span<const std::byte> bytes, int target, int component, const char* type,
                               std::size_t count) {
    const std::size_t view =
        add("bufferViews",
            {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}, {"target", target}});
    binary_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return add("accessors", {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
}

std::string GltfFile::bytes() {
    json_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    // glTF allows no empty lists.
    for (const char* list : {"meshes", "materials", "accessors", "bufferViews"})
        if (json_[list].empty()) json_.erase(list);
    if (binary_.empty()) json_.erase("buffers");
    std::string json = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::size_t size = 12 + 8 + json.size() + (binary_.empty() ? 0 : 8 + binary_.size());
    if (size > UINT32_MAX)
        throw InputError("F110", "",
                         "The scene is too large for glTF, whose files end at 4 GiB: build fewer storeys (--storeys).");
    std::string out;
    const auto put = [&out](std::uint32_t number) {
        char four[4];
        std::memcpy(four, &number, 4);
        out.append(four, 4);
    };
    put(magic);
    put(2);
    put(std::uint32_t(size));
    put(std::uint32_t(json.size()));
    put(chunk_json);
    out += json;
    if (binary_.empty()) return out;
    put(std::uint32_t(binary_.size()));
    put(chunk_binary);
    return out += binary_;
}

}  // namespace enfilade::modeler

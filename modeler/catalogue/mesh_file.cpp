#include <cmath>
#include <cstring>

#include "accel/texture_chain.h"
#include "modeler/catalogue/cache.h"

namespace enfilade::modeler {
namespace {

constexpr std::string_view magic = "ENFMESH2";

/// Tells damage, not malice.
std::uint64_t checksum(std::string_view bytes) {
    std::uint64_t sum = 0x9E3779B97F4A7C15u ^ bytes.size();
    const auto mix = [&](std::uint64_t word) {
        sum = (sum ^ word) * 0xFF51AFD7ED558CCDu;
        sum ^= sum >> 32;
    };
    while (bytes.size() >= 8) {
        std::uint64_t word;
        std::memcpy(&word, bytes.data(), 8);
        mix(word);
        bytes.remove_prefix(8);
    }
    for (const char c : bytes) mix(static_cast<unsigned char>(c));
    return sum;
}

class Writer {
public:
    template <class Value>
    void value(const Value& v) {
        static_assert(std::is_trivially_copyable_v<Value>);
        bytes.append(reinterpret_cast<const char*>(&v), sizeof v);
    }
    void text(std::string_view s) {
        value(static_cast<std::uint64_t>(s.size()));
        bytes.append(s);
    }
    template <class Value>
    void list(const std::vector<Value>& values) {
        static_assert(std::is_trivially_copyable_v<Value>);
        value(static_cast<std::uint64_t>(values.size()));
        if (!values.empty()) bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
    }
    std::string bytes;
};

class Reader {
public:
    explicit Reader(std::string_view bytes) : rest_(bytes) {}
    template <class Value>
    bool value(Value& v) {
        if (rest_.size() < sizeof v) return false;
        std::memcpy(&v, rest_.data(), sizeof v);
        rest_.remove_prefix(sizeof v);
        return true;
    }
    bool text(std::string& s) {
        std::uint64_t size = 0;
        if (!value(size) || size > rest_.size()) return false;
        s = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return true;
    }
    template <class Value>
    bool list(std::vector<Value>& values) {
        std::uint64_t count = 0;
        if (!value(count) || count > rest_.size() / sizeof(Value)) return false;
        values.resize(count);
        if (count > 0) std::memcpy(values.data(), rest_.data(), count * sizeof(Value));
        rest_.remove_prefix(count * sizeof(Value));
        return true;
    }
    [[nodiscard]] bool ended() const { return rest_.empty(); }

private:
    std::string_view rest_;
};

bool is_sound(const ObjectMesh& mesh) {
    if (mesh.triangle_materials.size() != mesh.triangles.size()) return false;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle)
            if (v >= mesh.vertices.size()) return false;
    for (const std::uint32_t m : mesh.triangle_materials)
        if (m >= mesh.materials.size()) return false;
    if (!mesh.texcoords.empty() && mesh.texcoords.size() != 3 * mesh.triangles.size()) return false;
    for (const auto& uv : mesh.texcoords)
        if (!(std::abs(uv[0]) <= 1e5f && std::abs(uv[1]) <= 1e5f)) return false;
    for (const ObjectMaterial& material : mesh.materials)
        if (material.look.texture != UINT32_MAX && material.look.texture >= mesh.textures.size()) return false;
    for (const auto& texture : mesh.textures) {
        const std::uint32_t w = texture->width, h = texture->height;
        if (w == 0 || h == 0 || w > UINT16_MAX || h > UINT16_MAX || texture->level_count != accel::level_count(w, h) ||
            texture->texels.size() != accel::texel_count(w, h))
            return false;
    }
    for (const auto& v : mesh.vertices)
        if (!std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2])) return false;
    return true;
}

bool read_payload(Reader& reader, LoadedMesh& loaded) {
    ObjectMesh& mesh = loaded.mesh;
    std::uint64_t materials = 0;
    if (!reader.text(mesh.name) || !reader.value(loaded.triangles_before) || !reader.value(loaded.error) ||
        !reader.text(loaded.refused) || !reader.list(mesh.vertices) || !reader.list(mesh.triangles) ||
        !reader.list(mesh.triangle_materials) || !reader.value(materials))
        return false;
    for (std::uint64_t k = 0; k < materials; ++k) {
        ObjectMaterial material;
        accel::InputLook& look = material.look;
        if (!reader.text(material.name) || !reader.value(material.colour) || !reader.value(look.mirror) ||
            !reader.value(look.through) || !reader.value(look.texture) || !reader.value(look.texture_from_face))
            return false;
        mesh.materials.push_back(std::move(material));
    }
    std::uint64_t textures = 0;
    if (!reader.list(mesh.texcoords) || !reader.value(textures)) return false;
    for (std::uint64_t k = 0; k < textures; ++k) {
        auto texture = std::make_shared<accel::InputTexture>();
        if (!reader.text(texture->name) || !reader.value(texture->width) || !reader.value(texture->height) ||
            !reader.value(texture->level_count) || !reader.list(texture->texels))
            return false;
        mesh.textures.push_back(std::move(texture));
    }
    return reader.ended();
}

}  // namespace

std::string mesh_bytes(const CacheKey& key, const LoadedMesh& loaded) {
    Writer writer;
    const ObjectMesh& mesh = loaded.mesh;
    writer.text(key.place);
    writer.text(key.state);
    writer.text(mesh.name);
    writer.value(loaded.triangles_before);
    writer.value(loaded.error);
    writer.text(loaded.refused);
    writer.list(mesh.vertices);
    writer.list(mesh.triangles);
    writer.list(mesh.triangle_materials);
    writer.value(static_cast<std::uint64_t>(mesh.materials.size()));
    for (const ObjectMaterial& material : mesh.materials) {
        writer.text(material.name);
        writer.value(material.colour);
        writer.value(material.look.mirror);
        writer.value(material.look.through);
        writer.value(material.look.texture);
        writer.value(material.look.texture_from_face);
    }
    writer.list(mesh.texcoords);
    writer.value(static_cast<std::uint64_t>(mesh.textures.size()));
    for (const auto& texture : mesh.textures) {
        writer.text(texture->name);
        writer.value(texture->width);
        writer.value(texture->height);
        writer.value(texture->level_count);
        writer.list(texture->texels);
    }
    Writer whole;
    whole.bytes = magic;
    whole.value(checksum(writer.bytes));
    return whole.bytes + writer.bytes;
}

std::optional<LoadedMesh> read_mesh_bytes(std::string_view bytes, const CacheKey& key) {
    if (!bytes.starts_with(magic)) return std::nullopt;
    bytes.remove_prefix(magic.size());
    Reader head(bytes.substr(0, 8));
    std::uint64_t sum = 0;
    if (!head.value(sum)) return std::nullopt;
    bytes.remove_prefix(8);
    if (checksum(bytes) != sum) return std::nullopt;
    Reader reader(bytes);
    std::string place;
    std::string state;
    if (!reader.text(place) || !reader.text(state) || place != key.place || state != key.state) return std::nullopt;
    LoadedMesh loaded;
    if (!read_payload(reader, loaded) || !is_sound(loaded.mesh)) return std::nullopt;
    return loaded;
}

}  // namespace enfilade::modeler

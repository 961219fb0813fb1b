#include "modeler/catalogue/cache.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "accel/sha256.h"
#include "plans/number_text.h"

namespace enfilade::modeler {
namespace {

/// Goes up with every change of what indices or meshes hold, or of how they are made.
constexpr const char* format_version = "3";

std::string state_of(const std::filesystem::path& file) {
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    if (error) return "none";
    const auto time = std::filesystem::last_write_time(file, error);
    if (error) return "none";
    return std::to_string(size) + " " + std::to_string(time.time_since_epoch().count());
}

std::optional<std::string> bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return std::nullopt;
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    return stream.bad() ? std::nullopt : std::optional(std::move(bytes));
}

}  // namespace

std::filesystem::path default_cache() {
    // An XDG path that is not absolute is to be ignored (XDG Base Directory Specification).
    if (const char* caches = std::getenv("XDG_CACHE_HOME"); caches != nullptr && *caches == '/')
        return std::filesystem::path(caches) / "enfilade";
    if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/')
        return std::filesystem::path(home) / ".cache" / "enfilade";
    return {};
}

CacheKey source_key(const std::filesystem::path& path, SourceKind kind) {
    std::error_code error;
    std::filesystem::path whole = std::filesystem::absolute(path, error).lexically_normal();
    CacheKey key{whole.string(), std::string("enfilade catalogue ") + format_version + "\n"};
    if (kind == SourceKind::Folder) {
        const auto files = open_folder(path);
        for (const std::string& name : files->names()) key.state += name + " " + state_of(whole / name) + "\n";
    } else {
        key.state += state_of(whole) + "\n";
    }
    if (kind == SourceKind::File)  // what it may be read with
        for (const std::string& name : {std::string("catalogue.json"), whole.stem().string() + ".mtl"})
            key.state += name + " " + state_of(whole.parent_path() / name) + "\n";
    return key;
}

CacheKey mesh_key(const CacheKey& source, const CatalogueRecord& record, const CatalogueOptions& options) {
    CacheKey key = source;
    const Fitting& fitting = record.fitting;
    key.place += "\n" + record.entry.id + "\n" + record.model + "\n" + std::to_string(options.object_triangles) + "\n" +
                 std::to_string(options.texture_side);
    key.state += record.entry.name + "\n" + plans::number_text(fitting.unit);
    key.state += std::string(" ") + (fitting.up ? (*fitting.up == UpAxis::Y ? "y" : "z") : "-");
    key.state += " " + std::to_string(static_cast<int>(fitting.front));
    for (const double x : fitting.rotation) key.state += " " + plans::number_text(x);
    if (fitting.size)
        for (const double x : *fitting.size) key.state += " " + plans::number_text(x);
    return key;
}

std::filesystem::path Cache::file_of(const CacheKey& key, const char* extension) const {
    return folder_ / (accel::hex(accel::sha256(std::as_bytes(std::span(key.place)))).substr(0, 32) + extension);
}

void Cache::write(const std::filesystem::path& file, std::string_view bytes) const {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) return;
    std::string name = file.string() + "." + std::string(6, 'X');  // what mkstemp replaces
    const int made = mkstemp(name.data());
    if (made < 0) return;
    bool whole = true;
    for (std::size_t at = 0; whole && at < bytes.size();) {
        const ssize_t count = ::write(made, bytes.data() + at, bytes.size() - at);
        if (count <= 0) whole = false;
        else at += static_cast<std::size_t>(count);
    }
    whole = close(made) == 0 && whole;
    if (whole) std::filesystem::rename(name, file, error);
    if (!whole || error) std::filesystem::remove(name, error);
}

std::optional<SourceIndex> Cache::index(const CacheKey& key) const noexcept {
    try {
        if (folder_.empty()) return std::nullopt;
        const auto text = bytes_of(file_of(key, ".json"));
        return text ? read_index(*text, key) : std::nullopt;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

void Cache::keep(const CacheKey& key, const SourceIndex& index) const noexcept {
    try {
        if (!folder_.empty()) write(file_of(key, ".json"), index_text(key, index));
    } catch (const std::exception&) {  // a cache is no part of the result
    }
}

std::optional<LoadedMesh> Cache::mesh(const CacheKey& key) const noexcept {
    try {
        if (folder_.empty()) return std::nullopt;
        const auto bytes = bytes_of(file_of(key, ".mesh"));
        return bytes ? read_mesh_bytes(*bytes, key) : std::nullopt;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

void Cache::keep(const CacheKey& key, const LoadedMesh& mesh) const noexcept {
    try {
        if (!folder_.empty()) write(file_of(key, ".mesh"), mesh_bytes(key, mesh));
    } catch (const std::exception&) {  // a cache is no part of the result
    }
}

}  // namespace enfilade::modeler

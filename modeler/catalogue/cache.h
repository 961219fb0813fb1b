#pragma once
// What was found out about sources and meshes, kept on disk.

#include <filesystem>
#include <optional>
#include <string>

#include "modeler/catalogue/catalogue.h"
#include "modeler/catalogue/source_index.h"

namespace enfilade::modeler {

/// Where something is kept, and what it must have been made from to be still true.
struct CacheKey {
    std::string place;  ///< absolute path of the source, what of it, and options: names the file
    std::string state;  ///< sizes and times of what it was made from, and the version of the format
};

/// The key of a source: a file by its size and time, a folder by those of all its files.
[[nodiscard]] CacheKey source_key(const std::filesystem::path& path, SourceKind kind);

/// The key of one of its meshes.
[[nodiscard]] CacheKey mesh_key(const CacheKey& source, const CatalogueRecord& record, const CatalogueOptions& options);

/// A folder of files, each whole or absent: they are written under another name first. What cannot be read, is damaged
/// or was made from something else counts as absent; what cannot be written is not kept. Never throws.
class Cache {
public:
    /// An empty folder: nothing is kept.
    explicit Cache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    [[nodiscard]] std::optional<SourceIndex> index(const CacheKey& key) const noexcept;
    void keep(const CacheKey& key, const SourceIndex& index) const noexcept;
    [[nodiscard]] std::optional<LoadedMesh> mesh(const CacheKey& key) const noexcept;
    void keep(const CacheKey& key, const LoadedMesh& mesh) const noexcept;

private:
    [[nodiscard]] std::filesystem::path file_of(const CacheKey& key, const char* extension) const;
    void write(const std::filesystem::path& file, std::string_view bytes) const;

    std::filesystem::path folder_;
};

/// The index as JSON, and back. \throws std::exception where it is no index
[[nodiscard]] std::string index_text(const CacheKey& key, const SourceIndex& index);
[[nodiscard]] std::optional<SourceIndex> read_index(std::string_view text, const CacheKey& key);

/// The mesh as bytes, with a checksum, and back. Nothing where anything does not fit.
[[nodiscard]] std::string mesh_bytes(const CacheKey& key, const LoadedMesh& mesh);
[[nodiscard]] std::optional<LoadedMesh> read_mesh_bytes(std::string_view bytes, const CacheKey& key);

}  // namespace enfilade::modeler

#pragma once
// What a library, a home or a folder of meshes has to offer: found once, then kept.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "accel/parallel_for.h"
#include "base/finding.h"
#include "modeler/catalogue/catalogue.h"
#include "modeler/catalogue/file_tree.h"
#include "modeler/catalogue/fit_mesh.h"

namespace enfilade::modeler {

enum class SourceKind : std::uint8_t { Library, Home, Folder, File };

/// An entry, and how its mesh is had.
struct CatalogueRecord {
    CatalogueEntry entry;
    std::string model;    ///< its name in the source
    std::string alias;    ///< what a home's plan calls it; else empty
    bool bare = false;    ///< nothing states its size: a mesh as it came
    bool cleared = true;  ///< its words may tell a kind
    Fitting fitting;
};

struct SourceIndex {
    SourceKind kind = SourceKind::File;
    std::vector<CatalogueRecord> records;  ///< by ascending id, each id once
    std::vector<Finding> findings;
};

/// Library, home, folder or single mesh, by what the path is. \throws InputError K101, K102
[[nodiscard]] SourceKind source_kind(const std::filesystem::path& path);

/// The files of a source. \throws InputError K101, K103
[[nodiscard]] std::unique_ptr<FileTree> open_source(const std::filesystem::path& path, SourceKind kind);

/// Reads every model of the source once: sizes, triangles, defects. The order and the wording of findings do not depend
/// on the executor. \throws InputError K101-K106
[[nodiscard]] SourceIndex read_source(const std::filesystem::path& path, const accel::Executor& executor);

/// The records of each kind of source as their descriptions have them, models not yet read. Findings are added.
void list_library(const FileTree& files, const std::string& title, SourceIndex& index);
void list_home(const FileTree& files, const std::string& title, SourceIndex& index);
void list_meshes(const FileTree& files, const std::filesystem::path& path, SourceIndex& index);

/// Whether things stand on top of pieces of this kind though nothing says so.
[[nodiscard]] bool has_flat_top(std::string_view kind);

/// A finding about a source.
[[nodiscard]] Finding source_finding(const char* code, Severity severity, std::string sentence, std::string hint);

}  // namespace enfilade::modeler

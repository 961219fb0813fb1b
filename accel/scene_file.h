#pragma once
// The `.enf` file: its layout, and reading and writing it (docs/scene-format.md).

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "accel/parallel_for.h"
#include "accel/scene.h"

namespace enfilade::accel {

inline constexpr std::uint32_t scene_file_version = 1;
inline constexpr std::size_t scene_file_alignment = 64;

/// First bytes of the file. `header_sha256` covers header and section table, with itself taken as zeros.
struct FileHeader {
    std::array<char, 8> magic;  ///< "ENFILADE"
    std::uint32_t version;
    std::uint32_t byte_order;  ///< 0x01020304, little-endian
    std::uint64_t file_bytes;
    std::uint32_t section_count;
    std::uint32_t section_entry_bytes;
    double unit;
    std::array<double, 3> origin;
    std::array<std::uint8_t, 32> header_sha256;
    std::array<std::uint8_t, 32> reserved;
};
static_assert(sizeof(FileHeader) == 128);

/// One row of the section table that follows the header. Arrays begin at multiples of 64 bytes and at least 64 zero
/// bytes follow each, so that wide loads may run over an end.
struct SectionEntry {
    std::array<char, 16> name;  ///< closed by zeros
    std::uint32_t id;
    Group group;
    std::uint32_t element_bytes;
    std::uint32_t reserved;
    std::uint64_t offset;
    std::uint64_t bytes;
    std::array<std::uint8_t, 32> sha256;
    std::array<std::uint8_t, 16> reserved2;
};
static_assert(sizeof(SectionEntry) == 96);

/// Ids of the sections. 44-63 are free; from 1000 on the model's arrays.
enum class SectionKind : std::uint32_t {
    Cells = 1,
    CellPortals,
    SectionX,
    SectionY,
    SectionTails,
    SideFaces,
    SideFacePortals,
    Portals,
    Tints,
    SourceFaces,
    Vertices,
    Materials,
    Spaces,
    TextOffsets,
    Text,
    LocatorNodes,
    LocatorCells,
    Meshes = 32,
    MeshVertices,
    MeshTriangles,
    Objects,
    CellObjectOffsets,
    CellObjects,
    Lights,
    MaterialLooks,
    Textures,
    Texels,
    MeshTexCoords,
    FaceFrames,
    Certificate = 900,
    FirstModel = 1000
};

struct ReadOptions {
    bool verify_hashes = false;          ///< also compare every array with its SHA-256
    const Executor* executor = nullptr;  ///< who validates; nullptr: all cores
};

/// Maps a scene file read-only and validates every index in it. Another process must not shorten the file meanwhile.
/// \throws IoError if the file cannot be opened or mapped; InputError (codes F1-F6) if it is no sound scene file.
[[nodiscard]] Scene open(const std::filesystem::path& path, const ReadOptions& options = {});

/// The same from bytes in memory, which are copied. \throws InputError as `open`.
[[nodiscard]] Scene read(std::span<const std::byte> bytes, const ReadOptions& options = {});

/// Writes to a temporary name beside `path` and renames it, so that a reader sees the old file or the new one.
/// \throws IoError, with the temporary file removed.
void write(const Scene& scene, const std::filesystem::path& path);

/// The same scene without its model group: it can be traced but neither edited nor checked against its map.
[[nodiscard]] Scene strip(const Scene& scene);

/// Names of the arrays whose bytes do not have the SHA-256 that the file states; empty for an undamaged scene.
[[nodiscard]] std::vector<std::string> damaged_arrays(const Scene& scene, const Executor* executor = nullptr);

}  // namespace enfilade::accel

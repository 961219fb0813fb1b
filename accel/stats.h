#pragma once
// Counts and memory of a scene, for `info` and the benchmarks.

#include <array>
#include <cstdint>

#include "accel/scene.h"

namespace enfilade::accel {

struct SceneStats {
    std::uint64_t cells = 0;
    std::uint64_t sections = 0;
    std::uint64_t side_faces = 0;
    std::uint64_t portals = 0;
    std::uint64_t source_faces = 0;
    std::uint64_t spaces = 0;
    std::uint64_t rooms = 0;         ///< spaces labelled Room
    std::uint64_t room_cells = 0;    ///< cells of those
    std::uint64_t max_sections = 0;  ///< of one cell
    std::array<std::uint64_t, label_count> cells_of_label = {};
    std::array<std::uint64_t, 3> portals_of_kind = {};
    std::uint64_t cell_bytes = 0;  ///< cells, sections, side faces, portals: what a walk reads
    std::uint64_t locator_bytes = 0;
    std::uint64_t trace_bytes = 0;  ///< the whole trace group, source faces and names included
    std::uint64_t objects = 0;
    std::uint64_t meshes = 0;
    std::uint64_t unique_triangles = 0;     ///< of all meshes
    std::uint64_t instanced_triangles = 0;  ///< of all objects
    std::uint64_t listed_objects = 0;       ///< entries of the cells' lists
    std::uint64_t object_bytes = 0;         ///< of the trace group: objects and the cells' lists
    std::uint64_t mesh_bytes = 0;           ///< of the trace group: meshes, their vertices and triangles
    std::uint64_t textures = 0;
    std::uint64_t texture_bytes = 0;  ///< of the trace group: texels, texture coordinates and what materials do
    std::uint64_t model_bytes = 0;
    std::array<float, 3> low = {};  ///< box of all cells, metres
    std::array<float, 3> high = {};

    /// Memory of the cell structure with its locator, a cell.
    [[nodiscard]] double bytes_per_cell() const;
    [[nodiscard]] double cells_per_room() const;
    /// Of the trace group, what the scene without its furniture takes (but for the names of that).
    [[nodiscard]] std::uint64_t bytes_without_objects() const { return trace_bytes - object_bytes - mesh_bytes; }
};

[[nodiscard]] SceneStats stats(const Scene& scene);

}  // namespace enfilade::accel

#pragma once
// Polyhedra made by other programs, with their indices as the file writes them (docs/meshes.md).

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/finding.h"

namespace enfilade::modeler {

struct CheckReport;  // modeler/check.h

enum class MeshFormat : std::uint8_t { Obj, Off, Ply, Stl, CityJson };

/// Inner rings of a face (CityJSON alone has them).
struct MeshHole {
    std::uint32_t face = 0;
    std::uint32_t first = 0;  ///< into Mesh::hole_ring
    std::uint32_t count = 0;
};

/// Faces that are meant to be one closed surface.
struct MeshShell {
    std::uint32_t first_face = 0;
    std::uint32_t face_count = 0;
};

/// A solid as the file names it: one outer shell, then those of its voids.
struct MeshSolid {
    std::string object;  ///< id of the CityObject
    std::string name;    ///< of this solid in sentences: `Building "A", LoD 2.2, solid 0`
    std::uint32_t first_shell = 0;
    std::uint32_t shell_count = 0;
    std::uint32_t composite = 0;     ///< solids of one CompositeSolid share it: they may touch, not overlap
    std::uint32_t first_vertex = 0;  ///< vertices of templates are counted from here
};

/// A name that the file gives to the faces from `first_face` on (`o`, `g` and `usemtl` of OBJ, solids of STL).
struct MeshGroup {
    std::uint32_t first_face = 0;
    std::string name;
};

struct Mesh {
    MeshFormat format = MeshFormat::Obj;
    std::vector<std::array<double, 3>> points;    ///< in the units of the file
    std::vector<std::uint32_t> ring_first = {0};  ///< [face + 1] into `ring`
    std::vector<std::uint32_t> ring;              ///< into `points`, as written (from 0)
    std::vector<std::array<float, 2>> texcoords;  ///< OBJ alone, where it is read tolerantly: u, v
    std::vector<std::uint32_t> ring_texcoord;     ///< [ring] into `texcoords`, or beyond; empty: no face has any
    std::vector<MeshHole> holes;                  ///< ascending by face
    std::vector<std::uint32_t> hole_ring;         ///< into `points`
    std::vector<MeshShell> shells;                ///< CityJSON alone, in the order of the faces
    std::vector<MeshSolid> solids;                ///< CityJSON alone; elsewhere connected pieces are solids
    std::vector<MeshGroup> groups;                ///< ascending by face
    std::vector<MeshGroup> materials;             ///< OBJ alone: the same of its materials
    std::vector<std::string> material_files;      ///< OBJ alone: names of its material libraries
    std::vector<bool> merged;                     ///< [vertex] welded away; empty where nothing was
    std::vector<Finding> findings;                ///< what reading had to say

    [[nodiscard]] std::size_t face_count() const noexcept { return ring_first.size() - 1; }
    [[nodiscard]] std::span<const std::uint32_t> face(std::size_t f) const {
        return std::span(ring).subspan(ring_first[f], ring_first[f + 1] - ring_first[f]);
    }
    [[nodiscard]] std::span<const std::uint32_t> hole(const MeshHole& h) const {
        return std::span(hole_ring).subspan(h.first, h.count);
    }
    /// The holes of a face.
    [[nodiscard]] std::span<const MeshHole> holes_of(std::size_t f) const;
    void end_face() { ring_first.push_back(static_cast<std::uint32_t>(ring.size())); }
};

struct MeshOptions {
    double weld = -1;               ///< units: points nearer than this become one; 0: equal ones; < 0: none
    double coincident = 0;          ///< G1: vertices this near are one too many
    double planar_distance = 0.01;  ///< G3: units, of a corner from the plane of its face
    double planar_angle_deg = 20;   ///< G3: between the plane and any triangle of the face
    std::size_t listed = 20;        ///< findings of a kind before the rest are counted in one
    /// Coordinates that are none become NaN, vertices that do not exist numbers beyond `points`, instead of a refusal:
    /// for those who leave such faces out themselves. Nothing is welded then.
    bool tolerant = false;
};

/// What was looked at, for reports and for comparing with other tools.
struct MeshCount {
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
    std::uint64_t pieces = 0;              ///< connected by vertices
    std::uint64_t boundary_edges = 0;      ///< with one face
    std::uint64_t holes = 0;               ///< loops of them
    std::uint64_t crowded_edges = 0;       ///< with more than two faces
    std::uint64_t turned_edges = 0;        ///< whose two faces run along it in the same direction
    std::uint64_t duplicate_vertices = 0;  ///< copies of a point beyond the first
    std::uint64_t unused_vertices = 0;
    std::uint64_t flat_faces = 0;      ///< without area
    std::uint64_t crossing_pairs = 0;  ///< of triangles
};

/// Reads OBJ, OFF, PLY, STL or CityJSON 1.0-2.0, told apart by content, then by extension, and welds where asked to.
/// Throws InputError P800-P809 with line or byte where the file cannot be used. Cost: linear in the file.
[[nodiscard]] Mesh read_mesh(const std::filesystem::path& path, const MeshOptions& options = {});

/// The same from memory; `name` stands in complaints, its extension decides where the content does not.
[[nodiscard]] Mesh read_mesh(std::string_view bytes, const std::string& name, const MeshOptions& options = {});

/// T1-T7 on the generalized map of the faces, with `Outside` beyond each shell, and G1-G5 (docs/checks.md). Findings
/// name faces and vertices as the file counts them: from 1 in OBJ, from 0 elsewhere.
[[nodiscard]] CheckReport check_mesh(const Mesh& mesh, const MeshOptions& options = {}, MeshCount* count = nullptr);

}  // namespace enfilade::modeler

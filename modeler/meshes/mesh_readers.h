#pragma once
// One reader a format. Each fills points, faces, names and findings; none of them repairs anything.
// `tolerant`: as in MeshOptions.

#include <string>
#include <string_view>
#include <vector>

#include "modeler/meshes/mesh.h"

namespace enfilade::modeler {

/// Wavefront OBJ: `v`, `f` with `v/vt/vn` and negative numbers, `o`, `g`, comments, continued lines. Vertices may come
/// after the faces that use them.
[[nodiscard]] Mesh read_obj(std::string_view bytes, const std::string& file, bool tolerant = false);

/// OFF and its variants with colours, normals and texture coordinates, which are passed over. `has_header`: false for a
/// file that begins with its counts.
[[nodiscard]] Mesh read_off(std::string_view bytes, const std::string& file, bool tolerant = false);

/// PLY, as text or binary of either byte order; elements and properties other than places and faces are passed over.
[[nodiscard]] Mesh read_ply(std::string_view bytes, const std::string& file, bool tolerant = false);

/// STL, as text or binary. The format has no indices: equal points become one vertex (P810).
[[nodiscard]] Mesh read_stl(std::string_view bytes, const std::string& file, bool tolerant = false);

/// Whether the bytes are as many as a binary STL of their number of triangles has.
[[nodiscard]] bool is_binary_stl(std::string_view bytes);

/// CityJSON 1.0 to 2.0: every Solid, MultiSolid and CompositeSolid of every CityObject and LoD.
[[nodiscard]] Mesh read_city_json(std::string_view bytes, const std::string& file);

/// The vertex that stands for each place: equal points, or points within a distance, share the lowest.
[[nodiscard]] std::vector<std::uint32_t> vertex_places(const Mesh& mesh, double distance);

/// Makes points within `distance` of each other one: the lowest of them takes the place of all (P811).
void weld(Mesh& mesh, double distance);

}  // namespace enfilade::modeler

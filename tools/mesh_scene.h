#pragma once
// A mesh by itself, as a scene: it stands on a plain under the sky, and is rendered like any other.

#include <array>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "accel/scene.h"
#include "modeler/catalogue/object_mesh.h"
#include "modeler/catalogue/raw_mesh.h"

namespace enfilade::tools {

/// Its longest side, metres, whatever it has in its file: what reckons in metres (corners that darken, slack where rays
/// start) suits it then.
inline constexpr double shown_mesh_size = 2;

struct MeshScene {
    accel::Scene scene;
    std::size_t triangles = 0;  ///< of the file, without those that were left out
    modeler::MeshDefects defects;
    std::array<double, 3> size = {0, 0, 0};  ///< upright, in the file's unit
    double scale = 1;                        ///< metres shown a unit of the file

    /// "69,451 triangles, 2 of them without area, 3 edges of three triangles or more"
    [[nodiscard]] std::string report() const;
    [[nodiscard]] nlohmann::ordered_json json() const;
};

/// Whether the file is a mesh by its name: .obj, .gltf, .glb, .ply, .off, .stl.
[[nodiscard]] bool is_mesh_file(const std::filesystem::path& file);

/// The mesh upright and `shown_mesh_size` large, the middle of its bottom at the origin, its front towards -y. Nothing
/// is repaired. `up`: which axis of the file points up; nothing: y in OBJ and glTF, z in the others. \throws InputError
/// (K...) if it cannot be read or holds no triangle; F148 where there is nothing to see of it
[[nodiscard]] MeshScene scene_of_mesh(const std::filesystem::path& file, std::optional<modeler::UpAxis> up);

}  // namespace enfilade::tools

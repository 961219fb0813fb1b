#pragma once
// Models of any format out of any archive or folder.

#include <cstdint>
#include <string>
#include <string_view>

#include "modeler/catalogue/file_tree.h"
#include "modeler/catalogue/raw_mesh.h"

namespace enfilade::modeler {

enum class ReadImages : bool { No, Yes };

/// The model of that name: OBJ with its materials, OFF, PLY, STL (modeler/meshes), glTF, GLB (assimp), or the first of
/// them inside a zip archive of that name. With `ReadImages::Yes`, materials with a texture take its mean colour, and
/// the texture itself, of at most `texture_side` texels a side, where that is not 0. \throws InputError K109 where it
/// has no triangle, K107 where it is no model that is read, K103 where its archive is damaged
[[nodiscard]] RawMesh read_model(const FileTree& files, const std::string& name, ReadImages images,
                                 std::uint32_t texture_side = 0);

/// Whether a file of that name may be a model of a kind that is read, by its extension.
[[nodiscard]] bool has_model_extension(std::string_view name);

/// Wavefront OBJ; its material libraries are looked for beside it. \throws InputError P80x
[[nodiscard]] RawMesh read_obj_model(const FileTree& files, const std::string& name, std::string_view bytes,
                                     ReadImages images, std::uint32_t texture_side = 0);

/// glTF 2.0, as JSON or binary, by assimp; every mesh at each of its nodes. \throws InputError K107
[[nodiscard]] RawMesh read_gltf_model(const FileTree& files, const std::string& name, std::string_view bytes,
                                      ReadImages images, std::uint32_t texture_side = 0);

}  // namespace enfilade::modeler

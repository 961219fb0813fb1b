#pragma once
// What a picture is of: a scene file, or a mesh.

#include <filesystem>
#include <optional>

#include "accel/scene.h"
#include "tools/commands.h"
#include "tools/mesh_scene.h"
#include "tools/trace_flags.h"

namespace enfilade::tools {

/// What --up says; nothing without it.
[[nodiscard]] std::optional<modeler::UpAxis> up_axis(const RenderOptions& options);

/// Refuses flags that a mesh, or nothing but a mesh, can do with. Throws InputError (F148).
void check_mesh_flags(const RenderOptions& options, const TracerChoice& choice);

/// The scene file. Throws InputError as accel::open; what is neither scene nor mesh is told what would be one (F148).
[[nodiscard]] accel::Scene opened_scene(const std::filesystem::path& file);

}  // namespace enfilade::tools

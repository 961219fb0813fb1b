#pragma once
// From where a picture is taken: views by name, fitted to the building, and places by coordinates.

#include <optional>
#include <string>

#include "accel/scene.h"
#include "render/camera.h"

namespace enfilade::tools {

struct View {
    render::Camera camera;
    std::optional<double> cut_z;  ///< what lies above is taken off; metres, scene frame
};

/// `text`: "exterior", "aerial", "dollhouse", "dollhouse:STOREY", or "X,Y,Z:X,Y,Z" (where the eye is, and what it looks
/// at; metres in the frame of the plan). Throws InputError for anything else.
[[nodiscard]] View named_view(const accel::SceneView& scene, const std::string& text, int width, int height);

/// From a corner of the room of this name or id, where most of it is in sight. Throws InputError where there is none.
[[nodiscard]] View room_view(const accel::SceneView& scene, const std::string& room, int width, int height);

}  // namespace enfilade::tools

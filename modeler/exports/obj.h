#pragma once
// A scene as Wavefront OBJ: the oldest format that every 3D program reads.

#include <string>
#include <string_view>

#include "accel/scene.h"

namespace enfilade::modeler {

struct ObjText {
    std::string obj;
    std::string mtl;  ///< its materials, a file of its own
};

/// One object a room (door, window, ...), by name. Metres, y up, colours (Kd) in sRGB; the sky is left out. `mtl_name`
/// is the file name under which the text of the materials will stand beside the OBJ.
[[nodiscard]] ObjText to_obj(const accel::SceneView& scene, std::string_view mtl_name);

}  // namespace enfilade::modeler

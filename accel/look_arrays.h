#pragma once
// Inside of `assemble`: what materials do besides their colours, laid out.

#include <functional>
#include <string>
#include <vector>

#include "accel/scene.h"
#include "accel/scene_input.h"

namespace enfilade::accel::detail {

struct LookArrays {
    std::vector<MaterialLook> material_looks;
    std::vector<Texture> textures;
    std::vector<Texel> texels;
    std::vector<FaceFrame> face_frames;
};

/// All of them empty where every material is a plain colour. name: the text's id. \throws InputError (F10)
[[nodiscard]] LookArrays lay_out_looks(const SceneInput& input, const std::function<TextId(const std::string&)>& name);

}  // namespace enfilade::accel::detail

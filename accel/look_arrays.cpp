#include "accel/look_arrays.h"

#include <algorithm>

#include "base/error.h"

namespace enfilade::accel::detail {

LookArrays lay_out_looks(const SceneInput& input, const std::function<TextId(const std::string&)>& name) {
    LookArrays arrays;
    const std::vector<InputMaterial>& materials = input.materials;
    const auto is_plain = [](const InputMaterial& m) { return m.look == InputLook{}; };
    if (input.textures.empty() && std::ranges::all_of(materials, is_plain)) return arrays;
    for (const InputMaterial& material : materials) {
        const InputLook& look = material.look;
        const TextureId texture = look.texture == UINT32_MAX ? none<TextureId> : static_cast<TextureId>(look.texture);
        arrays.material_looks.push_back({look.mirror, look.through, texture, look.texture_from_face, 0});
    }
    for (const auto& texture : input.textures) {
        if (texture->width > UINT16_MAX || texture->height > UINT16_MAX ||
            arrays.texels.size() + texture->texels.size() > UINT32_MAX)
            throw InputError("F10", "",
                             "the texture '" + texture->name + "' is too large; build with smaller textures");
        arrays.textures.push_back(
            {static_cast<std::uint32_t>(arrays.texels.size()), static_cast<std::uint16_t>(texture->width),
             static_cast<std::uint16_t>(texture->height), texture->level_count, name(texture->name)});
        for (const std::array<std::uint8_t, 4>& t : texture->texels) arrays.texels.push_back({t[0], t[1], t[2], t[3]});
    }
    const bool has_textured_faces = std::ranges::any_of(input.source_faces, [&](const InputSourceFace& face) {
        return face.material < materials.size() && materials[face.material].look.texture != UINT32_MAX;
    });
    if (!has_textured_faces) return arrays;
    for (const InputSourceFace& face : input.source_faces)
        arrays.face_frames.push_back({face.frame[0], face.frame[1], face.frame[2], face.frame[3]});
    return arrays;
}

}  // namespace enfilade::accel::detail

#include "modeler/objects/scene_textures.h"

#include "accel/texture_chain.h"

namespace enfilade::modeler {

std::vector<std::shared_ptr<const accel::InputTexture>> scene_textures(const accel::SceneView& scene) {
    std::vector<std::shared_ptr<const accel::InputTexture>> textures;
    for (const accel::Texture& from : scene.textures) {
        auto texture = std::make_shared<accel::InputTexture>();
        texture->name = scene.string(from.name);
        texture->width = from.width;
        texture->height = from.height;
        texture->level_count = from.level_count;
        const std::uint64_t end = from.first_texel + accel::texel_count(from.width, from.height);
        for (std::uint64_t t = from.first_texel; t < end; ++t)
            texture->texels.push_back({scene.texels[t].r, scene.texels[t].g, scene.texels[t].b, scene.texels[t].a});
        textures.push_back(std::move(texture));
    }
    return textures;
}

}  // namespace enfilade::modeler

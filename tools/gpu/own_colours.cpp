#include "tools/gpu/own_colours.h"

#include <array>

namespace enfilade::tools::gpu {

namespace {

/// Colours that each material is split into.
constexpr std::uint32_t hues = 61;

/// A channel from 0.3 to 1: the fraction of a multiple of an irrational number spreads evenly.
float channel(std::uint32_t number, double irrational) {
    const double multiple = irrational * (number + 1);
    return static_cast<float>(0.3 + 0.7 * (multiple - static_cast<double>(static_cast<std::uint64_t>(multiple))));
}

accel::MaterialId one_of(accel::MaterialId material, std::size_t number) {
    return static_cast<accel::MaterialId>(index(material) * hues + static_cast<std::uint32_t>(number % hues));
}

}  // namespace

OwnColours::OwnColours(const accel::SceneView& scene, bool has_clear_panes)
    : faces_(scene.source_faces.begin(), scene.source_faces.end()),
      triangles_(scene.mesh_triangles.begin(), scene.mesh_triangles.end()),
      objects_(scene.objects.begin(), scene.objects.end()),
      tints_(scene.tints.begin(), scene.tints.end()),
      view_(scene) {
    if (has_clear_panes) tints_.assign(tints_.size(), {1, 1, 1});
    for (const accel::Material& material : scene.materials)
        for (std::uint32_t k = 0; k < hues; ++k) {
            const auto number = static_cast<std::uint32_t>(materials_.size());
            materials_.push_back({{channel(number, 0.6180339887498949), channel(number, 0.7548776662466927),
                                   channel(number, 0.5698402909980532)},
                                  material.name});
        }
    for (const accel::MaterialLook& look : scene.material_looks) looks_.insert(looks_.end(), hues, look);
    for (std::size_t i = 0; i + 1 < faces_.size(); ++i) faces_[i].material = one_of(faces_[i].material, i);
    for (std::size_t i = 0; i < triangles_.size(); ++i) triangles_[i].material = one_of(triangles_[i].material, i);
    for (std::size_t i = 0; i < objects_.size(); ++i)
        if (objects_[i].material != none<accel::MaterialId>) objects_[i].material = one_of(objects_[i].material, i);
    view_.materials = {materials_.data(), materials_.size()};
    view_.material_looks = {looks_.data(), looks_.size()};
    view_.source_faces = {faces_.data(), faces_.size()};
    view_.mesh_triangles = {triangles_.data(), triangles_.size()};
    view_.tints = {tints_.data(), tints_.size()};
    view_.objects = {objects_.data(), objects_.size()};
}

}  // namespace enfilade::tools::gpu

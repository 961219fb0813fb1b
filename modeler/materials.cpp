#include "modeler/materials.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "accel/texture_chain.h"

namespace enfilade::modeler {
namespace {

plans::Colour default_colour(Surface surface) {
    switch (surface) {
        case Surface::WallPaper: return {0.83f, 0.80f, 0.74f};
        case Surface::Floor: return {0.52f, 0.38f, 0.25f};
        case Surface::Ceiling: return {0.90f, 0.89f, 0.87f};
        case Surface::Facade: return {0.78f, 0.73f, 0.65f};
        case Surface::Jamb:
        case Surface::Lintel: return {0.88f, 0.87f, 0.84f};
        case Surface::Sill: return {0.70f, 0.68f, 0.64f};
        case Surface::Leaf: return {0.42f, 0.27f, 0.16f};
        case Surface::Pane: return {0.55f, 0.66f, 0.72f};
        case Surface::Terrain: return {0.27f, 0.36f, 0.18f};
        case Surface::Roof: return {0.36f, 0.33f, 0.31f};
        case Surface::Sky: return {0.50f, 0.68f, 0.92f};
    }
    return {0.8f, 0.8f, 0.8f};
}

std::string material_name(Surface surface, const plans::Colour& colour) {
    char text[48];
    const auto byte = [](float c) {
        return int(std::lround(255 * std::pow(std::fmin(std::fmax(c, 0.f), 1.f), 1 / 2.2f)));
    };
    std::snprintf(text, sizeof text, "%s #%02x%02x%02x", accel::name_of(surface), byte(colour[0]), byte(colour[1]),
                  byte(colour[2]));
    return text;
}

}  // namespace

std::optional<plans::Colour> Materials::colour(Surface surface, std::uint32_t viewer_space, std::uint32_t behind_space,
                                               std::uint32_t line) const {
    switch (surface) {
        case Surface::WallPaper:
        case Surface::Facade: return wall_colour(behind_space, line);
        case Surface::Floor: return building_.spaces[viewer_space].colour;
        case Surface::Ceiling: return building_.spaces[viewer_space].ceiling_colour;
        default: return std::nullopt;
    }
}

std::optional<plans::Colour> Materials::wall_colour(std::uint32_t behind_space, std::uint32_t line) const {
    const std::vector<WallColour>& all = building_.wall_colours;
    const auto before = [](const WallColour& wall, std::pair<std::uint32_t, std::uint32_t> key) {
        return std::pair(wall.line, wall.wall_space) < key;
    };
    // The edge of a slab goes on in the colour of a wall on its line.
    const bool is_slab = building_.spaces[behind_space].label == Label::Slab;
    const auto at = std::lower_bound(all.begin(), all.end(), std::pair(line, is_slab ? 0 : behind_space), before);
    if (at == all.end() || at->line != line || (!is_slab && at->wall_space != behind_space)) return std::nullopt;
    return at->colour;
}

std::uint32_t Materials::of(Surface surface, std::uint32_t viewer_space, std::uint32_t behind_space,
                            std::uint32_t line) {
    const plans::Colour shown = colour(surface, viewer_space, behind_space, line).value_or(default_colour(surface));
    return number_of(surface, {material_name(surface, shown), shown});
}

std::uint32_t Materials::of(Surface surface, const PlanTexture& texture) {
    const plans::SurfaceTexture& laid = texture.laid;
    const accel::InputTexture& picture = *building_.pictures[texture.picture];
    const std::array<float, 4> mean = accel::mean_of(picture);
    accel::InputMaterial material{std::string(accel::name_of(surface)) + " " + laid.picture,
                                  {mean[0], mean[1], mean[2]}};
    material.look.texture = texture.picture;
    // Moved along the surface, turned against the picture's own turn, then counted in repeats. Ceilings are seen from
    // below: what runs to the right there runs to the left on the plan.
    const double c = std::cos(laid.angle), s = std::sin(laid.angle);
    const double u = surface == Surface::Ceiling ? -1 : 1;
    const double right = laid.offset_x * laid.width, up = laid.offset_y * laid.height;
    const double w = 1 / laid.width, h = 1 / laid.height;
    material.look.texture_from_face = {float(w * u * c), float(w * s),  float(-w * (c * right + s * up)),
                                       float(h * u * s), float(-h * c), float(h * (c * up - s * right))};
    return number_of(surface, std::move(material));
}

std::uint32_t Materials::number_of(Surface surface, accel::InputMaterial material) {
    const auto [at, is_new] =
        known_.try_emplace({surface, material.colour, material.look}, std::uint32_t(materials_.size()));
    if (is_new) materials_.push_back(std::move(material));
    return at->second;
}

}  // namespace enfilade::modeler

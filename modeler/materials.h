#pragma once
// What the faces of a scene are made of: the plan's textures and colours, else a plain default per surface.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "accel/scene_input.h"
#include "modeler/building.h"
#include "modeler/face_label.h"
#include "modeler/surface_textures.h"

namespace enfilade::modeler {

/// Materials by surface and colour or texture, numbered in order of first use.
class Materials {
public:
    explicit Materials(const Building& building) : building_(building) {}
    /// Of a side face over a line of the plan, or of a horizontal one (`line` UINT32_MAX).
    std::uint32_t of(Surface surface, std::uint32_t viewer_space, std::uint32_t behind_space, std::uint32_t line);
    /// Of a face that shows a texture.
    std::uint32_t of(Surface surface, const PlanTexture& texture);
    [[nodiscard]] std::vector<accel::InputMaterial> take() { return std::move(materials_); }

private:
    [[nodiscard]] std::optional<plans::Colour> colour(Surface surface, std::uint32_t viewer_space,
                                                      std::uint32_t behind_space, std::uint32_t line) const;
    [[nodiscard]] std::optional<plans::Colour> wall_colour(std::uint32_t behind_space, std::uint32_t line) const;

    std::uint32_t number_of(Surface surface, accel::InputMaterial material);

    const Building& building_;
    std::map<std::tuple<Surface, plans::Colour, accel::InputLook>, std::uint32_t> known_;
    std::vector<accel::InputMaterial> materials_;
};

}  // namespace enfilade::modeler

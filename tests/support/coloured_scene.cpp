#include "tests/support/coloured_scene.h"

#include <cmath>
#include <utility>

namespace enfilade::test {

accel::SceneInput with_own_colours(accel::SceneInput input) {
    const std::size_t count = input.source_faces.size();
    const auto shades = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    input.materials.clear();
    for (std::size_t f = 0; f < count; ++f) {
        const std::size_t hue = f * 1000003 % (shades * shades);  // a prime: no two faces share a hue
        const auto shade = [&](std::size_t k) {
            return static_cast<float>(0.25 + 0.75 * (static_cast<double>(k) + 0.5) / static_cast<double>(shades));
        };
        input.materials.push_back({"face " + std::to_string(f), {1, shade(hue % shades), shade(hue / shades)}});
        input.source_faces[f].material = static_cast<std::uint32_t>(f);
    }
    return input;
}

accel::SceneInput with_clear_panes(accel::SceneInput input) {
    for (accel::InputPortal& portal : input.portals) portal.tint = {1, 1, 1};
    return input;
}

}  // namespace enfilade::test

#include "modeler/lighting/lamp.h"

#include <cmath>
#include <numbers>

namespace enfilade::modeler {

std::array<float, 3> candela(const Lamp& lamp) {
    const double share = luminance(lamp.colour);
    if (!(lamp.lumen > 0 && share > 0)) return {0, 0, 0};
    const double scale = lamp.lumen / (4 * std::numbers::pi * share);
    std::array<float, 3> intensity{};
    for (std::size_t k = 0; k < 3; ++k) {
        intensity[k] = float(scale * double(lamp.colour[k]));
        if (!(intensity[k] >= 0 && std::isfinite(intensity[k]))) return {0, 0, 0};
    }
    return intensity;
}

}  // namespace enfilade::modeler

#include "modeler/lighting/lamp_rules.h"

#include <algorithm>

namespace enfilade::modeler {

const RoomLight* LampRules::room(std::string_view kind) const {
    auto found = std::ranges::find(rooms, kind, &RoomLight::kind);
    if (found == rooms.end()) found = std::ranges::find(rooms, "default", &RoomLight::kind);
    return found == rooms.end() || found->lux <= 0 ? nullptr : &*found;
}

const PieceLight* LampRules::piece(std::string_view kind) const {
    const auto found = std::ranges::find(pieces, kind, &PieceLight::kind);
    return found == pieces.end() || found->lumen <= 0 ? nullptr : &*found;
}

const LampRules& own_lamp_rules() {
    static const LampRules rules = {
        .source = "the program's own rules",
        .rooms =
            {
                // Homes, as usual.
                {"bedroom", 100, 15, 0.1, 2700},
                {"child", 200, 15, 0.1, 2700},
                {"living", 150, 15, 0.1, 2700},
                {"dining", 150, 15, 0.1, 2700},
                {"kitchen", 300, 12, 0.1, 3000},
                {"bathroom", 200, 8, 0.1, 3000},
                {"toilet", 200, 8, 0.1, 3000},
                {"hall", 100, 12, 0.1, 2700},
                {"laundry", 200, 12, 0.1, 4000},
                {"garage", 75, 20, 0.1, 4000},
                // EN 12464-1: areas of work and of passage.
                {"corridor", 100, 14, 0.1, 3000},
                {"stairwell", 150, 12, 0.1, 3000},
                {"study", 500, 12, 0.1, 4000},
                {"office", 500, 12, 0.1, 4000},
                {"open_office", 500, 12, 0.1, 4000},
                {"meeting", 500, 12, 0.1, 4000},
                {"reception", 300, 12, 0.1, 3000},
                {"classroom", 500, 12, 0.1, 4000},
                {"library", 300, 12, 0.1, 3000},
                {"break_room", 200, 12, 0.1, 3000},
                {"changing_room", 200, 12, 0.1, 3000},
                {"storage", 100, 15, 0.1, 4000},
                {"server_room", 300, 12, 0.1, 4000},
                {"void", 0},
                {"terrace", 0},
                {"default", 200, 15, 0.1, 3000},
            },
        .pieces =
            {
                {.kind = "ceiling_lamp", .lumen = 800, .height = 0.2, .lights_room = true},
                {.kind = "office_lamp", .lumen = 2000, .kelvin = 4000, .height = 0, .lights_room = true},
                {.kind = "floor_lamp", .lumen = 800},
                {.kind = "table_lamp", .lumen = 400},
                {.kind = "desk_lamp", .lumen = 400, .kelvin = 3000},
                {.kind = "wall_lamp", .lumen = 400},
            },
    };
    return rules;
}

std::array<float, 3> colour_of_kelvin(double kelvin) {
    const double t = 1000 / std::clamp(kelvin, 1667.0, 25000.0);
    const double x = t > 0.25 ? ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
                              : ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390;
    double y = 0;
    if (t > 1000.0 / 2222) y = ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683;
    else if (t > 0.25) y = ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867;
    else y = ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
    const double tall = x / y, flat = (1 - x - y) / y;  // X and Z, of Y = 1
    const double rgb[] = {3.2406255 * tall - 1.5372080 - 0.4986286 * flat,
                          -0.9689307 * tall + 1.8757561 + 0.0415175 * flat,
                          0.0557101 * tall - 0.2040211 + 1.0569959 * flat};
    const double most = std::max({rgb[0], rgb[1], rgb[2]});
    std::array<float, 3> colour{};
    for (std::size_t k = 0; k < 3; ++k) colour[k] = float(std::max(rgb[k], 0.0) / most);
    return colour;
}

}  // namespace enfilade::modeler

#include "tests/support/lit_rooms.h"

#include "tests/support/synthetic_scene.h"

namespace enfilade::test {

accel::SceneInput closed_room() {
    return scene_from_plots({{grid(0), grid(0), grid(6), grid(4), {{.z_floor = grid(0), .z_ceiling = grid(3)}}}});
}

accel::SceneInput closed_rooms(double turn) {
    using accel::Label;
    const auto plot = [](double x0, double y0, double x1, double y1, double top, Label label, std::uint32_t space) {
        return Plot{grid(x0), grid(y0), grid(x1), grid(y1), {{0, grid(top), label, space}}};
    };
    return scene_from_plots({plot(0, 0, 4, 3, 2.5, Label::Room, 0), plot(4, 1, 4.25, 2, 2, Label::Door, 1),
                             plot(4.25, 0, 7, 5, 3.25, Label::Room, 2), plot(5, 5, 6, 5.25, 2, Label::Door, 3),
                             plot(4.5, 5.25, 6.5, 8, 2.25, Label::Room, 4)},
                            turn);
}

void paint(accel::SceneInput& input, std::array<float, 3> colour) {
    for (accel::InputMaterial& material : input.materials) material.colour = colour;
}

void hang(accel::SceneInput& input, std::array<double, 3> position, std::array<float, 3> candela, double radius) {
    accel::InputLight light;
    light.id = "lamp-" + std::to_string(100000 + input.lights.size());
    light.position = position;
    light.intensity = candela;
    light.radius = radius;
    input.lights.push_back(light);
}

}  // namespace enfilade::test

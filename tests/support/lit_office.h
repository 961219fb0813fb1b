#pragma once
// An office with lamps, for tests of light.

#include <string>

#include "accel/assemble.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::test {

/// An office with a lamp in each cell that is a room, off the grid.
inline accel::Scene lit_office() {
    accel::SceneInput input = synthetic_office({.rooms_per_row = 3, .rows = 2, .turn = 0.3});
    const accel::Scene bare = accel::assemble(input);
    for (std::uint32_t c = 0; c < bare.view().cells.size(); ++c) {
        const accel::Cell& cell = bare.view().cells[c];
        if (cell.label != accel::Label::Room) continue;
        double x = 0, y = 0;
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
            x += double{bare.view().section_x[s]} / cell.section_count;
            y += double{bare.view().section_y[s]} / cell.section_count;
        }
        accel::InputLight light;
        light.id = "lamp-" + std::to_string(1000 + c);
        light.position = {x + 0.3, y - 0.2, cell.z_ceiling - 0.1};
        light.intensity = {80, 70, 60};
        input.lights.push_back(light);
    }
    return accel::assemble(input);
}

}  // namespace enfilade::test

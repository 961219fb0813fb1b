#pragma once
// The storeys of a flat scene seen from above: what a drawing needs, from the cells alone.

#include <cstdint>
#include <string>
#include <vector>

#include "accel/scene.h"
#include "tools/report/cell_layers.h"

namespace enfilade::tools {

struct SceneStorey {
    std::string name;
    std::uint32_t index = 0;  ///< `Space::storey_index` of its rooms
    float level = 0;  ///< at which it is cut to be drawn: 1.1 m above its floor, half its height at most; scene frame
};

/// The storeys that hold rooms, from the lowest index up.
[[nodiscard]] std::vector<SceneStorey> scene_storeys(const accel::SceneView& scene);

/// The cells of one space that a level cuts, as one outline.
struct SpaceOutline {
    accel::SpaceId space = {};
    accel::Label label = accel::Label::Room;
    std::size_t cells = 0;
    std::vector<std::vector<Mm>> rings;  ///< counter-clockwise, holes clockwise
};

/// What a level cuts of a scene; millimetres of the scene's frame, y up.
struct ScenePlan {
    std::vector<SpaceOutline> spaces;  ///< by space; the exterior is not among them
    std::vector<std::vector<Mm>>
        solid;                    ///< borders of walls and all else that light does not cross, with it on their left
    bool is_underground = false;  ///< no exterior at this level: `solid` has no outer border
    CellPlan inside;              ///< sides of cells
    CellPlan outside;             ///< portals between two cells of the exterior
    MmBox box;                    ///< around walls and rooms
};

[[nodiscard]] ScenePlan scene_plan(const accel::SceneView& scene, float level);

}  // namespace enfilade::tools

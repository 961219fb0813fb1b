#pragma once
// What each pixel's ray costs: pictures of numbers instead of light.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/camera.h"

namespace enfilade::render {

/// A number for each pixel, rows from the top; NaN where there is no ray (where a dollhouse shows paper or a cut wall).
struct PixelNumbers {
    int width = 0;
    int height = 0;
    std::vector<float> of_pixel;  ///< [width * height]
};

enum class RayCount {
    Cells,      ///< entered by the ray through the middle of the pixel, past all objects
    SideTests,  ///< vertical lines tested in them
    Leaves,     ///< of octrees, entered by the ray up to its first hit
    Blocks,     ///< of triangles tested in them (octree_counter.h)
    OfCell      ///< no count: the number that is given for the cell in which the ray ends, past all objects
};

class OctreeCounter;

/// Counts by the scalar walk in single precision, one ray a pixel. `cut_z`: as TraceOptions::cut_z. `executor`: nullptr
/// means all cores; the numbers do not depend on it. `octrees`: of this scene, for Leaves and Blocks; nullptr: none, so
/// these are 0. `of_cell`: [cell_count], for OfCell.
/// \throws InputError (R1, R2, R3) as `trace`
[[nodiscard]] PixelNumbers count_by_pixel(const accel::SceneView& scene, const Camera& camera, RayCount count,
                                          std::optional<double> cut_z = {}, const accel::Executor* executor = nullptr,
                                          const OctreeCounter* octrees = nullptr,
                                          std::span<const std::uint32_t> of_cell = {});

}  // namespace enfilade::render

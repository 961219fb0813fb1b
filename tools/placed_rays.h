#pragma once
// A block of rays in the frame of the scene, each with the cell where its walk begins.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/point_grid.h"
#include "render/vec.h"

namespace enfilade::tools {

/// Where a ray's walk begins.
enum class Start : std::uint8_t {
    Cell,     ///< in the cell that is named
    Face,     ///< on a face of the cell that is named, or up to `start_tolerance` behind it
    Site,     ///< beyond the site: `advance` metres ahead it enters the cell that is named
    Nowhere,  ///< beyond the site, and it never enters it
    Wall,     ///< in a solid
    Refused   ///< it is no ray
};

/// A ray that starts as deep as this behind the face through which it leaves a wall starts on that face: what a point
/// of a face is off by when it was computed in float. Metres.
inline constexpr double start_tolerance = 0.0005;

struct PlacedRay {
    render::Vec3d origin;     ///< metres, scene frame
    render::Vec3d direction;  ///< any length within what float holds
    double max_distance;      ///< metres; infinity where none was given
    double advance;           ///< metres, of Start::Site
    accel::CellId cell;       ///< none in walls and beyond the site
    Start start;
};

/// The rays of a block. numbers: [rays.size() * columns], as they stand in the file, in the frame of the plan.
void place_rays(const accel::SceneView& scene, const accel::PointGrid& grid, std::span<const double> numbers,
                std::size_t columns, std::vector<PlacedRay>& rays);

}  // namespace enfilade::tools

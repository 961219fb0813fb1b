#pragma once
// A walk through a building, as cameras.

#include <cstddef>
#include <vector>

#include "accel/scene.h"
#include "tools/view_file.h"

namespace enfilade::tools {

struct TourOptions {
    std::size_t views = 24;
    std::size_t rooms = 8;  ///< that the walk visits; the views are closer together in them than on the way between
};

/// Cameras at the height of eyes, looking ahead, along a walk that begins at a door to the outdoors where there is one,
/// and leads through rooms as far from each other as they are, up and down the stairs. Corners are rounded, so many
/// views make a film. Rooms that cannot be reached from the rest, by more people than not, are left out. The views are
/// as a view file holds them. The same scene gives the same tour. Cost: rooms times n log n of the cells, and some
/// walks a view.
/// \throws InputError (F137) where there is no room to walk in
[[nodiscard]] std::vector<SavedView> make_tour(const accel::SceneView& scene, const TourOptions& options = {});

}  // namespace enfilade::tools

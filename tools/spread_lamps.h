#pragma once
// Lamps for benchmarks: as many as wanted, spread over a building by floor area.

#include <cstddef>
#include <vector>

#include "accel/scene.h"
#include "plans/random.h"
#include "render/vec.h"

namespace enfilade::tools {

/// Where lamps hang.
enum class LampPlaces {
    Rooms,    ///< 0.1 m under their ceilings
    Hanging,  ///< 0.7 m under them: no ceiling is too bright
    Outside   ///< 4 m above the ground around the building, or half as high as a lower cell
};

/// `count` lamps of about 100 candela in several hues, one after the other along the floors' area, so that a room twice
/// as large has twice as many; the same on every machine. None where there is no such place. Their names are none.
[[nodiscard]] std::vector<accel::Light> spread_lamps(const accel::SceneView& scene, std::size_t count,
                                                     LampPlaces places);

/// A scene with other lamps than its own: the view of both.
[[nodiscard]] accel::SceneView with_lamps(const accel::SceneView& scene, const std::vector<accel::Light>& lamps);

/// A place in a cell, nowhere nearer to its walls than `inset` of the way to its middle.
[[nodiscard]] render::Vec3d random_place(const accel::SceneView& scene, const accel::Cell& cell, double inset,
                                         plans::Random& random);

/// m2
[[nodiscard]] double floor_area(const accel::SceneView& scene, const accel::Cell& cell);

}  // namespace enfilade::tools

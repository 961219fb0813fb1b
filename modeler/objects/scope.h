#pragma once
// What of a building pictures show: the cells whose objects their pixels may depend on (README.md, "Scopes").

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/parallel_for.h"
#include "accel/scene.h"

namespace enfilade::modeler {

/// From where pictures are taken. Both may be given.
struct ScopeEyes {
    std::vector<accel::SpaceId> rooms;  ///< from anywhere in them
    struct Point {
        accel::CellId cell = {};           ///< that holds it
        std::array<double, 3> position{};  ///< metres, scene frame
    };
    std::vector<Point> points;
};

/// What else than its line of sight a pixel may depend on.
struct ScopeLight {
    std::array<double, 3> sun = {0, 0, 0};  ///< towards it; of length 0: there is none
    double reach = 0;                       ///< metres: of the short rays that darken corners
    /// Lamps whose light is asked for at what is seen (points in the scene's frame, metres); those in solids light
    /// nothing.
    std::vector<std::array<double, 3>> lamps;
    bool mirrors = true;  ///< floors may be mirrors
};

/// Ascending cells and spaces of the scene.
struct Scope {
    std::vector<accel::CellId> cells;
    std::vector<accel::SpaceId> spaces;  ///< those cells'
    std::size_t seen = 0;                ///< cells that eyes see; the others are there for the light
    std::size_t darkening = 0;           ///< more of them, within reach of what is seen
    std::size_t sunlit = 0;              ///< more, that sunlight crosses on its way
    std::size_t lamplit = 0;             ///< more, that lamps' light crosses
};

/// All cells that hold something that can change a picture from these eyes, in a scene of which only what holds no
/// objects is known: an object outside of them is not seen, in no mirror either, and throws no shadow on anything seen.
/// Conservative: beams (accel/beam.h) with the margin of the float walk, so a few cells more than needed.
/// The same on any number of threads. Cost: the beams of the rooms' cells and of the points, then that of what they
/// see.
[[nodiscard]] Scope scope_of(const accel::SceneView& scene, const ScopeEyes& eyes, const ScopeLight& light,
                             const accel::Executor& executor = accel::SerialExecutor());

}  // namespace enfilade::modeler

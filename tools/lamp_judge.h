#pragma once
// Whether light trees know all lamps that a place sees: by walks in double precision that know nothing of them.

#include <cstdint>

#include "accel/lights/light_trees.h"
#include "render/object_tracer.h"

namespace enfilade::tools {

struct LampPairs {
    std::uint64_t pairs = 0;
    std::uint64_t seen = 0;          ///< the walk reaches the lamp
    std::uint64_t missed = 0;        ///< of these: it is not in the list of the place's cell
    std::uint64_t others = 0;        ///< the lamp's light by its tree is other than the walk's
    std::uint64_t outside_band = 0;  ///< of these: no edge is as near as roundings reach (render::error_band)

    LampPairs& operator+=(const LampPairs& other);
};

/// Judges `count` random pairs of a place and a lamp, half of them of lamps in the list of the place's cell. A pair is
/// missed only if the lamp is seen from places around as well, or the walk says so again from the lamp. objects: what
/// stands in the rooms, or nullptr. The same seed gives the same pairs. \pre the scene has lamps
[[nodiscard]] LampPairs judge_lamp_pairs(const accel::SceneView& scene, const accel::LightTreesView& trees,
                                         const render::ObjectTracer* objects, std::uint64_t seed, std::uint64_t count);

}  // namespace enfilade::tools

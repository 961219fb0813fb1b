#pragma once
// Inside of the reference: its loops for pictures lit by lamps, compiled by Highway for every instruction set and
// chosen where they run.

#include "accel/scene.h"
#include "render/embree_loops.h"

namespace enfilade::render::detail {

/// A rectangle of a lit picture.
struct EmbreeLitTile {
    EmbreeTile tile;
    const accel::Light* lights;
    const std::uint32_t* offsets;  ///< [cell_count + 1] into `lamps`
    const std::uint32_t* lamps;    ///< of each cell
    float exposure;
    const std::uint32_t* cells;  ///< of the whole image's pixels
    // First hits in blocks of 4 x 4 pixels; nullptr: primary rays are traced.
    const float* point[3];
    const float* normal[3];
    const float* colour[3];
    const std::uint8_t* is_lit;
    bool coherent_shadows;
    bool from_lamps;
};

/// Writes what a rectangle's primary rays hit, in blocks of 4 x 4 pixels of the whole image.
struct EmbreePlacesTile {
    EmbreeTile tile;
    float* point[3];
    float* normal[3];
    float* colour[3];
    std::uint8_t* is_lit;
};

/// Shadow rays are kept this far (metres) off the places that they leave.
inline constexpr float shadow_skin = 1e-3f;

/// `lanes` rays a call: 1, 8 or 16.
void embree_lit_tile(const EmbreeLitTile& job, int lanes);
/// By sixteen rays a call.
void embree_places_tile(const EmbreePlacesTile& job);

}  // namespace enfilade::render::detail

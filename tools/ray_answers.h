#pragma once
// What `enfilade trace` writes about each ray: records as numpy reads them (docs/queries.md).

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/crossings.h"
#include "tools/npy.h"

namespace enfilade::tools {

enum class RayStatus : std::uint8_t {
    Hit,      ///< met a face that light does not pass, or an object
    Sky,      ///< left the site
    Reached,  ///< came as far as its maximal distance
    Wall,     ///< starts inside a wall, a slab or the ground
    Refused,  ///< is no ray: a number is NaN or infinite, it has no direction, or its distance is below zero
    Leak      ///< its walk did not end: a defect of ours
};
inline constexpr int ray_status_count = 6;

/// One record a ray of `--query nearest`. Numbers that do not apply are 2^32 - 1 and 255, distances infinity or NaN.
struct HitRecord {
    double distance;              ///< metres
    std::array<float, 3> normal;  ///< of the face or triangle, unit, towards where the ray came from
    std::uint32_t face;           ///< source face
    std::uint32_t cell;           ///< the last one
    std::uint32_t space;          ///< of that cell
    std::uint32_t material;
    std::uint32_t object;    ///< that was met instead of a face
    std::uint32_t triangle;  ///< of that object's mesh
    std::uint8_t surface;
    std::uint8_t label;  ///< of that cell
    RayStatus status;
    std::uint8_t reserved;
};
static_assert(sizeof(HitRecord) == 48 && offsetof(HitRecord, face) == 20 && offsetof(HitRecord, status) == 46);

/// `--query any`: what lies between a ray's origin and its maximal distance.
enum class SightStatus : std::uint8_t { Free, Blocked, Wall, Refused, Leak };

[[nodiscard]] std::vector<NpyField> hit_fields();
[[nodiscard]] std::vector<NpyField> passage_fields();

}  // namespace enfilade::tools

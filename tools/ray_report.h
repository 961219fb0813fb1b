#pragma once
// What happened to the rays of a picture, for people and for programs.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "render/walk_events.h"

namespace enfilade::tools {

/// Lines for a person: cells and side tests a ray, packets, how many pixels they filled, recoveries and leaks.
/// `pixels`: of all pictures that the rays were for.
[[nodiscard]] std::string ray_report(const render::RayStats& stats, std::uint64_t pixels);

/// The same numbers, as they were counted and by the ray.
[[nodiscard]] nlohmann::ordered_json ray_json(const render::RayStats& stats, std::uint64_t pixels);

}  // namespace enfilade::tools

#pragma once
// What a plan may hold, whatever file it comes from. Readers refuse or drop what lies beyond; `write_json` and
// `read_json` therefore agree on every plan that a reader lets through.

namespace enfilade::plans::limits {

inline constexpr double coordinate = 1e7;  ///< metres from the origin: map projections fit
inline constexpr double elevation = 1e5;   ///< metres above and below 0
inline constexpr double height = 1e4;      ///< metres
inline constexpr double thickness = 1e3;   ///< metres
inline constexpr double lumen = 1e9;

}  // namespace enfilade::plans::limits

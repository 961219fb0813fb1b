#pragma once
// Numbers that float holds exactly, as doubles.

#include "render/vec.h"

namespace enfilade::test {

/// Through memory: the vectoriser of GCC 12 drops the way to float and back where it meets two of them side by side.
inline double rounded_to_float(double value) {
    const volatile float rounded = static_cast<float>(value);
    return rounded;
}

inline render::Vec3d rounded_to_float(render::Vec3d v) {
    return {rounded_to_float(v.x), rounded_to_float(v.y), rounded_to_float(v.z)};
}

}  // namespace enfilade::test

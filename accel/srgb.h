#pragma once
// The transfer curve of sRGB (IEC 61966-2-1), without the mathematics library: host and device, at compile time too.

#include <array>
#include <cstdint>

#include "accel/host_device.h"

namespace enfilade::accel {

/// The fifth root of x in [0, 1], by Newton's method: to the last bits of double.
constexpr double fifth_root(double x) {
    if (x <= 0) return 0;
    double root = 1;
    for (int i = 0; i < 64; ++i) {
        const double next = root - (root - x / (root * root * root * root)) / 5;
        if (next >= root) break;  // from above it falls until it stands
        root = next;
    }
    return root;
}

/// Linear light of a stored value in [0, 1]: ((v + 0.055) / 1.055)^2.4 above 0.04045.
constexpr double linear_of_srgb(double value) {
    if (value <= 0.04045) return value / 12.92;
    const double base = (value + 0.055) / 1.055;
    const double root = fifth_root(base * base);
    return base * base * root;
}

inline constexpr std::array<float, 256> srgb_table = [] {
    std::array<float, 256> table{};
    for (int i = 0; i < 256; ++i) table[static_cast<std::size_t>(i)] = static_cast<float>(linear_of_srgb(i / 255.0));
    return table;
}();

/// Linear light of a byte.
ENFILADE_HD float linear_of_byte(std::uint8_t byte) {
#if defined(__CUDA_ARCH__)
    return static_cast<float>(linear_of_srgb(byte / 255.0));  // a device has no view of the host's tables
#else
    return srgb_table.data()[byte];
#endif
}

}  // namespace enfilade::accel

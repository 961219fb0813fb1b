#pragma once
// Pictures lit by lamps, pixel by pixel: which differences rounding explains.

#include <cstdint>
#include <string>

#include "render/framebuffer.h"
#include "render/image.h"

namespace enfilade::test {

/// What became of the pixels of a picture. One differs where a channel is off by more than its tolerance: two steps of
/// 255, or 1e-3 of itself. That is explained where an edge, of a thing or of a shadow, passes: where every channel lies
/// among those that the expected picture has there or in the eight pixels around.
struct LitVerdict {
    std::uint64_t pixels = 0;
    std::uint64_t bright = 0;       ///< expected to be brighter than a tenth of white
    std::uint64_t differing = 0;    ///< the unexplained ones, too
    std::uint64_t unexplained = 0;  ///< faults
    std::string first;              ///< unexplained one, in words

    [[nodiscard]] std::string text() const;
    void add(const LitVerdict& other);
};

/// \pre the pictures have the same size
[[nodiscard]] LitVerdict compare(const render::Framebuffer& expected, const render::Framebuffer& actual);
[[nodiscard]] LitVerdict compare(const render::Image& expected, const render::Image& actual);

}  // namespace enfilade::test

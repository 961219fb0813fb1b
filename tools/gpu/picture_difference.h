#pragma once
// Two pictures of one view, pixel by pixel.

#include <cstdint>
#include <string>

#include "render/framebuffer.h"

namespace enfilade::tools::gpu {

/// What became of the pixels.
struct PictureDifference {
    std::uint64_t pixels = 0;
    std::uint64_t exact = 0;        ///< bit by bit
    std::uint64_t same = 0;         ///< no channel is off by more than the tolerance; the exact ones, too
    std::uint64_t at_edges = 0;     ///< of the others: every channel lies among those around the pixel
    std::uint64_t unexplained = 0;  ///< the rest
    std::uint64_t leaks = 0;        ///< magenta: no surface was found
    std::string first;              ///< unexplained pixel, or leak, in words

    void add(const PictureDifference& other);
};

/// steps: of 255, by which a channel may be off. \pre the pictures have the same size
[[nodiscard]] PictureDifference difference(const render::Framebuffer& expected, const render::Framebuffer& actual,
                                           int steps);

}  // namespace enfilade::tools::gpu

#pragma once
// What is counted of a picture by packets. Plain data.

#include <cstdint>

#include "render/walk_events.h"

namespace enfilade::render::cuda {

/// Costs nothing.
struct NoPacketEvents : NoEvents {
    ENFILADE_HD void walked_corners(int) {}
    ENFILADE_HD void stepped() {}
    ENFILADE_HD void split(int) {}
    ENFILADE_HD void filled(std::uint64_t) {}
    ENFILADE_HD void filled_tiles(int) {}
    ENFILADE_HD void walked_pixels(int) {}
    ENFILADE_HD void walked_from_start() {}
};

/// `Events` of a picture. A warp's 32 lanes do what one of them does: rounds are what a card's time goes by.
struct PacketCounts : NoEvents {
    std::uint64_t corner_rounds = 0;  ///< times that a warp set out with the corners of up to eight tiles
    std::uint64_t corner_steps = 0;   ///< cells that these rounds went through, in lockstep
    std::uint64_t tiles = 0;          ///< whose corners were walked
    std::uint64_t splits = 0;         ///< tiles whose corners did not agree
    std::uint64_t filled_pixels = 0;  ///< of tiles whose corners agreed
    std::uint64_t fill_rounds = 0;    ///< times that a warp's lanes wrote up to four pixels each
    std::uint64_t single_pixels = 0;  ///< walked by themselves
    std::uint64_t pixel_rounds = 0;   ///< times that a warp's lanes walked up to 32 of these
    std::uint64_t from_start = 0;     ///< of these: walked again from the eye, being rare cases
    std::uint64_t cells = 0;          ///< entered by corner rays and single ones

    ENFILADE_HD void entered_cell(std::uint32_t) { ++cells; }
    ENFILADE_HD void walked_corners(int tiles_) {
        ++corner_rounds;
        tiles += static_cast<std::uint64_t>(tiles_);
    }
    ENFILADE_HD void stepped() { ++corner_steps; }
    ENFILADE_HD void split(int tiles_) { splits += static_cast<std::uint64_t>(tiles_); }
    ENFILADE_HD void filled(std::uint64_t pixels) { filled_pixels += pixels; }
    ENFILADE_HD void filled_tiles(int rounds) { fill_rounds += static_cast<std::uint64_t>(rounds); }
    ENFILADE_HD void walked_pixels(int pixels) {
        ++pixel_rounds;
        single_pixels += static_cast<std::uint64_t>(pixels);
    }
    ENFILADE_HD void walked_from_start() { ++from_start; }
};

}  // namespace enfilade::render::cuda

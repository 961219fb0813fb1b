#pragma once
// How a walk can end, and what is counted on its way. Plain data, shared by all instruction sets.

#include <cstdint>

#include "accel/host_device.h"

namespace enfilade::render {

enum class WalkStatus : std::uint32_t {
    Hit,      ///< ends at a source face, solid or Sky
    Reached,  ///< the distance limit lies inside `cell`
    Leak,     ///< did not end within the bound on steps: a defect
    Refused,  ///< was no ray: a number is NaN or infinite, or the direction is zero
    Object    ///< ends at a triangle of an object
};

enum class Exit : std::uint32_t { Side, Floor, Ceiling };

/// What happened on the way. `NoEvents` costs nothing.
struct NoEvents {
    ENFILADE_HD void began_walk() {}
    ENFILADE_HD void entered_cell(std::uint32_t) {}
    ENFILADE_HD void several_exits() {}
    ENFILADE_HD void no_exit() {}
    ENFILADE_HD void leaked() {}
    ENFILADE_HD void crossed_glass() {}
    ENFILADE_HD void crossed(std::uint32_t) {}
    ENFILADE_HD void began_tile() {}
    ENFILADE_HD void split_tile() {}
    ENFILADE_HD void filled_tile(std::uint64_t) {}
    ENFILADE_HD void considered_lamp() {}
    ENFILADE_HD void lit_by_lamp() {}
};

/// What is counted of many rays. A packet's steps count once, whatever number of rays it stands for.
struct RayStats {
    std::uint64_t rays = 0;        ///< walks begun: of pixels, reflections, shadows and corners
    std::uint64_t cells = 0;       ///< cells entered, by rays and packets
    std::uint64_t side_tests = 0;  ///< vertical lines of these cells, each tested once, by rays and packets
    std::uint64_t several = 0;     ///< recoveries: sections accepted the ray at once, the farthest was taken
    std::uint64_t none = 0;        ///< recoveries: no section accepted it, the one that missed by least was taken
    std::uint64_t leaks = 0;
    std::uint64_t glass = 0;
    std::uint64_t tiles = 0;             ///< packets begun
    std::uint64_t splits = 0;            ///< packets whose corners left a cell by different faces
    std::uint64_t filled = 0;            ///< pixels that whole packets filled
    std::uint64_t lamps_considered = 0;  ///< pairs of a place and a lamp that was looked for there
    std::uint64_t lamps_lit = 0;         ///< those in whose light the place lies

    ENFILADE_HD void began_walk() { ++rays; }
    /// sections: of the cell
    ENFILADE_HD void entered_cell(std::uint32_t sections) {
        ++cells;
        side_tests += sections;
    }
    ENFILADE_HD void several_exits() { ++several; }
    ENFILADE_HD void no_exit() { ++none; }
    ENFILADE_HD void leaked() { ++leaks; }
    ENFILADE_HD void crossed_glass() { ++glass; }
    ENFILADE_HD void crossed(std::uint32_t) {}
    ENFILADE_HD void began_tile() { ++tiles; }
    ENFILADE_HD void split_tile() { ++splits; }
    ENFILADE_HD void filled_tile(std::uint64_t pixels) { filled += pixels; }
    ENFILADE_HD void considered_lamp() { ++lamps_considered; }
    ENFILADE_HD void lit_by_lamp() { ++lamps_lit; }
    ENFILADE_HD void add(const RayStats& other) {
        rays += other.rays;
        cells += other.cells;
        side_tests += other.side_tests;
        several += other.several;
        none += other.none;
        leaks += other.leaks;
        glass += other.glass;
        tiles += other.tiles;
        splits += other.splits;
        filled += other.filled;
        lamps_considered += other.lamps_considered;
        lamps_lit += other.lamps_lit;
    }
};

}  // namespace enfilade::render

#pragma once
// How a walk can end, and what is counted on its way. Plain data, shared by all instruction sets.

#include <cstdint>

#include "accel/host_device.h"

namespace enfilade::render {

enum class WalkStatus : std::uint32_t {
    Hit,      ///< ends at a source face, solid or Sky
    Reached,  ///< the distance limit lies inside `cell`
    Leak,     ///< did not end within the bound on steps: a defect
    Refused   ///< was no ray: a number is NaN or infinite, or the direction is zero
};

enum class Exit : std::uint32_t { Side, Floor, Ceiling };

/// What happened on the way. `NoEvents` costs nothing.
struct NoEvents {
    ENFILADE_HD void entered_cell() {}
    ENFILADE_HD void several_exits() {}
    ENFILADE_HD void no_exit() {}
    ENFILADE_HD void leaked() {}
    ENFILADE_HD void crossed_glass() {}
    ENFILADE_HD void crossed(std::uint32_t) {}
};

struct RayStats {
    std::uint64_t cells = 0;
    std::uint64_t several = 0;  ///< sections accepted the ray at once: the farthest was taken
    std::uint64_t none = 0;     ///< no section accepted it: the one that missed by least was taken
    std::uint64_t leaks = 0;
    std::uint64_t glass = 0;

    ENFILADE_HD void entered_cell() { ++cells; }
    ENFILADE_HD void several_exits() { ++several; }
    ENFILADE_HD void no_exit() { ++none; }
    ENFILADE_HD void leaked() { ++leaks; }
    ENFILADE_HD void crossed_glass() { ++glass; }
    ENFILADE_HD void crossed(std::uint32_t) {}
    ENFILADE_HD void add(const RayStats& other) {
        cells += other.cells;
        several += other.several;
        none += other.none;
        leaks += other.leaks;
        glass += other.glass;
    }
};

}  // namespace enfilade::render

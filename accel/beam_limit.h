#pragma once
// Keeps the number of beams down: where many come through one portal, one that covers them goes on.

#include <cstdint>
#include <vector>

#include "accel/beam_step.h"

namespace enfilade::accel {

/// Remembers what came through each portal from each side. The first `max_beams` pass as they are. Later ones pass only
/// if they hold something that has not passed, widened to all that came after the first; after a few of these,
/// everything that gets from the source to the portal passes, regardless of what lies between, and nothing after that.
/// So the number of beams is bounded by a multiple of the portals in sight, and no ray is lost.
class BeamLimit {
public:
    /// max_beams 0: all pass.
    BeamLimit(std::size_t portal_count, std::uint32_t max_beams);
    /// Forgets all. O(1).
    void clear() { arrivals_.clear(); }
    /// Whether the step adds something; if so it may have been widened. `is_front`: it leaves the portal's front cell.
    [[nodiscard]] bool admit(BeamStep& step, bool is_front, const BeamSource& source, std::int64_t margin,
                             PlanHistory& history);

private:
    struct Arrivals {
        std::uint32_t side;  ///< 2 * portal, + 1 from its back
        std::uint32_t count = 0;
        std::uint32_t widened = 0;
        bool is_whole = false;  ///< all that comes from the source has passed
        Beam hull = {};         ///< of what came after the first ones
    };
    [[nodiscard]] Arrivals& arrivals_at(std::uint32_t side);

    std::uint32_t max_beams_;
    std::vector<Arrivals> arrivals_;
    std::vector<std::uint32_t> place_of_side_;  ///< [2 * portal_count], in arrivals_ where that one says the same side
};

}  // namespace enfilade::accel

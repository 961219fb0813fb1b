#pragma once
// Internal to plans/: who owns each face in each storey, and which faces are one place.

#include <cstdint>
#include <vector>

#include "plans/arrange_parts.h"

namespace enfilade::plans {

[[nodiscard]] constexpr bool is_solid(OwnerKind kind) {
    return kind == OwnerKind::Wall || kind == OwnerKind::Opening || kind == OwnerKind::Column;
}

/// The strongest region over each face, per storey ([storey_count][face_count]); Room where there is none.
[[nodiscard]] std::vector<std::vector<Owner>> strongest_owners(const Overlay& overlay,
                                                               const std::vector<Region>& regions,
                                                               std::size_t storey_count);

/// The places of one storey: faces without solids, connected across edges that are no border between rooms.
struct Places {
    struct Place {
        std::int64_t area2 = 0;
        double perimeter = 0;          ///< grid units
        std::uint32_t first_face = 0;  ///< its least face
        bool exterior = false;         ///< reaches the site box
        bool pierced = false;          ///< a stair or shaft lies in it
    };
    std::vector<std::uint32_t> of_face;  ///< [face_count] kNone in solids
    std::vector<Place> places;           ///< by ascending least face; place 0 is the exterior
};

[[nodiscard]] Places find_places(const Overlay& overlay, const std::vector<SegmentTag>& tags,
                                 const std::vector<Owner>& owner, std::uint32_t storey);

}  // namespace enfilade::plans

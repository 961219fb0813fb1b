#pragma once
// What leads from one space to another: doors, windows, openings, borders without a wall, stairs.

#include <cstdint>
#include <vector>

#include "tools/report/plan_view.h"

namespace enfilade::tools {

enum class PassageKind : std::uint8_t { Door, Window, Opening, Border, Stair };

struct Passage {
    PassageKind kind = PassageKind::Door;
    std::uint32_t storey = 0;          ///< of stairs: the lower one
    std::uint32_t space = UINT32_MAX;  ///< the door, window, opening or well; none for a border
    std::uint32_t from = 0;            ///< space, the lower of both; of stairs: below
    std::uint32_t to = 0;
    Mm at_from;  ///< middle of where it meets `from`
    Mm at_to;
};

inline constexpr std::uint32_t unreachable = UINT32_MAX;

struct Passages {
    std::vector<Passage> list;         ///< by space of the opening, borders last by their spaces
    std::vector<std::uint32_t> depth;  ///< [space] passages but windows from the exterior; `unreachable`
};

[[nodiscard]] Passages find_passages(const PlanView& view);

}  // namespace enfilade::tools

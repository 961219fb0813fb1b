#pragma once
// Rooms furnished by rule.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "accel/parallel_for.h"
#include "base/finding.h"
#include "modeler/building.h"
#include "modeler/catalogue/catalogue.h"
#include "modeler/furnishing/rules.h"

namespace enfilade::modeler {

struct FurnishOptions {
    std::uint64_t seed = 1;
    std::vector<std::uint32_t> spaces;  ///< the rooms to furnish, into Building::spaces; empty: all of them
};

/// What became of a room.
struct RoomFurnished {
    std::uint32_t space = 0;
    std::string kind;             ///< of rules that applied; empty: none did
    std::uint32_t requested = 0;  ///< objects that its rules asked for
    std::uint32_t placed = 0;
    std::vector<std::string> not_placed;  ///< kinds that found no place, once each, with why
};

struct Furnished {
    Furnishing furnishing;             ///< what the building held and what was added, by ascending id
    std::vector<RoomFurnished> rooms;  ///< by space
    std::vector<Finding> findings;     ///< rooms too small, requests without a place, kinds in no catalogue
};

/// Furnishes rooms by rule, around what `building.furnishing` holds already. Guaranteed for what is added: no two
/// objects share a place (but for what stands on, or under, another by a rule that says so), none leaves its room, no
/// door's sweep is blocked, and every door of a room is reached from every other by a disc of 0.3 m radius wherever it
/// was before. Each room is furnished by itself, its random numbers keyed by (seed, room id, rule), so the same rooms
/// come out whatever others are asked for and on any number of threads. Ends quickly: tries are counted.
[[nodiscard]] Furnished furnish(const Building& building, const Rules& rules, const Catalogue& catalogue,
                                const FurnishOptions& options,
                                const accel::Executor& executor = accel::SerialExecutor());

}  // namespace enfilade::modeler

#pragma once
// Rooms of every kind that has ever made a cutter fall over, each from a seed.

#include <cstdint>
#include <span>
#include <string_view>

#include "tests/support/room.h"

namespace enfilade::testing {

struct RoomFamily {
    std::string_view name;
    std::uint32_t number;
};

/// The families of small rooms: up to some 200 corners.
[[nodiscard]] std::span<const RoomFamily> room_families();

/// The same room for the same seed on every machine whose `sin` and `cos` round alike. Most rooms are turned by some
/// angle, some lie at the rim of the grid (2^24), some have sides bent by lines that cross them.
[[nodiscard]] Room random_room(const RoomFamily& family, std::uint64_t seed);

/// Some 10,000 corners.
enum class LargeRoom : std::uint8_t { Comb, Star, Spiral, Circle, Columns, CurvedCorridor };
[[nodiscard]] Room large_room(LargeRoom kind, std::uint32_t corners, std::uint64_t seed);

}  // namespace enfilade::testing

#pragma once
// One room, cut by every cutter and judged.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "tests/support/partition_checks.h"
#include "tests/support/room.h"

namespace enfilade::modeler {

struct Cutter {
    const char* name;
    testing::PartitionWish wish;
    const Cutter* discs;  ///< takes what this one makes of a room, a ring at a time
    Partition (*cut)(const testing::Room&);
};

/// Those of modeler/cutting; ENFILADE_CUTTER=sah: `cut_in_every_way` takes those with that in their name.
[[nodiscard]] std::span<const Cutter> cutters();

/// Of one cutter over the rooms of one family.
struct Tally {
    std::uint64_t rooms = 0, pieces = 0, moved = 0, fallen_back = 0, thin_walls = 0, thin_corners = 0, thin_cuts = 0;
    std::uint64_t failures = 0, unused = 0;
    std::uint64_t ring_pieces = 0, ring_bound = 0;  ///< of rooms that are one ring; ceil(reflex corners / 2) + 1 each
    double stray = 0, dent = 0;

    void add(const testing::Room& room, const Partition& partition, const testing::PartitionVerdict& verdict);
    /// A line for tools/campaign.sh.
    void print(std::string_view family, std::string_view cutter) const;
};

/// Fails the test where a partition is none, with the least room that fails alike, which is kept in a file. A cutter
/// that aborts or takes a minute is named, and the room kept as well. \pre a tally for each of `cutters`
void cut_in_every_way(const testing::Room& room, const std::string& name, std::span<Tally> tallies);

}  // namespace enfilade::modeler

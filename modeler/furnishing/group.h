#pragma once
// What is placed together: a table with its chairs, a bed with its tables and their lamps.

#include <vector>

#include "modeler/furnishing/entry_lists.h"
#include "modeler/furnishing/occupancy.h"
#include "modeler/furnishing/wall_run.h"

namespace enfilade::modeler {

/// One rule with all that was drawn for it before anything is placed: so many of it, of these entries, with these.
struct Draft {
    const ObjectRule* rule = nullptr;
    std::uint32_t count = 1;
    std::vector<const CatalogueEntry*> tries;         ///< for each of them, in this order
    std::vector<Draft> with;                          ///< of each of them; `Under` first: what comes on it is raised
    bool known = true;                                ///< some catalogue has a piece of it
    [[nodiscard]] std::uint32_t pieces_each() const;  ///< itself and all that comes with it
};

/// Draws entries and what comes with it. style: pieces of one kind that stand in a room are alike by it, but for
/// pictures and what stands on others.
[[nodiscard]] Draft draft(const ObjectRule& rule, std::uint32_t count, const EntryLists& entries, plans::Random& random,
                          std::uint64_t style);

/// Places the pieces of one group around its first one.
class GroupPlacer {
public:
    GroupPlacer(Occupancy& occupancy, std::uint32_t group, std::uint64_t key)
        : occupancy_(occupancy), group_(group), random_{key} {}

    /// Tries the first piece there with all that comes with it. Returns how many were placed; 0 where the first one,
    /// or one that it needs, finds no place: the occupancy is as before then.
    std::uint32_t place(const Draft& draft, const CatalogueEntry& entry, const Pose& pose, double elevation,
                        bool hangs);
    /// The rules of what came with it and found no place, in whole or in part, in the last `place`.
    [[nodiscard]] const std::vector<const ObjectRule*>& missing() const { return missing_; }

private:
    struct Slot {
        Pose pose;
        double elevation = 0;
        std::uint32_t carrier = UINT32_MAX;
        bool hangs = false;
        double width = 0, depth = 0;  ///< metres; 0: as the entry
    };

    bool place_with(std::uint32_t parent, const std::vector<Draft>& drafts);
    bool put(const Draft& draft, const CatalogueEntry& entry, const Slot& slot);
    [[nodiscard]] bool keeps_clear(const Body& body, const Clearance& clearance, std::vector<Ring>& floors) const;

    [[nodiscard]] std::vector<Slot> slots(std::uint32_t parent, const Draft& draft, const CatalogueEntry& entry);
    [[nodiscard]] std::vector<Slot> around(const Body& parent, const Draft& draft, const CatalogueEntry& entry) const;
    [[nodiscard]] std::vector<Slot> on_top(std::uint32_t parent, const Draft& draft, const CatalogueEntry& entry);
    [[nodiscard]] std::vector<Slot> above(const Body& parent, const Draft& draft, const CatalogueEntry& entry) const;
    [[nodiscard]] std::vector<Slot> opposite(const Body& parent, const Draft& draft, const CatalogueEntry& entry);
    bool put_under(std::uint32_t parent, const Draft& draft);
    bool put_in_row(std::uint32_t parent, const Draft& draft, std::array<double, 2>& ends);

    Occupancy& occupancy_;
    std::uint32_t group_;
    plans::Random random_;
    std::uint32_t placed_ = 0;
    std::vector<const ObjectRule*> missing_;
};

}  // namespace enfilade::modeler

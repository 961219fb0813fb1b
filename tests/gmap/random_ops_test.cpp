// Random strings of operations: whatever was done, the map is a map, its cells are its orbits, and each step can be
// undone.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <optional>

#include "gmap/attribute.h"
#include "gmap/close.h"
#include "gmap/insert.h"
#include "gmap/isomorphism.h"
#include "gmap/remove.h"
#include "gmap/sew.h"
#include "gmap/text.h"
#include "maps.h"
#include "random_ops.h"

namespace enfilade::gmap {
namespace {

std::int64_t euler(const Map& map) {
    return static_cast<std::int64_t>(map.vertex_count() + map.face_count()) -
           static_cast<std::int64_t>(map.edge_count() + map.volume_count());
}

TEST(RandomOperations, KeepEveryInvariant) {
    EXPECT_TRUE(rc::check("strings of operations", [] {
        Map map = random_start();
        for (const Step& step : *rc::gen::container<std::vector<Step>>(rc::gen::arbitrary<Step>())) {
            const MapArrays before = map.arrays();
            const auto done = apply(map, step);
            if (!done) {
                RC_ASSERT(map.arrays().alpha == before.alpha);
                RC_ASSERT(map.arrays().cell_id == before.cell_id);
                continue;
            }
            const Validation found = validate(map);
            // Merging neighbours that meet twice makes cells that touch themselves, and cutting corners small ones;
            // nothing else may go wrong.
            for (const Defect& defect : found.defects)
                RC_ASSERT(defect.code == "T4" || defect.code == "T5" || defect.code == "T6");
            RC_ASSERT(static_cast<bool>(all_ids_are_orbits(map)));
            RC_ASSERT(euler(map) == 0);
        }
    }));
}

TEST(RandomOperations, InsertionsKeepASoundMapSound) {
    EXPECT_TRUE(rc::check("insertions", [] {
        Map map = random_start();
        for (Step step : *rc::gen::container<std::vector<Step>>(rc::gen::arbitrary<Step>())) {
            step.kind %= 3;
            step.keeps_sizes = true;
            if (!apply(map, step)) continue;
            const Validation found = validate(map);
            RC_ASSERT(found.is_sound() && found.suppressed == 0);
        }
    }));
}

TEST(RandomOperations, AreUndoneByTheirInverse) {
    EXPECT_TRUE(rc::check("operation, then its inverse", [] {
        Map map = random_start();
        for (const Step& step : *rc::gen::container<std::vector<Step>>(rc::gen::arbitrary<Step>())) {
            const Map before = map;
            const auto done = apply(map, step);
            if (!done || step.kind % kind_count >= 3) continue;
            Map undone = map;
            const auto inverse = undo(undone, step, *done);
            RC_ASSERT(inverse.has_value());
            RC_ASSERT(is_isomorphic(undone, before));
            RC_ASSERT(static_cast<bool>(all_ids_are_orbits(undone)));
            RC_ASSERT(cell_counts(undone) == cell_counts(before));
        }
    }));
}

TEST(RandomOperations, UnsewThenSewIsIsomorphic) {
    EXPECT_TRUE(rc::check("unsew and sew", [](std::uint32_t pick, std::uint8_t dimension) {
        const Map sound = random_start();
        Map map = sound;
        const DartId d{static_cast<std::uint32_t>(pick % map.dart_bound())};
        const int i = dimension % 4;
        const DartId e = map.alpha(i, d);
        RC_ASSERT(detail::unsew(map, i, d).has_value());
        RC_ASSERT(static_cast<bool>(all_ids_are_orbits(map)));
        for (const std::string& code : codes_of(validate(map))) RC_ASSERT(code == "T2");
        RC_ASSERT(detail::sew(map, i, d, e).has_value());
        RC_ASSERT(map.arrays().alpha == sound.arrays().alpha);
        RC_ASSERT(validate(map).is_sound());
    }));
}

TEST(RandomOperations, CloseUndoesTheRemovalOfVolumes) {
    EXPECT_TRUE(rc::check("remove a volume and close", [](std::uint32_t pick) {
        const Map sound = random_start();
        Map map = sound;
        RC_ASSERT(remove_volume(map, DartId{static_cast<std::uint32_t>(pick % map.dart_bound())}).has_value());
        close(map);
        RC_ASSERT(is_isomorphic(map, sound));
        RC_ASSERT(static_cast<bool>(all_ids_are_orbits(map)));
    }));
}

TEST(RandomOperations, AttributesCountTheOriginalCells) {
    // Each part of a split cell keeps the names of the whole, each union has those of its parts: no name is ever lost.
    EXPECT_TRUE(rc::check("attributes follow", [] {
        using Names = std::set<std::uint32_t>;
        Map map = random_start();
        AttributePolicy<Names> policy;
        policy.on_merge = [](const Names& kept, const Names& gone) {
            Names both = kept;
            both.insert(gone.begin(), gone.end());
            return both;
        };
        Attribute<VolumeId, Names> names(map, {}, policy);
        for (std::uint32_t v = 0; v < names.size(); ++v) names[VolumeId{v}] = {v};
        const std::size_t original = map.volume_count();
        for (const Step& step : *rc::gen::container<std::vector<Step>>(rc::gen::arbitrary<Step>()))
            if (const auto done = apply(map, step)) names.follow(*done);
        names.follow(map.compact());
        RC_ASSERT(names.size() == map.volume_count());
        Names all;
        for (std::uint32_t v = 0; v < names.size(); ++v) {
            RC_ASSERT(!names[VolumeId{v}].empty());
            all.insert(names[VolumeId{v}].begin(), names[VolumeId{v}].end());
        }
        RC_ASSERT(all.size() == original);
    }));
}

}  // namespace
}  // namespace enfilade::gmap

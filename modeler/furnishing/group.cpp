#include "modeler/furnishing/group.h"

#include <algorithm>
#include <cmath>

namespace enfilade::modeler {

std::uint32_t Draft::pieces_each() const {
    std::uint32_t sum = 1;
    for (const Draft& draft : with) sum += draft.count * draft.pieces_each();
    return sum;
}

Draft draft(const ObjectRule& rule, std::uint32_t count, const EntryLists& entries, plans::Random& random,
            std::uint64_t style) {
    Draft result;
    result.rule = &rule;
    result.count = count;
    result.known = false;
    for (const std::string& word : rule.object) {
        result.known = result.known || entries.knows(word);
        const bool varied = rule.place == Relation::OnWall || rule.place == Relation::OnTop;
        plans::Random look{style, hash_of(word), varied ? random.next() : 0};
        for (const CatalogueEntry* entry : entries.drawn(word, look, rule.place == Relation::Ceiling))
            result.tries.push_back(entry);
    }
    for (const ObjectRule& with : rule.with) {
        // Drawn whether it comes or not: what is drawn later does not depend on it.
        const bool comes = random.chance(with.probability);
        const std::uint32_t many = with.least + random.below(with.most - with.least + 1);
        Draft member = draft(with, many, entries, random, style);
        if (comes && many > 0) result.with.push_back(std::move(member));
    }
    std::stable_partition(result.with.begin(), result.with.end(),
                          [](const Draft& d) { return d.rule->place == Relation::Under; });
    return result;
}

std::uint32_t GroupPlacer::place(const Draft& draft, const CatalogueEntry& entry, const Pose& pose, double elevation,
                                 bool hangs) {
    const Occupancy::Mark before = occupancy_.mark();
    placed_ = 0;
    missing_.clear();
    if (put(draft, entry, {pose, elevation, UINT32_MAX, hangs, 0, 0})) return placed_;
    occupancy_.undo(before);
    return 0;
}

bool GroupPlacer::keeps_clear(const Body& body, const Clearance& clearance, std::vector<Ring>& floors) const {
    const double unit = occupancy_.room().frame.unit;
    const auto strip = [&](double front, double behind, double left, double right) {
        // Only the strip: the box's own extent that way is taken off.
        Body slim = body;
        const plans::Point along = body.pose.along(), look = body.pose.front();
        if (front > 0 || behind > 0) {
            slim.depth = 0;
            slim.pose.at = body.pose.at + look * ((front > 0 ? 0.5 : -0.5) * body.depth);
        } else {
            slim.width = 0;
            slim.pose.at = body.pose.at + along * ((right > 0 ? 0.5 : -0.5) * body.width);
        }
        return occupancy_.around(slim, front / unit, behind / unit, left / unit, right / unit);
    };
    const auto take = [&](Ring ring) {
        if (!occupancy_.is_free(ring, group_)) return false;
        floors.push_back(std::move(ring));
        return true;
    };
    if (clearance.front > 0 && !take(strip(clearance.front, 0, 0, 0))) return false;
    if (clearance.behind > 0 && !take(strip(0, clearance.behind, 0, 0))) return false;
    if (clearance.sides > 0 && (!take(strip(0, 0, clearance.sides, 0)) || !take(strip(0, 0, 0, clearance.sides))))
        return false;
    if (clearance.one_side > 0 && !take(strip(0, 0, clearance.one_side, 0)) &&
        !take(strip(0, 0, 0, clearance.one_side)))
        return false;
    return true;
}

bool GroupPlacer::put(const Draft& draft, const CatalogueEntry& entry, const Slot& slot) {
    Body body = slot.width > 0 ? occupancy_.body(entry, slot.pose, slot.elevation, slot.width, slot.depth)
                               : occupancy_.body(entry, slot.pose, slot.elevation);
    body.group = group_;
    body.carrier = slot.carrier;
    body.hangs = slot.hangs;
    if (!occupancy_.is_possible(body)) return false;
    std::vector<Ring> floors;
    if (!body.hangs && body.carrier == UINT32_MAX && !keeps_clear(body, draft.rule->clearance, floors)) return false;
    const Occupancy::Mark before = occupancy_.mark();
    const std::uint32_t placed_before = placed_;
    const std::size_t missing_before = missing_.size();
    for (Ring& ring : floors) occupancy_.add_free(std::move(ring), group_);
    const std::uint32_t index = occupancy_.add(std::move(body));
    ++placed_;
    if (place_with(index, draft.with)) return true;
    occupancy_.undo(before);
    placed_ = placed_before;
    missing_.resize(missing_before);
    return false;
}

bool GroupPlacer::place_with(std::uint32_t parent, const std::vector<Draft>& drafts) {
    const double half = occupancy_.bodies()[parent].width / 2;
    std::array<double, 2> row_ends = {half, half};
    for (const Draft& draft : drafts) {
        std::uint32_t done = 0;
        if (draft.rule->place == Relation::Under) {
            done += put_under(parent, draft);
        } else if (draft.rule->place == Relation::InRow) {
            for (std::uint32_t k = 0; k < draft.count; ++k) done += put_in_row(parent, draft, row_ends);
        } else {
            for (const CatalogueEntry* entry : draft.tries) {
                for (const Slot& slot : slots(parent, draft, *entry)) {
                    if (done == draft.count) break;
                    done += put(draft, *entry, slot);
                }
                if (done > 0) break;  // all of one kind
            }
        }
        if (done < draft.count && draft.known) missing_.push_back(draft.rule);
        // A table for six with one chair is no table for six.
        if (2 * done < draft.count && draft.rule->needed) return false;
    }
    return true;
}

}  // namespace enfilade::modeler

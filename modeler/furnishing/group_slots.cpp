// Where the pieces of a group may stand, relative to the one with which they come.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "modeler/furnishing/candidates.h"
#include "modeler/furnishing/group.h"

namespace enfilade::modeler {

using plans::Point;

namespace {

constexpr double pi = std::numbers::pi;

/// The place x along the parent's width and y behind its middle.
Point beside(const Body& parent, double x, double y) {
    return parent.pose.at + parent.pose.along() * x - parent.pose.front() * y;
}

}  // namespace

std::vector<GroupPlacer::Slot> GroupPlacer::slots(std::uint32_t index, const Draft& draft,
                                                  const CatalogueEntry& entry) {
    const Body parent = occupancy_.bodies()[index];
    const double unit = occupancy_.room().frame.unit;
    const double width = entry.width / unit, depth = entry.depth / unit, gap = draft.rule->gap / unit + 2;
    std::vector<Slot> result;
    switch (draft.rule->place) {
        case Relation::Beside: {
            const double x = parent.width / 2 + gap + width / 2, y = (parent.depth - depth) / 2;
            const double first = random_.chance(0.5) ? 1 : -1;
            for (const double side : {first, -first})
                result.push_back({{beside(parent, side * x, y), parent.pose.angle + (draft.rule->turned ? pi : 0)}});
            break;
        }
        case Relation::InFront: {
            const double y = -(parent.depth / 2 + gap + depth / 2);
            // Wide pieces leave room for more than one before them.
            for (const double x : {0.0, -parent.width / 4, parent.width / 4})
                result.push_back({{beside(parent, x, y), parent.pose.angle + (draft.rule->turned ? 0 : pi)}});
            break;
        }
        case Relation::Around: return around(parent, draft, entry);
        case Relation::OnTop: return on_top(index, draft, entry);
        case Relation::Above: return above(parent, draft, entry);
        case Relation::Opposite: return opposite(parent, draft, entry);
        default: break;
    }
    return result;
}

std::vector<GroupPlacer::Slot> GroupPlacer::around(const Body& parent, const Draft& draft,
                                                   const CatalogueEntry& entry) const {
    const double unit = occupancy_.room().frame.unit;
    const double width = entry.width / unit, depth = entry.depth / unit;
    const double gap = draft.rule->gap / unit + 2, between = 0.08 / unit;
    std::vector<Slot> result;
    if (parent.kind == "round_table") {
        // As many as fit side by side, their inner edges being the nearest.
        const double inner = std::max(parent.width, parent.depth) / 2 + gap;
        const double each = 2 * std::asin(std::min(1.0, (width + between) / (2 * inner)));
        const auto count = std::min<std::uint32_t>(draft.count, std::uint32_t(2 * pi / each));
        for (std::uint32_t k = 0; k < count; ++k) {
            // At 0 the chair stands behind the table, looking the way the table looks. Boxes may not overlap: between
            // the sides of the table's box it stands a little further out.
            const double turn = 2 * pi * k / count, s = std::sin(turn), c = std::cos(turn);
            const double radius = parent.width / 2 * std::abs(s) + parent.depth / 2 * std::abs(c) + gap + depth / 2;
            result.push_back({{beside(parent, radius * s, radius * c), parent.pose.angle - turn}});
        }
        return result;
    }
    const auto capacity = [&](double length) {
        return std::uint32_t(std::max(0.0, (length + between) / (width + between)));
    };
    const std::uint32_t along = capacity(parent.width), across = capacity(parent.depth);
    // Seats at the long sides first, both alike; then the heads.
    std::array<std::uint32_t, 4> seats = {0, 0, 0, 0};  // behind, before, right, left
    const bool wide = parent.width >= parent.depth;
    const std::array<std::uint32_t, 4> most = {along, along, across, across};
    const std::array<std::size_t, 4> order =
        wide ? std::array<std::size_t, 4>{0, 1, 2, 3} : std::array<std::size_t, 4>{2, 3, 0, 1};
    std::uint32_t left = draft.count;
    for (std::size_t pair = 0; pair < 2; ++pair)
        while (left > 0 && (seats[order[2 * pair]] < most[order[2 * pair]] ||
                            seats[order[2 * pair + 1]] < most[order[2 * pair + 1]]))
            for (const std::size_t side : {order[2 * pair], order[2 * pair + 1]})
                if (left > 0 && seats[side] < most[side]) {
                    ++seats[side];
                    --left;
                }
    constexpr std::array<double, 4> turns = {0, pi, -pi / 2, pi / 2};
    for (const std::size_t side : order)
        for (std::uint32_t k = 0; k < seats[side]; ++k) {
            const double length = side < 2 ? parent.width : parent.depth;
            const double u = length * ((k + 0.5) / seats[side] - 0.5);
            const double off = (side < 2 ? parent.depth : parent.width) / 2 + gap + depth / 2;
            const Point at = side == 0   ? beside(parent, u, off)
                             : side == 1 ? beside(parent, u, -off)
                             : side == 2 ? beside(parent, off, u)
                                         : beside(parent, -off, u);
            result.push_back({{at, parent.pose.angle + turns[side]}});
        }
    return result;
}

std::vector<GroupPlacer::Slot> GroupPlacer::on_top(std::uint32_t index, const Draft& draft,
                                                   const CatalogueEntry& entry) {
    const Body parent = occupancy_.bodies()[index];
    const double unit = occupancy_.room().frame.unit;
    const double width = entry.width / unit, depth = entry.depth / unit, rim = 0.01 / unit;
    const double x_most = (parent.width - width) / 2 - rim, y_most = (parent.depth - depth) / 2 - rim;
    // Where the catalogue tells of no top, things would float.
    if (x_most < 0 || y_most < 0 || parent.entry == nullptr || !parent.entry->top) return {};
    const double top = *parent.entry->top / unit;
    const bool is_round = parent.kind == "round_table" || parent.entry->name.find("ound") != std::string::npos;
    const auto is_over_edge = [&](double x, double y) {
        const double u = (std::abs(x) + width / 2) / (parent.width / 2);
        const double v = (std::abs(y) + depth / 2) / (parent.depth / 2);
        return is_round && u * u + v * v > 1;
    };
    const double elevation = std::ceil(parent.z_low + top - 1e-6) - occupancy_.room().z_floor;
    const bool large = width > 0.3 * parent.width || draft.rule->score.centre > 0, tall = entry.height > 0.25;
    std::vector<std::pair<double, Slot>> places;
    constexpr int steps = 6;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= 2; ++j) {
            const double x = x_most * (2.0 * i / steps - 1), y = y_most * (j - 1.0);
            if (is_over_edge(x, y)) continue;
            const double off_middle = std::abs(x) / (x_most > 0 ? x_most : 1);
            // What is large stands in the middle, what is small beside it; what is tall behind what is low.
            double good = large ? -2 * off_middle : off_middle;
            good += (tall ? 0.8 : 0.2) * (j - 1) + 0.5 * random_.uniform();
            places.push_back({good, {{beside(parent, x, y), parent.pose.angle}, elevation, index, false, 0, 0}});
        }
    std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Slot> result;
    for (const auto& [good, slot] : places) result.push_back(slot);
    return result;
}

std::vector<GroupPlacer::Slot> GroupPlacer::above(const Body& parent, const Draft& draft,
                                                  const CatalogueEntry& entry) const {
    const RoomShape& room = occupancy_.room();
    const double unit = room.frame.unit;
    const PieceSize size{entry.width / unit, entry.depth / unit};
    Pose pose{beside(parent, 0, (parent.depth - size.depth) / 2), parent.pose.angle};
    const auto at_wall = pushed_back(room, pose, size, 0, 0.35 / unit);
    if (!at_wall) return {};
    const double top = parent.z_high - room.z_floor;
    const double wanted = draft.rule->elevation >= 0 ? draft.rule->elevation / unit : entry.elevation / unit;
    const double over = std::max(wanted, top + draft.rule->gap / unit);
    std::vector<Slot> result;
    for (const double elevation : {over, top + 0.05 / unit})
        result.push_back({*at_wall, std::ceil(elevation), UINT32_MAX, true, 0, 0});
    return result;
}

std::vector<GroupPlacer::Slot> GroupPlacer::opposite(const Body& parent, const Draft& draft,
                                                     const CatalogueEntry& entry) {
    const RoomShape& room = occupancy_.room();
    const double unit = room.frame.unit, width = entry.width / unit, depth = entry.depth / unit;
    std::vector<std::pair<double, Slot>> places;
    const double least = draft.rule->gap / unit, most = draft.rule->most_gap / unit;
    for (double way = least; way <= most + 1; way += 0.2 / unit)
        for (const double aside : {0.0, -0.3, 0.3, -0.6, 0.6}) {
            const double y = -(parent.depth / 2 + way + depth / 2);
            const Pose pose{beside(parent, aside / unit, y), parent.pose.angle + pi};
            // Best with a wall behind it, or else about in the middle of the range.
            const double share = most > least ? (way - least) / (most - least) : 0.5;
            const double good = -0.8 * std::abs(aside) - std::abs(share - 0.4) + 0.2 * random_.uniform();
            places.push_back({good, {pose}});
            const auto at_wall = pushed_back(room, pose, {width, depth}, 0, 0.6 / unit);
            if (!at_wall) continue;
            const double way_there =
                plans::dot(at_wall->at - parent.pose.at, parent.pose.front()) - (parent.depth + depth) / 2;
            if (way_there >= least && way_there <= most) places.push_back({good + 1, {*at_wall}});
        }
    std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Slot> result;
    for (const auto& [good, slot] : places) result.push_back(slot);
    return result;
}

/// The parent, and what stands on it, is raised by the thickness of what lies under it.
bool GroupPlacer::put_under(std::uint32_t index, const Draft& draft) {
    const double unit = occupancy_.room().frame.unit;
    for (const CatalogueEntry* entry : draft.tries) {
        const Body parent = occupancy_.bodies()[index];
        if (parent.carrier != UINT32_MAX || parent.z_low != occupancy_.room().z_floor) return false;
        // Carpets are cut to size: 0.4 m beyond the piece at most.
        for (const double beyond : {0.4, 0.2, 0.1}) {
            Slot slot;
            slot.width = std::min(std::max(entry->width, entry->depth), parent.width * unit + 2 * beyond);
            slot.depth = std::min(std::min(entry->width, entry->depth), parent.depth * unit + 2 * beyond);
            if (parent.width < parent.depth) {
                slot.width = std::min(std::min(entry->width, entry->depth), parent.width * unit + 2 * beyond);
                slot.depth = std::min(std::max(entry->width, entry->depth), parent.depth * unit + 2 * beyond);
            }
            if (slot.width < parent.width * unit || slot.depth < parent.depth * unit) continue;
            slot.pose = parent.pose;
            Body raised = parent;
            Body carpet = occupancy_.body(*entry, slot.pose, 0, slot.width, slot.depth);
            const std::int32_t by = carpet.z_high - carpet.z_low;
            if ((by * unit) > 0.05) break;
            raised.z_low += by;
            raised.z_high += by;
            occupancy_.bodies()[index] = raised;
            const bool fits = raised.z_high <= occupancy_.room().z_ceiling && put(draft, *entry, slot);
            if (fits) {
                // `put` may have moved the bodies in memory.
                occupancy_.bodies()[index].carrier = std::uint32_t(occupancy_.bodies().size() - 1);
                return true;
            }
            occupancy_.bodies()[index] = parent;
        }
    }
    return false;
}

bool GroupPlacer::put_in_row(std::uint32_t index, const Draft& draft, std::array<double, 2>& ends) {
    const Body parent = occupancy_.bodies()[index];
    const double unit = occupancy_.room().frame.unit;
    const std::size_t first = random_.chance(0.5) ? 0 : 1;
    for (const CatalogueEntry* entry : draft.tries)
        for (const std::size_t side : {first, 1 - first}) {
            const double width = entry->width / unit, depth = entry->depth / unit;
            const double gap = draft.rule->gap / unit + 1;
            const double x = (side == 0 ? -1 : 1) * (ends[side] + gap + width / 2);
            Slot slot;
            slot.pose = {beside(parent, x, (parent.depth - depth) / 2), parent.pose.angle};
            if (!put(draft, *entry, slot)) continue;
            ends[side] += gap + width;
            return true;
        }
    return false;
}

}  // namespace enfilade::modeler

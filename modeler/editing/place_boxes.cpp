#include "modeler/editing/place_boxes.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/check.h"
#include "base/error.h"
#include "modeler/editing/footprint.h"
#include "modeler/editing/region_split.h"
#include "modeler/editing/split_edges.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

constexpr std::uint32_t no_index = UINT32_MAX;

std::string called(const Space& space) {
    if (space.label == Label::Exterior) return "the exterior";
    return "room \"" + (space.name.empty() ? space.id : space.name) + "\"";
}

struct Bounds {
    GridPoint min{INT32_MAX, INT32_MAX}, max{INT32_MIN, INT32_MIN};
    void add(GridPoint p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
    [[nodiscard]] bool meets(const Bounds& other, std::int32_t margin) const {
        return min.x <= other.max.x + margin && max.x >= other.min.x - margin && min.y <= other.max.y + margin &&
               max.y >= other.min.y - margin;
    }
};

class Placer {
public:
    Placer(const std::shared_ptr<const Stack>& bare, std::vector<Box> boxes) : bare_(*bare), stack_(*bare) {
        stack_.bare = bare;
        std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.id < b.id; });
        stack_.boxes = std::move(boxes);
    }

    Stack run() {
        for (std::uint32_t k = 0; k < stack_.boxes.size(); ++k) accept(k);
        find_regions();
        for (auto& [space, boxes] : boxes_of_) split_room(space, boxes);
        build_edges();
        build_regions();
        for (const auto& [space, boxes] : boxes_of_) refuse_full_room(space, boxes);
        return std::move(stack_);
    }

private:
    void accept(std::uint32_t k) {
        const Box& box = stack_.boxes[k];
        const auto refuse = [&](const std::string& why) { throw InputError("P503", "", called(box) + " " + why); };
        if (box.space >= bare_.spaces.size() ||
            (bare_.spaces[box.space].label != Label::Room && bare_.spaces[box.space].label != Label::Exterior))
            refuse("stands in no room: give it a room of the building, or the exterior.");
        if (k > 0 && stack_.boxes[k - 1].id == box.id) refuse("is there twice: give each box an id of its own.");
        if (!is_convex_ring(box.footprint))
            refuse("has a footprint that is no convex ring: give its corners counter-clockwise.");
        if (box.z_low >= box.z_high) refuse("has no height: its top must be above its bottom.");
        for (const GridPoint p : box.footprint)
            if (std::max(std::abs(std::int64_t(p.x)), std::abs(std::int64_t(p.y))) > 1 << 25)
                refuse("stands far outside the site: move it into its room.");
        const Space& room = bare_.spaces[box.space];
        first_line_.push_back(stack_.line_count);
        stack_.line_count += std::uint32_t(box.footprint.size());
        stack_.spaces.push_back(
            {.label = Label::Object, .id = box.id, .name = box.name, .storey = room.storey, .room = box.space});
        boxes_of_[box.space].push_back(k);
        footprints_.emplace_back();
    }

    /// Calls visit(slice, z_low) for each slice of the columns of a region.
    template <class Visit>
    void for_each_slice(const Region& region, Visit visit) const {
        for (std::uint32_t b = region.first_band; b <= region.last_band; ++b) {
            const Column& column = stack_.columns[stack_.region_columns[region.first_column + b - region.first_band]];
            std::int32_t z = stack_.bands[b].z_low;
            for (std::uint32_t s = column.first_slice; s < column.first_slice + column.slice_count; ++s) {
                visit(stack_.slices[s], z);
                z = stack_.slices[s].z_high;
            }
        }
    }

    void find_regions() {
        for (std::uint32_t r = 0; r < bare_.regions.size(); ++r)
            for_each_slice(bare_.regions[r], [&](const Slice& slice, std::int32_t) {
                const auto at = boxes_of_.find(slice.space);
                if (at == boxes_of_.end()) return;
                std::vector<std::uint32_t>& regions = regions_of_[slice.space];
                if (regions.empty() || regions.back() != r) regions.push_back(r);
            });
    }

    /// Whether some slice of the room lies at the height of the box.
    [[nodiscard]] bool at_its_height(const Region& region, const Box& box) const {
        bool found = false;
        for_each_slice(region, [&](const Slice& slice, std::int32_t z) {
            found |= slice.space == box.space && box.z_low < slice.z_high && box.z_high > z;
        });
        return found;
    }

    void split_room(std::uint32_t space, const std::vector<std::uint32_t>& boxes) {
        Bounds all;
        for (const std::uint32_t k : boxes)
            for (const GridPoint p : stack_.boxes[k].footprint) all.add(p);
        std::vector<std::uint32_t> regions;
        std::vector<plans::Segment> sides;
        for (const std::uint32_t r : regions_of_[space]) {
            Bounds own;
            const Region& region = bare_.regions[r];
            const std::size_t first = sides.size();
            for (std::uint32_t k = 0; k < region.half_edge_count; ++k) {
                const StackEdge& edge = bare_.edges[bare_.boundary[region.first_half_edge + k] / 2];
                sides.push_back({bare_.points[edge.a], bare_.points[edge.b]});
                own.add(sides.back().a);
                own.add(sides.back().b);
            }
            if (own.meets(all, 4)) regions.push_back(r);
            else sides.resize(first);
        }
        for (const std::uint32_t k : boxes) {
            footprints_[k] = snapped(stack_.boxes[k].footprint, sides);
            for (std::size_t i = 0; i < footprints_[k].size(); ++i)
                sides.push_back({footprints_[k][i], footprints_[k][(i + 1) % footprints_[k].size()]});
        }
        std::set<std::uint32_t> placed;
        for (const std::uint32_t r : regions) split(r, boxes, placed);
        for (const std::uint32_t k : boxes)
            if (!placed.contains(k)) refuse_outside(stack_.boxes[k]);
    }

    void split(std::uint32_t r, const std::vector<std::uint32_t>& boxes, std::set<std::uint32_t>& placed) {
        std::vector<PlacedBox> here;
        for (const std::uint32_t k : boxes)
            if (at_its_height(bare_.regions[r], stack_.boxes[k]))
                here.push_back({k, footprints_[k], stack_.boxes[k].z_low, stack_.boxes[k].z_high});
        if (here.empty()) return;
        RegionSplit split = split_region(bare_, r, here);
        if (!split.overlaps.empty()) {
            const Box& first = stack_.boxes[split.overlaps.front().first];
            const Box& second = stack_.boxes[split.overlaps.front().second];
            throw InputError("P504", "",
                             called(second) + " stands in " + called(first) + ": move one of them, they may touch.");
        }
        if (split.parts.empty() || (split.parts.size() == 1 && split.parts[0].boxes.empty())) return;
        for (const RegionPart& part : split.parts) placed.insert(part.boxes.begin(), part.boxes.end());
        splits_.emplace(r, std::move(split));
    }

    [[noreturn]] void refuse_outside(const Box& box) const {
        throw InputError("P505", "",
                         called(box) + " has no place inside " + called(bare_.spaces[box.space]) +
                             ": what is left of it there is thinner than two units of the grid. Move it into the room, "
                             "or make it thicker.");
    }

    /// Edges on which boxes end become chains, then the new edges follow.
    void build_edges() {
        for (const auto& [r, split] : splits_)
            for (const RegionPart& part : split.parts)
                for (const SplitSide& side : part.sides)
                    if (!side.is_new)
                        chains_.add(stack_, side.edge, side.from), chains_.add(stack_, side.edge, side.to);
        chains_.split(stack_);
        for (const auto& [r, split] : splits_) {
            std::map<GridPoint, std::uint32_t> own;
            const Region& region = bare_.regions[r];
            for (std::uint32_t k = 0; k < region.half_edge_count; ++k) {
                const StackEdge& edge = bare_.edges[bare_.boundary[region.first_half_edge + k] / 2];
                own.emplace(bare_.points[edge.a], edge.a);
                own.emplace(bare_.points[edge.b], edge.b);
            }
            const auto point = [&](GridPoint p) {
                const auto at = own.find(p);
                return at != own.end() ? at->second : chains_.point(stack_, p);
            };
            first_new_edge_[r] = std::uint32_t(stack_.edges.size());
            for (const NewEdge& edge : split.new_edges)
                stack_.edges.push_back(
                    {point(edge.a), point(edge.b), first_line_[edge.box] + std::min(edge.side, last_side(edge.box))});
        }
    }
    [[nodiscard]] std::uint32_t last_side(std::uint32_t box) const {
        return std::uint32_t(stack_.boxes[box].footprint.size()) - 1;
    }

    void build_regions() {
        stack_.boundary.clear();
        for (std::uint32_t r = 0; r < bare_.regions.size(); ++r) {
            const auto split = splits_.find(r);
            if (split != splits_.end()) {
                fill(r, r, split->second.parts.front());
                continue;
            }
            Region& region = stack_.regions[r];
            const std::uint32_t first = region.first_half_edge;
            region.first_half_edge = std::uint32_t(stack_.boundary.size());
            for (std::uint32_t k = first; k < first + region.half_edge_count; ++k)
                chains_.append(bare_.boundary[k], stack_.boundary);
            region.half_edge_count = std::uint32_t(stack_.boundary.size()) - region.first_half_edge;
        }
        for (const auto& [r, split] : splits_)
            for (std::size_t p = 1; p < split.parts.size(); ++p) {
                stack_.regions.push_back(bare_.regions[r]);
                fill(std::uint32_t(stack_.regions.size() - 1), r, split.parts[p]);
            }
    }

    /// Region `r` becomes a part of the bare region `from`.
    void fill(std::uint32_t r, std::uint32_t from, const RegionPart& part) {
        Region region = bare_.regions[from];
        region.first_half_edge = std::uint32_t(stack_.boundary.size());
        for (const SplitSide& side : part.sides) {
            if (side.is_new)
                stack_.boundary.push_back(2 * (first_new_edge_[from] + side.edge) + (side.reversed ? 1 : 0));
            else chains_.append(stack_, 2 * side.edge + (side.reversed ? 1 : 0), side.from, side.to, stack_.boundary);
        }
        region.half_edge_count = std::uint32_t(stack_.boundary.size()) - region.first_half_edge;
        if (!part.boxes.empty()) {
            region.first_column = std::uint32_t(stack_.region_columns.size());
            for (std::uint32_t b = region.first_band; b <= region.last_band; ++b)
                stack_.region_columns.push_back(
                    boxed_column(bare_.region_columns[bare_.regions[from].first_column + b - region.first_band],
                                 stack_.bands[b].z_low, part.boxes));
        }
        stack_.regions[r] = region;
    }

    std::uint32_t boxed_column(std::uint32_t bare_column, std::int32_t z, std::vector<std::uint32_t> boxes) {
        std::sort(boxes.begin(), boxes.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(stack_.boxes[a].z_low, a) < std::pair(stack_.boxes[b].z_low, b);
        });
        const std::uint32_t space = stack_.boxes[boxes.front()].space;
        const Column column = bare_.columns[bare_column];
        Column result{std::uint32_t(stack_.slices.size()), 0};
        const auto up_to = [&](std::int32_t z_high, Label label, std::uint32_t of) {
            if (z_high <= z) return;
            stack_.slices.push_back({z_high, label, of});
            z = z_high;
        };
        bool is_changed = false;
        for (std::uint32_t s = column.first_slice; s < column.first_slice + column.slice_count; ++s) {
            const Slice slice = bare_.slices[s];
            if (slice.space == space)
                for (const std::uint32_t k : boxes) {
                    const Box& box = stack_.boxes[k];
                    if (box.z_high <= z || box.z_low >= slice.z_high) continue;
                    up_to(std::min(box.z_low, slice.z_high), slice.label, slice.space);
                    up_to(std::min(box.z_high, slice.z_high), Label::Object, std::uint32_t(bare_.spaces.size()) + k);
                    is_changed = true;
                }
            up_to(slice.z_high, slice.label, slice.space);
        }
        if (!is_changed) {
            stack_.slices.resize(result.first_slice);
            return bare_column;
        }
        result.slice_count = std::uint32_t(stack_.slices.size()) - result.first_slice;
        stack_.columns.push_back(result);
        return std::uint32_t(stack_.columns.size() - 1);
    }

    void refuse_full_room(std::uint32_t space, const std::vector<std::uint32_t>& boxes) const {
        bool is_left = false;
        for (const Region& region : stack_.regions)
            for_each_slice(region, [&](const Slice& slice, std::int32_t) { is_left |= slice.space == space; });
        if (is_left) return;
        const Box& last = stack_.boxes[boxes.back()];
        throw InputError("P506", "",
                         (boxes.size() > 1 ? called(last) + " and the other boxes fill " : called(last) + " fills ") +
                             called(bare_.spaces[space]) +
                             " from wall to wall and floor to ceiling: nothing is left "
                             "of the room. Make it smaller.");
    }

    const Stack& bare_;
    Stack stack_;
    std::vector<std::uint32_t> first_line_;                           ///< [box]
    std::vector<std::vector<GridPoint>> footprints_;                  ///< [box] as they stand in their room
    std::map<std::uint32_t, std::vector<std::uint32_t>> boxes_of_;    ///< by space
    std::map<std::uint32_t, std::vector<std::uint32_t>> regions_of_;  ///< by space, with boxes only
    std::map<std::uint32_t, RegionSplit> splits_;                     ///< by region
    std::map<std::uint32_t, std::uint32_t> first_new_edge_;           ///< by region
    StackChains chains_;
};

}  // namespace

Stack place_boxes(const std::shared_ptr<const Stack>& bare, std::vector<Box> boxes) {
    ENFILADE_CHECK(bare->boxes.empty());
    return Placer(bare, std::move(boxes)).run();
}

std::string called(const Box& box) { return "The box \"" + (box.name.empty() ? box.id : box.name) + "\""; }

}  // namespace enfilade::modeler

#include "modeler/stack.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "base/check.h"
#include "modeler/levels.h"
#include "modeler/region.h"

namespace enfilade::modeler {
namespace {

using plans::Layout;
using plans::Owner;
using plans::OwnerKind;
using plans::Plan;

constexpr std::uint32_t no_index = UINT32_MAX;

/// Fills a Stack from a layout, band by band.
class Stacker {
public:
    Stacker(const Plan& plan, const Layout& layout, std::vector<Finding>& findings)
        : plan_(plan), layout_(layout), findings_(findings), face_count_(layout.map.face_count) {
        stack_.frame = layout.frame;
        stack_.site_min = layout.site_min;
        stack_.site_max = layout.site_max;
        levels_ = find_levels(plan, layout, findings_);
    }

    Stack run() {
        add_space({.label = Label::Exterior, .id = "exterior", .name = "Exterior"});
        add_space({.label = Label::Ground, .id = "ground", .name = "Ground"});
        add_space({.label = Label::Outside, .id = "outside", .name = "Outside"});
        for (std::uint32_t k = 0; k < layout_.storeys.size(); ++k) add_storey_spaces(k);
        add_lines();
        for (const Level& level : levels_.bands) add_band(level);
        find_regions(layout_, band_columns_, stack_);
        return std::move(stack_);
    }

private:
    struct StoreySpaces {
        std::vector<std::uint32_t> rooms, walls, above_walls, openings, columns, stairs, shafts;
        std::vector<std::uint32_t> host;  ///< of each opening: index of its wall
        std::vector<bool> outdoors;       ///< of each wall: no room touches it
    };

    const plans::Storey& storey(std::uint32_t k) const { return plan_.storeys[layout_.storeys[k].plan_storey]; }

    std::uint32_t add_space(Space space) {
        stack_.spaces.push_back(std::move(space));
        return std::uint32_t(stack_.spaces.size() - 1);
    }

    void add_storey_spaces(std::uint32_t k) {
        const plans::Storey& from = storey(k);
        StoreySpaces spaces;
        for (const plans::FoundRoom& room : layout_.storeys[k].rooms) {
            Space space{.label = Label::Room,
                        .id = room.id,
                        .name = room.name,
                        .kind = room.kind,
                        .storey = k,
                        .area_m2 = room.area_m2};
            if (room.polygon) {
                space.colour = from.rooms[*room.polygon].floor_colour;
                space.ceiling_colour = from.rooms[*room.polygon].ceiling_colour;
            }
            spaces.rooms.push_back(add_space(std::move(space)));
        }
        std::unordered_map<std::string, std::uint32_t> wall_by_id;
        for (std::uint32_t w = 0; w < from.walls.size(); ++w) {
            const plans::Wall& wall = from.walls[w];
            wall_by_id.emplace(wall.id, w);
            spaces.walls.push_back(add_space({.label = Label::Wall, .id = wall.id, .name = wall.name, .storey = k}));
        }
        spaces.above_walls.assign(from.walls.size(), no_index);
        for (const plans::Opening& opening : from.openings) {
            const Label label = opening.kind == plans::OpeningKind::Door     ? Label::Door
                                : opening.kind == plans::OpeningKind::Window ? Label::Window
                                                                             : Label::Opening;
            const auto host = wall_by_id.find(opening.wall);
            spaces.host.push_back(host == wall_by_id.end() ? no_index : host->second);
            spaces.openings.push_back(add_space({.label = label,
                                                 .id = opening.id,
                                                 .name = opening.name,
                                                 .storey = k,
                                                 .closed = label == Label::Door && opening.open_angle == 0}));
        }
        for (const plans::Column& column : from.columns)
            spaces.columns.push_back(
                add_space({.label = Label::Wall, .id = column.id, .name = column.name, .kind = "column", .storey = k}));
        for (const plans::Stair& stair : from.stairs)
            spaces.stairs.push_back(
                add_space({.label = Label::Stair, .id = stair.id, .name = stair.name, .storey = k}));
        for (const plans::Shaft& shaft : from.shafts)
            spaces.shafts.push_back(
                add_space({.label = Label::Shaft, .id = shaft.id, .name = shaft.name, .storey = k}));
        spaces.outdoors = outdoor_walls(k, spaces);
        spaces_.push_back(std::move(spaces));
        stack_.storeys.push_back({from.id, from.name, levels_.floor[k], levels_.ceiling[k]});
    }

    /// The wall that holds a face of storey k, directly or by one of its openings.
    std::uint32_t wall_of(Owner owner, const StoreySpaces& spaces) const {
        if (owner.kind == OwnerKind::Wall) return owner.element;
        if (owner.kind == OwnerKind::Opening) return spaces.host[owner.element];
        return no_index;
    }

    /// Walls that touch the exterior and no room (fences, parapets): the sky is above them, no slab.
    std::vector<bool> outdoor_walls(std::uint32_t k, const StoreySpaces& spaces) const {
        const std::vector<Owner>& owner = layout_.storeys[k].owner;
        std::vector<bool> touches_exterior(spaces.walls.size(), false), touches_room(spaces.walls.size(), false);
        for (std::uint32_t h = 0; h < 2 * layout_.graph.edges.size(); ++h) {
            const std::uint32_t wall = wall_of(owner[layout_.map.face(h)], spaces);
            if (wall == no_index) continue;
            const OwnerKind beyond = owner[layout_.map.face(h ^ 1)].kind;
            if (beyond == OwnerKind::Exterior) touches_exterior[wall] = true;
            if (beyond == OwnerKind::Room || beyond == OwnerKind::Stair || beyond == OwnerKind::Shaft)
                touches_room[wall] = true;
        }
        std::vector<bool> result(spaces.walls.size());
        for (std::size_t w = 0; w < result.size(); ++w) result[w] = touches_exterior[w] && !touches_room[w];
        return result;
    }

    void add_lines() {
        stack_.line_count = std::uint32_t(layout_.lines.size());
        std::map<std::pair<std::uint32_t, std::uint32_t>, plans::Colour> colours;
        for (std::size_t e = 0; e < layout_.graph.edges.size(); ++e) {
            const plans::NodedEdge& edge = layout_.graph.edges[e];
            for (std::uint32_t u = edge.first_use; u < edge.first_use + edge.use_count; ++u) {
                const plans::LineSource& source = layout_.lines[std::size_t(layout_.use_line[u])];
                if (source.storey == no_index || source.wall == no_index) continue;
                const plans::Wall& wall = storey(source.storey).walls[source.wall];
                const auto& colour = source.left_side ? wall.left_colour : wall.right_colour;
                if (!colour) continue;
                const std::uint32_t space = spaces_[source.storey].walls[source.wall];
                colours.emplace(std::pair(std::uint32_t(layout_.edge_line[e]), space), *colour);
            }
        }
        for (const auto& [key, colour] : colours) stack_.wall_colours.push_back({key.first, key.second, colour});
    }

    std::uint32_t add_column(const std::vector<Slice>& slices) {
        stack_.columns.push_back({std::uint32_t(stack_.slices.size()), std::uint32_t(slices.size())});
        stack_.slices.insert(stack_.slices.end(), slices.begin(), slices.end());
        return std::uint32_t(stack_.columns.size() - 1);
    }

    /// Open air down to the ground level, ground below it.
    std::vector<Slice> open_air(const Band& band) const {
        std::vector<Slice> slices;
        if (levels_.ground > band.z_low)
            slices.push_back({std::min(levels_.ground, band.z_high), Label::Ground, ground_space});
        if (levels_.ground < band.z_high) slices.push_back({band.z_high, Label::Exterior, exterior_space});
        return slices;
    }

    void add_band(const Level& level) {
        const Band band{level.z_low, level.z_high};
        stack_.bands.push_back(band);
        std::vector<std::uint32_t> column(face_count_, no_index);
        const std::uint32_t air = add_column(open_air(band));
        switch (level.kind) {
            case LevelKind::Open: std::fill(column.begin(), column.end(), air); break;
            case LevelKind::Storey: fill_storey(level.storey, band, air, column); break;
            case LevelKind::Slab: fill_slab(level, band, air, column); break;
        }
        column[0] = no_index;
        band_columns_.push_back(std::move(column));
    }

    void fill_storey(std::uint32_t k, const Band& band, std::uint32_t air, std::vector<std::uint32_t>& column) {
        std::map<Owner, std::uint32_t> known;
        const std::vector<Owner>& owner = layout_.storeys[k].owner;
        for (std::uint32_t face = 1; face < face_count_; ++face) {
            const Owner key = owner[face].kind == OwnerKind::Exterior ? Owner{} : owner[face];
            const auto [at, is_new] = known.try_emplace(key, no_index);
            if (is_new) at->second = key.kind == OwnerKind::Exterior ? air : add_column(storey_column(k, key, band));
            column[face] = at->second;
        }
    }

    std::vector<Slice> storey_column(std::uint32_t k, Owner owner, const Band& band) {
        StoreySpaces& spaces = spaces_[k];
        switch (owner.kind) {
            case OwnerKind::Room: return {{band.z_high, Label::Room, spaces.rooms[owner.element]}};
            case OwnerKind::Stair: return {{band.z_high, Label::Stair, spaces.stairs[owner.element]}};
            case OwnerKind::Shaft: return {{band.z_high, Label::Shaft, spaces.shafts[owner.element]}};
            case OwnerKind::Column: return column_slices(k, owner.element, band);
            case OwnerKind::Wall: {
                std::vector<Slice> slices;
                wall_slices(k, owner.element, band, slices);
                return slices;
            }
            case OwnerKind::Opening: return opening_slices(k, owner.element, band);
            case OwnerKind::Exterior: break;
        }
        return open_air(band);
    }

    /// Level of a height above the floor of storey k, within the band.
    std::int32_t level(std::uint32_t k, double height, const Band& band) const {
        const std::int32_t z = stack_.frame.grid_z(storey(k).elevation + height);
        return std::clamp(z, band.z_low, band.z_high);
    }

    std::vector<Slice> column_slices(std::uint32_t k, std::uint32_t c, const Band& band) {
        const plans::Column& column = storey(k).columns[c];
        const std::int32_t top = column.height > 0 ? level(k, column.height, band) : band.z_high;
        std::vector<Slice> slices;
        if (top > band.z_low) slices.push_back({top, Label::Wall, spaces_[k].columns[c]});
        if (top < band.z_high) {
            const std::uint32_t above = add_space(
                {.label = Label::Opening, .id = column.id + "/above", .name = "above " + column.name, .storey = k});
            slices.push_back({band.z_high, Label::Opening, above});
        }
        return slices;
    }

    /// The wall from what `slices` already hold up to its top, then what is above it.
    void wall_slices(std::uint32_t k, std::uint32_t w, const Band& band, std::vector<Slice>& slices) {
        StoreySpaces& spaces = spaces_[k];
        const plans::Wall& wall = storey(k).walls[w];
        const std::int32_t bottom = slices.empty() ? band.z_low : slices.back().z_high;
        const std::int32_t top = level(k, std::max(wall.height_at_start, wall.height_at_end), band);
        if (top > bottom) slices.push_back({top, Label::Wall, spaces.walls[w]});
        if (std::max(top, bottom) >= band.z_high) return;
        if (spaces.outdoors[w]) {
            slices.push_back({band.z_high, Label::Exterior, exterior_space});
            return;
        }
        if (spaces.above_walls[w] == no_index)
            spaces.above_walls[w] = add_space({.label = Label::Opening,
                                               .id = wall.id + "/above",
                                               .name = "above " + (wall.name.empty() ? wall.id : wall.name),
                                               .storey = k});
        slices.push_back({band.z_high, Label::Opening, spaces.above_walls[w]});
    }

    std::vector<Slice> opening_slices(std::uint32_t k, std::uint32_t o, const Band& band) {
        const StoreySpaces& spaces = spaces_[k];
        const plans::Opening& opening = storey(k).openings[o];
        const std::uint32_t host = spaces.host[o];
        const std::int32_t sill = level(k, opening.sill, band), head = level(k, opening.head, band);
        std::vector<Slice> slices;
        if (sill > band.z_low)
            slices.push_back({sill, Label::Wall, host == no_index ? spaces.openings[o] : spaces.walls[host]});
        if (head > sill) slices.push_back({head, stack_.spaces[spaces.openings[o]].label, spaces.openings[o]});
        if (host != no_index) wall_slices(k, host, band, slices);
        else if (slices.empty() || slices.back().z_high < band.z_high)
            slices.push_back({band.z_high, Label::Wall, spaces.openings[o]});
        return slices;
    }

    /// Whether the slab next to storey k covers this face, or the sky does.
    bool is_open(std::uint32_t k, std::uint32_t face) const {
        const Owner owner = layout_.storeys[k].owner[face];
        if (owner.kind == OwnerKind::Exterior) return true;
        const std::uint32_t wall = wall_of(owner, spaces_[k]);
        return wall != no_index && spaces_[k].outdoors[wall];
    }

    void fill_slab(const Level& level, const Band& band, std::uint32_t air, std::vector<std::uint32_t>& column) {
        const std::uint32_t below = level.storey_below, above = level.storey;
        const plans::Storey& carried = storey(above != no_index ? above : below);
        // Slab, terrace (sky above), overhang (sky below): one space each, so that a slab is one volume where it can
        // be.
        std::array<std::uint32_t, 4> of_kind = {no_index, no_index, no_index, no_index};
        std::map<std::uint32_t, std::uint32_t> wells;
        for (std::uint32_t face = 1; face < face_count_; ++face) {
            const bool open_below = below == no_index || is_open(below, face);
            const bool open_above = above == no_index || layout_.storeys[above].owner[face].kind == OwnerKind::Exterior;
            if (open_below && open_above) {
                column[face] = air;
                continue;
            }
            const std::uint32_t well =
                below != no_index && above != no_index ? layout_.storeys[below].opens_up[face] : no_index;
            if (well != no_index) {
                const auto [at, is_new] = wells.try_emplace(well, no_index);
                if (is_new) at->second = well_column(below, well, band);
                column[face] = at->second;
                continue;
            }
            const int kind = (below != no_index && open_below ? 1 : 0) + (above != no_index && open_above ? 2 : 0);
            if (of_kind[std::size_t(kind)] == no_index) {
                const char* names[] = {"slab", "overhang", "terrace", "slab"};
                const std::string what = above == no_index ? "roof" : names[kind];
                const std::uint32_t space = add_space({.label = Label::Slab,
                                                       .id = what + "@" + carried.id,
                                                       .name = what + (above == no_index ? " over " : " under ") +
                                                               (carried.name.empty() ? carried.id : carried.name),
                                                       .storey = above != no_index ? above : below});
                of_kind[std::size_t(kind)] = add_column({{band.z_high, Label::Slab, space}});
            }
            column[face] = of_kind[std::size_t(kind)];
        }
    }

    std::uint32_t well_column(std::uint32_t k, std::uint32_t well, const Band& band) {
        const plans::Storey& from = storey(k);
        const bool is_stair = well < from.stairs.size();
        const std::string& id = is_stair ? from.stairs[well].id : from.shafts[well - from.stairs.size()].id;
        const std::string& name = is_stair ? from.stairs[well].name : from.shafts[well - from.stairs.size()].name;
        const Label label = is_stair ? Label::Stair : Label::Shaft;
        return add_column(
            {{band.z_high, label, add_space({.label = label, .id = id + "/slab", .name = name, .storey = k})}});
    }

    const Plan& plan_;
    const Layout& layout_;
    std::vector<Finding>& findings_;
    std::uint32_t face_count_;
    Levels levels_;
    Stack stack_;
    std::vector<StoreySpaces> spaces_;                      ///< by storey of the layout
    std::vector<std::vector<std::uint32_t>> band_columns_;  ///< [band][face]
};

}  // namespace

Stack stack(const Plan& plan, const Layout& layout, std::vector<Finding>& findings) {
    ENFILADE_CHECK(!layout.storeys.empty());
    return Stacker(plan, layout, findings).run();
}

}  // namespace enfilade::modeler

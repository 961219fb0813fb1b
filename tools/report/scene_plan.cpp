#include "tools/report/scene_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "tools/report/ring_chain.h"

namespace enfilade::tools {
namespace {

using accel::Cell;
using accel::Label;
using accel::SceneView;
using accel::Surface;
using accel::Target;

/// A side of a cell where the level cuts it.
struct Side {
    std::uint32_t cell = 0;
    std::uint32_t section = 0, next = 0;  ///< where it begins and ends: indices into the sections
    Target target;
    float height = 0;  ///< of the face
};

bool is_cut(const Cell& cell, float level) { return cell.z_floor <= level && level < cell.z_ceiling; }

class PlanReader {
public:
    PlanReader(const SceneView& scene, float level) : scene_(scene) {
        for (std::uint32_t c = 0; c < scene.cells.size(); ++c)
            if (is_cut(scene.cells[c], level)) add_sides(c, level);
    }

    ScenePlan run() {
        ScenePlan plan;
        plan.is_underground = std::none_of(sides_.begin(), sides_.end(), [&](const Side& side) {
            return scene_.cells[side.cell].label == Label::Exterior;
        });
        for (const Side& side : sides_) add_to_layers(side, plan);
        read_spaces(plan);
        plan.solid = rings([&](const Side& side) { return is_wall(side); }, true);
        const auto grow = [&](const std::vector<std::vector<Mm>>& all) {
            for (const std::vector<Mm>& ring : all)
                for (const Mm at : ring) plan.box.add(at);
        };
        grow(plan.solid);
        for (const SpaceOutline& space : plan.spaces) grow(space.rings);
        return plan;
    }

private:
    void add_sides(std::uint32_t c, float level) {
        const Cell& cell = scene_.cells[c];
        for (std::uint32_t k = 0; k < cell.section_count; ++k) {
            const std::uint32_t s = cell.first_section + k;
            const std::uint32_t end = cell.first_section + (k + 1) % cell.section_count;
            float z_low = cell.z_floor;
            for (std::uint32_t f = scene_.section_tails[s].first_face; f < scene_.section_tails[s + 1].first_face;
                 ++f) {
                const accel::SideFace& face = scene_.side_faces[f];
                if (level < face.z_top) {
                    sides_.push_back({c, s, end, face.target, face.z_top - z_low});
                    break;
                }
                z_low = face.z_top;
            }
        }
    }

    [[nodiscard]] Surface surface(const Side& side) const {
        return scene_.source_faces[index(side.target.source_face())].surface;
    }
    /// Solid faces between two cells.
    [[nodiscard]] bool is_leaf(const Side& side) const {
        return !side.target.is_portal() && (surface(side) == Surface::Leaf || surface(side) == Surface::Pane);
    }
    [[nodiscard]] bool is_wall(const Side& side) const {
        return !side.target.is_portal() && !is_leaf(side) && surface(side) != Surface::Sky;
    }
    [[nodiscard]] Mm mm(std::uint32_t section) const {
        return {std::llround(1000.0 * double(scene_.section_x[section])),
                std::llround(1000.0 * double(scene_.section_y[section]))};
    }

    void add_to_layers(const Side& side, ScenePlan& plan) const {
        const Cell& cell = scene_.cells[side.cell];
        CellSide drawn{mm(side.section), mm(side.next), side.cell, side.cell};
        if (side.target.is_portal()) {
            const auto beyond = std::uint32_t(index(side.target.neighbour()));
            if (beyond < side.cell) return;  // drawn already
            const bool same_space = scene_.cells[beyond].space == cell.space;
            const auto kind = accel::PortalKind(std::uint32_t(side.target.kind()) - 1);
            drawn.back = beyond;
            drawn.kind = side_kind(kind, same_space);
            drawn.area_m2 =
                double(side.height) * std::hypot(double(scene_.section_x[side.next] - scene_.section_x[side.section]),
                                                 double(scene_.section_y[side.next] - scene_.section_y[side.section]));
            (same_space && cell.label == Label::Exterior ? plan.outside : plan.inside).sides.push_back(drawn);
        } else if (is_leaf(side)) {
            drawn.kind = SideKind::Leaf;
            plan.inside.sides.push_back(drawn);
        } else if (cell.label != Label::Exterior) {
            plan.inside.sides.push_back(drawn);
        }
    }

    void read_spaces(ScenePlan& plan) const {
        std::map<std::uint32_t, std::vector<Side>> by_space;
        for (const Side& side : sides_)
            if (scene_.cells[side.cell].label != Label::Exterior)
                by_space[std::uint32_t(index(scene_.cells[side.cell].space))].push_back(side);
        for (const auto& [space, sides] : by_space) {
            SpaceOutline outline{accel::SpaceId(space), scene_.spaces[space].label};
            for (std::size_t k = 0; k < sides.size(); ++k)
                outline.cells += k == 0 || sides[k].cell != sides[k - 1].cell;
            outline.rings = rings_of(sides, false, [&, s = space](const Side& side) {
                return !side.target.is_portal() || index(scene_.cells[index(side.target.neighbour())].space) != s;
            });
            plan.spaces.push_back(std::move(outline));
        }
    }

    template <class Keep>
    [[nodiscard]] std::vector<std::vector<Mm>> rings(const Keep& keep, bool backwards) const {
        return rings_of(sides_, backwards, keep);
    }

    /// The borders that the sides make, run the other way round where `backwards`.
    template <class Keep>
    [[nodiscard]] std::vector<std::vector<Mm>> rings_of(const std::vector<Side>& sides, bool backwards,
                                                        const Keep& keep) const {
        std::map<std::pair<float, float>, std::uint32_t> ids;  // floats of one corner are the same in all its cells
        const auto id = [&](std::uint32_t s) {
            return ids.try_emplace({scene_.section_x[s], scene_.section_y[s]}, std::uint32_t(ids.size())).first->second;
        };
        std::vector<std::array<std::uint32_t, 2>> ends;
        std::vector<std::uint32_t> starts;  // sections
        for (const Side& side : sides) {
            if (!keep(side)) continue;
            const std::uint32_t from = backwards ? side.next : side.section;
            ends.push_back({id(from), id(backwards ? side.section : side.next)});
            starts.push_back(from);
        }
        std::vector<std::vector<Mm>> rings;
        for (const std::vector<std::uint32_t>& chain : chain_rings(ends)) {
            std::vector<Mm>& ring = rings.emplace_back();
            for (const std::uint32_t k : chain) ring.push_back(mm(starts[k]));
            if (ring.size() < 3) rings.pop_back();
        }
        return rings;
    }

    const SceneView& scene_;
    std::vector<Side> sides_;
};

}  // namespace

std::vector<SceneStorey> scene_storeys(const SceneView& scene) {
    std::map<std::uint32_t, const Cell*> lowest;  // by storey: its room's cell with the lowest floor
    for (const Cell& cell : scene.cells) {
        if (cell.label != Label::Room) continue;
        const Cell*& found = lowest[scene.spaces[index(cell.space)].storey_index];
        if (!found || cell.z_floor < found->z_floor) found = &cell;
    }
    std::vector<SceneStorey> storeys;
    for (const auto& [number, cell] : lowest)
        storeys.push_back({std::string(scene.string(scene.spaces[index(cell->space)].storey)), number,
                           cell->z_floor + std::min(1.1f, (cell->z_ceiling - cell->z_floor) / 2)});
    return storeys;
}

ScenePlan scene_plan(const SceneView& scene, float level) { return PlanReader(scene, level).run(); }

}  // namespace enfilade::tools

#include "modeler/surface_textures.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "base/error.h"
#include "modeler/catalogue/file_tree.h"
#include "modeler/catalogue/picture.h"
#include "plans/read.h"

namespace enfilade::modeler {
namespace {

constexpr double flat_arc = 1e-6;        ///< metres that an arc bulges at least
constexpr double least_direction = 0.7;  ///< cosine: what runs less along its wall is an end of it

/// Plans are read again from their text: not for nothing.
std::optional<plans::Plan> textured_plan(const Building& building) {
    if (building.plan_json.find("_texture\"") == std::string::npos) return std::nullopt;
    return plans::read_json(building.plan_json, "the plan");
}

/// The names of all pictures of a plan, ascending.
std::set<std::string> pictures_of(const plans::Plan& plan) {
    std::set<std::string> names;
    const auto add = [&](const std::optional<plans::SurfaceTexture>& texture) {
        if (texture) names.insert(texture->picture);
    };
    for (const plans::Storey& storey : plan.storeys) {
        for (const plans::Wall& wall : storey.walls) add(wall.left_texture), add(wall.right_texture);
        for (const plans::Room& room : storey.rooms) add(room.floor_texture), add(room.ceiling_texture);
    }
    return names;
}

/// Where the pictures of a plan's file are.
std::unique_ptr<FileTree> files_of(const std::filesystem::path& plan_file) {
    std::array<char, 2> start{};
    std::ifstream(plan_file, std::ios::binary).read(start.data(), start.size());
    return start == std::array{'P', 'K'} ? open_archive(plan_file) : open_file(plan_file);
}

std::array<float, 4> frame_of(double x_u, double y_u, double u_0, double v_0) {
    return {float(x_u), float(y_u), float(u_0), float(v_0)};
}

}  // namespace

void read_surface_pictures(Building& building, const std::filesystem::path& plan_file, std::uint32_t most_a_side) {
    const std::optional<plans::Plan> plan = textured_plan(building);
    if (!plan || most_a_side == 0) return;
    const auto tell = [&](const std::string& name, const std::string& reason) {
        building.findings.push_back(
            {"K160", Severity::Warning,
             "The picture \"" + name + "\" of the plan's walls or floors is left out: " + reason,
             "Their colours are shown. Mend the picture, or name another one in the plan."});
    };
    std::unique_ptr<FileTree> files;
    for (const std::string& name : pictures_of(*plan)) {
        try {
            if (!files) files = files_of(plan_file);
            const std::optional<std::string> bytes = files->read(name);
            if (!bytes) {
                tell(name, files->why_absent(name));
                continue;
            }
            if (auto texture = read_texture(name, *bytes, most_a_side)) building.pictures.push_back(std::move(texture));
            else tell(name, "it is no PNG or JPEG, is damaged, or has more than 67 million pixels.");
        } catch (const InputError& error) {
            tell(name, error.what());
        } catch (const IoError& error) {
            tell(name, error.what());
        }
    }
}

SurfaceTextures::SurfaceTextures(const Building& building) : building_(building) {
    if (building.pictures.empty()) return;
    const std::optional<plans::Plan> plan = textured_plan(building);
    if (!plan) return;
    ByName spaces;
    for (std::uint32_t s = 0; s < building.spaces.size(); ++s) {
        const Space& space = building.spaces[s];
        if (space.storey >= building.storeys.size()) continue;
        if (space.label == Label::Room || (space.label == Label::Wall && space.kind.empty()))
            spaces.emplace(std::pair(building.storeys[space.storey].id, space.id), s);
    }
    for (const plans::Storey& storey : plan->storeys) add(storey, spaces);
}

void SurfaceTextures::add(const plans::Storey& storey, const ByName& spaces) {
    for (const plans::Wall& from : storey.walls) {
        const auto space = spaces.find({storey.id, from.id});
        if (space == spaces.end()) continue;
        Wall wall{{from.start, from.end, from.arc_extent, flat_arc},
                  from.thickness / 2,
                  building_.spaces[space->second].storey,
                  with_picture(from.left_texture),
                  with_picture(from.right_texture)};
        if (!(wall.left || wall.right) || !(wall.axis.length() > 0)) continue;
        wall_of_space_.emplace(space->second, std::uint32_t(walls_.size()));
        walls_.push_back(std::move(wall));
    }
    for (const plans::Room& from : storey.rooms) {
        const auto space = spaces.find({storey.id, from.id});
        if (space == spaces.end()) continue;
        if (const auto floor = with_picture(from.floor_texture)) floors_.emplace(space->second, *floor);
        if (const auto ceiling = with_picture(from.ceiling_texture)) ceilings_.emplace(space->second, *ceiling);
    }
}

std::optional<PlanTexture> SurfaceTextures::with_picture(const std::optional<plans::SurfaceTexture>& texture) const {
    if (!texture) return std::nullopt;
    for (std::uint32_t p = 0; p < building_.pictures.size(); ++p)
        if (building_.pictures[p]->name == texture->picture) return PlanTexture{*texture, p};
    return std::nullopt;
}

plans::Point SurfaceTextures::world(plans::GridPoint p) const {
    return {building_.frame.world_x(p.x), building_.frame.world_y(p.y)};
}

SurfaceTextures::Beside SurfaceTextures::beside(const Wall& wall, plans::GridPoint a, plans::GridPoint b) const {
    const plans::Point from = world(a), to = world(b), middle = {(from.x + to.x) / 2, (from.y + to.y) / 2};
    const double share = wall.axis.nearest(middle);
    const plans::Point at = wall.axis.at(share), left = wall.axis.normal(share);
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    return {share, (middle.x - at.x) * left.x + (middle.y - at.y) * left.y,
            (left.y * (to.x - from.x) - left.x * (to.y - from.y)) / length};
}

/// On its left side a wall is seen from the left: the edge, with its viewer on the left, runs along the axis.
const PlanTexture* SurfaceTextures::shown(const Wall& wall, const Beside& at) const {
    if (std::abs(at.direction) < least_direction || (at.direction > 0) != (at.distance > 0)) return nullptr;
    const std::optional<PlanTexture>& side = at.direction > 0 ? wall.left : wall.right;
    return side ? &*side : nullptr;
}

std::uint32_t SurfaceTextures::wall_behind(std::uint32_t space, plans::GridPoint a, plans::GridPoint b) const {
    if (walls_.empty()) return no_wall;
    if (const auto own = wall_of_space_.find(space); own != wall_of_space_.end())
        return shown(walls_[own->second], beside(walls_[own->second], a, b)) != nullptr ? own->second : no_wall;
    // The edge of a slab goes on in the texture of a wall below or above it.
    const Space& slab = building_.spaces[space];
    if (slab.label != Label::Slab) return no_wall;
    const double near = 4 * building_.frame.unit;
    for (std::uint32_t w = 0; w < walls_.size(); ++w) {
        const Wall& wall = walls_[w];
        if (wall.storey != slab.storey && wall.storey + 1 != slab.storey) continue;
        const Beside at = beside(wall, a, b);
        if (at.share <= 0 || at.share >= 1 || std::abs(std::abs(at.distance) - wall.half) > near) continue;
        if (shown(wall, at) != nullptr) return w;
    }
    return no_wall;
}

const PlanTexture& SurfaceTextures::of_wall(std::uint32_t wall, plans::GridPoint a, plans::GridPoint b) const {
    return *shown(walls_[wall], beside(walls_[wall], a, b));
}

std::array<float, 4> SurfaceTextures::wall_frame(std::uint32_t number, plans::GridPoint a, plans::GridPoint b) const {
    const Wall& wall = walls_[number];
    const plans::Point from = world(a), to = world(b);
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    // To the right as one looks at it: against the edge. Facets of arcs run as they do, which snapping hardly turns.
    const double sign = beside(wall, a, b).direction > 0 ? -1 : 1;
    const bool straight = wall.axis.straight();
    // Metres are counted at the end that is nearer to the wall's middle: the other one may lie beyond the axis.
    const double from_share = wall.axis.nearest(from), to_share = wall.axis.nearest(to);
    const bool is_from = std::abs(from_share - 0.5) < std::abs(to_share - 0.5);
    const double share = is_from ? from_share : to_share;
    const plans::Point at = wall.axis.at(share), left = wall.axis.normal(share), end = is_from ? from : to;
    const double distance = (end.x - at.x) * left.x + (end.y - at.y) * left.y;
    const double x_u = straight ? sign * left.y : (from.x - to.x) / length;
    const double y_u = straight ? -sign * left.x : (from.y - to.y) / length;
    // Round arcs metres are those of the side that is seen.
    const double bend = straight ? 0 : (wall.axis.extent() > 0 ? -1 : 1) / wall.axis.radius();
    const double along = sign * share * wall.axis.length() * (1 + bend * distance);
    const plans::Point foot = wall.axis.offset(share, distance);
    const plans::GridFrame& frame = building_.frame;
    const double u_0 = along - x_u * (foot.x - frame.origin_x) - y_u * (foot.y - frame.origin_y);
    return frame_of(x_u, y_u, u_0, -frame.unit * building_.storeys[wall.storey].z_floor);
}

std::array<float, 4> SurfaceTextures::level_frame() const {
    return frame_of(1, 0, building_.frame.origin_x, building_.frame.origin_y);
}

}  // namespace enfilade::modeler

#include "modeler/lighting/outdoor_lamps.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "modeler/lighting/ceiling_lamps.h"

namespace enfilade::modeler {
namespace {

using plans::Point;
using Place = std::array<double, 3>;

constexpr double off_wall = 0.2;    ///< metres from a door's wall to its lamp
constexpr double over_door = 0.25;  ///< metres from a door's head up to its lamp
constexpr double post = 0.3;        ///< metres that stay free around a lamp on the site
constexpr double most_places = 1e6;

Lamp lamp_at(std::string id, std::string name, const Place& place, double lumen, const OutdoorLight& light) {
    return {.id = std::move(id),
            .name = std::move(name),
            .position = place,
            .radius = light.radius,
            .colour = colour_of_kelvin(light.kelvin),
            .lumen = lumen,
            .by_rule = true};
}

/// The widest side of a doorway that leads into the open.
struct Threshold {
    Point a, b;  ///< metres, the open on the left
    double width2 = 0;
};

class OpenAir {
public:
    OpenAir(const Building& building, const VolumeFinder& volumes) : building_(building), volumes_(volumes) {}

    [[nodiscard]] bool holds(const Place& place) const {
        const std::uint32_t v = volumes_.at(place);
        return v != UINT32_MAX && building_.volumes[v].label == Label::Exterior;
    }
    [[nodiscard]] bool holds_post(Point p, double ground, double top) const {
        for (const double z : {ground + 0.05, (ground + top) / 2, top})
            for (const Point way : {Point{0, 0}, Point{post, 0}, Point{0, post}, Point{-post, 0}, Point{0, -post}})
                if (!holds({p.x + way.x, p.y + way.y, z})) return false;
        return true;
    }

private:
    const Building& building_;
    const VolumeFinder& volumes_;
};

std::map<std::uint32_t, Threshold> thresholds(const Building& building) {
    std::map<std::uint32_t, Threshold> found;  // by the door's space
    const plans::GridFrame& frame = building.frame;
    for (const Face& face : building.faces) {
        if (face.direction != Direction::Side) continue;
        const Volume &front = building.volumes[face.front], &back = building.volumes[face.back];
        const bool opens_left = front.label == Label::Exterior && back.label == Label::Door;
        if (!opens_left && !(back.label == Label::Exterior && front.label == Label::Door)) continue;
        const PlanEdge& edge = building.edges[face.edge];
        const auto world = [&](std::uint32_t p) {
            return Point{frame.world_x(building.points[p].x), frame.world_y(building.points[p].y)};
        };
        Threshold side{world(edge.a), world(edge.b)};
        if (!opens_left) std::swap(side.a, side.b);
        side.width2 = plans::dot(side.b - side.a, side.b - side.a);
        Threshold& widest = found[opens_left ? back.space : front.space];
        if (side.width2 > widest.width2) widest = side;
    }
    return found;
}

/// The ground around the building.
class Site {
public:
    Site(const Building& building, const VolumeFinder& volumes) : air_(building, volumes) {
        const plans::GridFrame& frame = building.frame;
        low_ = {frame.world_x(building.site_min[0]), frame.world_y(building.site_min[1])};
        high_ = {frame.world_x(building.site_max[0]), frame.world_y(building.site_max[1])};
        std::int32_t ground = INT32_MAX;
        for (const Volume& volume : building.volumes)
            if (volume.label == Label::Exterior) ground = std::min(ground, volume.z_low);
        has_ground_ = ground != INT32_MAX;
        if (has_ground_) ground_ = frame.world_z(ground);
    }

    /// The spacing at which so many would fill the site without a building.
    [[nodiscard]] double widest(std::size_t count) const {
        return std::sqrt((high_.x - low_.x) * (high_.y - low_.y) / double(count));
    }

    /// On a square grid in the middle of the site.
    [[nodiscard]] std::vector<Lamp> lamps(const OutdoorLight& light, double spacing) const {
        std::vector<Lamp> lamps;
        if (!has_ground_) return lamps;
        const double columns = std::floor((high_.x - low_.x) / spacing);
        const double rows = std::floor((high_.y - low_.y) / spacing);
        if (columns * rows > most_places)
            throw InputError("U106", "",
                             "A lamp every " + std::to_string(spacing) +
                                 " m would be more than a million lamps on the site: give \"outdoor\" a larger "
                                 "\"spacing\", or a smaller \"count\".");
        const Point first{(low_.x + high_.x - (columns - 1) * spacing) / 2,
                          (low_.y + high_.y - (rows - 1) * spacing) / 2};
        for (int j = 0; j < int(rows); ++j)
            for (int i = 0; i < int(columns); ++i) {
                const Place place =
                    to_millimetres({first.x + i * spacing, first.y + j * spacing, ground_ + light.elevation});
                if (!air_.holds_post({place[0], place[1]}, ground_, place[2])) continue;
                lamps.push_back(lamp_at("site/lamp-" + std::to_string(i + 1) + "-" + std::to_string(j + 1), "", place,
                                        light.lumen, light));
            }
        return lamps;
    }

private:
    OpenAir air_;
    Point low_, high_;
    double ground_ = 0;
    bool has_ground_ = false;
};

}  // namespace

std::vector<Lamp> entrance_lamps(const Building& building, const OutdoorLight& light, const VolumeFinder& volumes) {
    std::vector<Lamp> lamps;
    if (!(light.entrance_lumen > 0)) return lamps;
    std::vector<std::int32_t> head(building.spaces.size(), INT32_MIN);
    for (const Volume& volume : building.volumes)
        if (volume.label == Label::Door) head[volume.space] = std::max(head[volume.space], volume.z_high);
    const OpenAir air(building, volumes);
    for (const auto& [door, side] : thresholds(building)) {
        if (!(side.width2 > 0)) continue;
        const Point outward = plans::turned_left(side.b - side.a) * (off_wall / std::sqrt(side.width2));
        const Point at = (side.a + side.b) * 0.5 + outward;
        const double top = building.frame.world_z(head[door]);
        // Under a balcony there is no room over the door: then at the height of its head.
        for (const double z : {top + over_door, top - 0.05}) {
            const Place place = to_millimetres({at.x, at.y, z});
            if (!air.holds(place)) continue;
            const Space& space = building.spaces[door];
            lamps.push_back(lamp_at(space.id + "/lamp", space.name.empty() ? "" : space.name + ", lamp outside", place,
                                    light.entrance_lumen, light));
            lamps.back().storey = space.storey;
            break;
        }
    }
    return lamps;
}

std::vector<Lamp> site_lamps(const Building& building, const OutdoorLight& light, const VolumeFinder& volumes) {
    if (!(light.lumen > 0)) return {};
    const Site site(building, volumes);
    if (light.count == 0) return light.spacing > 0 ? site.lamps(light, light.spacing) : std::vector<Lamp>();
    // As wide a grid as has enough places, of grids a fifteenth apart; what is too many is left out evenly.
    for (double spacing = site.widest(light.count); spacing > 0.05; spacing /= 1.07) {
        std::vector<Lamp> all = site.lamps(light, spacing);
        if (all.size() < light.count) continue;
        std::vector<Lamp> kept;
        for (std::size_t k = 0; k < light.count; ++k) kept.push_back(std::move(all[k * all.size() / light.count]));
        return kept;
    }
    return site.lamps(light, 0.05);
}

}  // namespace enfilade::modeler

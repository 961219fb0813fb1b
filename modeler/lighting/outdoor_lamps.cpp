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
    std::vector<Lamp> lamps;
    if (!(light.spacing > 0 && light.lumen > 0)) return lamps;
    const plans::GridFrame& frame = building.frame;
    const Point low{frame.world_x(building.site_min[0]), frame.world_y(building.site_min[1])};
    const Point high{frame.world_x(building.site_max[0]), frame.world_y(building.site_max[1])};
    const double columns = std::floor((high.x - low.x) / light.spacing);
    const double rows = std::floor((high.y - low.y) / light.spacing);
    if (columns * rows > most_places)
        throw InputError("U106", "",
                         "A lamp every " + std::to_string(light.spacing) +
                             " m would be more than a million lamps on the site: give \"outdoor\" a larger "
                             "\"spacing\".");
    std::int32_t ground = INT32_MAX;
    for (const Volume& volume : building.volumes)
        if (volume.label == Label::Exterior) ground = std::min(ground, volume.z_low);
    if (ground == INT32_MAX) return lamps;
    const double foot = frame.world_z(ground);
    const Point first{(low.x + high.x - (columns - 1) * light.spacing) / 2,
                      (low.y + high.y - (rows - 1) * light.spacing) / 2};
    const OpenAir air(building, volumes);
    for (int j = 0; j < int(rows); ++j)
        for (int i = 0; i < int(columns); ++i) {
            const Place place =
                to_millimetres({first.x + i * light.spacing, first.y + j * light.spacing, foot + light.elevation});
            if (!air.holds_post({place[0], place[1]}, foot, place[2])) continue;
            lamps.push_back(lamp_at("site/lamp-" + std::to_string(i + 1) + "-" + std::to_string(j + 1), "", place,
                                    light.lumen, light));
        }
    return lamps;
}

}  // namespace enfilade::modeler

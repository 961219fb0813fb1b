#include "modeler/lighting/ceiling_lamps.h"

#include <algorithm>
#include <cmath>

#include "modeler/lighting/spread.h"
#include "modeler/objects/object_box.h"

namespace enfilade::modeler {
namespace {

using plans::Point;

constexpr double object_clearance = 0.05;  ///< metres to the boxes of objects
constexpr double least_height = 0.6;       ///< of a room's height: lower than that no lamp hangs, however low the room

/// What of a room's air is in the way of lamps at one height.
class FreeAir {
public:
    FreeAir(const RoomShape& room, double z, const VolumeFinder& volumes,
            std::span<const FurnishedObject* const> objects)
        : space_(room.space), z_(z), volumes_(volumes) {
        for (const FurnishedObject* object : objects) {
            const ObjectBox box = box_of(*object);
            if (z > box.z_low - object_clearance && z < box.z_high + object_clearance) boxes_.push_back(box.footprint);
        }
    }

    [[nodiscard]] bool is_free(Point p, double clearance) const {
        constexpr double diagonal = 0.7071067811865476;
        constexpr std::array<Point, 9> around = {Point{0, 0},
                                                 {1, 0},
                                                 {0, 1},
                                                 {-1, 0},
                                                 {0, -1},
                                                 {diagonal, diagonal},
                                                 {-diagonal, diagonal},
                                                 {-diagonal, -diagonal},
                                                 {diagonal, -diagonal}};
        return std::ranges::none_of(boxes_, [&](const auto& box) { return is_near(p, box); }) &&
               std::ranges::all_of(around, [&](Point way) {
                   return volumes_.holds(space_, {p.x + clearance * way.x, p.y + clearance * way.y, z_});
               });
    }

private:
    static bool is_near(Point p, const std::array<Point, 4>& box) {
        bool inside = true;
        for (std::size_t k = 0; k < 4; ++k) {
            const Point a = box[k], b = box[(k + 1) % 4];
            if (plans::distance(p, a, b) < object_clearance) return true;
            inside = inside && plans::cross(b - a, p - a) >= 0;
        }
        return inside;
    }

    std::uint32_t space_;
    double z_;
    const VolumeFinder& volumes_;
    std::vector<std::array<Point, 4>> boxes_;
};

}  // namespace

double room_lumen(double area_m2, const RoomLight& light, double utilisation) {
    return light.lux * area_m2 / utilisation;
}

std::array<double, 3> to_millimetres(const std::array<double, 3>& place) {
    std::array<double, 3> rounded = place;
    for (double& x : rounded) x = std::round(x * 1000) / 1000;
    return rounded;
}

std::vector<Lamp> ceiling_lamps(const RoomShape& room, const RoomLight& light, double utilisation, std::size_t count,
                                bool is_exact, const VolumeFinder& volumes,
                                std::span<const FurnishedObject* const> objects) {
    const plans::GridFrame& frame = room.frame;
    const double floor = frame.world_z(room.z_floor), ceiling = frame.world_z(room.z_ceiling);
    const auto world = [&](plans::GridPoint p) { return Point{frame.world_x(p.x), frame.world_y(p.y)}; };
    SpreadRegion region;
    for (const auto& ring : room.rings)
        for (const RoomSide& side : ring) region.sides.push_back({world(side.a), world(side.b)});
    region.area = room.area_m2;
    std::vector<Point> places;
    double z = std::max(ceiling - light.drop, floor + least_height * (ceiling - floor));
    // Where pieces or slopes take all of the air up there, lower, once.
    for (const double height : {z, (floor + ceiling) / 2}) {
        const FreeAir air(room, height, volumes, objects);
        region.is_free = [&](Point p, double clearance) { return air.is_free(p, clearance); };
        places = spread(region, count, is_exact);
        z = height;
        if (!places.empty()) break;
    }
    std::vector<Lamp> lamps;
    const double lumen = room_lumen(room.area_m2, light, utilisation) / double(std::max<std::size_t>(1, places.size()));
    for (const Point p : places) {
        Lamp lamp;
        lamp.id = room.id + "/lamp-" + std::to_string(lamps.size() + 1);
        lamp.name = room.name.empty() ? "" : room.name + ", lamp " + std::to_string(lamps.size() + 1);
        lamp.position = to_millimetres({p.x, p.y, z});
        if (!volumes.holds(room.space, lamp.position)) lamp.position = {p.x, p.y, z};
        lamp.radius = light.radius;
        lamp.colour = colour_of_kelvin(light.kelvin);
        lamp.lumen = std::max(1.0, std::round(lumen));
        lamp.by_rule = true;
        lamps.push_back(std::move(lamp));
    }
    return lamps;
}

}  // namespace enfilade::modeler

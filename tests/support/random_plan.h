#pragma once
// Plans as nobody should draw them: walls that cross, overlap and stop anywhere, of any thickness, in several storeys.

#include <rapidcheck.h>

#include <cmath>
#include <numbers>
#include <string>

#include "plans/plan.h"

namespace enfilade::testing {

/// A point on a coarse raster (so that things coincide), or anywhere.
inline rc::Gen<plans::Point> any_point() {
    return rc::gen::oneOf(rc::gen::map(rc::gen::pair(rc::gen::inRange(0, 9), rc::gen::inRange(0, 9)),
                                       [](const std::pair<int, int>& p) {
                                           return plans::Point{1.0 * p.first, 1.0 * p.second};
                                       }),
                          rc::gen::map(rc::gen::pair(rc::gen::inRange(0, 8000), rc::gen::inRange(0, 8000)),
                                       [](const std::pair<int, int>& p) {
                                           return plans::Point{p.first / 1000.0, p.second / 1000.0};
                                       }));
}

inline std::vector<plans::Point> any_box() {
    const plans::Point at = *any_point();
    const double w = *rc::gen::inRange(1, 30) / 10.0, d = *rc::gen::inRange(1, 30) / 10.0;
    return {at, {at.x + w, at.y}, {at.x + w, at.y + d}, {at.x, at.y + d}};
}

inline plans::Wall any_wall(const std::string& id) {
    plans::Wall wall;
    wall.id = id;
    wall.start = *any_point();
    wall.end = *any_point();
    wall.thickness = *rc::gen::element(0.3, 0.25, 0.2, 0.1, 0.05, 0.3001, 0.002, 1.0);
    wall.height_at_start = wall.height_at_end = *rc::gen::element(2.5, 2.5, 2.5, 1.0, 0.2, 3.5);
    if (*rc::gen::inRange(0, 4) == 0) wall.arc_extent = *rc::gen::element(0.5, -1.0, 3.0, -4.5);
    return wall;
}

/// One to three storeys with up to twelve walls each, openings, columns, stairs and room names.
inline plans::Plan any_plan() {
    plans::Plan plan;
    plan.name = "random";
    const int storeys = *rc::gen::element(1, 1, 2, 3);
    for (int k = 0; k < storeys; ++k) {
        plans::Storey storey;
        storey.id = storey.name = "s" + std::to_string(k);
        storey.elevation = 2.75 * k;
        storey.slab_thickness = 0.25;
        const int walls = *rc::gen::inRange(1, 13);
        for (int w = 0; w < walls; ++w) storey.walls.push_back(any_wall(storey.id + "w" + std::to_string(w)));
        const int openings = *rc::gen::inRange(0, 6);
        for (int o = 0; o < openings; ++o) {
            plans::Opening opening;
            opening.id = storey.id + "o" + std::to_string(o);
            opening.kind =
                *rc::gen::element(plans::OpeningKind::Door, plans::OpeningKind::Window, plans::OpeningKind::Opening);
            const plans::Wall& host = storey.walls[std::size_t(*rc::gen::inRange(0, walls))];
            opening.wall = host.id;
            opening.offset =
                *rc::gen::inRange(0, 100) / 100.0 * std::hypot(host.end.x - host.start.x, host.end.y - host.start.y);
            opening.width = *rc::gen::element(0.9, 0.5, 2.0, 0.01);
            opening.sill = *rc::gen::element(0.0, 0.9, 2.4);
            opening.head = opening.sill + *rc::gen::element(2.0, 0.1, 1.2);
            opening.open_angle = *rc::gen::element(0.0, 1.0);
            storey.openings.push_back(opening);
        }
        if (*rc::gen::inRange(0, 3) == 0)
            storey.columns.push_back({storey.id + "c", "", any_box(), *rc::gen::element(0.0, 1.0)});
        if (*rc::gen::inRange(0, 2) == 0) storey.stairs.push_back({storey.id + "stair", "", any_box()});
        if (*rc::gen::inRange(0, 3) == 0) storey.shafts.push_back({storey.id + "shaft", "", any_box()});
        const int rooms = *rc::gen::inRange(0, 4);
        for (int r = 0; r < rooms; ++r) {
            plans::Room room;
            room.id = room.name = storey.id + "r" + std::to_string(r);
            room.kind = *rc::gen::element<std::string>("room", "room", "courtyard");
            room.polygon = any_box();
            storey.rooms.push_back(room);
        }
        const int lamps = *rc::gen::inRange(0, 3);
        for (int l = 0; l < lamps; ++l) {
            plans::Light lamp;
            lamp.id = storey.id + "l" + std::to_string(l);
            lamp.position = any_box().front();  // in a room, a wall or outside
            lamp.elevation = *rc::gen::element(2.3, 0.0, -1.0, 2.5);
            lamp.power_lumen = *rc::gen::element(800.0, 0.0, 1256.6370614359173);
            lamp.radius = *rc::gen::element(0.0, 0.05);
            lamp.furniture = *rc::gen::element<std::string>("", "lamp");
            storey.lights.push_back(lamp);
        }
        plan.storeys.push_back(storey);
    }
    return plan;
}

}  // namespace enfilade::testing

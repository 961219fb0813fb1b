#pragma once
// Plans small enough to know every number of their model by heart.

#include <string>
#include <vector>

#include "plans/plan.h"

namespace enfilade::testing {

inline plans::Wall wall(std::string id, plans::Point a, plans::Point b, double thickness = 0.25, double height = 2.5) {
    plans::Wall result;
    result.id = std::move(id);
    result.start = a;
    result.end = b;
    result.thickness = thickness;
    result.height_at_start = result.height_at_end = height;
    return result;
}

inline plans::Opening opening(std::string id, plans::OpeningKind kind, std::string host, double offset, double width,
                              double sill, double head) {
    plans::Opening result;
    result.id = std::move(id);
    result.kind = kind;
    result.wall = std::move(host);
    result.offset = offset;
    result.width = width;
    result.sill = sill;
    result.head = head;
    return result;
}

inline plans::Storey storey(std::string id, double elevation = 0) {
    plans::Storey result;
    result.id = result.name = std::move(id);
    result.elevation = elevation;
    result.height = 2.5;
    result.slab_thickness = 0.25;
    return result;
}

/// Four walls around axes (0, 0) - (width, depth), named s, e, n, w after `prefix`.
inline void add_box(plans::Storey& to, const std::string& prefix, double width, double depth) {
    to.walls.push_back(wall(prefix + "s", {0, 0}, {width, 0}));
    to.walls.push_back(wall(prefix + "e", {width, 0}, {width, depth}));
    to.walls.push_back(wall(prefix + "n", {width, depth}, {0, depth}));
    to.walls.push_back(wall(prefix + "w", {0, depth}, {0, 0}));
}

/// One room of 4 m x 3 m between axes, a door in the south wall.
inline plans::Plan one_room() {
    plans::Plan plan;
    plan.name = "one room";
    plans::Storey ground = storey("ground");
    add_box(ground, "", 4, 3);
    ground.openings.push_back(opening("door", plans::OpeningKind::Door, "s", 1, 1, 0, 2));
    plan.storeys.push_back(ground);
    return plan;
}

/// Two rooms side by side, a door between them and one to the outside, a window.
inline plans::Plan two_rooms() {
    plans::Plan plan = one_room();
    plan.name = "two rooms";
    plans::Storey& ground = plan.storeys[0];
    ground.walls.push_back(wall("m", {2, 0}, {2, 3}, 0.125));
    ground.openings.push_back(opening("inner door", plans::OpeningKind::Door, "m", 1.5, 0.75, 0, 2));
    ground.openings.push_back(opening("window", plans::OpeningKind::Window, "n", 1, 1, 1, 2));
    return plan;
}

/// A room with a column in its middle: its floor is a ring.
inline plans::Plan ring_room() {
    plans::Plan plan = one_room();
    plan.name = "ring room";
    plan.storeys[0].columns.push_back({"column", "", {{1.75, 1.25}, {2.25, 1.25}, {2.25, 1.75}, {1.75, 1.75}}, 0});
    return plan;
}

/// Two storeys of the same outline joined by a stair; the upper one has a wall across and a terrace beside it.
inline plans::Plan two_storeys() {
    plans::Plan plan;
    plan.name = "two storeys";
    plans::Storey ground = storey("ground"), upper = storey("upper", 2.75);
    add_box(ground, "g", 8, 6);
    add_box(upper, "u", 5, 6);
    ground.openings.push_back(opening("door", plans::OpeningKind::Door, "gs", 4, 1, 0, 2));
    upper.walls.push_back(wall("um", {0, 4}, {5, 4}, 0.125));
    upper.openings.push_back(opening("upper door", plans::OpeningKind::Door, "um", 4, 0.75, 0, 2));
    upper.openings.push_back(opening("terrace door", plans::OpeningKind::Door, "ue", 2, 1, 0, 2));
    ground.stairs.push_back({"stair", "Stair", {{0.5, 0.5}, {1.5, 0.5}, {1.5, 3.5}, {0.5, 3.5}}});
    plan.storeys = {ground, upper};
    return plan;
}

}  // namespace enfilade::testing

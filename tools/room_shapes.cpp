#include "tools/room_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enfilade::tools {

using plans::GridPoint;

namespace {

constexpr std::int32_t metre = 8192;

std::vector<GridPoint> comb(std::uint32_t corners) {
    const std::uint32_t niches = corners / 4;
    const std::int32_t pitch = metre / 2, depth = 6 * metre;
    std::vector<GridPoint> points = {{0, 0}};
    const std::int32_t width = std::int32_t(niches) * pitch;
    points.push_back({width, 0});
    // Back along the upper side; niches of uneven depth, so that no two of their backs are in line.
    for (std::uint32_t k = niches; k-- > 0;) {
        const std::int32_t x = std::int32_t(k) * pitch;
        const std::int32_t back = depth + metre + std::int32_t(k * 2654435761u >> 20);
        if (k + 1 < niches) points.push_back({x + pitch, depth});
        points.push_back({x + pitch, back});
        points.push_back({x + pitch / 3, back});
        if (k > 0) points.push_back({x + pitch / 3, depth});
    }
    points.push_back({pitch / 3, depth});
    points.push_back({0, depth});
    return points;
}

std::vector<GridPoint> star(std::uint32_t corners) {
    std::vector<GridPoint> points;
    const double outer = std::max(4.0, 0.05 * corners) * metre;
    for (std::uint32_t k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * k / corners;
        const double uneven = double(k * 2654435761u >> 16) / 65536;
        const double radius = outer * (k % 2 == 0 ? 1 - 0.1 * uneven : 0.8 - 0.2 * uneven);
        points.push_back(
            {std::int32_t(std::lround(radius * std::cos(angle))), std::int32_t(std::lround(radius * std::sin(angle)))});
    }
    return points;
}

std::vector<GridPoint> arcs(std::uint32_t corners) {
    constexpr int chords = 16;
    const std::uint32_t bulges = std::max(1u, corners / 2 / (chords + 1));
    const std::int32_t pitch = 2 * metre, radius = 3 * metre / 4, depth = 8 * metre;
    const std::int32_t width = std::int32_t(bulges) * pitch;
    std::vector<GridPoint> points = {{0, 0}};
    const auto add_bulge = [&](std::int32_t middle, std::int32_t y, int up) {
        for (int c = 0; c <= chords; ++c) {
            const double angle = std::numbers::pi * (1 - double(c) / chords);
            points.push_back({middle + up * std::int32_t(std::lround(radius * std::cos(angle))),
                              y + up * std::int32_t(std::lround(radius * std::sin(angle)))});
        }
    };
    for (std::uint32_t k = 0; k < bulges; ++k) add_bulge(std::int32_t(k) * pitch + pitch / 2, 0, 1);
    points.push_back({width, 0});
    points.push_back({width, depth});
    for (std::uint32_t k = bulges; k-- > 0;) add_bulge(std::int32_t(k) * pitch + pitch / 2, depth, -1);
    points.push_back({0, depth});
    return points;
}

}  // namespace

const char* name_of(RoomShape shape) {
    switch (shape) {
        case RoomShape::Comb: return "comb";
        case RoomShape::Star: return "star";
        case RoomShape::Arcs: return "arcs";
    }
    return "comb";
}

ShapedRoom shaped_room(RoomShape shape, std::uint32_t corners) {
    ShapedRoom room;
    room.points = shape == RoomShape::Comb ? comb(corners) : shape == RoomShape::Star ? star(corners) : arcs(corners);
    const auto n = std::uint32_t(room.points.size());
    for (std::uint32_t k = 0; k < n; ++k) room.sides.push_back({k, (k + 1) % n, k, k, k, 1});
    return room;
}

}  // namespace enfilade::tools

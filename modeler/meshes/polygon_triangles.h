#pragma once
// Polygons with holes in the plane, cut into triangles; what keeps them from being one disc is told.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace enfilade::modeler {

enum class PolygonFault : std::uint8_t {
    None,
    Coincident,    ///< two corners at one place
    Crossing,      ///< two sides cross
    Touching,      ///< a corner lies on another side
    HoleOutside,   ///< an inner ring lies outside of the outer one
    HoleNested,    ///< an inner ring lies within another
    Disconnected,  ///< the rings leave several parts
    NoArea
};

struct PolygonVerdict {
    PolygonFault fault = PolygonFault::None;
    std::uint32_t corner = 0;  ///< where it shows
};

class PolygonTriangulator {
public:
    PolygonTriangulator();
    ~PolygonTriangulator();

    /// `ring_ends`: behind the last corner of each ring, the outer one first. Triangles are indices into `corners`,
    /// turning as the outer ring does; none where there is a fault. Exact.
    PolygonVerdict triangulate(std::span<const std::array<double, 2>> corners, std::span<const std::uint32_t> ring_ends,
                               std::vector<std::array<std::uint32_t, 3>>& triangles);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace enfilade::modeler

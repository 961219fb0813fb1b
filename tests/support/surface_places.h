#pragma once
// Places drawn from all surfaces of a scene that stop light, for integrals over them.

#include <cstdint>
#include <vector>

#include "accel/scene.h"
#include "render/path_trace.h"

namespace enfilade::test {

struct SurfacePlaces {
    std::vector<render::Vec3f> points;
    std::vector<render::Vec3f> normals;
    std::vector<accel::CellId> cells;
    std::vector<accel::MaterialId> materials;
    double area = 0;  ///< m2 of all surfaces, the sky's left out

    [[nodiscard]] render::LitPlaces view() const { return {points, normals, cells}; }
};

/// `count` places, evenly by area: each is drawn from an equal share of it.
[[nodiscard]] SurfacePlaces surface_places(const accel::SceneView& scene, std::size_t count, std::uint64_t seed);

}  // namespace enfilade::test

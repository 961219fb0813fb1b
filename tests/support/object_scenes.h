#pragma once
// Scenes with meshes that stand in rooms, and the nearest triangle of a mesh by brute force.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "accel/scene.h"
#include "accel/scene_input.h"
#include "render/vec.h"

namespace enfilade::test {

/// Triangles by their corners, each with vertices of its own.
[[nodiscard]] accel::InputMesh soup(const std::vector<std::array<std::array<float, 3>, 3>>& triangles);

/// A box of 12 triangles from `low` to `high`.
[[nodiscard]] accel::InputMesh box_mesh(std::array<float, 3> low, std::array<float, 3> high);

/// A ball about the origin of 2 * rings * 2 * rings triangles, bumpy so that boxes of its triangles overlap.
[[nodiscard]] accel::InputMesh ball_mesh(int rings, float radius);

/// `count` triangles of about `size` with corners drawn from a cube of side 2 about the origin.
[[nodiscard]] accel::InputMesh random_soup(std::uint32_t count, float size, std::uint64_t seed);

/// One closed room of 8 x 8 x 4 m about (0, 0, 2) in which each of the meshes stands once, at the origin and as it is.
[[nodiscard]] accel::Scene room_of_meshes(const std::vector<accel::InputMesh>& meshes);

/// Where `place` puts the meshes of a furnished scene.
struct FurnishedOptions {
    std::uint64_t seed = 1;
    int objects = 60;
    double turn = 0;        ///< of the building, radians
    double mesh_scale = 1;  ///< meshes are made that much larger, placements that much smaller
    bool stretched = true;  ///< else placements keep angles
};

/// The synthetic office with objects of half a metre to two at random places and turns, some mirrored, some across
/// walls and each other; each cell lists those whose boxes share a place with it.
[[nodiscard]] accel::Scene furnished_office(const FurnishedOptions& options);

/// Lists the objects of a scene input by boxes.
void list_objects(accel::SceneInput& input);

struct BruteHit {
    double t;  ///< in units of the direction
    std::uint32_t triangle;
    double margin;  ///< how far the hit lies inside the triangle: its least barycentric coordinate
};

/// By testing all triangles of the mesh in double (Möller and Trumbore); both sides are seen.
[[nodiscard]] std::optional<BruteHit> brute_nearest(const accel::SceneView& scene, accel::MeshId mesh,
                                                    render::Vec3d origin, render::Vec3d direction, double near,
                                                    double far);

}  // namespace enfilade::test

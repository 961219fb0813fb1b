#pragma once
// Buildings full of objects at random places, for tests of whatever traces, checks or writes furniture.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "accel/scene.h"
#include "modeler/building.h"

namespace enfilade::test {

/// Meshes of all kinds at the size of furniture: a box, a tetrahedron, spheres of 80, 1280 and 20480 triangles, an open
/// square, and ones that no tracer may stumble over: triangles without area, the same triangle many times, a million
/// times smaller than the rest, a fan of slivers on one vertex, a vertex alone, nothing at all.
[[nodiscard]] std::vector<std::shared_ptr<const modeler::ObjectMesh>> test_meshes();

/// `count` objects of those meshes in the rooms, in doorways and in front of the house, at any angle and of any size up
/// to 1.2 m, some mirrored, turned over or in a colour of their own. They overlap, stick in walls and hang in the air.
[[nodiscard]] modeler::Furnishing random_furnishing(const modeler::Building& building, std::uint64_t seed,
                                                    std::size_t count);

/// The building with `random_furnishing`. \pre it is convex and, for `Cut`, holds its stack
[[nodiscard]] modeler::Building furnished(const modeler::Building& building, std::uint64_t seed, std::size_t count,
                                          modeler::ObjectCells cells);

enum class FurnishedHouse { Townhouse, Office, Curved };

/// The townhouse of plans/examples, an office of 12 rooms, or 8 rooms with curved and oblique walls: convex.
[[nodiscard]] modeler::Building house(FurnishedHouse which);

/// Furnished, as a scene without model group.
[[nodiscard]] accel::Scene furnished_scene(FurnishedHouse which, std::uint64_t seed, std::size_t count,
                                           modeler::ObjectCells cells = modeler::ObjectCells::List);

}  // namespace enfilade::test

#pragma once
// Objects in scenes without plans, for tests of accel and render alone.

#include <cstddef>
#include <cstdint>

#include "accel/scene_input.h"

namespace enfilade::test {

/// `input` with `count` objects of four meshes (a box, a tetrahedron, triangles without area, nothing) around corners
/// of its cells, turned and mirrored. Every cell lists what its bounding box meets, so that some lists are longer than
/// they need be.
[[nodiscard]] accel::SceneInput with_objects(accel::SceneInput input, std::uint64_t seed, std::size_t count);

}  // namespace enfilade::test

#pragma once
// A mesh with its octree, and brute force over the same triangles by the same test: what walks have to answer to the
// last bit.

#include <cstdint>
#include <vector>

#include "accel/octree/linked_octree.h"
#include "accel/octree/octree.h"
#include "accel/octree/rope_octree.h"
#include "accel/scene.h"
#include "accel/scene_input.h"
#include "render/object_tracer.h"
#include "render/vec.h"

namespace enfilade::test {

/// A mesh without a scene about it.
class TriedMesh {
public:
    explicit TriedMesh(const accel::InputMesh& mesh);

    [[nodiscard]] accel::MeshPart part() const { return {places_.data(), triangles_.data(), used_}; }
    [[nodiscard]] const std::vector<accel::Vertex>& places() const { return places_; }
    [[nodiscard]] const std::vector<accel::MeshTriangle>& triangles() const { return triangles_; }
    [[nodiscard]] const std::vector<std::uint32_t>& used() const { return used_; }  ///< those that can be hit
    [[nodiscard]] float low(int axis) const { return low_[axis]; }                  ///< of those
    [[nodiscard]] float high(int axis) const { return high_[axis]; }
    /// The longest side of their box.
    [[nodiscard]] double size() const;
    [[nodiscard]] render::Vec3d corner(std::uint32_t triangle, std::size_t k) const;

    /// The ray's answer by testing all triangles as the walks do (triangle_test.h, brought near as near_ray.h says): of
    /// equally near ones that of the lowest number.
    [[nodiscard]] render::ObjectRay nearest(const render::ObjectRay& ray) const;

    /// How far from the triangle is what the test takes for the ray's meeting with it, in sizes of the mesh: rounding,
    /// large where a ray runs along the plane of the triangle; negative: the test says that it misses.
    [[nodiscard]] double off_triangle(const render::ObjectRay& ray, std::uint32_t triangle) const;

private:
    std::vector<accel::Vertex> places_;
    std::vector<accel::MeshTriangle> triangles_;
    std::vector<std::uint32_t> used_;
    float low_[3], high_[3];
};

/// One of its octrees, in every layout.
class TriedOctree {
public:
    TriedOctree(const TriedMesh& mesh, const accel::OctreeOptions& options);
    [[nodiscard]] const accel::Octree& tree() const { return tree_; }
    [[nodiscard]] accel::OctreeView view() const { return linked_.view(); }
    [[nodiscard]] std::size_t bytes() const { return linked_.bytes(); }
    /// The paper's, boxes stored, balanced if the tree is; and one with neighbours of any size and boxes computed.
    [[nodiscard]] accel::RopeView stored_ropes() const { return stored_ropes_.view(); }
    [[nodiscard]] accel::RopeView free_ropes() const { return free_ropes_.view(); }

private:
    accel::Octree tree_;
    accel::LinkedOctree linked_;
    accel::RopeOctree stored_ropes_, free_ropes_;
};

}  // namespace enfilade::test

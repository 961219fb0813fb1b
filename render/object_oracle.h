#pragma once
// Brute force over the triangles of all objects: what tracers of furnished rooms are checked against.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "accel/scene.h"
#include "render/oracle.h"
#include "render/trace_rays.h"

namespace enfilade::render {

/// Something that a ray may rightly end at: a triangle of an object, or the room's face.
struct PossibleEnd {
    double distance;   ///< metres
    double tolerance;  ///< metres along the ray: what a float tracer may miss it by
    bool is_sure;      ///< the ray passes it within rounding of an edge or of a wall otherwise
    accel::ObjectId object = none<accel::ObjectId>;  ///< none: the face
    std::uint32_t triangle = 0;
};

/// Tests every ray against every triangle of every object that some cell lists, in double, in the scene's space: it
/// shares neither trees, nor boxes, nor formulas with the tracers. An object is seen where one of the cells that list
/// it is. Glass does not stop its rays. Cost: linear in the triangles, about 10 ns each.
class ObjectOracle {
public:
    /// band: metres; a ray that passes an edge nearer than that may end on either side of it (error_band).
    ObjectOracle(const accel::SceneView& scene, double band);

    /// What the ray may end at, by distance: some of which rounding decides, then the first that stops it in any case.
    [[nodiscard]] std::vector<PossibleEnd> ends_of(const RayQuery& ray) const;

    /// Whether the answer is one of them. A ray of a length must not be answered as if it were endless.
    [[nodiscard]] bool allows(const RayQuery& ray, const RayHit& answer) const;

    /// Whether a triangle stands between p and q, farther than `touch` metres from both: yes, no, or nothing where
    /// rounding decides. Walls do not count, nor does the object `skipped`.
    [[nodiscard]] std::optional<bool> stands_between(Vec3d p, Vec3d q, double touch, accel::ObjectId skipped) const;

    /// Unit normal of a triangle; zero where it has no area.
    [[nodiscard]] Vec3d normal(accel::ObjectId object, std::uint32_t triangle) const;

private:
    struct Body {
        std::uint32_t first, count;  ///< triangles
        std::vector<std::uint32_t> cells;
    };
    void add_triangles(const accel::PlacedObject& object);
    [[nodiscard]] std::optional<PossibleEnd> meet(const std::array<Vec3d, 3>& triangle, Vec3d origin, Vec3d unit) const;
    [[nodiscard]] double depth_in(const Body& body, Vec3d point) const;
    void meet_object(std::uint32_t object, Vec3d origin, Vec3d unit, double farthest,
                     std::vector<PossibleEnd>& ends) const;

    const accel::SceneView& scene_;
    Oracle faces_;
    double band_;
    std::vector<Body> bodies_;                     ///< [object]
    std::vector<std::array<Vec3d, 3>> triangles_;  ///< in the scene
};

}  // namespace enfilade::render

#pragma once
// Brute force over the source faces: what the cells are checked against.

#include <optional>
#include <span>
#include <vector>

#include "accel/scene.h"
#include "render/camera.h"
#include "render/image.h"
#include "render/trace_rays.h"

namespace enfilade::render {

/// Where a ray first meets a source face from the side on which light is.
struct OracleHit {
    accel::SourceFaceId source_face;
    double distance;  ///< metres
};

/// Tests every ray against every source face as it was before convexification, concave ones included, in double, with
/// no acceleration on purpose: it shares neither cells nor formulas with the walk. Glass does not stop its rays. Cost:
/// linear in the faces, about 5 ns each.
class Oracle {
public:
    explicit Oracle(const accel::SceneView& scene);

    /// The first face that the ray meets from its light side; nothing if there is none. direction of any finite length.
    [[nodiscard]] std::optional<OracleHit> trace(Vec3d origin, Vec3d direction) const;

    /// The least distance (metres) at which the ray passes an edge of any source face up to `distance` along it. Rays
    /// that pass nearer than the error of a tracer's arithmetic may rightly end on either side of that edge: the error
    /// band.
    [[nodiscard]] double edge_distance(Vec3d origin, Vec3d direction, double distance) const;

    /// Metres from the point to the face's plane.
    [[nodiscard]] double plane_distance(Vec3d point, accel::SourceFaceId face) const;

    /// The source face's normal on its light side.
    [[nodiscard]] Vec3d normal(accel::SourceFaceId face) const { return faces_[index(face)].normal; }

private:
    struct Face {
        Vec3d normal;                ///< unit
        double offset;               ///< normal . point on the plane
        int axis;                    ///< dropped for the 2D test: where the normal is longest
        std::uint32_t first, count;  ///< ring in `vertices_`
    };
    std::vector<Face> faces_;
    std::vector<Vec3d> vertices_;
};

/// The picture that the camera sees by the oracle, lit like `Shading::Lambert`, on the calling thread. mirror_floor:
/// share of their light that floors reflect. Cost: pixels times faces. \throws as `trace`
[[nodiscard]] Image trace_by_oracle(const accel::SceneView& scene, const Camera& camera, int samples_per_pixel = 1,
                                    float mirror_floor = 0);

/// A tracer's answers against the oracle's. A ray counts as agreeing if both name the same source face.
struct Agreement {
    std::uint64_t rays = 0;
    std::uint64_t differing_inside_band =
        0;  ///< pass an edge, or start at the plane of the face met, nearer than the band
    std::uint64_t differing_outside_band = 0;  ///< none are expected
    double largest_distance_error = 0;         ///< metres, of the agreeing ones that meet their face at over 1 degree
};

/// The band in which float walks may differ from exact geometry, for a scene as large as this one: 16 roundings of its
/// largest coordinate, and two grid units.
[[nodiscard]] double error_band(const accel::SceneView& scene);

/// hits: [rays.size()], as `trace_rays` answered. Cost: rays times faces.
[[nodiscard]] Agreement compare(const Oracle& oracle, std::span<const RayQuery> rays, std::span<const RayHit> hits,
                                double band);

}  // namespace enfilade::render

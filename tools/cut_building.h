#pragma once
// One building cut in several ways, to be compared on the same rays.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "accel/scene.h"
#include "modeler/convexify.h"
#include "render/camera.h"
#include "render/framebuffer.h"
#include "render/trace_rays.h"
#include "render/tracer.h"
#include "tools/cut_figures.h"
#include "tools/floor_views.h"
#include "tools/room_pieces.h"

namespace enfilade::tools {

struct CutBuilding {
    accel::Scene scene;
    CutFigures figures;
    std::vector<std::uint32_t> parents;  ///< [cell] the volume that it is cut from
    RoomPieces rooms;                    ///< of those without holes
    std::uint64_t moved = 0;
    std::uint64_t fallen_back = 0;
};

/// Cut and exported; not checked. \pre `whole` comes from `build`
[[nodiscard]] CutBuilding cut_building(const modeler::Building& whole, const modeler::ConvexifyOptions& options);

/// The same rays, and pictures from the same places, in all scenes of one building.
class SameRays {
public:
    /// `ray_count` rays (even_rays.h), and `view_count` square pictures of `side` pixels; views and rays that start
    /// within rounding of a wall are left out. The scenes are kept by reference.
    SameRays(std::vector<const accel::SceneView*> scenes, std::size_t ray_count, std::size_t view_count, int side);

    [[nodiscard]] std::size_t ray_count() const { return rays_.front().size(); }
    [[nodiscard]] std::size_t pixel_count() const { return views_.front().size() * pixels_a_view_; }
    [[nodiscard]] const std::vector<render::RayQuery>& rays(std::size_t scene) const { return rays_[scene]; }

    /// For a Contest: one competitor a scene, on the calling thread.
    [[nodiscard]] std::vector<std::function<void()>> random();
    [[nodiscard]] std::vector<std::function<void()>> primary(render::Tracer tracer = render::Tracer::Scalar);

    /// Rays that see another face in `scene` than in `reference`, and rays that end nowhere in `scene`.
    struct Agreement {
        std::size_t differ = 0;
        std::size_t leaks = 0;
    };
    [[nodiscard]] Agreement agreement(std::size_t scene, std::size_t reference) const;

private:
    std::vector<const accel::SceneView*> scenes_;
    std::vector<std::vector<render::RayQuery>> rays_;  ///< [scene]
    std::vector<std::vector<PreparedView>> views_;     ///< [scene]
    std::size_t pixels_a_view_ = 0;
    std::vector<render::RayHit> hits_;
    render::Framebuffer framebuffer_;
};

}  // namespace enfilade::tools

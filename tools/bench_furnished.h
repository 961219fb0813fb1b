#pragma once
// What the benchmarks of furnished floors share (bench_furnished*.cpp).

#include <memory>
#include <string>

#include "render/embree_instances.h"
#include "render/object_tracer.h"
#include "tools/bench_cells.h"
#include "tools/furnished_floor.h"

namespace enfilade::tools {

/// A furnished floor as tracers see it, and Embree's scene of it.
struct TracedFloor {
    const FurnishedFloor* floor;
    double accel_seconds = 0;
    std::unique_ptr<render::ObjectAccel> accel;
    render::ObjectTracer objects;
    double embree_seconds = 0;
    std::unique_ptr<render::EmbreeInstances> embree;  ///< nullptr where it is not asked for

    TracedFloor(const FurnishedFloor& floor_, bool has_embree,
                render::ObjectAccelKind kind = render::ObjectAccelKind::Bvh);
    [[nodiscard]] const accel::SceneView& scene() const { return floor->scene.view(); }
    [[nodiscard]] const std::string& name() const { return floor->name; }
};

/// Embree's way that all ratios are against: instanced, 16 coherent rays, of quads or triangles.
[[nodiscard]] bool is_sixteen_coherent(render::EmbreeWay way);

/// Pixels of which a channel differs by more than one step.
[[nodiscard]] std::uint64_t unlike_pixels(const render::Framebuffer& a, const render::Framebuffer& b);

/// Pictures: every tracer against Embree's instances, asked in every way. `octrees`: the same floor with octrees inside
/// objects; `cut`: the same objects as volumes.
void bench_furnished_pictures(Bench& bench, const TracedFloor& traced, const TracedFloor& octrees,
                              const TracedFloor* cut);
/// Bounces, in the order of an image and shuffled, and shadow rays to lamps.
void bench_furnished_streams(Bench& bench, const TracedFloor& traced, const TracedFloor& octrees);

}  // namespace enfilade::tools

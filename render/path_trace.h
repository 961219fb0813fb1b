#pragma once
// Global illumination: light that goes from surface to surface, by path tracing over the same cells (README.md,
// "Paths").

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/camera.h"
#include "render/image.h"
#include "render/lamps.h"
#include "render/look.h"
#include "render/object_tracer.h"
#include "render/walk_events.h"

namespace enfilade::render {

/// How far a picture has come.
struct PathProgress {
    int samples_done = 0;       ///< a pixel, in the part of the picture that is still worked at
    int samples_wanted = 0;     ///< at most
    double noise = 0;           ///< PathNoise::typical of what there is
    double share_finished = 0;  ///< of the pixels: those that need no more samples
};

/// Light and how it is followed. Sky and sun are in units of the picture, lamps come by their exposure.
struct PathOptions {
    int samples_per_pixel = 64;  ///< at most; rounded up to a multiple of 4
    int most_bounces = 32;       ///< after the place that the eye sees; 0: direct light alone; at most 1000. From the
                                 ///< fourth on paths end by chance (Russian roulette), which costs no light
    int lamps_per_bounce = 0;    ///< that many are asked at each place, drawn by what they would give if nothing stood
                                 ///< between; 0: all that the place's cell may see
    double noise = 0;  ///< parts of the picture in which PathNoise::typical is less get no more samples; 0: all get all
    int samples_per_pass = 0;  ///< progress is told, and noise asked for, so often; 0: after 8, 16, 32, 64... samples
    std::uint64_t seed = 0;    ///< another one: other noise

    bool lamps = true;  ///< whether the scene's lamps shine
    LampSearch search = LampSearch::Tree;
    float exposure = 1;                          ///< what a white surface in a light of pi lux becomes in the picture
    std::optional<accel::LightTreesView> trees;  ///< nothing: built for this picture; those of others need
                                                 ///< LightTreeOptions::balls where lamps have a radius

    Look look;                     ///< its sky and sun; the rest of it is for `trace`
    float sky = 1;                 ///< what the Look's sky is multiplied by; 0: dark
    float sun = 1;                 ///< and its sun
    double sun_radius_deg = 0.27;  ///< half the angle at which the sun is seen

    float mirror_floor = 0;  ///< share of their light that floors reflect as mirrors do, 0 to 1
    float clamp = 0;         ///< light that comes by way of a bounce counts for no more than this, which takes off
                             ///< bright dots and some light; 0: nothing is taken off, on average the picture is right

    std::optional<accel::CellId> start;         ///< the cell that holds the eye, where it is known; else looked for
    std::optional<double> cut_z;                ///< dollhouse: the camera does not see what lies above; light does
    const accel::Executor* executor = nullptr;  ///< nullptr: all cores. Results do not depend on it.
    const ObjectTracer* objects = nullptr;      ///< nullptr: where the scene has objects, built for this picture
    RayStats* stats = nullptr;                  ///< where given, what happened to the rays is added
    std::function<bool(const PathProgress&)> progress;  ///< called after each pass; false: it was enough
};

/// The noise of a picture: the standard error of each pixel's luminance over that luminance and 0.02 (so that black
/// places need no endless work), estimated from four sequences of samples that know nothing of each other.
struct PathNoise {
    double typical = 0;            ///< the root of the mean square over the pixels
    double mean = 0;               ///< over the pixels
    double share_above_5 = 0;      ///< of the pixels: noise of 5 % and more
    double mean_luminance = 0;     ///< of the picture
    double error_of_the_mean = 0;  ///< standard error of that, absolute
};

struct PathResult {
    Image image;                        ///< linear; not clipped, no shoulder
    std::vector<float> standard_error;  ///< [width * height] of each pixel's luminance, absolute
    std::vector<int> samples;           ///< [width * height] done
    PathNoise noise;
};

/// A picture with global illumination. The same bytes on any number of threads and every instruction set.
/// \throws InputError as `trace`; R4 too for options out of their ranges
[[nodiscard]] PathResult trace_paths(const accel::SceneView& scene, const Camera& camera,
                                     const PathOptions& options = {});

/// Places on surfaces, as columns of one length.
struct LitPlaces {
    std::span<const Vec3f> points;   ///< metres, scene frame
    std::span<const Vec3f> normals;  ///< of length 1, into the room
    std::span<const accel::CellId> cells;
};

/// What falls on a surface: lux by linear RGB of the lamps, direct and by bounces, besides what sky and sun give in
/// units of pi / exposure.
struct PlaceLight {
    Vec3d lux = {0, 0, 0};
    double standard_error = 0;  ///< of its luminance
};

/// How bright it is at places: a light meter that knows all bounces. Camera, cut and noise do not apply. [places]
[[nodiscard]] std::vector<PlaceLight> measure_light(const accel::SceneView& scene, const LitPlaces& places,
                                                    const PathOptions& options = {});

/// The picture with bright surfaces brought below white softly, from `shoulder` on (Look::shoulder).
[[nodiscard]] Image under_shoulder(Image image, float shoulder);

}  // namespace enfilade::render

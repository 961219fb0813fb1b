#pragma once
// Who looks for lamps, against brute force and against each other.

#include <cstdint>
#include <string>
#include <vector>

#include "accel/lights/light_trees.h"
#include "render/camera.h"
#include "render/object_tracer.h"
#include "render/trace.h"
#include "tests/support/lit_scene.h"

namespace enfilade::test {

/// What pairs of a place and a lamp came to.
struct PairTally {
    std::uint64_t pairs = 0;
    std::uint64_t lit = 0;        ///< by the walk
    std::uint64_t differing = 0;  ///< a list or a tree answers other than the walk, within the error band of an edge
    std::uint64_t wrong = 0;      ///< some answer is wrong by brute force
    std::uint64_t missed = 0;     ///< of these: the place sees a lamp that a list or a tree lacks
    std::string first_wrong;      ///< in words

    void add(const PairTally& other);
};

/// Asks the walk, lists and trees of `count` random pairs whether the place sees the lamp, and brute force where they
/// differ, or always if `is_thorough`. objects: what stands in the rooms, or nullptr.
[[nodiscard]] PairTally judge_pairs(const accel::SceneView& scene, const render::ObjectTracer* objects, int count,
                                    std::uint64_t seed, bool is_thorough = true);

/// Pairs that a test is to ask: the environment's ENFILADE_LAMP_PAIRS, for campaigns, or `usual`.
[[nodiscard]] int pairs_to_ask(int usual);

/// What pictures by lists and trees came to, against the one that walks to all lamps.
struct PictureTally {
    std::uint64_t pixels = 0;
    std::uint64_t lit = 0;        ///< pixels that are not black
    std::uint64_t differing = 0;  ///< from the walked picture by more than rounding, where a way passes an edge closely
    std::uint64_t wrong = 0;      ///< elsewhere
    std::string first_wrong;
};

/// Draws by all three searches. Options are used as they are but for the lamps' search. Of cut pictures, and of those
/// with mirrors, differing pixels are wrong.
[[nodiscard]] PictureTally judge_pictures(const accel::SceneView& scene, const render::Camera& camera,
                                          render::TraceOptions options, const render::ObjectTracer* objects);

/// A camera in each of `count` cells that have lamps, of that many pixels a side, looking across.
[[nodiscard]] std::vector<render::Camera> cameras_by_lamps(const accel::SceneView& scene, int count, int pixels);

}  // namespace enfilade::test

#pragma once
// Inside of render: a picture's options checked, and what its loops are given of them, whoever runs these.

#include <cstdint>

#include "accel/lights/light_trees.h"
#include "accel/scene.h"
#include "render/camera.h"
#include "render/lamps.h"
#include "render/look.h"
#include "render/trace.h"

namespace enfilade::render::detail {

struct PictureSetup {
    CameraFrame frame;
    accel::SceneView scene;  ///< without what its materials do besides their colour, where the picture does not show it
    Look look;
    int samples_a_side;
    std::uint32_t start_cell;  ///< unless it is cut
    bool is_cut;
    float cut_z;
    bool is_plain;  ///< Lambert's shading of one sample, uncut
};

/// \throws InputError as `trace` does, but for what tracers of the CPU alone are asked (packets, who walks in double)
[[nodiscard]] PictureSetup set_up(const accel::SceneView& scene, const Camera& camera, const TraceOptions& options);

/// own: holds the trees where the caller brings none and needs some.
[[nodiscard]] Lamps prepared(const accel::SceneView& scene, const LampOptions& options, const accel::Executor& executor,
                             accel::LightTrees& own);

}  // namespace enfilade::render::detail

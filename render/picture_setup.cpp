#include "render/picture_setup.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace enfilade::render::detail {

PictureSetup set_up(const accel::SceneView& scene, const Camera& camera, const TraceOptions& options) {
    if (!(options.mirror_floor >= 0 && options.mirror_floor <= 1))
        throw InputError("R4", "", "a floor mirrors a share of the light between 0 and 1");
    PictureSetup setup = {};
    setup.frame = make_frame(camera);
    setup.scene = scene;
    const bool is_lambert = options.shading == Shading::Lambert;
    // A lamp at the eye alone shows plain colours, whoever traces, with any number of samples.
    if (is_lambert && !options.lamps) setup.scene.material_looks = {};
    setup.samples_a_side = std::max(1, static_cast<int>(std::ceil(std::sqrt(std::max(1, options.samples_per_pixel)))));
    setup.is_cut = options.cut_z.has_value();
    if (setup.is_cut) {
        setup.cut_z = static_cast<float>(*options.cut_z);
        if (!(setup.frame.origin.z > setup.cut_z))
            throw InputError("R3", "", "the camera stands below the height at which the building is cut; move it up");
    } else {
        setup.start_cell = static_cast<std::uint32_t>(options.start ? *options.start : start_cell(scene, setup.frame));
    }
    setup.is_plain = is_lambert && !setup.is_cut && setup.samples_a_side == 1;
    setup.look = is_lambert && (!setup.is_plain || options.lamps) ? lambert_look(options.look) : options.look;
    return setup;
}

Lamps prepared(const accel::SceneView& scene, const LampOptions& options, const accel::Executor& executor,
               accel::LightTrees& own) {
    const bool needs_trees = options.search != LampSearch::Naive;
    if (needs_trees && !options.trees)
        own = accel::build_light_trees(scene, {.trees = options.search == LampSearch::Tree}, executor);
    return {options.trees ? *options.trees : own.view(), options.search, options.exposure};
}

}  // namespace enfilade::render::detail

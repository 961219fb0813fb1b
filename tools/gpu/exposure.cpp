#include "tools/gpu/exposure.h"

#include <cmath>

#include "render/trace.h"

namespace enfilade::tools::gpu {

float picture_exposure(const TriedScene& scene, const accel::LightTreesView& trees, const accel::Executor& executor) {
    constexpr int side = 48;
    const accel::SceneView view = scene.view();
    for (int power = 0; power > -16; --power) {
        render::Lamps lamps;
        lamps.trees = trees;
        lamps.exposure = std::ldexp(1.0f, power);
        std::size_t white = 0, pixels = 0;
        for (const TriedView& tried : scene.views) {
            render::Framebuffer picture(side, side);
            trace_lambert(view, tried.frame(side), tried.start, {.tracer = render::Tracer::Scalar, .lamps = &lamps},
                          executor, picture);
            for (const std::uint32_t pixel : picture.rgba) white += (pixel & 0xffu) == 0xffu ? 1 : 0;
            pixels += picture.rgba.size();
        }
        if (white * 100 <= pixels * 3) return lamps.exposure;
    }
    return 0x1p-16f;
}

}  // namespace enfilade::tools::gpu

#pragma once
// Pictures of furnished rooms by two tracers, pixel by pixel: which differences rounding explains.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "accel/scene.h"
#include "render/camera.h"
#include "render/framebuffer.h"
#include "render/object_tracer.h"

namespace enfilade::test {

/// Pixels that differ by more than one step of 255.
struct FurnishedVerdict {
    std::uint64_t pixels = 0;
    std::uint64_t differing = 0;
    std::uint64_t unexplained = 0;    ///< that no ray beside it shows either, nor a triangle edge-on: faults
    std::vector<std::string> faults;  ///< the first few, in words

    void add(const FurnishedVerdict& other);
    [[nodiscard]] std::string text() const;
};

/// Judges pictures from one camera against the scalar tracer's. Where a pixel differs, eyes beside the camera's are
/// asked, as far away as rounding moves things (`render::error_band`): the scalar tracer sees from one of them what the
/// other tracer saw, or rounding is no excuse.
class FurnishedJudge {
public:
    FurnishedJudge(const accel::SceneView& scene, const render::ObjectTracer& objects, const render::CameraFrame& frame,
                   accel::CellId start, int width, int height, float mirror_floor = 0);

    [[nodiscard]] const render::Framebuffer& expected() const { return expected_; }
    [[nodiscard]] FurnishedVerdict compare(const render::Framebuffer& actual);

private:
    [[nodiscard]] render::Framebuffer scalar(const render::CameraFrame& frame, accel::CellId start) const;
    void look_from_beside();

    const accel::SceneView* scene_;
    const render::ObjectTracer* objects_;
    render::CameraFrame frame_;
    accel::CellId start_;
    int width_, height_;
    float mirror_floor_;
    render::Framebuffer expected_;
    std::vector<render::Framebuffer> beside_;  ///< empty until a pixel differs
};

}  // namespace enfilade::test

#pragma once
// Pixels of two tracers' pictures, one by one: which differences rounding explains, and which are faults.

#include <cstdint>
#include <string>
#include <vector>

#include "accel/scene.h"
#include "render/camera.h"
#include "render/framebuffer.h"
#include "render/image.h"
#include "render/oracle.h"

namespace enfilade::test {

/// What became of the pixels that differ.
struct PictureVerdict {
    std::uint64_t pixels = 0;
    std::uint64_t inside_band = 0;    ///< show another face, and their ray passes an edge within the error band
    std::uint64_t outside_band = 0;   ///< show another face: a fault
    std::uint64_t other_shade = 0;    ///< show the same face otherwise lit: a fault
    std::uint64_t leaks = 0;          ///< magenta: a fault
    std::vector<std::string> faults;  ///< the first few, in words

    [[nodiscard]] bool is_right() const { return outside_band + other_shade + leaks == 0; }
    [[nodiscard]] std::string text() const;
    void add(const PictureVerdict& other);
};

/// A camera's numbers as a test prints them.
[[nodiscard]] std::string text_of(const render::CameraFrame& frame, int width, int height);

/// Judges pictures of one scene whose faces have their own colours (coloured_scene.h): Lambert, one sample a pixel.
class PictureJudge {
public:
    explicit PictureJudge(const accel::SceneView& scene);

    /// Channels may differ by 1e-3 of themselves.
    [[nodiscard]] PictureVerdict compare(const render::CameraFrame& frame, accel::CellId start,
                                         const render::Image& expected, const render::Image& actual) const;
    /// Channels may differ by one step of 255.
    [[nodiscard]] PictureVerdict compare(const render::CameraFrame& frame, accel::CellId start,
                                         const render::Framebuffer& expected, const render::Framebuffer& actual) const;

private:
    struct Pixel {
        int x, y;
        render::Vec3f expected, actual;  ///< linear
        float tolerance;                 ///< of a channel, linear: what its encoding loses
    };
    void judge(const render::CameraFrame& frame, accel::CellId start, const Pixel& pixel,
               PictureVerdict& verdict) const;

    const accel::SceneView* scene_;
    render::Oracle oracle_;
    double band_;
    double largest_;  ///< coordinate, metres
};

}  // namespace enfilade::test

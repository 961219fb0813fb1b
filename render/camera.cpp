#include "render/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "accel/locate.h"
#include "base/error.h"

namespace enfilade::render {
namespace {

bool is_finite(Vec3d v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// In the plan's metres, as people type and read them.
std::string text(const accel::SceneView& scene, Vec3f p) {
    std::array<char, 96> buffer;
    std::snprintf(buffer.data(), buffer.size(), "(%.3f, %.3f, %.3f)", p.x + scene.origin[0], p.y + scene.origin[1],
                  p.z + scene.origin[2]);
    return buffer.data();
}

}  // namespace

CameraFrame make_frame(const Camera& camera) {
    const auto refuse = [](const char* sentence) { throw InputError("R1", "", sentence); };
    if (!is_finite(camera.eye) || !is_finite(camera.target) || !is_finite(camera.up) || !std::isfinite(camera.fov_deg))
        refuse("the camera has a number that is not finite; give its eye and target in metres");
    if (camera.width < 1 || camera.height < 1 || camera.width > 1 << 16 || camera.height > 1 << 16)
        refuse("an image needs between 1 and 65536 pixels a side");
    if (!(camera.fov_deg > 0) || !(camera.fov_deg < 180))
        refuse("the field of view must lie between 0 and 180 degrees");
    const Vec3d view = camera.target - camera.eye;
    if (!(length(view) > 0)) refuse("the camera looks at its own eye; move its target");
    const Vec3d forward = normalized(view);
    const Vec3d side = cross(forward, camera.up);
    if (!(length(side) > 1e-9 * length(camera.up)))
        refuse("the camera looks along its up direction; give another one, for example 0,1,0");
    const Vec3d right = normalized(side);
    const Vec3d down = cross(forward, right);
    const int longer = std::max(camera.width, camera.height);
    const double pixel = 2 * std::tan(camera.fov_deg * std::numbers::pi / 360) / longer;
    const Vec3d corner = forward - (0.5 * pixel * camera.width) * right - (0.5 * pixel * camera.height) * down;
    return {vec_cast<float>(camera.eye), vec_cast<float>(corner), vec_cast<float>(pixel * right),
            vec_cast<float>(pixel * down)};
}

accel::CellId start_cell(const accel::SceneView& scene, const CameraFrame& frame) {
    const Vec3f eye = frame.origin;
    const std::optional<accel::CellId> cell = accel::locate(scene, {eye.x, eye.y, eye.z});
    if (cell) return *cell;
    const accel::LocatorNode& site = scene.locator_nodes[0];
    const bool is_outside = eye.x < site.low[0] || eye.y < site.low[1] || eye.z < site.low[2] || eye.x > site.high[0] ||
                            eye.y > site.high[1] || eye.z > site.high[2];
    const std::string corners = text(scene, {site.low[0], site.low[1], site.low[2]}) + " to " +
                                text(scene, {site.high[0], site.high[1], site.high[2]});
    const bool has_rooms = std::any_of(scene.spaces.begin(), scene.spaces.end(),
                                       [](const accel::Space& space) { return space.label == accel::Label::Room; });
    const std::string remedy =
        has_rooms ? " or name a room with --room" : ", or give --camera exterior or aerial in its place";
    throw InputError(
        "R2", "",
        is_outside
            ? "the camera at " + text(scene, eye) + " stands outside the site, which reaches from " + corners +
                  "; move it inside" + remedy
            : "the camera at " + text(scene, eye) + " stands inside a wall, a slab or the ground; move it" + remedy);
}

}  // namespace enfilade::render

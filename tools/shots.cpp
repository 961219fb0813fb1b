#include "tools/shots.h"

#include <charconv>

#include "base/error.h"
#include "tools/false_colour.h"
#include "tools/mesh_scene.h"
#include "tools/view_file.h"

namespace enfilade::tools {

namespace {

constexpr int largest_side = 32768;

const char* usual_camera(const RenderOptions& options) {
    return is_mesh_file(options.scene) ? "exterior" : "dollhouse";
}

/// Width and height of what a camera sees.
std::pair<int, int> picture_size(const RenderOptions& options) {
    const auto [width, height] = parse_size(options.size);
    return {width, height - scale_rows(options)};
}

Shot chosen_shot(const RenderOptions& options, const accel::SceneView& scene) {
    const auto [width, height] = picture_size(options);
    return {{},
            !options.room.empty()
                ? room_view(scene, options.room, width, height)
                : named_view(scene, options.camera.empty() ? usual_camera(options) : options.camera, width, height),
            {}};
}

}  // namespace

std::array<int, 2> parse_size(const std::string& text) {
    std::array<int, 2> size = {};
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size[0]);
    const bool has_x = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
    const auto height = has_x ? std::from_chars(width.ptr + 1, end, size[1]) : width;
    for (const int side : size)
        if (!has_x || height.ec != std::errc() || height.ptr != end || side < 1 || side > largest_side)
            throw InputError("F111", "",
                             "--size \"" + text +
                                 "\" is no size: give width x height in pixels, like 1280x960, at most " +
                                 std::to_string(largest_side) + " each.");
    return size;
}

int scale_rows(const RenderOptions& options) {
    const auto [width, height] = parse_size(options.size);
    return options.show.empty() ? 0 : bar_rows(width, height);
}

std::vector<Shot> chosen_shots(const RenderOptions& options, const accel::SceneView& scene, const Console& console) {
    std::vector<Shot> shots;
    if (options.views.empty()) {
        shots.push_back(chosen_shot(options, scene));
    } else {
        const ViewFile file = read_views(options.views, scene);
        if (!file.relocated.empty() && !console.quiet()) console.warn(file.warning(options.views));
        for (const SavedView& view : file.views) shots.push_back({view.name, {view.camera, {}}, view.cell});
    }
    const auto [width, height] = picture_size(options);
    for (Shot& shot : shots) {
        shot.view.camera.width = width;
        shot.view.camera.height = height;
        if (options.fov_deg) shot.view.camera.fov_deg = *options.fov_deg;
    }
    return shots;
}

}  // namespace enfilade::tools

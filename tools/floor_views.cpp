#include "tools/floor_views.h"

#include <cmath>

namespace enfilade::tools {

std::vector<render::Camera> floor_views(const accel::SceneView& scene, std::size_t count, int side) {
    std::vector<std::size_t> cells;
    for (std::size_t c = 0; c < scene.cells.size(); ++c)
        if (scene.cells[c].label == accel::Label::Room) cells.push_back(c);
    if (cells.empty())
        for (std::size_t c = 0; c < scene.cells.size(); ++c) cells.push_back(c);
    std::vector<render::Camera> views;
    for (std::size_t k = 0; k < count && !cells.empty(); ++k) {
        const accel::Cell& cell = scene.cells[cells[(2 * k + 1) * cells.size() / (2 * count)]];
        const double height = double(cell.z_ceiling) - cell.z_floor;
        render::Vec3d eye = {0, 0, cell.z_floor + (height > 1.7 ? 1.6 : height / 2)};
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s)
            eye = eye + (1.0 / cell.section_count) * render::Vec3d{scene.section_x[s], scene.section_y[s], 0};
        const double angle = 2.399963229728653 * double(k);
        render::Camera camera;
        camera.eye = eye;
        camera.target = eye + render::Vec3d{std::cos(angle), std::sin(angle), -0.05};
        camera.width = camera.height = side;
        views.push_back(camera);
    }
    return views;
}

std::vector<PreparedView> prepared(const accel::SceneView& scene, const std::vector<render::Camera>& cameras) {
    std::vector<PreparedView> views;
    for (const render::Camera& camera : cameras) {
        const render::CameraFrame frame = render::make_frame(camera);
        views.push_back({frame, render::start_cell(scene, frame)});
    }
    return views;
}

}  // namespace enfilade::tools

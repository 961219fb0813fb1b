#pragma once
// A scene of the bundle and the views from which it is looked at.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "accel/scene.h"
#include "render/camera.h"

namespace enfilade::tools::gpu {

/// A camera, and the cell of the scene from which it sees.
struct TriedView {
    std::string name;
    render::Camera camera;  ///< square; frame(side) has its size
    accel::CellId start;

    [[nodiscard]] render::CameraFrame frame(int side) const;
};

/// A scene with its views. Movable.
struct TriedScene {
    std::string name;  ///< of the file, without its ending
    accel::Scene file;
    std::vector<TriedView> views;         ///< at least one
    std::vector<accel::Light> lamps;      ///< instead of the file's, where there are any
    std::size_t instanced_triangles = 0;  ///< of all objects

    [[nodiscard]] accel::SceneView view() const;
    [[nodiscard]] bool has_lamps() const { return view().lights.count != 0; }
    [[nodiscard]] bool has_objects() const { return view().has_objects(); }
    /// One cell that the sky surrounds: a mesh by itself.
    [[nodiscard]] bool is_single_mesh() const { return view().cells.count == 1 && view().objects.count == 1; }
};

/// Opens SCENE.enf and, where it exists, SCENE.views beside it: text, a line each of
///
///     view NAME eye x y z, target x y z, field of view in degrees    (metres, in the frame of the plan)
///     lamps COUNT rooms|hanging|outside                              (spread_lamps.h; instead of the file's own)
///
/// with numbers apart by spaces alone, and # before remarks. Where no view is given, `own_views` cameras stand in rooms
/// spread over the scene (floor_views.h). \throws IoError, InputError
[[nodiscard]] TriedScene open_tried_scene(const std::filesystem::path& file, std::size_t own_views = 8);

/// What stands in SCENE.views. \throws InputError with line, F134 for what is no such line, F135 for a camera that is
/// none or stands in no cell
void read_views(std::string_view text, const std::string& name, TriedScene& scene);

/// A line of such a file. The camera is in the frame of the scene.
[[nodiscard]] std::string view_line(const std::string& name, const render::Camera& camera,
                                    const accel::SceneView& scene);

}  // namespace enfilade::tools::gpu

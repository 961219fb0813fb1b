// gpu_scenes FOLDER EXAMPLES [MESH.ply|.obj|.off ...]: writes the scenes by which cards are measured, with their views
// (tried_scene.h), into a folder: floors of the paper's sizes, bare and furnished by our own rules with our own pieces,
// with as many lamps as the paper had; one with 2,500 lamps outside; one of 1,000 rooms; and each mesh by itself.
// EXAMPLES: the folder plans/examples. tools/gpu-bundle.sh runs it.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "accel/scene_file.h"
#include "base/error.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/generate.h"
#include "plans/read.h"
#include "tools/floor_views.h"
#include "tools/furnished_floor.h"
#include "tools/gpu/tried_scene.h"
#include "tools/mesh_scene.h"
#include "tools/view.h"
#include "tools/view_file.h"

namespace enfilade::tools::gpu {

namespace {

constexpr const char* header =
    "# view NAME eye x y z, target x y z, field of view in degrees; metres, in the frame of the plan\n";

/// Without what only `check` and `edit` read.
void write_scene(const std::filesystem::path& folder, const std::string& name, const accel::Scene& scene,
                 const std::vector<render::Camera>& cameras, const std::string& lamps) {
    accel::write(accel::strip(scene), folder / (name + ".enf"));
    std::ofstream views(folder / (name + ".views"));
    views << header << lamps;
    for (std::size_t i = 0; i < cameras.size(); ++i)
        views << view_line("v" + std::to_string(i), cameras[i], scene.view());
    if (!views.flush()) throw IoError("The views of " + name + " cannot be written to " + folder.string() + ".");
    std::cout << name << "\n";
}

modeler::Building rooms_of(const plans::Plan& plan) { return modeler::convexify(modeler::build(plan)); }

accel::Scene scene_of(const modeler::Building& building) {
    return modeler::export_scene(building, modeler::check(building), "{}");
}

std::string hanging(int lamps) { return "lamps " + std::to_string(lamps) + " hanging\n"; }

/// The views of a tour, as the paper saved them on a visit.
std::vector<render::Camera> toured(const std::filesystem::path& file, const accel::Scene& scene) {
    std::vector<render::Camera> cameras;
    for (const SavedView& view : tools::read_views(file, scene.view()).views) cameras.push_back(view.camera);
    return cameras;
}

/// From around the mesh, so that it fills the picture.
std::vector<render::Camera> around(const accel::SceneView& scene) {
    const accel::PlacedObject& object = scene.objects[0];
    const render::Vec3d low = {object.low[0], object.low[1], object.low[2]};
    const render::Vec3d high = {object.high[0], object.high[1], object.high[2]};
    const render::Vec3d middle = 0.5 * (low + high);
    constexpr double fov = 40;
    const double distance = 0.5 * length(high - low) / std::tan(fov / 2 * std::numbers::pi / 180);
    std::vector<render::Camera> cameras;
    for (int i = 0; i < 6; ++i) {
        const double turn = (i + 0.25) * std::numbers::pi / 3, up = i % 2 == 0 ? 0.12 : 0.5;
        render::Camera camera;
        camera.eye = middle + distance * render::Vec3d{std::cos(turn) * std::cos(up), std::sin(turn) * std::cos(up),
                                                       std::sin(up)};
        camera.target = middle;
        camera.fov_deg = fov;
        cameras.push_back(camera);
    }
    return cameras;
}

/// From the corners of the site, a person's height and a first floor's above the ground.
std::vector<render::Camera> from_corners(const accel::SceneView& scene) {
    const auto& low = scene.locator_nodes[0].low;
    const auto& high = scene.locator_nodes[0].high;
    std::vector<render::Camera> cameras;
    for (int i = 0; i < 4; ++i) {
        render::Camera camera;
        camera.eye = {i % 2 == 0 ? low[0] + 0.5 : high[0] - 0.5, i / 2 == 0 ? low[1] + 0.5 : high[1] - 0.5,
                      low[2] + (i % 2 == 0 ? 1.7 : 5)};
        camera.target = {0.5 * (double(low[0]) + high[0]), 0.5 * (double(low[1]) + high[1]), low[2] + 1.5};
        cameras.push_back(camera);
    }
    return cameras;
}

void write_floors(const std::filesystem::path& folder, const std::filesystem::path& examples) {
    struct Floor {
        const char* name;  ///< of its plan and its tour
        const char* rooms;
        int lamps;  ///< the paper's MAISON, BAT-1 and BAT-2
    };
    for (const Floor& floor : {Floor{"townhouse", "9", 8}, {"office-46", "46", 55}, {"office-135", "135", 200}}) {
        const plans::Plan plan = plans::read(examples / (std::string(floor.name) + ".json"));
        const modeler::Building rooms = rooms_of(plan);
        const accel::Scene bare = scene_of(rooms);
        const std::vector<render::Camera> cameras = toured(examples / (std::string(floor.name) + ".views.json"), bare);
        write_scene(folder, std::string("bare-") + floor.rooms, bare, cameras, hanging(floor.lamps));
        const FurnishedFloor furnished = furnished_floor(floor.name, rooms, {.detail = 4});
        write_scene(folder, std::string("furnished-") + floor.rooms, furnished.scene, cameras, hanging(floor.lamps));
        // For tools that look at every load: the same furniture, plainer.
        if (std::string(floor.rooms) == "9")
            write_scene(folder, "small-9", furnished_floor(floor.name, rooms, {.detail = 1}).scene, cameras,
                        hanging(floor.lamps));
        if (std::string(floor.rooms) != "46") continue;
        std::vector<render::Camera> outside = from_corners(bare.view());
        outside.push_back(named_view(bare.view(), "exterior", 1024, 1024).camera);
        write_scene(folder, "outside-46", bare, outside, "lamps 2500 outside\n");
    }
    const accel::Scene large = scene_of(rooms_of(plans::generate({.rooms = 1000})));
    write_scene(folder, "bare-1000", large, floor_views(large.view(), 12, 1024), hanging(1480));
}

int run(const std::vector<std::string>& words) {
    if (words.size() < 2) {
        std::cerr << "Say where the scenes are to be written and where plans/examples is: gpu_scenes FOLDER EXAMPLES "
                     "[MESH ...]\n";
        return 2;
    }
    const std::filesystem::path folder = words[0];
    std::filesystem::create_directories(folder);
    write_floors(folder, words[1]);
    for (std::size_t i = 2; i < words.size(); ++i) {
        const std::filesystem::path file = words[i];
        const MeshScene mesh = scene_of_mesh(file, {});
        write_scene(folder, "mesh-" + file.stem().string(), mesh.scene, around(mesh.scene.view()), "");
    }
    return 0;
}

}  // namespace

}  // namespace enfilade::tools::gpu

int main(int count, char** words) {
    try {
        return enfilade::tools::gpu::run({words + 1, words + count});
    } catch (const enfilade::InputError& error) {
        std::cerr << error.located() << "\n";
        return 2;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 3;
    }
}

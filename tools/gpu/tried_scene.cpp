#include "tools/gpu/tried_scene.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "accel/scene_file.h"
#include "base/error.h"
#include "tools/floor_views.h"
#include "tools/spread_lamps.h"

namespace enfilade::tools::gpu {

namespace {

render::Vec3d origin_of(const accel::SceneView& scene) { return {scene.origin[0], scene.origin[1], scene.origin[2]}; }

/// Reads the words of one line.
class LineReader {
public:
    LineReader(const std::string& file, int number, const std::string& line)
        : file_(file), number_(number), words_(line) {}

    [[nodiscard]] bool word(std::string& into) { return static_cast<bool>(words_ >> into); }
    [[nodiscard]] double number() {
        double value = 0;
        if (!(words_ >> value)) refuse("F134", "A number is missing here; write as the file's first lines say.");
        return value;
    }
    [[nodiscard]] render::Vec3d place() {
        const double x = number(), y = number(), z = number();
        return {x, y, z};
    }
    void end() {
        std::string more;
        if (words_ >> more) refuse("F134", "\"" + more + "\" is one word too many in this line.");
    }
    [[noreturn]] void refuse(const std::string& code, const std::string& sentence) const {
        throw InputError(code, file_, number_, 1, sentence);
    }

private:
    const std::string& file_;
    int number_;
    std::istringstream words_;
};

TriedView placed(const accel::SceneView& scene, std::string name, const render::Camera& camera) {
    return {std::move(name), camera, render::start_cell(scene, render::make_frame(camera))};
}

void read_view(LineReader& line, TriedScene& scene) {
    std::string name;
    if (!line.word(name)) line.refuse("F134", "This view has no name.");
    render::Camera camera;
    camera.eye = line.place() - origin_of(scene.file.view());
    camera.target = line.place() - origin_of(scene.file.view());
    camera.fov_deg = line.number();
    line.end();
    try {
        scene.views.push_back(placed(scene.file.view(), std::move(name), camera));
    } catch (const InputError& error) {
        line.refuse("F135", error.what());
    }
}

void read_lamps(LineReader& line, TriedScene& scene) {
    constexpr std::array<std::pair<const char*, LampPlaces>, 3> all = {
        {{"rooms", LampPlaces::Rooms}, {"hanging", LampPlaces::Hanging}, {"outside", LampPlaces::Outside}}};
    const double count = line.number();
    std::string where;
    if (!line.word(where)) line.refuse("F134", "Say where the lamps are: rooms, hanging or outside.");
    line.end();
    if (!(count >= 1 && count <= 1e6)) line.refuse("F134", "There may be 1 to 1,000,000 lamps.");
    for (const auto& [name, places] : all) {
        if (where != name) continue;
        scene.lamps = spread_lamps(scene.file.view(), static_cast<std::size_t>(count), places);
        return;
    }
    line.refuse("F134", "\"" + where + "\" is no place for lamps: write rooms, hanging or outside.");
}

}  // namespace

render::CameraFrame TriedView::frame(int side) const {
    render::Camera sized = camera;
    sized.width = sized.height = side;
    return render::make_frame(sized);
}

accel::SceneView TriedScene::view() const {
    accel::SceneView scene = file.view();
    if (!lamps.empty()) scene.lights = {lamps.data(), lamps.size()};
    return scene;
}

void read_views(std::string_view text, const std::string& name, TriedScene& scene) {
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        LineReader reader(name, number, line.substr(0, line.find('#')));
        std::string what;
        if (!reader.word(what)) continue;
        if (what == "view") read_view(reader, scene);
        else if (what == "lamps") read_lamps(reader, scene);
        else reader.refuse("F134", "\"" + what + "\" begins no line of this file: write view or lamps.");
    }
}

TriedScene open_tried_scene(const std::filesystem::path& file, std::size_t own_views) {
    TriedScene scene;
    scene.name = file.stem().string();
    scene.file = accel::open(file);
    const accel::SceneView view = scene.file.view();
    for (const accel::PlacedObject& object : view.objects)
        scene.instanced_triangles += view.meshes[index(object.mesh)].triangle_count;
    std::filesystem::path beside = file;
    beside.replace_extension(".views");
    if (std::ifstream stream(beside, std::ios::binary); stream)
        read_views(std::string(std::istreambuf_iterator<char>(stream), {}), beside.string(), scene);
    if (scene.views.empty()) {
        std::size_t number = 0;
        for (const render::Camera& camera : floor_views(view, own_views, 1024))
            scene.views.push_back(placed(view, "own-" + std::to_string(++number), camera));
    }
    return scene;
}

std::string view_line(const std::string& name, const render::Camera& camera, const accel::SceneView& scene) {
    const render::Vec3d eye = camera.eye + origin_of(scene), target = camera.target + origin_of(scene);
    std::array<char, 512> text;
    std::snprintf(text.data(), text.size(), "view %s %.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", name.c_str(), eye.x, eye.y,
                  eye.z, target.x, target.y, target.z, camera.fov_deg);
    return text.data();
}

}  // namespace enfilade::tools::gpu

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>

#include "accel/scene_file.h"
#include "base/error.h"
#include "render/executor.h"
#include "render/oracle.h"
#include "render/trace.h"
#include "tools/bench.h"
#include "tools/check_report.h"
#include "tools/commands.h"
#include "tools/count_pictures.h"
#include "tools/exit_code.h"
#include "tools/mesh_scene.h"
#include "tools/object_accel.h"
#include "tools/picture_files.h"
#include "tools/progress.h"
#include "tools/ray_report.h"
#include "tools/trace_flags.h"
#include "tools/view.h"
#include "tools/view_file.h"

namespace enfilade::tools {

namespace {

constexpr int largest_side = 32768;

/// "640x480"
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

/// Tells a progress bar how many chunks are done, of one picture of several.
class WatchedExecutor final : public accel::Executor {
public:
    WatchedExecutor(const accel::Executor& executor, Progress& progress, std::size_t picture, std::size_t picture_count)
        : executor_(executor), progress_(progress), done_(double(picture)), all_(double(picture_count)) {}
    void run(std::size_t chunk_count, const std::function<void(std::size_t)>& body) const override {
        std::atomic<std::size_t> done = 0;
        executor_.run(chunk_count, [&](std::size_t chunk) {
            body(chunk);
            progress_.fraction((done_ + double(++done) / double(chunk_count)) / all_);
        });
    }

private:
    const accel::Executor& executor_;
    Progress& progress_;
    double done_;  ///< pictures before this one
    double all_;
};

/// A picture to make, and what became of it.
struct Shot {
    std::string name;  ///< in the view file; empty without one
    View view;
    std::optional<accel::CellId> cell;  ///< of the view file
    double seconds = 0;
};

const char* usual_camera(const RenderOptions& options) {
    return is_mesh_file(options.scene) ? "exterior" : "dollhouse";
}

/// Rows of the files that the colour scale takes: the pictures above it are so much less high.
int scale_rows(const RenderOptions& options) {
    const auto [width, height] = parse_size(options.size);
    return options.show.empty() ? 0 : bar_rows(width, height);
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

render::Image render_view(const RenderOptions& options, const TracerChoice& choice, const accel::SceneView& scene,
                          const Shot& shot, const render::ObjectTracer* objects, const accel::Executor& executor,
                          render::RayStats& stats) {
    const View& view = shot.view;
    if (choice.is_oracle) {
        if (view.cut_z)
            throw InputError("F112", "",
                             "The oracle takes nothing off the building: give it --room NAME, --camera exterior or "
                             "--camera X,Y,Z:X,Y,Z.");
        return render::trace_by_oracle(scene, view.camera, int(options.samples * options.samples), choice.mirror_floor);
    }
    render::TraceOptions trace;
    trace.tracer = choice.tracer;
    trace.precision = choice.precision;
    trace.packets = choice.packets;
    trace.mirror_floor = choice.mirror_floor;
    trace.shading = options.shading == "lambert" ? render::Shading::Lambert : render::Shading::Look;
    trace.samples_per_pixel = int(options.samples * options.samples);
    trace.start = shot.cell;
    trace.cut_z = view.cut_z;
    // A model that is cut open stands on paper: what is left of the sky's box around it is not drawn.
    if (view.cut_z) trace.look.sky_zenith = trace.look.sky_horizon = trace.look.paper;
    trace.executor = &executor;
    trace.objects = objects;
    trace.stats = &stats;
    return render::trace(scene, view.camera, trace);
}

std::optional<modeler::UpAxis> up_axis(const RenderOptions& options) {
    if (options.up.empty()) return std::nullopt;
    return options.up == "y" ? modeler::UpAxis::Y : modeler::UpAxis::Z;
}

/// Flags that a mesh, or nothing but a mesh, can do with.
void check_mesh_flags(const RenderOptions& options, const TracerChoice& choice) {
    const bool is_mesh = is_mesh_file(options.scene);
    if (!is_mesh && !options.up.empty())
        throw InputError("F148", "", "--up says how a mesh stands, and this is none: leave it out.");
    if (is_mesh && choice.is_oracle)
        throw InputError("F148", "", "The oracle sees no objects, so it shows no mesh: choose another --tracer.");
    if (is_mesh && !options.room.empty())
        throw InputError("F148", "",
                         "A mesh by itself has no rooms: give --camera exterior, aerial or X,Y,Z:X,Y,Z instead of "
                         "--room.");
    if (is_mesh && options.camera.starts_with("dollhouse"))
        throw InputError("F148", "",
                         "A mesh by itself has no storey to cut open: give --camera exterior, aerial or X,Y,Z:X,Y,Z.");
    if (is_mesh && options.no_objects)
        throw InputError("F148", "", "A picture of a mesh shows nothing but that: leave out --no-objects.");
    if (is_mesh && options.mirror_floor)
        throw InputError("F148", "", "A mesh by itself stands on no floor that mirrors: leave out --mirror-floor.");
}

/// The scene file; what is none is told what would be one.
accel::Scene opened(const std::filesystem::path& file) {
    try {
        return accel::open(file);
    } catch (const InputError& error) {
        std::array<char, 8> begin = {};
        std::ifstream(file, std::ios::binary).read(begin.data(), begin.size());
        if (error.code != "F1" || file.extension() == ".enf" || std::string_view(begin.data(), 8) == "ENFILADE") throw;
    }
    const std::string ending = file.extension().string();
    if (ending == ".gz" || ending == ".zip" || ending == ".xz" || ending == ".bz2")
        throw InputError("F148", file.string(), "The file is compressed: unpack it first, and give what was in it.");
    throw InputError("F148", file.string(),
                     "This is neither a scene (.enf, as \"enfilade build\" makes them) nor a mesh by its ending: .obj, "
                     ".gltf, .glb, .ply, .off and .stl are read.");
}

/// Whether --show asks for what rays do inside of objects.
bool counts_octrees(const RenderOptions& options) { return options.show == "leaves" || options.show == "blocks"; }

/// What one run made.
struct Pictures {
    std::vector<Shot> shots;
    std::vector<std::filesystem::path> paths;
    std::array<double, 3> origin = {};  ///< of the scene's frame in the plan's, metres
    render::RayStats stats;
    ObjectsSummary objects;
    std::optional<MeshScene> mesh;  ///< where the pictures are of one; its scene is gone
    std::string counted;            ///< what false colours show; empty: pictures of light
    nlohmann::ordered_json counts;

    [[nodiscard]] std::uint64_t pixels() const {
        const render::Camera& camera = shots.front().view.camera;
        return shots.size() * std::uint64_t(camera.width) * std::uint64_t(camera.height);
    }
    [[nodiscard]] double seconds() const {
        double sum = 0;
        for (const Shot& shot : shots) sum += shot.seconds;
        return sum;
    }
};

Pictures make_pictures(const RenderOptions& options, const TracerChoice& choice, const ObjectAccelChoice& accel,
                       const Console& console) {
    Pictures made;
    Progress progress(console, {"Reading the scene", "Rendering", "Writing"});
    if (is_mesh_file(options.scene)) made.mesh = scene_of_mesh(options.scene, up_axis(options));
    const accel::Scene scene = made.mesh ? std::move(made.mesh->scene) : opened(options.scene);
    const accel::SceneView view = options.no_objects ? without_objects(scene.view()) : scene.view();
    std::copy_n(view.origin, 3, made.origin.begin());
    progress.next();
    made.shots = chosen_shots(options, view, console);
    std::vector<std::string> names;
    for (const Shot& shot : made.shots) names.push_back(shot.name);
    PictureFiles files(options.output, names);
    const std::unique_ptr<accel::Executor> cores = render::make_executor(options.threads);
    std::optional<CountPictures> counts;
    PreparedObjects prepared;
    if (!choice.is_oracle && (options.show.empty() || counts_octrees(options)))
        prepared = prepare_objects(view, accel, *cores);
    if (!options.show.empty()) {
        if (counts_octrees(options) && prepared.accel == nullptr)
            throw InputError("F139", options.scene.string(),
                             "Nothing stands in this scene, so there are no " + options.show +
                                 " to count: build it with --furnish, or choose another --show.");
        std::vector<View> views;
        for (const Shot& shot : made.shots) views.push_back(shot.view);
        counts.emplace(view, views, options.show, *cores, prepared.accel ? prepared.accel->octrees() : nullptr);
    }
    made.objects = prepared.summary;
    const render::ObjectTracer tracer = prepared.accel ? prepared.accel->tracer() : render::ObjectTracer{};
    const render::ObjectTracer* objects = prepared.accel ? &tracer : nullptr;
    for (std::size_t k = 0; k < made.shots.size(); ++k) {
        Shot& shot = made.shots[k];
        const WatchedExecutor watched(*cores, progress, k, made.shots.size());
        render::Image image;
        shot.seconds = seconds_of([&] {
            image = counts ? counts->picture(shot.view, watched, scale_rows(options))
                           : render_view(options, choice, view, shot, objects, watched, made.stats);
        });
        files.write(k, image);
    }
    progress.next();
    files.commit();
    if (counts) {
        made.counted = counts->report();
        made.counts = counts->json();
    }
    made.paths = files.paths();
    return made;
}

/// Eye, target and field of view as a view file has them.
void add_camera(nlohmann::ordered_json& json, const Shot& shot, const std::array<double, 3>& origin) {
    const auto point = [&](const render::Vec3d& p) {
        return nlohmann::ordered_json{p.x + origin[0], p.y + origin[1], p.z + origin[2]};
    };
    json["eye"] = point(shot.view.camera.eye);
    json["target"] = point(shot.view.camera.target);
    json["fov_deg"] = shot.view.camera.fov_deg;
    if (shot.cell) json["cell"] = index(*shot.cell);
    json["seconds"] = shot.seconds;
}

/// Lanes and packets are for one ray a pixel, lit by the lamp at the eye; all else goes ray by ray (render/trace.h).
const char* walked_by(const RenderOptions& options, const TracerChoice& choice, const Pictures& made) {
    const bool is_plain = options.shading == "lambert" && options.samples == 1 && !made.shots.front().view.cut_z;
    return is_plain || choice.is_oracle ? choice.name() : "scalar";
}

nlohmann::ordered_json render_json(const RenderOptions& options, const TracerChoice& choice, const Pictures& made) {
    nlohmann::ordered_json json = {
        {"command", "render"}, {"input", options.scene.string()}, {"output", options.output.string()}};
    json["tracer"] = choice.name();
    if (!made.counted.empty()) json["counts"] = made.counts;
    if (made.counted.empty()) json["walked_by"] = walked_by(options, choice, made);
    json["real"] = choice.precision == render::Precision::Double ? "double" : "float";
    if (choice.has_packets())
        json["packets"] = {{"largest", choice.packets.largest}, {"smallest", choice.packets.smallest}};
    json["mirror_floor"] = choice.mirror_floor;
    json["objects"] = made.objects.json();
    if (made.mesh) json["mesh"] = made.mesh->json();
    json["shading"] = options.shading;
    const auto [width, height] = parse_size(options.size);
    json["width"] = width;
    json["height"] = height;
    if (options.views.empty()) {
        add_camera(json, made.shots.front(), made.origin);
    } else {
        json["views"] = options.views.string();
        json["seconds"] = made.seconds();
        json["pictures"] = nlohmann::ordered_json::array();
        for (std::size_t k = 0; k < made.shots.size(); ++k) {
            nlohmann::ordered_json picture = {{"name", made.shots[k].name}, {"file", made.paths[k].string()}};
            add_camera(picture, made.shots[k], made.origin);
            json["pictures"].push_back(std::move(picture));
        }
    }
    if (!choice.is_oracle && made.counted.empty()) json["statistics"] = ray_json(made.stats, made.pixels());
    return json;
}

}  // namespace

int run_render(const RenderOptions& options, const Console& console) {
    check_picture_name(options.output);  // a wrong flag is said before the work
    const auto [width, height] = parse_size(options.size);
    const TracerChoice choice = tracer_choice(options);
    check_mesh_flags(options, choice);
    if (counts_octrees(options) && options.no_objects)
        throw InputError("F139", "",
                         "--show " + options.show + " counts what rays do inside of objects: leave out --no-objects.");
    if (choice.is_oracle) refuse_object_accel(options.object_accel, "The oracle sees no objects");
    if (options.no_objects) refuse_object_accel(options.object_accel, "With --no-objects rays see no objects");
    if (!options.show.empty() && !counts_octrees(options))
        refuse_object_accel(options.object_accel, "--show " + options.show + " counts past all objects");
    const ObjectAccelChoice accel =
        object_accel_choice(options.object_accel, counts_octrees(options) ? "--show " + options.show : "");
    const Pictures made = make_pictures(options, choice, accel, console);
    if (console.json()) {
        console.print(dump(render_json(options, choice, made)));
        return exit_ok;
    }
    const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
    console.say(made.paths.front().string() +
                (made.paths.size() == 1 ? ": " + size
                                        : " to " + made.paths.back().filename().string() + ": " +
                                              counted(made.paths.size(), "picture") + " of " + size) +
                " in " + time_text(made.seconds()) + (made.counted.empty() ? "" : "; " + made.counted) + '.');
    if (made.mesh) console.say(options.scene.filename().string() + ": " + made.mesh->report() + '.');
    if (options.stats) console.print(ray_report(made.stats, made.pixels()) + made.objects.report());
    return exit_ok;
}

}  // namespace enfilade::tools

#include <algorithm>
#include <atomic>
#include <nlohmann/json.hpp>

#include "accel/scene_file.h"
#include "base/error.h"
#include "plans/number_text.h"
#include "render/executor.h"
#include "render/oracle.h"
#include "render/trace.h"
#include "tools/bench.h"
#include "tools/check_report.h"
#include "tools/commands.h"
#include "tools/count_pictures.h"
#include "tools/device_pictures.h"
#include "tools/exit_code.h"
#include "tools/lit_pictures.h"
#include "tools/object_accel.h"
#include "tools/path_pictures.h"
#include "tools/picture_files.h"
#include "tools/picture_scene.h"
#include "tools/progress.h"
#include "tools/ray_report.h"
#include "tools/shots.h"
#include "tools/trace_flags.h"

namespace enfilade::tools {

namespace {

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

render::Image render_view(const RenderOptions& options, const TracerChoice& choice, const accel::SceneView& scene,
                          const Shot& shot, render::TraceOptions trace, const LitPictures& lit,
                          DevicePictures* device) {
    const View& view = shot.view;
    if (choice.is_oracle) {
        if (view.cut_z)
            throw InputError("F112", "",
                             "The oracle takes nothing off the building: give it --room NAME, --camera exterior or "
                             "--camera X,Y,Z:X,Y,Z.");
        return render::trace_by_oracle(scene, view.camera, direct_samples(options), choice.mirror_floor);
    }
    trace.start = shot.cell;
    trace.cut_z = view.cut_z;
    lit.light(trace);
    // A model that is cut open stands on paper: what is left of the sky's box around it is not drawn.
    if (view.cut_z) trace.look.sky_zenith = trace.look.sky_horizon = trace.look.paper;
    if (device == nullptr) return render::trace(scene, view.camera, trace);
    trace.stats = nullptr;
    return device->trace(view.camera, trace);
}

/// What all pictures of a run share.
render::TraceOptions shared_options(const RenderOptions& options, const TracerChoice& choice,
                                    const render::ObjectTracer* objects, const accel::Executor& executor) {
    render::TraceOptions trace;
    trace.tracer = choice.tracer;
    trace.precision = choice.precision;
    trace.packets = choice.packets;
    trace.mirror_floor = choice.mirror_floor;
    trace.shading = options.shading == "lambert" ? render::Shading::Lambert : render::Shading::Look;
    trace.samples_per_pixel = direct_samples(options);
    trace.executor = &executor;
    trace.objects = objects;
    return trace;
}

/// Candela / m2 rather than parts of white.
bool is_linear(const RenderOptions& options, const LightChoice& lights) {
    return !lights.exposure_ev && options.lights.exposure.empty() && options.output.extension() == ".exr";
}

/// Whether --show asks for what rays do inside of objects.
bool counts_octrees(const RenderOptions& options) { return options.show == "leaves" || options.show == "blocks"; }

/// What the flags ask for.
struct Choices {
    TracerChoice tracer;
    ObjectAccelChoice accel;
    LightChoice lights;
    PathChoice path;
};

/// What one run made.
struct Pictures {
    std::vector<Shot> shots;
    std::vector<std::filesystem::path> paths;
    std::array<double, 3> origin = {};  ///< of the scene's frame in the plan's, metres
    render::RayStats stats;
    ObjectsSummary objects;
    LitPictures lit;                             ///< its scene is gone, too
    bool has_looks = false;                      ///< of materials
    std::optional<PathPictures> paths_of_light;  ///< its scene is gone, too
    std::optional<MeshScene> mesh;               ///< where the pictures are of one; its scene is gone
    std::string device;                          ///< of the cuda tracer; empty: it did not trace
    std::size_t device_bytes = 0;                ///< that it holds
    std::string counted;                         ///< what false colours show; empty: pictures of light
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

Pictures make_pictures(const RenderOptions& options, const Choices& choices, const Console& console) {
    const TracerChoice& choice = choices.tracer;
    const std::unique_ptr<accel::Executor> cores = render::make_executor(options.threads);
    std::optional<DevicePictures> device;  // what is not there is said before the work
    if (choice.device) device.emplace(*choice.device, *cores);
    Pictures made;
    std::vector<std::string> steps = {"Reading the scene", "Rendering", "Writing"};
    if (choices.lights.search) steps.insert(steps.begin() + 1, "Following the light");
    Progress progress(console, steps);
    if (is_mesh_file(options.scene)) made.mesh = scene_of_mesh(options.scene, up_axis(options));
    const accel::Scene scene = made.mesh ? std::move(made.mesh->scene) : opened_scene(options.scene);
    const accel::SceneView view = options.no_objects ? without_objects(scene.view()) : scene.view();
    std::copy_n(view.origin, 3, made.origin.begin());
    made.has_looks = view.has_looks();
    progress.next();
    made.shots = chosen_shots(options, view, console);
    std::vector<std::string> names;
    for (const Shot& shot : made.shots) names.push_back(shot.name);
    PictureFiles files(options.output, names);
    std::optional<CountPictures> counts;
    PreparedObjects prepared;
    // With lamps the CPU makes the small pictures by which all others are exposed.
    const bool is_asked = choice.device ? choices.lights.search.has_value() : !choice.is_oracle;
    if (is_asked && (options.show.empty() || counts_octrees(options)))
        prepared = prepare_objects(view, choices.accel, *cores);
    if (!options.show.empty()) {
        if (options.show == "lamps" && view.lights.size() == 0)
            throw InputError("F160", options.scene.string(),
                             "There is no lamp in this scene, so there are none to count: build it with --lamps.");
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
    render::TraceOptions shared = shared_options(options, choice, objects, *cores);
    if (choices.lights.search) {
        made.lit = LitPictures(view, choices.lights, made.shots, shared, is_linear(options, choices.lights));
        progress.next();
    }
    const accel::SceneView lit = made.lit.lit(view);
    if (device) {
        device->show(lit, choice, choices.accel);
        made.device = device->name();
        made.objects = device->objects();
    }
    if (choices.path.is_on)
        made.paths_of_light.emplace(lit, choices.path, choices.lights, made.shots, shared, made.lit);
    for (std::size_t k = 0; k < made.shots.size(); ++k) {
        Shot& shot = made.shots[k];
        const WatchedExecutor watched(*cores, progress, k, made.shots.size());
        if (!choice.device) shared.stats = &made.stats;
        if (!made.paths_of_light) shared.executor = &watched;
        const auto told = [&](double done, double noise) {
            progress.fraction((double(k) + done) / double(made.shots.size()));
            progress.remark("noise " + plans::rounded_text(100 * noise, 1) + " %");
        };
        render::Image image;
        shot.seconds = seconds_of([&] {
            if (counts) image = counts->picture(shot.view, watched, scale_rows(options));
            else if (made.paths_of_light) image = made.paths_of_light->picture(shot, shared, made.lit, told);
            else image = render_view(options, choice, lit, shot, shared, made.lit, device ? &*device : nullptr);
        });
        files.write(k, image);
    }
    progress.next();
    if (device) made.device_bytes = device->bytes();
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

/// Lanes and packets are for one ray a pixel, lit by lamps alone and past plain colours; all else goes ray by ray
/// (render/trace.h).
const char* walked_by(const RenderOptions& options, const TracerChoice& choice, const Pictures& made) {
    const bool is_plain =
        options.shading == "lambert" && direct_samples(options) == 1 && !made.shots.front().view.cut_z;
    if (choice.device) return choice.name();
    if (made.paths_of_light || (made.lit.are_lit() && made.has_looks)) return "scalar";
    return is_plain || choice.is_oracle ? choice.name() : "scalar";
}

nlohmann::ordered_json render_json(const RenderOptions& options, const TracerChoice& choice, const Pictures& made) {
    nlohmann::ordered_json json = {
        {"command", "render"}, {"input", options.scene.string()}, {"output", options.output.string()}};
    json["tracer"] = choice.name();
    if (!made.counted.empty()) json["counts"] = made.counts;
    if (made.counted.empty()) json["walked_by"] = walked_by(options, choice, made);
    if (choice.device) json["device"] = made.device;
    if (choice.device) json["device_bytes"] = made.device_bytes;
    json["real"] = choice.precision == render::Precision::Double ? "double" : "float";
    if (choice.has_packets())
        json["packets"] = {{"largest", choice.packets.largest}, {"smallest", choice.packets.smallest}};
    json["mirror_floor"] = choice.mirror_floor;
    json["objects"] = made.objects.json();
    if (made.mesh) json["mesh"] = made.mesh->json();
    json["shading"] = options.shading;
    json["lights"] = made.lit.json();
    json["paths"] = made.paths_of_light ? made.paths_of_light->json() : nullptr;
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
    if (!choice.is_oracle && !choice.device && made.counted.empty())
        json["statistics"] = ray_json(made.stats, made.pixels());
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
    const Choices choices = {
        choice, object_accel_choice(options.object_accel, counts_octrees(options) ? "--show " + options.show : ""),
        light_choice(options), path_choice(options)};
    if (choice.device) check_device_objects(choices.accel);
    const Pictures made = make_pictures(options, choices, console);
    if (choices.lights.search && !made.lit.are_lit() && !console.quiet())
        console.warn("There is no lamp in " + options.scene.string() +
                     ", so the picture is lit as without --lights: build the scene with --lamps.");
    if (console.json()) {
        console.print(dump(render_json(options, choice, made)));
        return exit_ok;
    }
    const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
    console.say(made.paths.front().string() +
                (made.paths.size() == 1 ? ": " + size
                                        : " to " + made.paths.back().filename().string() + ": " +
                                              counted(made.paths.size(), "picture") + " of " + size) +
                " in " + time_text(made.seconds()) + (made.counted.empty() ? "" : "; " + made.counted) +
                (made.lit.are_lit() ? "; " + made.lit.text() : "") +
                (made.paths_of_light ? "; " + made.paths_of_light->text() : "") + '.');
    if (made.mesh) console.say(options.scene.filename().string() + ": " + made.mesh->report() + '.');
    if (options.stats) console.print(ray_report(made.stats, made.pixels()) + made.objects.report() + made.lit.report());
    return exit_ok;
}

}  // namespace enfilade::tools

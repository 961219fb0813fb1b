#include <atomic>
#include <charconv>
#include <nlohmann/json.hpp>

#include "accel/scene_file.h"
#include "base/error.h"
#include "render/executor.h"
#include "render/image_file.h"
#include "render/oracle.h"
#include "render/trace.h"
#include "tools/bench.h"
#include "tools/commands.h"
#include "tools/exit_code.h"
#include "tools/output_file.h"
#include "tools/progress.h"
#include "tools/ray_report.h"
#include "tools/trace_flags.h"
#include "tools/view.h"

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

/// Tells a progress bar how many chunks are done.
class WatchedExecutor final : public accel::Executor {
public:
    WatchedExecutor(const accel::Executor& executor, Progress& progress) : executor_(executor), progress_(progress) {}
    void run(std::size_t chunk_count, const std::function<void(std::size_t)>& body) const override {
        std::atomic<std::size_t> done = 0;
        executor_.run(chunk_count, [&](std::size_t chunk) {
            body(chunk);
            progress_.fraction(double(++done) / double(chunk_count));
        });
    }

private:
    const accel::Executor& executor_;
    Progress& progress_;
};

View chosen_view(const RenderOptions& options, const accel::SceneView& scene) {
    const auto [width, height] = parse_size(options.size);
    View view = !options.room.empty()
                    ? room_view(scene, options.room, width, height)
                    : named_view(scene, options.camera.empty() ? "dollhouse" : options.camera, width, height);
    if (options.fov_deg) view.camera.fov_deg = *options.fov_deg;
    return view;
}

render::Image render_view(const RenderOptions& options, const TracerChoice& choice, const accel::SceneView& scene,
                          const View& view, Progress& progress, render::RayStats& stats) {
    if (choice.is_oracle) {
        if (view.cut_z)
            throw InputError("F112", "",
                             "The oracle takes nothing off the building: give it --room NAME, --camera exterior or "
                             "--camera X,Y,Z:X,Y,Z.");
        return render::trace_by_oracle(scene, view.camera, int(options.samples * options.samples));
    }
    const std::unique_ptr<accel::Executor> cores = render::make_executor(options.threads);
    const WatchedExecutor watched(*cores, progress);
    render::TraceOptions trace;
    trace.tracer = choice.tracer;
    trace.precision = choice.precision;
    trace.packets = choice.packets;
    trace.mirror_floor = choice.mirror_floor;
    trace.shading = options.shading == "lambert" ? render::Shading::Lambert : render::Shading::Look;
    trace.samples_per_pixel = int(options.samples * options.samples);
    trace.cut_z = view.cut_z;
    // A model that is cut open stands on paper: what is left of the sky's box around it is not drawn.
    if (view.cut_z) trace.look.sky_zenith = trace.look.sky_horizon = trace.look.paper;
    trace.executor = &watched;
    trace.stats = &stats;
    return render::trace(scene, view.camera, trace);
}

}  // namespace

int run_render(const RenderOptions& options, const Console& console) {
    const std::string extension = options.output.extension().string();
    if (extension != ".png" && extension != ".exr")
        throw InputError("F113", options.output.string(), "Pictures are written as .png or .exr: end the name so.");
    parse_size(options.size);  // a wrong flag is said before the work
    const TracerChoice choice = tracer_choice(options);
    const std::filesystem::path output = output_path(options.output);

    View view;
    render::RayStats stats;
    double seconds = 0;
    {
        Progress progress(console, {"Reading the scene", "Rendering", "Writing"});
        const accel::Scene scene = accel::open(options.scene);
        progress.next();
        view = chosen_view(options, scene.view());
        render::Image image;
        seconds = seconds_of([&] { image = render_view(options, choice, scene.view(), view, progress, stats); });
        progress.next();
        render::write_image(image, output);
    }
    const std::uint64_t pixels = std::uint64_t(view.camera.width) * std::uint64_t(view.camera.height);
    if (console.json()) {
        const auto point = [](const render::Vec3d& p) { return nlohmann::ordered_json{p.x, p.y, p.z}; };
        nlohmann::ordered_json json = {
            {"command", "render"}, {"input", options.scene.string()}, {"output", options.output.string()}};
        json["tracer"] = choice.name();
        json["real"] = choice.precision == render::Precision::Double ? "double" : "float";
        if (!choice.is_oracle && choice.tracer == render::Tracer::Packet)
            json["packets"] = {{"largest", choice.packets.largest}, {"smallest", choice.packets.smallest}};
        json["mirror_floor"] = choice.mirror_floor;
        json["shading"] = options.shading;
        json["width"] = view.camera.width;
        json["height"] = view.camera.height;
        json["eye"] = point(view.camera.eye);
        json["target"] = point(view.camera.target);
        json["fov_deg"] = view.camera.fov_deg;
        json["seconds"] = seconds;
        if (!choice.is_oracle) json["statistics"] = ray_json(stats, pixels);
        console.print(json.dump(2) + '\n');
    } else {
        console.say(options.output.string() + ": " + std::to_string(view.camera.width) + " x " +
                    std::to_string(view.camera.height) + " pixels in " + time_text(seconds) + '.');
        if (options.stats && !choice.is_oracle) console.print(ray_report(stats, pixels));
    }
    return exit_ok;
}

}  // namespace enfilade::tools

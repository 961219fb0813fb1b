// The command line of `enfilade`: reads the flags, runs one subcommand, says what went wrong in one sentence.
// CLI11 costs seconds in each translation unit that includes it: this one only.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <new>
#include <string>

#include "base/error.h"
#include "tools/commands.h"
#include "tools/convexifiers.h"
#include "tools/exit_code.h"
#include "tools/suggestion.h"
#include "tools/version.h"

namespace enfilade::tools {
namespace {

/// What the flags ask for.
struct Invocation {
    bool quiet = false;
    bool json = false;
    std::function<int(const Console&)> run;
};

constexpr const char* about =
    "Enfilade models buildings from plans, checks that the model is sound, and traces rays through it.\n"
    "\n"
    "A first picture:\n"
    "  enfilade build plans/examples/townhouse.json -o house.enf\n"
    "  enfilade render house.enf -o house.png\n";
constexpr const char* exit_codes =
    "Every command ends with 0 when all is well, 1 when the plan or the model has errors, 2 when a file or a flag is\n"
    "wrong, 3 when a file or a device would not do its part. \"enfilade COMMAND --help\" shows the flags of a command.";
constexpr const char* plan_text =
    "the plan: our JSON, a Sweet Home 3D home (.sh3d), a DXF drawing, or FloorspaceJS JSON";

constexpr const char* report_text =
    "write all findings to this file: .html is a page with the plan drawn, .json is for programs, .txt is plain";

template <class Options>
CLI::App* add_command(CLI::App& app, Invocation& invocation, Options& options, const char* name, const char* sentence,
                      const char* example, int (*run)(const Options&, const Console&), bool with_json = true) {
    CLI::App* command = app.add_subcommand(name, sentence);
    command->footer(std::string("Example:\n") + example);
    command->add_flag("-q,--quiet", invocation.quiet, "say nothing but errors");
    if (with_json) command->add_flag("--json", invocation.json, "say the result as JSON, for programs");
    command->callback([&invocation, &options, run] {
        invocation.run = [&options, run](const Console& console) { return run(options, console); };
    });
    return command;
}

void add_strict(CLI::App* command, bool& strict) { command->add_flag("--strict", strict, "warnings count as errors"); }

/// An option with a value. `kind` is how help calls the value.
template <class T>
CLI::Option* add_value(CLI::App* command, const char* name, T& value, const char* kind, const std::string& sentence) {
    return command->add_option(name, value, sentence)->option_text(kind);
}
template <class T>
void add_needed(CLI::App* command, const char* name, T& value, const char* kind, const std::string& sentence) {
    add_value(command, name, value, kind, sentence)->required();
}
template <class T>
void add_positional(CLI::App* command, const char* name, T& value, const std::string& sentence) {
    command->add_option(name, value, sentence)->option_text(" ")->required();
}

void add_read_flags(CLI::App* command, ReadFlags& read) {
    command
        ->add_option_function<std::string>(
            "--units", [&read](const std::string& name) { read.options.unit = plans::unit_of(name); },
            "drawings and FloorspaceJS: unit of the numbers in the file, whatever it says itself: mm, cm, dm, m, km, "
            "in, ft, yd or mi")
        ->option_text("UNIT")
        ->check(CLI::IsMember({"mm", "cm", "dm", "m", "km", "in", "ft", "yd", "mi"}));
    command
        ->add_option("--layer", read.options.layers,
                     "drawings: read this layer only; * and ? match, and it may be given several times (all)")
        ->option_text("NAME")
        ->allow_extra_args(false);
    command->add_flag("--list-layers", read.list_layers, "drawings: name the layers with what is on them, and end");
    command
        ->add_option_function<std::string>(
            "--crop", [&read](const std::string& box) { read.options.crop = parse_crop(box); },
            "drawings: read only what lies in this box of the drawing's own numbers, for sheets with several plans")
        ->option_text("X0,Y0,X1,Y1");
    add_value(command, "--mapping", read.options.mapping, "FILE",
              "drawings: JSON that says which layers and blocks are walls, doors, windows (docs/dxf.md)");
    command
        ->add_option_function<double>(
            "--wall-thickness-mm", [&read](double mm) { read.options.wall_thickness = mm / 1000; },
            "thickness of walls that the file draws as single lines (100)")
        ->option_text("MM")
        ->check(CLI::PositiveNumber);
    command
        ->add_option_function<double>(
            "--storey-height-mm", [&read](double mm) { read.options.storey_height = mm / 1000; },
            "floor to ceiling where the file does not say (2500)")
        ->option_text("MM")
        ->check(CLI::PositiveNumber);
}

void add_model_flags(CLI::App* command, ModelOptions& model) {
    command
        ->add_option_function<std::string>(
            "--storeys", [&model](const std::string& list) { model.storeys = parse_storeys(list); },
            "model these storeys only, counted from 0 upward, like 0,2 (all)")
        ->option_text("LIST");
    add_value(command, "--snap-mm", model.snap_mm, "MM",
              "grid on which all corners lie, rounded down to a power of two of a metre (0.122)")
        ->check(CLI::PositiveNumber);
    add_value(command, "--sagitta-mm", model.sagitta_mm, "MM",
              "largest distance of a curved wall from its straight pieces (2)")
        ->check(CLI::PositiveNumber);
    add_value(command, "--step-mm", model.step_mm, "MM", "height of the steps that sloped wall tops are cut into (250)")
        ->check(CLI::PositiveNumber);
    add_value(command, "--least-thickness-mm", model.least_thickness_mm, "MM",
              "warn of walls and slabs that are thinner (10)")
        ->check(CLI::NonNegativeNumber);
    command
        ->add_option_function<std::string>(
            "--glass", [&model](const std::string& kind) { model.opaque_glass = kind == "opaque"; },
            "clear: light passes windows; opaque: it does not (clear)")
        ->option_text("KIND")
        ->check(CLI::IsMember({"clear", "opaque"}));
    command
        ->add_option_function<std::string>(
            "--convexify", [&model](const std::string& name) { model.convexifier = convexifier_of(name); },
            "how rooms are cut into the cells that rays walk through. sah: few of them, at the least cost to a ray; "
            "hertel-mehlhorn: a triangulation, thinned; diagonals: one cell after the other along the walls (sah)")
        ->option_text("METHOD");
}

void add_import(CLI::App& app, Invocation& invocation, ImportOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "import",
                                    "Read a plan in any format and write it as our JSON, with what was repaired.",
                                    "  enfilade import house.sh3d -o house.json", run_import);
    add_positional(command, "PLAN", options.plan, plan_text);
    add_value(command, "-o,--output", options.output, "FILE", "the JSON file to write (needed)");
    add_read_flags(command, options.read);
    add_strict(command, options.strict);
}

void add_generate(CLI::App& app, Invocation& invocation, GenerateCommandOptions& options) {
    CLI::App* command =
        add_command(app, invocation, options, "generate", "Invent the plan of an office building of any size.",
                    "  enfilade generate --rooms 200 --storeys 2 --curved 0.1 -o office.json", run_generate);
    add_value(command, "--rooms", options.rooms, "N", "rooms of the whole building, corridors counted (needed)")
        ->required()
        ->check(CLI::Range(1u, 2000000u));
    add_value(command, "--storeys", options.storeys, "N", "storeys over which they are spread (1)")
        ->check(CLI::Range(1u, 200u));
    add_value(command, "--curved", options.curved, "SHARE", "share of the inner walls that are arcs, 0 to 1 (0)")
        ->check(CLI::Range(0.0, 1.0));
    add_value(command, "--oblique", options.oblique, "SHARE", "share of the inner walls that are turned, 0 to 1 (0)")
        ->check(CLI::Range(0.0, 1.0));
    add_value(command, "--seed", options.seed, "N", "another number, another building (1)");
    add_needed(command, "-o,--output", options.output, "FILE", "the JSON file to write (needed)");
}

void add_build(CLI::App& app, Invocation& invocation, BuildCommandOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "build",
                                    "Model a building from its plan, check it, and write it as a scene.",
                                    "  enfilade build house.sh3d -o house.enf --report house.txt", run_build);
    add_positional(command, "PLAN", options.plan, plan_text);
    add_value(command, "-o,--output", options.output, "FILE", "the scene file to write, .enf (needed)");
    add_model_flags(command, options.model);
    add_read_flags(command, options.read);
    command->add_flag("--keep-going", options.keep_going, "write the scene even where the check finds errors");
    command->add_flag("--strip", options.strip,
                      "leave out the model group: a smaller file that can be traced, but not checked");
    add_value(command, "--report", options.report, "FILE", report_text);
    add_strict(command, options.strict);
}

void add_check(CLI::App& app, Invocation& invocation, CheckOptions& options) {
    CLI::App* command =
        add_command(app, invocation, options, "check",
                    "Say whether the model of a plan, or a scene file, is sound, and what is wrong where.",
                    "  enfilade check house.sh3d\n  enfilade check house.enf --json", run_check);
    add_positional(command, "INPUT", options.input,
                   "a plan, a scene file (.enf), or a mesh of closed bodies (.obj, .off, .ply, .stl, .city.json)");
    add_value(command, "--report", options.report, "FILE", report_text);
    add_model_flags(command, options.model);
    add_read_flags(command, options.read);
    add_value(command, "--weld", options.weld, "DISTANCE",
              "meshes: join points this close, in the file's unit; 0 joins equal points (none; STL: 0)")
        ->check(CLI::NonNegativeNumber);
    add_value(command, "--planar-distance", options.planar_distance, "DISTANCE",
              "meshes: how far a corner may lie from the plane of its face, in the file's unit (0.01)")
        ->check(CLI::NonNegativeNumber);
    add_value(command, "--planar-angle-deg", options.planar_angle_deg, "DEGREES",
              "meshes: by how much a face may be folded (20)")
        ->check(CLI::Range(0.0, 180.0));
    add_strict(command, options.strict);
}

void add_info(CLI::App& app, Invocation& invocation, InfoOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "info",
                                    "Show what a scene file holds: rooms, cells, bytes, and how they are joined.",
                                    "  enfilade info house.enf\n  enfilade info house.enf --svg cuts.svg\n"
                                    "  enfilade info house.enf --visible-from Kitchen",
                                    run_info);
    add_positional(command, "SCENE", options.scene, "the scene file (.enf)");
    CLI::Option* svg = add_value(command, "--svg", options.svg, "FILE",
                                 "draw how the rooms are cut, with cuts coloured by the area of their portal, to this "
                                 "file (.svg)");
    add_value(command, "--storey", options.storey, "STOREY",
              "draw this storey only, by its name or its number, counted from 0 (all)")
        ->needs(svg);
    add_value(command, "--visible-from", options.visible_from, "ROOM",
              "say what can be seen from the room of this name or id instead: which rooms, through how many doors and "
              "windows at least, and what share of its view each fills");
}

void add_render(CLI::App& app, Invocation& invocation, RenderOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "render", "Render a picture of a scene.",
                                    "  enfilade render house.enf -o house.png --camera dollhouse\n"
                                    "  enfilade render house.enf -o kitchen.png --room Kitchen\n"
                                    "  enfilade render house.enf -o tour/ --views house.views.json",
                                    run_render);
    add_positional(command, "SCENE", options.scene, "the scene file (.enf)");
    add_needed(
        command, "-o,--output", options.output, "FILE",
        "the picture to write, .png or .exr; of several views a folder, like tour/, or a name with a number, like "
        "tour-%02d.png (needed)");
    CLI::Option* camera = add_value(command, "--camera", options.camera, "VIEW", camera_help());
    CLI::Option* room =
        add_value(command, "--room", options.room, "NAME", "look into the room of this name or id, from inside it")
            ->excludes(camera);
    add_value(command, "--views", options.views, "FILE",
              "a picture of each view of this file, as \"enfilade tour\" writes it (docs/views.schema.json)")
        ->excludes(camera)
        ->excludes(room);
    add_value(command, "--size", options.size, "WxH", "width and height in pixels (1024x1024)");
    add_value(command, "--fov-deg", options.fov_deg, "DEGREES", "field of view across the longer side (the view's own)")
        ->check(CLI::Range(1.0, 170.0));
    add_value(
        command, "--tracer", options.tracer, "NAME",
        "scalar: through the cells, one ray at a time; simd: as many rays as a register holds; packet: whole tiles "
        "of the picture; oracle: every face against every ray, slow; simd and packet are for --shading lambert "
        "--samples 1 "
        "of a building not cut open, other pictures go ray by ray (packet)")
        ->check(CLI::IsMember({"scalar", "simd", "packet", "oracle"}));
    add_value(
        command, "--real", options.real, "TYPE",
        "float or double: the numbers in which rays walk; double is for the scalar tracer, and chooses it (float)")
        ->check(CLI::IsMember({"float", "double"}));
    add_value(command, "--packets", options.packets, "LARGEST:SMALLEST",
              "packet tracer: pixels a side of the tiles that it begins with, and of those that it walks ray by ray "
              "(64:8)");
    add_value(command, "--mirror-floor", options.mirror_floor, "[SHARE]",
              "floors mirror this share of the light, 0 to 1; 0.25 where the flag stands alone (0)")
        ->expected(0, 1);
    add_value(command, "--shading", options.shading, "NAME",
              "look: sun, sky and darkened corners; lambert: one lamp at the eye, as the oracle has it (look)")
        ->check(CLI::IsMember({"look", "lambert"}));
    add_value(command, "--samples", options.samples, "N", "rays along each side of a pixel: 3 gives 9 a pixel (2)")
        ->check(CLI::Range(1u, 32u));
    add_value(command, "--threads", options.threads, "N", "how many cores to use (all)");
    add_value(command, "--show", options.show, "WHAT",
              "instead of light, in false colours what each pixel's ray costs the scalar tracer: cells, the ones it "
              "enters, or sides, the vertical lines it is tested against")
        ->check(CLI::IsMember({"cells", "sides"}));
    command->add_flag(
        "--stats", options.stats,
        "say what happened to the rays: cells and sides a ray, packets, recoveries; with --json it is always "
        "there");
}

void add_trace(CLI::App& app, Invocation& invocation, TraceCommandOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "trace",
                                    "Answer many rays: what each meets, whether it is blocked, all it passes.",
                                    "  enfilade trace house.enf rays.npy -o hits.npy\n"
                                    "  enfilade trace house.enf links.npy -o passages.npy --query all",
                                    run_trace);
    add_positional(command, "SCENE", options.scene, "the scene file (.enf)");
    add_positional(command, "RAYS", options.rays,
                   "rays as numpy saves them (.npy): (n, 6) numbers, origin and direction in metres of the plan, or "
                   "(n, 7) with a maximal distance");
    add_needed(command, "-o,--output", options.output, "FILE", "the answers to write, .npy (needed; docs/queries.md)");
    add_value(command, "--query", options.query, "KIND",
              "nearest: the face that each ray meets; any: whether something opaque lies within its distance; all: "
              "every cell, door, pane and solid that it passes, with thicknesses (nearest)")
        ->check(CLI::IsMember({"nearest", "any", "all"}));
    add_value(command, "--real", options.real, "KIND",
              "float, or double: ray by ray, slower (float; all is always computed in double)")
        ->check(CLI::IsMember({"float", "double"}));
    add_value(command, "--tracer", options.tracer, "NAME",
              "scalar: one ray at a time; simd: as many as a register holds; packet: whichever is fastest (packet)")
        ->check(CLI::IsMember({"scalar", "simd", "packet"}));
    add_value(command, "--threads", options.threads, "N", "how many cores to use (all)");
}

void add_tour(CLI::App& app, Invocation& invocation, TourCommandOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "tour",
                                    "Walk through a building, from room to room, and save the views along the way.",
                                    "  enfilade tour house.enf -o house.views.json\n"
                                    "  enfilade render house.enf --views house.views.json -o tour/",
                                    run_tour);
    add_positional(command, "SCENE", options.scene, "the scene file (.enf)");
    add_needed(command, "-o,--output", options.output, "FILE",
               "the view file to write, JSON (docs/views.schema.json) (needed)");
    add_value(command, "--views", options.views, "N", "how many views (24)")->check(CLI::Range(1u, 100000u));
    add_value(command, "--rooms", options.rooms, "N", "how many rooms, or places in them, the walk leads to (8)")
        ->check(CLI::Range(1u, 1000u));
}

void add_export(CLI::App& app, Invocation& invocation, ExportOptions& options) {
    CLI::App* command = add_command(
        app, invocation, options, "export", "Write a scene in a format of other programs.",
        "  enfilade export house.enf -o house.glb\n  enfilade export house.enf -o house.graphml", run_export);
    add_positional(command, "SCENE", options.scene, "the scene file (.enf)");
    add_needed(command, "-o,--output", options.output, "FILE",
               "the file to write (needed); its ending chooses the format:" + export_list());
    add_value(command, "--level", options.level, "LEVEL", "of a .dot graph: rooms, or the convex cells (rooms)")
        ->check(CLI::IsMember({"rooms", "cells"}));
}

void add_bench(CLI::App& app, Invocation& invocation, BenchOptions& options) {
    CLI::App* command =
        add_command(app, invocation, options, "bench",
                    "Measure how fast this machine does it, against the goals and the best known relatives.",
                    "  enfilade bench cells --quick", run_bench, false);
    add_positional(command, "NAME", options.name, "which one:\n" + bench_list());
    command->add_flag("--quick", options.quick, "smaller inputs and fewer runs: at most 40 seconds");
    add_value(command, "--json", options.json, "FILE", "also write the rows to this file");
    add_value(command, "--data", options.data, "FOLDER",
              "where other people's plans lie, in sh3d, dxf and other; benchmarks of them are left out without it "
              "(../shared/data)");
    command->add_flag("--strict", options.strict, "end with 1 where a goal is not met");
}

/// What CLI11 found wrong, in our words.
std::string sentence_of(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<std::string> chosen_names = [&] {
        std::vector<std::string> names;
        for (const CLI::App* command : app.get_subcommands()) names.push_back(command->get_name());
        return names;
    }();
    const std::vector<std::string> left = app.remaining(true);
    if (chosen_names.empty()) {
        std::vector<std::string> known;
        for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
            known.push_back(command->get_name());
        const std::string what = left.empty() ? "nothing" : '"' + left.front() + '"';
        return "There is no command " + what + (left.empty() ? "" : suggestion(left.front(), known)) +
               "; \"enfilade --help\" lists them.";
    }
    const CLI::App* command = app.get_subcommand(chosen_names.front());
    const std::string help = "; \"enfilade " + command->get_name() + " --help\" shows how.";
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !left.empty()) {
        std::vector<std::string> known;
        for (const CLI::Option* option : command->get_options())
            for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
        return "\"enfilade " + command->get_name() + "\" does not take \"" + left.front() + '"' +
               suggestion(left.front(), known) + help;
    }
    std::string text = error.what();
    if (const std::size_t end = text.find('\n'); end != std::string::npos) text.resize(end);
    return text + help;
}

int run(int argument_count, char** arguments) {
    CLI::App app(about, "enfilade");
    app.footer(exit_codes);
    app.set_version_flag("--version", std::string("enfilade ") + version);
    app.require_subcommand(1);
    app.get_formatter()->column_width(28);

    Invocation invocation;
    ImportOptions import_options;
    GenerateCommandOptions generate_options;
    BuildCommandOptions build_options;
    CheckOptions check_options;
    InfoOptions info_options;
    RenderOptions render_options;
    TraceCommandOptions trace_options;
    TourCommandOptions tour_options;
    ExportOptions export_options;
    BenchOptions bench_options;
    add_import(app, invocation, import_options);
    add_generate(app, invocation, generate_options);
    add_build(app, invocation, build_options);
    add_check(app, invocation, check_options);
    add_info(app, invocation, info_options);
    add_render(app, invocation, render_options);
    add_trace(app, invocation, trace_options);
    add_tour(app, invocation, tour_options);
    add_export(app, invocation, export_options);
    add_bench(app, invocation, bench_options);

    if (argument_count < 2) {
        std::fputs(app.help().c_str(), stderr);
        return exit_bad_input;
    }
    try {
        app.parse(argument_count, arguments);
    } catch (const CLI::Success& success) {
        return app.exit(success);  // --help and --version
    } catch (const CLI::ParseError& error) {
        throw InputError("F100", "", sentence_of(app, error));
    }
    return invocation.run(Console(invocation.quiet, invocation.json));
}

/// The sentence on stderr, and the exit code.
int fail(const std::string& sentence, int code) {
    std::fprintf(stderr, "enfilade: %s\n", sentence.c_str());
    return code;
}

}  // namespace
}  // namespace enfilade::tools

int main(int argument_count, char** arguments) {
    using namespace enfilade;
    try {
        return tools::run(argument_count, arguments);
    } catch (const InputError& error) {
        return tools::fail(error.located(), tools::exit_bad_input);
    } catch (const IoError& error) {
        return tools::fail(error.what(), tools::exit_device);
    } catch (const std::filesystem::filesystem_error& error) {
        return tools::fail(error.path1().string() + ": " + error.code().message() + ".", tools::exit_device);
    } catch (const std::bad_alloc&) {
        return tools::fail(
            "There is not enough memory for this: model fewer storeys (--storeys), or use a larger machine.",
            tools::exit_device);
    }
}

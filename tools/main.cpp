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
constexpr const char* plan_text = "the plan: our JSON, or a Sweet Home 3D home (.sh3d)";

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

void add_model_flags(CLI::App* command, ModelOptions& model) {
    command->add_option("--storeys", model.storeys, "model these storeys only, counted from 0 upward: 0,2")
        ->delimiter(',');
    command
        ->add_option("--snap-mm", model.snap_mm,
                     "grid on which all corners lie, in millimetres (0.122; rounded down to a power of two of a metre)")
        ->check(CLI::PositiveNumber);
    command
        ->add_option("--sagitta-mm", model.sagitta_mm,
                     "largest distance of a curved wall from its straight pieces, in millimetres (2)")
        ->check(CLI::PositiveNumber);
    command
        ->add_option_function<std::string>(
            "--glass", [&model](const std::string& kind) { model.opaque_glass = kind == "opaque"; },
            "clear: light passes windows (the usual case); opaque: it does not")
        ->check(CLI::IsMember({"clear", "opaque"}));
}

void add_import(CLI::App& app, Invocation& invocation, ImportOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "import",
                                    "Read a plan in any format and write it as our JSON, with what was repaired",
                                    "  enfilade import house.sh3d -o house.json", run_import);
    command->add_option("PLAN", options.plan, plan_text)->required();
    command->add_option("-o,--output", options.output, "the JSON file to write")->required();
    add_strict(command, options.strict);
}

void add_generate(CLI::App& app, Invocation& invocation, GenerateCommandOptions& options) {
    CLI::App* command =
        add_command(app, invocation, options, "generate", "Invent the plan of an office building of any size",
                    "  enfilade generate --rooms 200 --storeys 2 --curved 0.1 -o office.json", run_generate);
    command->add_option("--rooms", options.rooms, "rooms of the whole building, corridors counted")
        ->required()
        ->check(CLI::Range(1u, 2000000u));
    command->add_option("--storeys", options.storeys, "storeys over which they are spread (1)")
        ->check(CLI::Range(1u, 200u));
    command->add_option("--curved", options.curved, "share of the inner walls that are arcs, 0 to 1 (0)")
        ->check(CLI::Range(0.0, 1.0));
    command->add_option("--oblique", options.oblique, "share of the inner walls that are turned, 0 to 1 (0)")
        ->check(CLI::Range(0.0, 1.0));
    command->add_option("--seed", options.seed, "another number, another building (1)");
    command->add_option("-o,--output", options.output, "the JSON file to write")->required();
}

void add_build(CLI::App& app, Invocation& invocation, BuildCommandOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "build",
                                    "Model a building from its plan, check it, and write it as a scene",
                                    "  enfilade build house.sh3d -o house.enf --report house.txt", run_build);
    command->add_option("PLAN", options.plan, plan_text)->required();
    command->add_option("-o,--output", options.output, "the scene file to write (.enf)")->required();
    add_model_flags(command, options.model);
    command->add_flag("--keep-going", options.keep_going, "write the scene even where the check finds errors");
    command->add_flag("--strip", options.strip,
                      "leave out the model group: a smaller file that can be traced, but not checked");
    command->add_option("--report", options.report, "write all findings to this file (.txt or .json)");
    add_strict(command, options.strict);
}

void add_check(CLI::App& app, Invocation& invocation, CheckOptions& options) {
    CLI::App* command =
        add_command(app, invocation, options, "check",
                    "Say whether the model of a plan, or a scene file, is sound, and what is wrong where",
                    "  enfilade check house.sh3d\n  enfilade check house.enf --json", run_check);
    command->add_option("INPUT", options.input, "a plan, or a scene file (.enf)")->required();
    add_model_flags(command, options.model);
    add_strict(command, options.strict);
}

void add_info(CLI::App& app, Invocation& invocation, InfoOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "info",
                                    "Show what a scene file holds: rooms, cells, faces, bytes, and how they are joined",
                                    "  enfilade info house.enf", run_info);
    command->add_option("SCENE", options.scene, "the scene file (.enf)")->required();
}

void add_render(CLI::App& app, Invocation& invocation, RenderOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "render", "Render a picture of a scene",
                                    "  enfilade render house.enf -o house.png --camera dollhouse\n"
                                    "  enfilade render house.enf -o kitchen.png --room Kitchen",
                                    run_render);
    command->add_option("SCENE", options.scene, "the scene file (.enf)")->required();
    command->add_option("-o,--output", options.output, "the picture to write (.png or .exr)")->required();
    CLI::Option* camera = command->add_option("--camera", options.camera, camera_help());
    command->add_option("--room", options.room, "look into the room of this name, from inside it")->excludes(camera);
    command->add_option("--size", options.size, "width x height in pixels (1024x1024)");
    command
        ->add_option("--fov-deg", options.fov_deg, "field of view across the longer side, in degrees (the view's own)")
        ->check(CLI::Range(1.0, 170.0));
    command
        ->add_option("--tracer", options.tracer,
                     "scalar: through the cells (the usual case); oracle: every face against every ray, in double "
                     "precision, slow")
        ->check(CLI::IsMember({"scalar", "oracle"}));
    command
        ->add_option(
            "--shading", options.shading,
            "look: sun, sky and darkened corners (the usual case); lambert: one lamp at the eye, as the oracle has it")
        ->check(CLI::IsMember({"look", "lambert"}));
    command->add_option("--samples", options.samples, "rays along each side of a pixel: 3 gives 9 a pixel (2)")
        ->check(CLI::Range(1u, 32u));
    command->add_option("--threads", options.threads, "how many cores to use (all)");
}

void add_export(CLI::App& app, Invocation& invocation, ExportOptions& options) {
    CLI::App* command = add_command(
        app, invocation, options, "export", "Write a scene in a format of other programs",
        "  enfilade export house.enf -o house.glb\n  enfilade export house.enf -o house.graphml", run_export);
    command->add_option("SCENE", options.scene, "the scene file (.enf)")->required();
    command
        ->add_option(
            "-o,--output", options.output,
            "the file to write: .glb (glTF) and .obj hold the faces, .graphml the rooms, the cells and what joins them")
        ->required();
}

void add_bench(CLI::App& app, Invocation& invocation, BenchOptions& options) {
    CLI::App* command =
        add_command(app, invocation, options, "bench",
                    "Measure how fast this machine does it, against the goals and the best known relatives",
                    "  enfilade bench cells --quick", run_bench, false);
    command->add_option("NAME", options.name, "which one:\n" + bench_list())->required();
    command->add_flag("--quick", options.quick, "smaller inputs and fewer runs: at most 40 seconds");
    command->add_option("--json", options.json, "also write the rows to this file");
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
    ExportOptions export_options;
    BenchOptions bench_options;
    add_import(app, invocation, import_options);
    add_generate(app, invocation, generate_options);
    add_build(app, invocation, build_options);
    add_check(app, invocation, check_options);
    add_info(app, invocation, info_options);
    add_render(app, invocation, render_options);
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

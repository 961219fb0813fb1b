// The command line of `enfilade`: reads the flags, runs one subcommand, says what went wrong in one sentence.

#include <cstdio>
#include <filesystem>
#include <new>
#include <string>

#include "base/error.h"
#include "tools/exit_code.h"
#include "tools/flags.h"
#include "tools/suggestion.h"
#include "tools/version.h"

namespace enfilade::tools {
namespace {

constexpr const char* about =
    "Enfilade models buildings from plans, checks that the model is sound, and traces rays through it.\n"
    "\n"
    "A first picture:\n"
    "  enfilade build plans/examples/townhouse.json -o house.enf\n"
    "  enfilade render house.enf -o house.png\n";
constexpr const char* exit_codes =
    "Every command ends with 0 when all is well, 1 when the plan or the model has errors, 2 when a file or a flag is\n"
    "wrong, 3 when a file or a device would not do its part. \"enfilade COMMAND --help\" shows the flags of a command.";
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
    PlaceOptions place_options;
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
    add_place(app, invocation, place_options);
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

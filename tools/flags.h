#pragma once
// The flags of the subcommands. CLI11 costs seconds in each translation unit: it is included here alone, and this by
// main.cpp and flags_*.cpp alone.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "tools/commands.h"

namespace enfilade::tools {

/// What the flags ask for.
struct Invocation {
    bool quiet = false;
    bool json = false;
    std::function<int(const Console&)> run;
};

/// Each adds its command: the flags go to `options`, and the command chosen to `invocation`.
void add_import(CLI::App& app, Invocation& invocation, ImportOptions& options);
void add_generate(CLI::App& app, Invocation& invocation, GenerateCommandOptions& options);
void add_build(CLI::App& app, Invocation& invocation, BuildCommandOptions& options);
void add_check(CLI::App& app, Invocation& invocation, CheckOptions& options);
void add_place(CLI::App& app, Invocation& invocation, PlaceOptions& options);
void add_info(CLI::App& app, Invocation& invocation, InfoOptions& options);
void add_render(CLI::App& app, Invocation& invocation, RenderOptions& options);
void add_trace(CLI::App& app, Invocation& invocation, TraceCommandOptions& options);
void add_tour(CLI::App& app, Invocation& invocation, TourCommandOptions& options);
void add_export(CLI::App& app, Invocation& invocation, ExportOptions& options);
void add_bench(CLI::App& app, Invocation& invocation, BenchOptions& options);

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

}  // namespace enfilade::tools

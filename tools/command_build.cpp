#include <nlohmann/json.hpp>

#include "accel/scene_file.h"
#include "base/error.h"
#include "modeler/export_scene.h"
#include "modeler/lighting/rule_lamps.h"
#include "modeler/surface_textures.h"
#include "plans/read.h"
#include "render/executor.h"
#include "tools/bench.h"
#include "tools/check_report.h"
#include "tools/commands.h"
#include "tools/exit_code.h"
#include "tools/findings_text.h"
#include "tools/furniture.h"
#include "tools/lamp_summary.h"
#include "tools/model.h"
#include "tools/output_file.h"
#include "tools/scene_summary.h"

namespace enfilade::tools {

namespace {

constexpr std::size_t shown_findings = 20;  ///< of each severity; all with --report and with `check`

struct Built {
    Modelled modelled;
    accel::Scene scene;
    std::string furniture_text;  ///< empty: there is none
    nlohmann::ordered_json furniture;
    double read_seconds = 0;
    double export_seconds = 0;
    double write_seconds = 0;
    double seconds = 0;
};

/// The certificate's options, with how objects and cells know each other.
std::string with_objects(const std::string& options_json, const FurnishFlags& furnish) {
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(options_json);
    json["objects"] = furnish.cut ? "cut" : "list";
    if (furnish.rules) json["seed"] = furnish.seed;
    return json.dump();
}

/// The same, with the lamp rules.
std::string with_lamps(const std::string& options_json, const FurnishFlags& furnish) {
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(options_json);
    json["lamps"] = furnish.lamps->empty() ? "own" : std::filesystem::path(*furnish.lamps).filename().string();
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

Built build_scene(const BuildCommandOptions& options, const Console& console) {
    const std::filesystem::path output = output_path(options.output);
    std::vector<std::string> steps = {"Reading the plan"};
    steps.insert(steps.end(), furnished_model_steps.begin(), furnished_model_steps.end());
    steps.insert(steps.end(), {"Laying out the scene", "Writing"});
    Progress progress(console, std::move(steps));
    Built built;
    built.seconds = seconds_of([&] {
        std::optional<Furniture> furniture;
        const std::optional<modeler::LampRules> lamps = lamp_rules_of(options.furnish);
        plans::Plan plan;
        built.read_seconds = seconds_of([&] {
            plan = plans::read(options.plan, options.read.options);
            furniture.emplace(options.furnish, options.plan, plan);
        });
        progress.next();
        built.modelled = model(plan, options.model, progress, [&](modeler::Building& building) {
            modeler::read_surface_pictures(building, options.plan, options.furnish.texture_side);
            if (furniture->is_wanted()) furniture->put_into(building, progress);
            if (lamps) modeler::light_building(building, *lamps, furniture->catalogue(), *render::make_executor());
        });
        progress.next();
        if (furniture->is_wanted()) {
            built.modelled.options_json = with_objects(built.modelled.options_json, options.furnish);
            built.furniture_text = furniture->text();
            built.furniture = furniture->json(built.modelled.building);
        }
        if (lamps) built.modelled.options_json = with_lamps(built.modelled.options_json, options.furnish);
        if (has_defects(built.modelled.report, options.strict) && !options.keep_going) return;
        built.export_seconds = seconds_of([&] {
            built.scene =
                modeler::export_scene(built.modelled.building, built.modelled.report, built.modelled.options_json);
            if (options.strip) built.scene = accel::strip(built.scene);
        });
        progress.next();
        built.write_seconds = seconds_of([&] { accel::write(built.scene, output); });
    });
    return built;
}

std::string result_json(const BuildCommandOptions& options, const Built& built, bool written) {
    nlohmann::ordered_json json = {{"command", "build"}, {"input", options.plan.string()}};
    json["output"] = nullptr;
    if (written) json["output"] = options.output.string();
    json["seconds"] = built.seconds;
    json["options"] = nlohmann::ordered_json::parse(built.modelled.options_json);
    json["volumes"] = built.modelled.building.volumes.size();
    json["darts"] = built.modelled.building.map.dart_count();
    json["furniture"] = built.furniture;
    json["lamps"] = nullptr;
    if (written) json["lamps"] = lamps_json(lamp_summary(built.scene.view()));
    json["stage_seconds"] = {{"read", built.read_seconds},
                             {"model", built.modelled.build_seconds},
                             {"convexify", built.modelled.convexify_seconds},
                             {"check", built.modelled.check_seconds},
                             {"export", built.export_seconds},
                             {"write", built.write_seconds}};
    json["scene"] = nullptr;
    if (written) json["scene"] = scene_counts_json(built.scene);
    json["check"] = report_json({options.plan.string(), ""}, built.modelled.report);
    return dump(json);
}

}  // namespace

int run_build(const BuildCommandOptions& options, const Console& console) {
    if (options.read.list_layers) return list_layers(options.plan, console);
    need_output(options.output, "build");
    need_report_name(options.report);
    const Built built = build_scene(options, console);
    const modeler::CheckReport& report = built.modelled.report;
    const ReportSubject subject{options.plan.string(), ""};
    if (!options.report.empty()) write_report(options.report, subject, report, &built.modelled.building);

    const bool defects = has_defects(report, options.strict);
    const bool written = !defects || options.keep_going;
    if (console.json()) {
        console.print(result_json(options, built, written));
        return defects ? exit_defects : exit_ok;
    }
    console.say(report_text(subject, report, shown_findings));
    if (!built.furniture_text.empty()) console.say(built.furniture_text);
    if (written && !built.scene.view().lights.empty()) console.say(lamps_text(lamp_summary(built.scene.view())));
    if (written)
        console.say(options.output.string() + ": " + scene_counts_text(built.scene) + ", in " +
                    time_text(built.seconds) + '.');
    else
        console.warn("enfilade: " + options.output.string() + " is not written, because the model has defects (" +
                     counts_text(report.findings) + "): mend the plan, or build with --keep-going.");
    return defects ? exit_defects : exit_ok;
}

}  // namespace enfilade::tools

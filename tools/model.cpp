#include "tools/model.h"

#include <charconv>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "modeler/convexify.h"
#include "tools/bench.h"
#include "tools/convexifiers.h"

namespace enfilade::tools {

namespace {

/// Names of the plan's storeys by index, for whoever asked for one that is not there.
std::string storey_list(const plans::Plan& plan) {
    std::string text;
    for (std::size_t i = 0; i < plan.storeys.size(); ++i)
        text += (i == 0 ? "" : ", ") + std::to_string(i) + " \"" + plan.storeys[i].name + '"';
    return text;
}

std::string options_text(const ModelOptions& options, const modeler::BuildOptions& build) {
    nlohmann::ordered_json json = {{"snap_mm", build.arrange.snap_mm},
                                   {"sagitta_mm", build.arrange.sagitta_mm},
                                   {"step_mm", 1000 * build.clean.step}};
    json["storeys"] = options.storeys;
    json["glass"] = options.opaque_glass ? "opaque" : "clear";
    json["convexify"] = name_of(options.convexifier);
    return json.dump();
}

}  // namespace

std::vector<std::uint32_t> parse_storeys(const std::string& list) {
    std::vector<std::uint32_t> storeys;
    const char* at = list.data();
    const char* const end = at + list.size();
    for (;;) {
        std::uint32_t storey = 0;
        const auto [stop, error] = std::from_chars(at, end, storey);
        if (error != std::errc() || (stop != end && *stop != ','))
            throw InputError(
                "F103", "",
                "--storeys \"" + list + "\" is no list of storeys: give their numbers, counted from 0, like 0,2.");
        storeys.push_back(storey);
        if (stop == end) return storeys;
        at = stop + 1;
    }
}

modeler::BuildOptions build_options(const ModelOptions& options, const plans::Plan& plan) {
    for (const std::uint32_t storey : options.storeys)
        if (storey >= plan.storeys.size())
            throw InputError("F103", "",
                             "--storeys " + std::to_string(storey) + ": the plan has " +
                                 counted(plan.storeys.size(), "storey") + ", counted from 0: " + storey_list(plan) +
                                 '.');
    modeler::BuildOptions build;
    if (options.snap_mm) {
        build.arrange.snap_mm = *options.snap_mm;
        build.arrange.snap_fixed = true;
    }
    if (options.sagitta_mm) build.arrange.sagitta_mm = *options.sagitta_mm;
    if (options.step_mm) build.clean.step = *options.step_mm / 1000;
    build.arrange.storeys = options.storeys;
    build.opaque_glass = options.opaque_glass;
    return build;
}

modeler::CheckOptions check_options(const ModelOptions& options) {
    modeler::CheckOptions check;
    if (options.least_thickness_mm) check.least_thickness = *options.least_thickness_mm / 1000;
    return check;
}

Modelled model(const plans::Plan& plan, const ModelOptions& options, Progress& progress,
               const std::function<void(modeler::Building&)>& furnish) {
    const modeler::BuildOptions build = build_options(options, plan);
    Modelled modelled;
    modelled.options_json = options_text(options, build);
    {
        modeler::Building whole;
        modelled.build_seconds = seconds_of([&] { whole = modeler::build(plan, build); });
        progress.next();
        modelled.convexify_seconds =
            seconds_of([&] { modelled.building = modeler::convexify(whole, {.convexifier = options.convexifier}); });
    }
    progress.next();
    if (furnish) {
        furnish(modelled.building);
        progress.next();
    }
    modelled.check_seconds =
        seconds_of([&] { modelled.report = modeler::check(modelled.building, check_options(options)); });
    return modelled;
}

}  // namespace enfilade::tools

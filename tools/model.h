#pragma once
// From a plan file to a checked model: what `build`, `check` and the benchmarks share.

#include <functional>
#include <string>

#include "modeler/build.h"
#include "modeler/check.h"
#include "plans/plan.h"
#include "tools/commands.h"
#include "tools/progress.h"

namespace enfilade::tools {

struct Modelled {
    modeler::Building building;  ///< convex
    modeler::CheckReport report;
    std::string options_json;  ///< of the build, on one line: it enters the scene's certificate
    double build_seconds = 0;
    double convexify_seconds = 0;
    double check_seconds = 0;
};

/// The steps of `model`, for a progress bar.
inline const std::vector<std::string> model_steps = {"Modelling", "Cutting into convex cells", "Checking"};
/// The same where it furnishes.
inline const std::vector<std::string> furnished_model_steps = {"Modelling", "Cutting into convex cells", "Furnishing",
                                                               "Checking"};

/// What `modeler::build` makes of the flags. Throws InputError where a storey does not exist.
[[nodiscard]] modeler::BuildOptions build_options(const ModelOptions& options, const plans::Plan& plan);

/// What `modeler::check` makes of the flags.
[[nodiscard]] modeler::CheckOptions check_options(const ModelOptions& options);

/// Builds, convexifies and checks. `progress` stands at the first of `model_steps`, and is left at the last one.
/// furnish: if given, what the convex building is handed to before it is checked; then `progress` goes by
/// `furnished_model_steps`.
[[nodiscard]] Modelled model(const plans::Plan& plan, const ModelOptions& options, Progress& progress,
                             const std::function<void(modeler::Building&)>& furnish = {});

}  // namespace enfilade::tools

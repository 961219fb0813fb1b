#pragma once
// The plans that the repository brings, for benchmarks that want them.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "plans/plan.h"
#include "tools/bench.h"

namespace enfilade::tools {

/// plans/examples/<file>: beside or above the folder where the program runs, or where it lies. Nothing where it is
/// nowhere.
[[nodiscard]] std::optional<std::filesystem::path> example_file(const std::string& file);

struct ExamplePlan {
    std::string name;  ///< the example's, or "46 rooms" where it is generated
    plans::Plan plan;
};
/// The example of that name. Where it is nowhere, a generated floor of as many rooms under a name of its own, and a
/// remark that says so.
[[nodiscard]] ExamplePlan example_plan(Bench& bench, const std::string& name, std::uint32_t rooms);

}  // namespace enfilade::tools

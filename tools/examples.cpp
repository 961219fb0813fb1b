#include "tools/examples.h"

#include <system_error>

#include "plans/generate.h"
#include "plans/read.h"

namespace enfilade::tools {

namespace {

/// In the folder, or in one that it lies in.
std::optional<std::filesystem::path> found_from(std::filesystem::path folder, const std::string& file) {
    while (!folder.empty()) {
        std::filesystem::path candidate = folder / "plans" / "examples" / file;
        std::error_code error;
        if (std::filesystem::is_regular_file(candidate, error)) return candidate;
        const std::filesystem::path above = folder.parent_path();
        if (above == folder) break;
        folder = above;
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::filesystem::path> example_file(const std::string& file) {
    std::error_code error;
    if (const auto found = found_from(std::filesystem::current_path(error), file)) return found;
    return found_from(std::filesystem::read_symlink("/proc/self/exe", error).parent_path(), file);
}

ExamplePlan example_plan(Bench& bench, const std::string& name, std::uint32_t rooms) {
    if (const auto file = example_file(name + ".json")) return {name, plans::read(*file)};
    ExamplePlan made{std::to_string(rooms) + " rooms", plans::generate({.rooms = rooms})};
    bench.remark("The example " + name + " is not found from here (plans/examples): a generated floor of " + made.name +
                 " stands for it. Run this inside the repository.");
    return made;
}

}  // namespace enfilade::tools

#include "tools/real_plans.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "tools/commands.h"
#include "tools/inputs_counted.h"

namespace enfilade::tools {

namespace {

namespace fs = std::filesystem;

/// The flags that `inputs_counted.json` gives to the command line, as options.
plans::ReadOptions options_of(const nlohmann::json& counted) {
    plans::ReadOptions options;
    const nlohmann::json flags = counted.value("flags", nlohmann::json::array());
    for (std::size_t k = 0; k + 1 < flags.size(); k += 2) {
        const std::string flag = flags[k], value = flags[k + 1];
        if (flag == "--crop") options.crop = parse_crop(value);
        else if (flag == "--layer") options.layers.push_back(value);
        else ENFILADE_CHECK(false);
    }
    return options;
}

void add_files(const fs::path& folder, const char* below, const std::string& prefix, const std::string& ending,
               const nlohmann::json& counted, std::vector<RealPlan>& plans) {
    std::error_code absent;
    const std::size_t first = plans.size();
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / below, absent)) {
        const std::string name = entry.path().filename().string();
        if (!entry.is_regular_file() || !name.starts_with(prefix) || !name.ends_with(ending)) continue;
        const std::string key = std::string(below) + '/' + name;
        plans.push_back({name, entry.path(), options_of(counted.value(key, nlohmann::json::object()))});
    }
    std::sort(plans.begin() + std::ptrdiff_t(first), plans.end(),
              [](const RealPlan& a, const RealPlan& b) { return a.name < b.name; });
}

}  // namespace

std::vector<RealPlan> real_plans(const fs::path& folder) {
    const nlohmann::json counted = nlohmann::json::parse(inputs_counted);
    std::vector<RealPlan> plans;
    add_files(folder, "sh3d", "", ".sh3d", counted, plans);
    add_files(folder, "dxf", "", ".dxf", counted, plans);
    add_files(folder, "other", "floorspace_", ".json", counted, plans);
    return plans;
}

}  // namespace enfilade::tools

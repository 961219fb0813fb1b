#include "tools/ray_report.h"

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tools/console.h"

namespace enfilade::tools {

namespace {

double per(std::uint64_t part, std::uint64_t whole) { return whole == 0 ? 0 : double(part) / double(whole); }

std::string decimal(double value, int digits) {
    std::array<char, 64> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.*f", digits, value);
    return buffer.data();
}

std::string line(const char* name, const std::string& value, const std::string& remark = {}) {
    std::string text = "  " + std::string(name);
    text.resize(24, ' ');
    text += std::string(value.size() < 12 ? 12 - value.size() : 0, ' ') + value;
    return text + (remark.empty() ? "" : "  " + remark) + '\n';
}

}  // namespace

std::string ray_report(const render::RayStats& stats, std::uint64_t pixels) {
    std::string text = line("rays walked", grouped(stats.rays));
    text += line("cells entered", grouped(stats.cells), decimal(per(stats.cells, stats.rays), 2) + " a ray");
    text += line("sides tested", grouped(stats.side_tests), decimal(per(stats.side_tests, stats.rays), 2) + " a ray");
    if (stats.glass > 0) text += line("panes crossed", grouped(stats.glass));
    if (stats.lamps_considered > 0)
        text += line("lamps looked for", grouped(stats.lamps_considered),
                     decimal(100 * per(stats.lamps_lit, stats.lamps_considered), 1) + " % of them shine there");
    if (stats.tiles > 0) {
        text += line("packets", grouped(stats.tiles), grouped(stats.splits) + " of them split");
        text += line("pixels filled whole", grouped(stats.filled),
                     decimal(100 * per(stats.filled, pixels), 1) + " % of " + grouped(pixels));
    }
    text += line("recoveries", grouped(stats.several + stats.none),
                 grouped(stats.several) + " of several exits, " + grouped(stats.none) + " of none");
    return text + line("leaks", grouped(stats.leaks), stats.leaks > 0 ? "a defect: please report it" : "");
}

nlohmann::ordered_json ray_json(const render::RayStats& stats, std::uint64_t pixels) {
    return {{"rays", stats.rays},
            {"cells", stats.cells},
            {"side_tests", stats.side_tests},
            {"cells_per_ray", per(stats.cells, stats.rays)},
            {"side_tests_per_ray", per(stats.side_tests, stats.rays)},
            {"glass", stats.glass},
            {"lamps_looked_for", stats.lamps_considered},
            {"lamps_that_shine", stats.lamps_lit},
            {"packets", stats.tiles},
            {"packet_splits", stats.splits},
            {"pixels", pixels},
            {"pixels_filled_whole", stats.filled},
            {"share_filled_whole", per(stats.filled, pixels)},
            {"recoveries_several_exits", stats.several},
            {"recoveries_no_exit", stats.none},
            {"leaks", stats.leaks}};
}

}  // namespace enfilade::tools

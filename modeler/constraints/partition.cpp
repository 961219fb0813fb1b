// G5: the volumes tile the site box.

#include <algorithm>
#include <array>
#include <cmath>

#include "modeler/constraints/constraints.h"
#include "modeler/map_geometry.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

std::string litres(const Building& building, Int128 volume6) {
    const double cubic_metres = double(volume6) / 6 * std::pow(building.frame.unit, 3);
    char text[48];
    std::snprintf(text, sizeof text, "%.3g litres", 1000 * cubic_metres);
    return text;
}

/// The middle of the first side of the hull that is not where the site box has it; of the box where all sides are.
std::array<double, 3> middle_of_wrong_side(const Building& building) {
    std::array<std::int32_t, 3> low = building.vertices.front(), high = low;
    for (const auto& p : building.vertices)
        for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
    std::array<double, 3> place;
    for (std::size_t i = 0; i < 3; ++i) place[i] = (double(building.site_min[i]) + building.site_max[i]) / 2;
    for (std::size_t i = 0; i < 3; ++i) {
        if (low[i] == building.site_min[i] && high[i] == building.site_max[i]) continue;
        place[i] = low[i] != building.site_min[i] ? low[i] : high[i];
        break;
    }
    const plans::GridFrame& frame = building.frame;
    return {frame.origin_x + frame.unit * place[0], frame.origin_y + frame.unit * place[1],
            frame.origin_z + frame.unit * place[2]};
}

}  // namespace

void check_partition(const Building& building, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("G5");
    if (blame.any()) {  // measures of a map that is not closed and oriented mean nothing
        ++report.suppressed;
        return;
    }
    const auto volumes = volumes6(building.map, building.vertices);
    if (!volumes || volumes->size() != building.volumes.size()) {
        ++report.suppressed;
        return;
    }
    Int128 box = 6, sum = 0;
    for (std::size_t i = 0; i < 3; ++i) box *= Int128(building.site_max[i]) - building.site_min[i];
    const std::uint32_t outside = std::uint32_t(building.volumes.size() - 1);
    bool named = false;
    for (std::uint32_t v = 0; v < outside; ++v) {
        sum += (*volumes)[v];
        if ((*volumes)[v] > 0) continue;
        Finding finding{.code = "G5", .severity = Severity::Error};
        finding.sentence = "The volume of " + title(building.spaces[building.volumes[v].space]) +
                           " is turned inside out: it overlaps its neighbours by " + litres(building, -(*volumes)[v]) +
                           ".";
        finding.hint = "Look for walls that cross or coincide here.";
        place_at_volume(building, v, finding);
        blame.volume[v] = true;
        named = true;
        report.findings.push_back(std::move(finding));
    }
    if (named) return;
    if (sum != box || (*volumes)[outside] != -box) {
        Finding finding{.code = "G5", .severity = Severity::Error};
        finding.sentence = "The volumes do not fill the site: they sum to " + litres(building, sum - box) +
                           " more than the site box, whose hull differs by " +
                           litres(building, -(*volumes)[outside] - box) + ".";
        finding.hint = "Some volume is missing or counted twice; report the plan.";
        finding.point = middle_of_wrong_side(building);
        place_at_volume(building, outside, finding);
        blame.whole_map = true;
        report.findings.push_back(std::move(finding));
    }
}

}  // namespace enfilade::modeler

// S7: lamps hang where light is, shine, and no two at one place.

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "modeler/constraints/constraints.h"
#include "modeler/place.h"
#include "modeler/volume_finder.h"

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t nowhere = UINT32_MAX;

const char* const solid_hint =
    "Move it into the room or the open air beside, a centimetre away from walls and ceilings.";

std::string called(const Lamp& lamp) { return '"' + (lamp.name.empty() ? lamp.id : lamp.name) + '"'; }

class Lamps {
public:
    Lamps(const Building& building, CheckReport& report) : building_(building), report_(report) {}

    void run() {
        check_places();
        check_power();
        check_pairs();
    }

private:
    Finding& add(const Lamp& lamp, std::string sentence, const char* hint) {
        Finding finding{
            .code = "S7", .severity = Severity::Warning, .sentence = std::move(sentence), .hint = std::string(hint)};
        finding.point = lamp.position;
        if (lamp.storey < building_.storeys.size()) finding.storey = building_.storeys[lamp.storey].id;
        finding.elements = {{"light", lamp.id, lamp.name}};
        return report_.findings.emplace_back(std::move(finding));
    }

    void check_places() {
        const VolumeFinder volumes(building_);
        for (const Lamp& lamp : building_.lamps) {
            const std::uint32_t v = volumes.at(lamp.position);
            if (v != nowhere && accel::carries_light(building_.volumes[v].label)) continue;
            if (v == nowhere) {
                add(lamp, "Lamp " + called(lamp) + " hangs outside the site and lights nothing.",
                    "Move it towards the building, or widen the site (\"site_margin\").");
                continue;
            }
            const Space& space = building_.spaces[building_.volumes[v].space];
            add(lamp, "Lamp " + called(lamp) + " is inside the " + title(space) + " and lights nothing.", solid_hint)
                .elements.push_back({std::string(accel::name_of(space.label)), space.id, space.name});
        }
    }

    void check_power() {
        for (const Lamp& lamp : building_.lamps)
            if (candela(lamp) == std::array<float, 3>{0, 0, 0})
                add(lamp, "Lamp " + called(lamp) + " has no power, or a black colour, and lights nothing.",
                    "Give it a power above 0 (\"power_lumen\") and a colour, or delete it.");
    }

    /// Both shine, twice as bright as one sees: most likely one lamp that is there twice.
    void check_pairs() {
        const auto place = [&](std::uint32_t k) { return building_.lamps[k].position; };
        std::vector<std::uint32_t> order(building_.lamps.size());
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::stable_sort(order, {}, place);
        std::vector<std::array<std::uint32_t, 2>> pairs;
        for (std::size_t k = 1, first = 0; k < order.size(); ++k) {
            if (place(order[k]) != place(order[first])) first = k;
            else pairs.push_back({order[k], order[first]});
        }
        std::ranges::sort(pairs);
        for (const auto& [k, first] : pairs) {
            const Lamp& other = building_.lamps[first];
            add(building_.lamps[k],
                "Lamp " + called(building_.lamps[k]) + " hangs exactly where lamp " + called(other) +
                    " does: both shine.",
                "Delete one of them if they are one and the same.")
                .elements.push_back({"light", other.id, other.name});
        }
    }

    const Building& building_;
    CheckReport& report_;
};

}  // namespace

void check_lamps(const Subject& subject, CheckReport& report) {
    if (!subject.building.lamps.empty()) Lamps(subject.building, report).run();
    report.codes_checked.emplace_back("S7");
}

}  // namespace enfilade::modeler

// S4: each flight links two consecutive storeys and pierces the slab between them.

#include <algorithm>

#include "modeler/constraints/constraints.h"
#include "modeler/constraints/map_faces.h"
#include "modeler/constraints/space_index.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

class StairCheck {
public:
    StairCheck(const Subject& subject, const Blame& blame, CheckReport& report)
        : building_(subject.building),
          plan_(subject.plan),
          faces_(subject.faces),
          spaces_(subject.spaces),
          blame_(blame),
          report_(report) {}

    void run() {
        for (std::uint32_t k = 0; k + 1 < building_.storeys.size(); ++k) {
            // Stairs to a storey that is not built end at their slab (P330).
            const plans::Storey *storey = spaces_.storey(k), *next = spaces_.storey(k + 1);
            if (!storey || !next || next - storey != 1) continue;
            for (const plans::Stair& stair : storey->stairs) check(k, *storey, *next, stair);
        }
    }

private:
    void check(std::uint32_t k, const plans::Storey& storey, const plans::Storey& next, const plans::Stair& stair) {
        const auto flight = spaces_.find(Label::Stair, stair.id), well = spaces_.find(Label::Stair, stair.id + "/slab");
        const char* fault = nullptr;
        if (!flight || spaces_.volumes(*flight).empty()) fault = "has no place between the walls of its storey";
        else if (touches_blame(*flight) || (well && touches_blame(*well))) return void(++report_.suppressed);
        else if (!well || spaces_.volumes(*well).empty()) fault = "does not pierce the slab above it";
        else if (!reaches(*flight, building_.storeys[k].z_floor, building_.storeys[k].z_ceiling))
            fault = "does not reach from the floor to the ceiling of its storey";
        else if (!reaches(*well, building_.storeys[k].z_ceiling, building_.storeys[k + 1].z_floor))
            fault = "does not reach through the slab";
        else if (!opens_below(*well, *flight)) fault = "is closed where it enters the slab";
        else if (!opens_above(*well, k + 1)) fault = "is closed where it leaves the slab";
        if (!fault) return;
        // A volume that it seems to lack may be one that is blamed for naming another space (S1).
        const bool is_absent = !flight || !well || spaces_.volumes(*flight).empty() || spaces_.volumes(*well).empty();
        if (is_absent && std::find(blame_.volume.begin(), blame_.volume.end(), true) != blame_.volume.end())
            return void(++report_.suppressed);

        const auto name = [](const auto& element) { return element.name.empty() ? element.id : element.name; };
        Finding finding{.code = "S4", .severity = Severity::Error};
        finding.sentence = "Stair \"" + name(stair) + "\" " + fault + ": it does not lead from storey \"" +
                           name(storey) + "\" to \"" + name(next) + "\".";
        finding.hint =
            "Both storeys need free floor over the stair's outline: look for walls across it, and for a room "
            "around its upper end.";
        finding.storey = storey.id;
        finding.elements = {{"stair", stair.id, stair.name}, {"storey", next.id, next.name}};
        plans::Point at;
        for (const plans::Point p : stair.polygon) at.x += p.x, at.y += p.y;
        const double count = std::max<double>(1, double(stair.polygon.size()));
        finding.point = {at.x / count, at.y / count, building_.frame.world_z(building_.storeys[k].z_ceiling)};
        report_.findings.push_back(std::move(finding));
    }

    [[nodiscard]] bool touches_blame(std::uint32_t space) const {
        return std::any_of(spaces_.volumes(space).begin(), spaces_.volumes(space).end(), [&](std::uint32_t v) {
            return blame_.volume[v] ||
                   std::any_of(faces_.of_volume(v).begin(), faces_.of_volume(v).end(), [&](std::uint32_t f) {
                       const std::uint32_t other = faces_[f].beyond(v);
                       return faces_[f].level() &&
                              (blame_.face[f] || (other < blame_.volume.size() && blame_.volume[other]));
                   });
        });
    }

    /// Whether some volume of the space has level faces of the map at both heights.
    [[nodiscard]] bool reaches(std::uint32_t space, std::int32_t z_low, std::int32_t z_high) const {
        bool low = false, high = false;
        for (const std::uint32_t v : spaces_.volumes(space))
            for (const std::uint32_t f : faces_.of_volume(v)) {
                low = low || (faces_[f].level() && faces_[f].z_low == z_low);
                high = high || (faces_[f].level() && faces_[f].z_low == z_high);
            }
        return low && high;
    }

    template <class Fits>
    [[nodiscard]] bool touches(std::uint32_t space, Fits fits) const {
        for (const std::uint32_t v : spaces_.volumes(space))
            for (const std::uint32_t f : faces_.of_volume(v)) {
                const std::uint32_t other = faces_[f].beyond(v);
                if (faces_[f].level() && other < building_.volumes.size() && fits(building_.volumes[other]))
                    return true;
            }
        return false;
    }

    [[nodiscard]] bool opens_below(std::uint32_t well, std::uint32_t flight) const {
        return touches(well, [&](const Volume& beside) { return beside.space == flight; });
    }

    [[nodiscard]] bool opens_above(std::uint32_t well, std::uint32_t storey) const {
        return touches(well, [&](const Volume& beside) {
            return carries_light(beside.label) && building_.spaces[beside.space].storey == storey &&
                   beside.z_low == building_.storeys[storey].z_floor;
        });
    }

    const Building& building_;
    const plans::Plan& plan_;
    const MapFaces& faces_;
    const SpaceIndex& spaces_;
    const Blame& blame_;
    CheckReport& report_;
};

}  // namespace

void check_stairs(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("S4");
    if (blame.whole_map) ++report.suppressed;
    else StairCheck(subject, blame, report).run();
}

}  // namespace enfilade::modeler

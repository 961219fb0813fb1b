// S5: one exterior, and a way to it from every room that people use.

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "base/disjoint_sets.h"
#include "modeler/constraints/constraints.h"
#include "modeler/constraints/map_faces.h"
#include "modeler/constraints/space_index.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

constexpr double most_step = 0.5;      ///< metres: holes in walls that begin higher are no way through
constexpr double least_habitable = 2;  ///< square metres, of rooms that the plan does not name

class AccessCheck {
public:
    AccessCheck(const Subject& subject, Blame& blame, CheckReport& report)
        : building_(subject.building), faces_(subject.faces), blame_(blame), report_(report), spaces_(subject.spaces) {
        for (const plans::Storey& storey : subject.plan.storeys)
            for (const plans::Room& room : storey.rooms) named_.insert(room.id);
        for (const Finding& finding : report.findings)
            if (finding.code == "S4")
                for (const ElementRef& element : finding.elements)
                    if (element.kind == "storey") unreached_.insert(element.id);
    }

    void run() {
        check_exterior();
        check_rooms();
    }

private:
    [[nodiscard]] Label label(std::uint32_t v) const { return building_.volumes[v].label; }

    /// Calls visit(a, b, level) for the faces between two volumes.
    template <class Visit>
    void for_each_face(Visit visit) const {
        for (std::uint32_t f = 0; f < faces_.size(); ++f)
            if (faces_[f].volumes[1] < building_.volumes.size())
                visit(faces_[f].volumes[0], faces_[f].volumes[1], faces_[f].level());
    }

    void check_exterior() {
        DisjointSets groups(building_.volumes.size());
        // A stair in the garden, or a gap in its wall, parts the air no more than the plan's lines do.
        const auto is_air = [&](std::uint32_t v) {
            const Label l = label(v);
            return l == Label::Exterior || l == Label::Stair || l == Label::Shaft || l == Label::Opening ||
                   blame_.volume[v];
        };
        for_each_face([&](std::uint32_t a, std::uint32_t b, bool) {
            if (is_air(a) && is_air(b)) groups.join(a, b);
        });
        // The open air is the group around the highest volume.
        std::uint32_t highest = UINT32_MAX;
        for (std::uint32_t v = 0; v < building_.volumes.size(); ++v)
            if (label(v) == Label::Exterior &&
                (highest == UINT32_MAX || building_.volumes[v].z_high > building_.volumes[highest].z_high))
                highest = v;
        std::unordered_set<std::uint32_t> reported;
        for (std::uint32_t v = 0; v < building_.volumes.size(); ++v) {
            if (label(v) != Label::Exterior || groups.find(v) == groups.find(highest)) continue;
            if (blame_.volume[v]) {
                ++report_.suppressed;
                continue;
            }
            if (!reported.insert(groups.find(v)).second) continue;
            // Above a fence inside a wall there may be a pocket; what people can stand in is none.
            const bool is_pocket = floor_area(v) < least_habitable;
            Finding finding{.code = "S5", .severity = is_pocket ? Severity::Warning : Severity::Error};
            finding.sentence = "Some open air is shut off from the sky: there is more than one exterior.";
            finding.hint = "Look at what stands around and over this place, and report the plan.";
            place_at_volume(building_, v, finding);
            place_beside(v, finding);
            report_.findings.push_back(std::move(finding));
        }
    }

    /// Names what surrounds a volume of the exterior, which has no name of its own.
    void place_beside(std::uint32_t v, Finding& finding) const {
        for (const std::uint32_t f : faces_.of_volume(v))
            if (const std::uint32_t other = faces_[f].beyond(v); other < building_.volumes.size())
                place_at_volume(building_, other, finding);
    }

    /// Whether people pass through the volume on their way. Shut doors are ways; windows and shafts are none.
    [[nodiscard]] bool is_way(std::uint32_t v) const {
        if (blame_.volume[v]) return true;  // unknown: to its advantage
        const Volume& volume = building_.volumes[v];
        switch (volume.label) {
            case Label::Room:
            case Label::Door:
            case Label::Stair:
            case Label::Exterior: return true;
            case Label::Opening: {
                const std::uint32_t k = building_.spaces[volume.space].storey;
                return k >= building_.storeys.size() ||
                       building_.frame.unit * (double(volume.z_low) - building_.storeys[k].z_floor) <= most_step;
            }
            default: return false;
        }
    }

    [[nodiscard]] bool is_habitable(std::uint32_t space) const {
        const Space& room = building_.spaces[space];
        if (room.label != Label::Room || spaces_.volumes(space).empty()) return false;
        for (const std::string_view kind : {"shaft", "duct", "void", "cavity", "chimney", "flue", "riser"})
            if (room.kind == kind) return false;
        return named_.contains(room.id) || floor_area_of_space(space) >= least_habitable;
    }

    [[nodiscard]] double floor_area_of_space(std::uint32_t space) const {
        double area = 0;
        for (const std::uint32_t v : spaces_.volumes(space)) area += floor_area(v);
        return area;
    }

    /// Square metres under a volume.
    [[nodiscard]] double floor_area(std::uint32_t v) const {
        double units2 = 0;
        for (const std::uint32_t f : faces_.of_volume(v))
            if (faces_.is_prism(v) && faces_[f].level() && faces_.side(faces_[f], v) < 0)
                units2 += double(area2(building_, faces_[f]));
        return units2 / 2 * building_.frame.unit * building_.frame.unit;
    }

    void check_rooms() {
        DisjointSets groups(building_.volumes.size());
        for_each_face([&](std::uint32_t a, std::uint32_t b, bool level) {
            if (!is_way(a) || !is_way(b)) return;
            // Up and down there are only stairs; the air over a terrace is no way to the roof's, but stays one place.
            if (level && label(a) != Label::Stair && label(b) != Label::Stair &&
                building_.volumes[a].space != building_.volumes[b].space && !blame_.volume[a] && !blame_.volume[b])
                return;
            groups.join(a, b);
        });
        std::vector<bool> leads_out(building_.volumes.size(), false);
        for (std::uint32_t v = 0; v < building_.volumes.size(); ++v)
            if (label(v) == Label::Exterior || blame_.volume[v]) leads_out[groups.find(v)] = true;

        std::vector<std::vector<std::uint32_t>> shut(building_.volumes.size());  // by root: rooms
        for (std::uint32_t space = 0; space < building_.spaces.size(); ++space) {
            if (!is_habitable(space)) continue;
            const std::uint32_t group = groups.find(spaces_.volumes(space).front());
            if (!leads_out[group]) shut[group].push_back(space);
        }
        for (const std::vector<std::uint32_t>& rooms : shut)
            if (std::any_of(rooms.begin(), rooms.end(), [&](std::uint32_t room) { return lies_over_fault(room); }))
                ++report_.suppressed;
            else if (!rooms.empty()) report_shut(rooms);
    }

    /// Whether a stair to the room's storey does not reach it: that is why it has no way out.
    [[nodiscard]] bool lies_over_fault(std::uint32_t space) const {
        const std::uint32_t k = building_.spaces[space].storey;
        return k < building_.storeys.size() && unreached_.contains(building_.storeys[k].id);
    }

    /// Rooms that are joined to each other, and not to the exterior: one door is missing for all of them.
    void report_shut(const std::vector<std::uint32_t>& rooms) {
        Finding finding{.code = "S5", .severity = Severity::Warning};
        const std::string first = "No door leads from " + title(building_.spaces[rooms.front()]);
        finding.sentence = rooms.size() == 1
                               ? first + " to the outside or to a room that has one."
                               : first + " and the " + std::to_string(rooms.size() - 1) +
                                     (rooms.size() == 2 ? " room" : " rooms") + " joined to it to the outside.";
        finding.hint = "Add a door, or an opening that begins at the floor; windows are no way out.";
        for (const std::uint32_t room : rooms) place_at_volume(building_, spaces_.volumes(room).front(), finding);
        report_.findings.push_back(std::move(finding));
    }

    const Building& building_;
    const MapFaces& faces_;
    Blame& blame_;
    CheckReport& report_;
    const SpaceIndex& spaces_;
    std::unordered_set<std::string> named_;      ///< ids of the plan's rooms
    std::unordered_set<std::string> unreached_;  ///< ids of storeys to which a stair should lead (S4)
};

}  // namespace

void check_access(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("S5");
    if (blame.whole_map) ++report.suppressed;
    else AccessCheck(subject, blame, report).run();
}

}  // namespace enfilade::modeler

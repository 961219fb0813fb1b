// T8: storeys lie between slabs.

#include <algorithm>
#include <unordered_map>

#include "modeler/constraints/constraints.h"
#include "modeler/constraints/map_faces.h"
#include "modeler/constraints/ring_crossings.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

constexpr int below = -1;
constexpr int above = 1;

/// What stands in the storeys, between floor and ceiling.
bool stands_in_storey(Label label) {
    switch (label) {
        case Label::Slab:
        case Label::Exterior:
        case Label::Ground:
        case Label::Outside: return false;
        default: return true;
    }
}

class StoreyCheck {
public:
    StoreyCheck(const Subject& subject, Blame& blame, CheckReport& report)
        : building_(subject.building),
          plan_(subject.plan),
          faces_(subject.faces),
          rings_(subject.rings),
          blame_(blame),
          report_(report) {}

    void run() {
        find_mixed_parents();
        check_elevations();
        for (std::uint32_t v = 0; v < building_.volumes.size(); ++v)
            if (is_judged(v)) check_extent(v);
        for (std::uint32_t v = 0; v < building_.volumes.size(); ++v)
            if (is_judged(v)) check_contacts(v);
    }

    void run_tiling() {
        find_mixed_parents();
        for (std::uint32_t v = 0; v < building_.volumes.size(); ++v)
            if (is_judged(v) && label(v) == Label::Slab) check_tiling(v);
    }

private:
    [[nodiscard]] Label label(std::uint32_t v) const { return building_.volumes[v].label; }

    /// Volumes with another label than their space, or another space than the other pieces of theirs, are S1's; those
    /// of another shape than their row are the geometry's.
    [[nodiscard]] bool is_judged(std::uint32_t v) const {
        const Volume& volume = building_.volumes[v];
        return !blame_.volume[v] && faces_.is_prism(v) && !mixed_[volume.parent] &&
               volume.label == building_.spaces[volume.space].label;
    }

    /// The storey in which a volume stands; nothing for slabs, the exterior, and storeys whose levels are blamed.
    [[nodiscard]] const StoreyInfo* storey(std::uint32_t v) const {
        const std::uint32_t k = building_.spaces[building_.volumes[v].space].storey;
        if (!stands_in_storey(label(v)) || k >= building_.storeys.size() || wrong_[k]) return nullptr;
        return &building_.storeys[k];
    }

    [[nodiscard]] bool stands_in_wrong_storey(std::uint32_t v) const {
        const std::uint32_t k = building_.spaces[building_.volumes[v].space].storey;
        return k < wrong_.size() && wrong_[k];
    }

    /// The part of a stair or shaft inside the slab over its storey.
    [[nodiscard]] bool is_well(std::uint32_t v, const StoreyInfo& info) const {
        return (label(v) == Label::Stair || label(v) == Label::Shaft) && building_.volumes[v].z_low == info.z_ceiling;
    }

    void find_mixed_parents() {
        std::vector<std::uint32_t> first(building_.volumes.size(), UINT32_MAX);
        mixed_.assign(building_.volumes.size(), false);
        for (const Volume& volume : building_.volumes) {
            std::uint32_t& known = first[volume.parent];
            if (known == UINT32_MAX) known = volume.space;
            else if (known != volume.space) mixed_[volume.parent] = true;
        }
    }

    void check_elevations() {
        wrong_.assign(building_.storeys.size(), false);
        std::unordered_map<std::string, const plans::Storey*> by_id;
        for (const plans::Storey& storey : plan_.storeys) by_id.emplace(storey.id, &storey);
        for (std::uint32_t k = 0; k < building_.storeys.size(); ++k) {
            const StoreyInfo& info = building_.storeys[k];
            const auto at = by_id.find(info.id);
            if (at == by_id.end()) continue;
            const std::int32_t asked = building_.frame.grid_z(at->second->elevation);
            if (info.z_floor == asked && info.z_floor < info.z_ceiling) continue;
            wrong_[k] = true;
            Finding finding{.code = "T8", .severity = Severity::Error};
            finding.sentence = "The floor of storey \"" + info.name + "\" lies " + text(info.z_floor - asked) +
                               " away from where the plan has it.";
            finding.hint = "The model is not of this plan: build it again.";
            finding.storey = info.id;
            finding.elements.push_back({"storey", info.id, info.name});
            for (std::uint32_t v = 0; v < building_.volumes.size() && !finding.point; ++v)
                if (building_.spaces[building_.volumes[v].space].storey == k && label(v) == Label::Room)
                    place_at_volume(building_, v, finding);
            report_.findings.push_back(std::move(finding));
        }
    }

    [[nodiscard]] std::string text(std::int32_t height) const {
        char text[32];
        std::snprintf(text, sizeof text, "%.0f mm", 1000 * building_.frame.unit * std::abs(height));
        return text;
    }

    void check_extent(std::uint32_t v) {
        const StoreyInfo* info = storey(v);
        if (!info || is_well(v, *info)) return;
        const Volume& volume = building_.volumes[v];
        if (volume.z_low >= info->z_floor && volume.z_high <= info->z_ceiling) return;
        blame(v, UINT32_MAX,
              "The " + title(building_.spaces[volume.space]) + " reaches out of storey \"" + info->name +
                  "\" into what should be a slab.");
    }

    void check_contacts(std::uint32_t v) {
        const StoreyInfo* info = storey(v);
        const bool is_slab = label(v) == Label::Slab;
        if (!info && !is_slab) return;
        for (const std::uint32_t f : faces_.of_volume(v)) {
            const MapFace& face = faces_[f];
            const int side = face.level() ? faces_.side(face, v) : 0;
            const std::uint32_t other = face.beyond(v);
            if (side == 0 || other == UINT32_MAX || !face.joins_two || label(other) == Label::Outside) continue;
            if (is_slab ? label(other) != Label::Slab : may_touch(v, *info, other, side)) continue;
            if (blame_.volume[other] || stands_in_wrong_storey(other)) {
                ++report_.suppressed;
                continue;
            }
            if (!is_judged(other)) continue;
            const std::string self = "The " + title(building_.spaces[building_.volumes[v].space]);
            const std::string what = "the " + title(building_.spaces[building_.volumes[other].space]);
            const std::string wanted = is_slab ? "a storey, the ground or the open air" : "a slab";
            blame(other, f,
                  self + (side == below ? " stands on " : " lies under ") + what + ", and not " +
                      (side == below ? "on " : "under ") + wanted + ".");
        }
    }

    [[nodiscard]] bool may_touch(std::uint32_t v, const StoreyInfo& info, std::uint32_t other, int side) const {
        const Volume& volume = building_.volumes[v];
        const StoreyInfo* other_info = storey(other);
        if (is_well(v, info)) {
            if (!other_info || !carries_light(label(other))) return false;
            return side == below ? other_info == &info : other_info->z_floor == volume.z_high;
        }
        const std::int32_t z = side == below ? volume.z_low : volume.z_high;
        if (z == (side == below ? info.z_floor : info.z_ceiling)) {
            if (label(other) == Label::Slab) return true;
            if (other_info && is_well(other, *other_info)) return true;
            return side == above && is_air(other) && is_outdoors(v);
        }
        // Openings over walls, walls over openings, the air above a fence.
        if (other_info) return other_info == &info;
        return side == above && is_air(other) && is_outdoors(v);
    }

    /// The exterior, and what stands in it.
    [[nodiscard]] bool is_air(std::uint32_t v) const {
        const Space& space = building_.spaces[building_.volumes[v].space];
        return label(v) == Label::Exterior || (label(v) == Label::Object && space.room == exterior_space);
    }

    /// Walls and what is in them where no room is beside them: no slab covers these.
    [[nodiscard]] bool is_outdoors(std::uint32_t v) const {
        const Label self = label(v);
        if (self == Label::Room || self == Label::Stair || self == Label::Shaft || self == Label::Object) return false;
        for (const std::uint32_t f : faces_.of_volume(v)) {
            if (faces_[f].level()) continue;
            const std::uint32_t other = faces_[f].beyond(v);
            if (other == UINT32_MAX) continue;
            if (label(other) == Label::Room || label(other) == Label::Stair || label(other) == Label::Shaft)
                return false;
        }
        return true;
    }

    /// What lies on the slab and what lies under it cover the same area, to the last square unit.
    /// Whether its level faces are bounded by simple rings: areas of others say nothing (G2).
    [[nodiscard]] bool is_simple_level(std::uint32_t v) const {
        std::vector<plans::GridPoint> flat;
        for (const std::uint32_t f : rings_.faces_of(v)) {
            if (rings_.lie(f) != Lie::Level) continue;
            rings_.flatten(f, flat);
            if (!ring_crossings(flat, 1).empty()) return false;
        }
        return true;
    }

    void check_tiling(std::uint32_t v) {
        std::int64_t top = 0, underside = 0;
        for (const std::uint32_t f : faces_.of_volume(v)) {
            const MapFace& face = faces_[f];
            if (face.level()) (faces_.side(face, v) == above ? top : underside) += area2(building_, face);
        }
        if (top == underside || !is_simple_level(v)) return;
        const double square_metres = 0.5 * building_.frame.unit * building_.frame.unit * double(top - underside);
        char difference[32];
        std::snprintf(difference, sizeof difference, "%.3g", std::abs(square_metres));
        blame(v, UINT32_MAX,
              "What lies on the " + title(building_.spaces[building_.volumes[v].space]) + " covers " + difference +
                  " m2 " + (square_metres > 0 ? "more" : "less") + " than what lies under it.");
    }

    /// `face`: where it shows; UINT32_MAX: in the whole volume.
    void blame(std::uint32_t v, std::uint32_t face, std::string sentence) {
        Finding finding{.code = "T8", .severity = Severity::Error, .sentence = std::move(sentence)};
        finding.hint =
            "The storeys of the model do not rest on its slabs here: look at the storeys' elevations and "
            "heights, and report the plan.";
        if (face != UINT32_MAX) finding.point = middle(building_, faces_[face]);
        place_at_volume(building_, v, finding);
        if (face != UINT32_MAX)
            for (const std::uint32_t beside : faces_[face].volumes) place_at_volume(building_, beside, finding);
        blame_.volume[v] = true;
        report_.findings.push_back(std::move(finding));
    }

    const Building& building_;
    const plans::Plan& plan_;
    const MapFaces& faces_;
    const FaceRings& rings_;
    Blame& blame_;
    CheckReport& report_;
    std::vector<bool> mixed_;  ///< [parent] its pieces name several spaces
    std::vector<bool> wrong_;  ///< [storey] its levels are not the plan's
};

}  // namespace

void check_storeys(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("T8");
    if (blame.whole_map) ++report.suppressed;
    else StoreyCheck(subject, blame, report).run();
}

void check_tiling(const Subject& subject, Blame& blame, CheckReport& report) {
    const bool is_doubtful =
        blame.any() || std::find(blame.vertex.begin(), blame.vertex.end(), true) != blame.vertex.end();
    if (is_doubtful) ++report.suppressed;
    else StoreyCheck(subject, blame, report).run_tiling();
}

}  // namespace enfilade::modeler

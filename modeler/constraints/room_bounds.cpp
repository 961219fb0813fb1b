// S3: what a room is bounded by.

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "modeler/cell_node.h"
#include "modeler/constraints/constraints.h"
#include "modeler/constraints/map_faces.h"
#include "modeler/constraints/space_index.h"
#include "modeler/constraints/wall_bodies.h"
#include "modeler/place.h"
#include "plans/vector2.h"

namespace enfilade::modeler {
namespace {

class BoundsCheck {
public:
    BoundsCheck(const Subject& subject, Blame& blame, CheckReport& report)
        : building_(subject.building),
          faces_(subject.faces),
          spaces_(subject.spaces),
          blame_(blame),
          report_(report),
          bodies_(building_.storeys.size()),
          named_(building_.storeys.size()) {}

    void run() {
        for (std::uint32_t v = 0; v < building_.volumes.size(); ++v) {
            if (building_.volumes[v].label != Label::Room) continue;
            for (const std::uint32_t f : faces_.of_volume(v)) check_face(v, f);
        }
    }

private:
    void check_face(std::uint32_t v, std::uint32_t f) {
        const MapFace& face = faces_[f];
        const std::uint32_t other = face.beyond(v);
        if (other >= building_.volumes.size()) return;
        const std::uint32_t own = building_.volumes[v].space, beyond = building_.volumes[other].space;
        const Label label = building_.volumes[other].label;
        if (label == Label::Room && (other < v || own == beyond || face.level())) return;  // T8 looks at level ones
        const bool is_fault = label == Label::Exterior || label == Label::Ground || label == Label::Outside ||
                              (label == Label::Room && !is_border(v, other));
        if (!is_fault) return;
        // A room that is open to something is so on many faces, but once.
        const bool is_known = !reported_.insert(std::minmax(own, beyond)).second;
        if (is_known || blame_.volume[v] || blame_.volume[other] || blame_.face[f]) {
            ++report_.suppressed;
            return;
        }
        // The plan may draw a courtyard or terrace against the room with no wall between.
        const bool is_drawn = label == Label::Exterior && is_open_place(building_.spaces[own].storey, face);
        Finding finding{.code = "S3", .severity = is_drawn ? Severity::Warning : Severity::Error};
        const std::string what = label == Label::Room     ? " runs into " + title(building_.spaces[beyond])
                                 : label == Label::Ground ? " lies open to the ground"
                                                          : " is open to the air";
        finding.sentence = "The " + title(building_.spaces[own]) + what +
                           (label == Label::Room ? ": no polygon of the plan ends here." : " without an opening.");
        finding.hint = is_drawn
                           ? "Draw a wall, or a wall with an opening as wide as it, between the two."
                           : "A wall or slab is missing here: look at the walls of this room, and report the plan.";
        finding.point = middle(building_, face);
        place_at_volume(building_, v, finding);
        place_at_volume(building_, other, finding);
        if (!is_drawn) blame_.volume[v] = blame_.volume[other] = true;
        report_.findings.push_back(std::move(finding));
    }

    /// Whether two rooms may meet here without a wall: where polygons of the plan name one of them, or both, and the
    /// plan has no wall where one of them is. (Where polygons leave a gap, or overlap, the border lies between them.)
    [[nodiscard]] bool is_border(std::uint32_t volume, std::uint32_t other) {
        const std::uint32_t own = building_.volumes[volume].space, beyond = building_.volumes[other].space;
        const std::uint32_t k = building_.spaces[own].storey;
        if (k >= building_.storeys.size() || building_.spaces[beyond].storey != k || !spaces_.storey(k)) return false;
        if (!is_named(k, own) && !is_named(k, beyond)) return false;
        return !fills_wall(k, volume) && !fills_wall(k, other);
    }

    /// Whether the storey has polygons that are open to the sky, the face lies at a side of some polygon, and the plan
    /// has no wall there: the polygons part a courtyard from a room without one.
    [[nodiscard]] bool is_open_place(std::uint32_t k, const MapFace& face) {
        constexpr double reach = 0.25;  // metres: polygons lie that far from the places that they name
        if (k >= building_.storeys.size() || !spaces_.storey(k) || !face.upright()) return false;
        const std::vector<plans::Room>& rooms = spaces_.storey(k)->rooms;
        const bool has_open = std::any_of(rooms.begin(), rooms.end(), [](const plans::Room& room) {
            return room.kind == "courtyard" || room.kind == "terrace";
        });
        if (!has_open || is_wall_behind(k, face)) return false;
        const auto at = middle(building_, face);
        for (const plans::Room& room : rooms)
            for (std::size_t i = 0; i < room.polygon.size(); ++i)
                if (plans::distance({at[0], at[1]}, room.polygon[i], room.polygon[(i + 1) % room.polygon.size()]) <=
                    reach)
                    return true;
        return false;
    }

    /// Whether the plan has a wall on either side of the face.
    [[nodiscard]] bool is_wall_behind(std::uint32_t k, const MapFace& face) {
        constexpr double step = 0.01;
        const plans::Point a = world(face.feet[0]), b = world(face.feet[1]), middle = (a + b) * 0.5;
        const plans::Point normal = plans::turned_left(b - a) * (step / plans::norm(b - a));
        return bodies(k).at(middle + normal) || bodies(k).at(middle - normal);
    }

    /// Whether the plan has a wall where the volume is. Where walls end beside each other, small parts of their strips
    /// stay open: these are no wall.
    [[nodiscard]] bool fills_wall(std::uint32_t k, std::uint32_t volume) {
        constexpr double deep = 0.001, least_area = 0.02;  // metres, square metres
        double units2 = 0;
        for (const std::uint32_t f : faces_.of_volume(volume))
            if (faces_[f].level() && faces_[f].z_low == building_.volumes[volume].z_low)
                units2 += double(area2(building_, faces_[f]));
        if (units2 / 2 * building_.frame.unit * building_.frame.unit < least_area) return false;
        const auto node = cell_node(building_, volume);
        return bodies(k).at({node[0], node[1]}, {.grown = -deep}).has_value();
    }

    [[nodiscard]] plans::Point world(plans::GridPoint p) const {
        return {building_.frame.world_x(p.x), building_.frame.world_y(p.y)};
    }

    [[nodiscard]] bool is_named(std::uint32_t k, std::uint32_t space) {
        if (!named_[k]) {
            named_[k] = std::make_unique<std::set<std::string>>();
            for (const plans::Room& room : spaces_.storey(k)->rooms) named_[k]->insert(room.id);
        }
        return named_[k]->contains(building_.spaces[space].id);
    }

    [[nodiscard]] const WallBodies& bodies(std::uint32_t k) {
        if (!bodies_[k]) bodies_[k] = std::make_unique<WallBodies>(*spaces_.storey(k));
        return *bodies_[k];
    }

    const Building& building_;
    const MapFaces& faces_;
    const SpaceIndex& spaces_;
    Blame& blame_;
    CheckReport& report_;
    std::vector<std::unique_ptr<WallBodies>> bodies_;             ///< [storey], where asked for
    std::vector<std::unique_ptr<std::set<std::string>>> named_;   ///< [storey] ids of its polygons, where asked for
    std::set<std::pair<std::uint32_t, std::uint32_t>> reported_;  ///< pairs of spaces
};

}  // namespace

void check_room_bounds(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("S3");
    if (blame.whole_map) ++report.suppressed;
    else BoundsCheck(subject, blame, report).run();
}

}  // namespace enfilade::modeler

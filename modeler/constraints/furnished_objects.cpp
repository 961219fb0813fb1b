#include "modeler/constraints/furnished_objects.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "modeler/constraints/door_sweeps.h"
#include "modeler/constraints/piece_boxes.h"
#include "modeler/constraints/wall_bodies.h"
#include "modeler/objects/object_box.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

constexpr double margin = 0.01;        ///< metres: less is rounding
constexpr double flat = 0.03;          ///< metres: rugs, which other pieces stand on
constexpr double least_volume = 1e-6;  ///< cubic metres outside the room, of a box that is smaller by the margin

const char* const hint =
    "Find it another place (\"enfilade place\"); if a rule has put it there, report the plan and the rules.";

struct Body {
    const FurnishedObject* object;
    UprightBody box;  ///< z as storeys' elevations
};

Body body_of_object(const FurnishedObject& object) {
    const ObjectBox box = box_of(object);
    return {&object, {{box.footprint.begin(), box.footprint.end()}, box.z_low, box.z_high}};
}

/// The box without its outer centimetre, or what is in the middle of a thin one.
UprightBody shrunk(FurnishedObject object) {
    object.position[2] += std::min(margin, object.size[2] / 2);
    for (double& length : object.size) length = std::max(length - 2 * margin, 1e-4);
    return body_of_object(object).box;
}

std::string called(const FurnishedObject& object) {
    return '"' + (object.name.empty() ? object.id : object.name) + '"';
}

class FurnishedObjects {
public:
    FurnishedObjects(const Subject& subject, CheckReport& report)
        : subject_(subject), building_(subject.building), report_(report) {}

    void run() {
        for (const FurnishedObject& object : building_.furnishing.objects)
            by_room_[object.space].push_back(body_of_object(object));
        for (const auto& [room, bodies] : by_room_) {
            if (room >= building_.spaces.size()) continue;
            if (std::none_of(bodies.begin(), bodies.end(), [](const Body& body) { return body.object->by_rule; }))
                continue;
            check_inside(room, bodies);
            check_pairs(bodies);
            check_doors(room, bodies);
        }
    }

private:
    Finding& add(const FurnishedObject& object, std::string sentence) {
        Finding finding{.code = "S6", .severity = Severity::Error, .sentence = std::move(sentence), .hint = hint};
        finding.point = {object.position[0], object.position[1], object.position[2] + object.size[2] / 2};
        const std::uint32_t storey = building_.spaces[object.space].storey;
        if (storey < building_.storeys.size()) finding.storey = building_.storeys[storey].id;
        finding.elements = {{"object", object.id, object.name}};
        report_.findings.push_back(std::move(finding));
        return report_.findings.back();
    }

    [[nodiscard]] Footprint floor_of(const Volume& volume) const {
        const Piece& piece = building_.pieces[volume.piece];
        Footprint ring;
        for (std::uint32_t k = 0; k < piece.corner_count; ++k) {
            const plans::GridPoint p = building_.points[building_.corners[piece.first_corner + k].vertex];
            ring.push_back({building_.frame.world_x(p.x), building_.frame.world_y(p.y)});
        }
        return ring;
    }

    /// The space of a volume that is part of the body, where it has any.
    [[nodiscard]] double volume_in(const UprightBody& body, const Volume& volume, const Footprint& floor) const {
        const double height = std::min(body.z_high, building_.frame.world_z(volume.z_high)) -
                              std::max(body.z_low, building_.frame.world_z(volume.z_low));
        if (height <= 0) return 0;
        const Footprint common = shared(floor, body.footprint);
        return common.empty() ? 0 : area_of(common) * height;
    }

    void check_inside(std::uint32_t room, const std::vector<Body>& bodies) {
        std::vector<std::pair<const Volume*, Footprint>> own;
        for (const Volume& volume : building_.volumes) {
            if (volume.label == Label::Outside) continue;
            const Space& space = building_.spaces[volume.space];
            if (volume.space == room || space.room == room) own.emplace_back(&volume, floor_of(volume));
        }
        for (const Body& body : bodies) {
            if (!body.object->by_rule) continue;
            const UprightBody inner = shrunk(*body.object);
            double outside = area_of(inner.footprint) * (inner.z_high - inner.z_low);
            for (const auto& [volume, floor] : own) outside -= volume_in(inner, *volume, floor);
            if (outside > least_volume) tell_outside(body, inner, room);
        }
    }

    /// Names what holds most of the part that is outside.
    void tell_outside(const Body& body, const UprightBody& inner, std::uint32_t room) {
        double most = 0;
        std::optional<std::uint32_t> in;
        for (const Volume& volume : building_.volumes) {
            if (volume.label == Label::Outside) continue;
            if (volume.space == room || building_.spaces[volume.space].room == room) continue;
            const double here = volume_in(inner, volume, floor_of(volume));
            if (here > most) most = here, in = volume.space;
        }
        const std::string where = title(building_.spaces[room]);
        Finding& finding = add(*body.object, called(*body.object) + " leaves the " + where +
                                                 (in ? " into the " + title(building_.spaces[*in]) : "") + ".");
        if (in) place_at_space(building_, *in, finding);
    }

    void check_pairs(const std::vector<Body>& bodies) {
        for (std::size_t a = 0; a < bodies.size(); ++a)
            for (std::size_t b = a + 1; b < bodies.size(); ++b) check_pair(bodies[a], bodies[b]);
    }

    void check_pair(const Body& a, const Body& b) {
        if (!a.object->by_rule && !b.object->by_rule) return;
        if (a.object->stands_on == b.object->id || b.object->stands_on == a.object->id) return;
        if (std::min(a.object->size[2], b.object->size[2]) <= flat || shared_height(a.box, b.box) <= margin) return;
        const double depth = depth_in(a.box.footprint, b.box.footprint);
        if (depth <= margin) return;
        const Body& placed = b.object->by_rule ? b : a;
        const Body& other = b.object->by_rule ? a : b;
        char millimetres[32];
        std::snprintf(millimetres, sizeof millimetres, "%.0f mm", 1000 * depth);
        add(*placed.object, called(*placed.object) + " stands " + millimetres + " in " + called(*other.object) + ".")
            .elements.push_back({"object", other.object->id, other.object->name});
    }

    /// What the room touches: by its own volumes, or by those of the objects in it.
    const std::set<std::uint32_t>& beside(std::uint32_t room) {
        const auto [at, is_new] = beside_.try_emplace(room);
        if (!is_new) return at->second;
        for (std::uint32_t v = 0; v < building_.volumes.size(); ++v) {
            const std::uint32_t space = building_.volumes[v].space;
            if (space != room && building_.spaces[space].room != room) continue;
            for (const std::uint32_t f : subject_.faces.of_volume(v))
                if (const std::uint32_t other = subject_.faces[f].beyond(v); other < building_.volumes.size())
                    at->second.insert(building_.volumes[other].space);
        }
        return at->second;
    }

    /// Whether a leaf may turn into the room: not where another wall closes the doorway on this side. It may come from
    /// the next room over an open border.
    bool opens_here(const plans::Opening& door, std::uint32_t room) {
        const std::optional<std::uint32_t> space = subject_.spaces.find(Label::Door, door.id);
        if (!space || beside(room).contains(*space)) return true;
        const std::set<std::uint32_t>& around = beside(room);
        return std::any_of(around.begin(), around.end(), [&](std::uint32_t next) {
            return building_.spaces[next].label == Label::Room && beside(next).contains(*space);
        });
    }

    void check_doors(std::uint32_t room, const std::vector<Body>& bodies) {
        const std::uint32_t k = building_.spaces[room].storey;
        const plans::Storey* storey = k < building_.storeys.size() ? subject_.spaces.storey(k) : nullptr;
        if (storey == nullptr) return;
        const WallBodies walls(*storey);
        for (const plans::Opening& door : storey->openings) {
            if (door.kind != plans::OpeningKind::Door) continue;
            const auto wall = std::find_if(storey->walls.begin(), storey->walls.end(),
                                           [&](const plans::Wall& w) { return w.id == door.wall; });
            if (wall == storey->walls.end()) continue;
            const auto host = std::uint32_t(wall - storey->walls.begin());
            for (const DoorSweep& sweep : door_sweeps(*wall, door))
                for (const Body& body : bodies)
                    if (body.object->by_rule) check_door(room, body, sweep, walls, host, *storey, door);
        }
    }

    void check_door(std::uint32_t room, const Body& body, const DoorSweep& sweep, const WallBodies& walls,
                    std::uint32_t host, const plans::Storey& storey, const plans::Opening& door) {
        UprightBody box = body.box;
        box.z_low -= storey.elevation;
        box.z_high -= storey.elevation;
        if (depth_in_sweep(box, sweep, walls, host) <= margin || !opens_here(door, room)) return;
        const std::string name = '"' + (door.name.empty() ? door.id : door.name) + '"';
        add(*body.object, called(*body.object) + " stands in the way of door " + name + ".")
            .elements.push_back({"door", door.id, door.name});
    }

    const Subject& subject_;
    const Building& building_;
    CheckReport& report_;
    std::map<std::uint32_t, std::vector<Body>> by_room_;
    std::map<std::uint32_t, std::set<std::uint32_t>> beside_;  ///< [space]
};

}  // namespace

void check_furnished_objects(const Subject& subject, CheckReport& report) {
    if (!subject.building.furnishing.empty()) FurnishedObjects(subject, report).run();
}

}  // namespace enfilade::modeler

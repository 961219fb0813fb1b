// S6: objects lie inside one room, are disjoint and keep out of door sweeps.

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <unordered_map>

#include "modeler/constraints/constraints.h"
#include "modeler/constraints/door_sweeps.h"
#include "modeler/constraints/furnished_objects.h"
#include "modeler/constraints/map_faces.h"
#include "modeler/constraints/piece_boxes.h"
#include "modeler/constraints/space_index.h"
#include "modeler/constraints/wall_bodies.h"
#include "modeler/place.h"
#include "plans/vector2.h"

namespace enfilade::modeler {
namespace {

using plans::Furniture;
using plans::Point;

// What people draw: cupboards a few centimetres in the wall, chairs under tables, sinks in worktops, tubes and railings
// through anything. The homes at hand have 30 pieces in walls and 56 pairs that overlap; these limits leave the ones
// that cannot stand so (docs/checks.md).
constexpr double doubtful = 0.08;   ///< metres: less is how people draw
constexpr double thin = 0.15;       ///< railings, pipes, pictures, curtains go through walls and each other
constexpr double largest = 12;      ///< square metres: roofs and lawns are no furniture
constexpr double tall = 1.2;        ///< metres: nothing is pushed under pieces of this height
constexpr double same_place = 0.5;  ///< share of the common space in the space of both: one piece placed twice
constexpr double inserted = 0.9;    ///< share of a piece within another: built into it
constexpr double built_in = 0.02;  ///< metres by which windows and niches placed as pieces may be thicker than the wall
constexpr double rule_margin = 0.01;  ///< metres, of objects that a rule has placed

/// Bodies by their place along x, so that those near one are found without looking at all.
class Row {
public:
    explicit Row(std::vector<plans::PlanBox> boxes) : boxes_(std::move(boxes)) {
        for (std::uint32_t k = 0; k < boxes_.size(); ++k) {
            order_.push_back(k);
            widest_ = std::max(widest_, boxes_[k].max.x - boxes_[k].min.x);
        }
        std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(boxes_[a].min.x, a) < std::pair(boxes_[b].min.x, b);
        });
    }

    /// Calls visit(index) for all whose box meets `box`.
    template <class Visit>
    void near(const plans::PlanBox& box, Visit visit) const {
        auto at = std::lower_bound(order_.begin(), order_.end(), box.min.x - widest_,
                                   [&](std::uint32_t k, double x) { return boxes_[k].min.x < x; });
        for (; at != order_.end() && boxes_[*at].min.x <= box.max.x; ++at) {
            const plans::PlanBox& other = boxes_[*at];
            if (other.max.x >= box.min.x && other.min.y <= box.max.y && other.max.y >= box.min.y) visit(*at);
        }
    }

private:
    std::vector<plans::PlanBox> boxes_;
    std::vector<std::uint32_t> order_;
    double widest_ = 0;
};

struct Piece {
    const Furniture* from;
    UprightBody body;
    double area;
    [[nodiscard]] double volume() const { return area * (body.z_high - body.z_low); }
};

template <class Element>
std::string called(const Element& element) {
    return '"' + (element.name.empty() ? element.id : element.name) + '"';
}

std::string millimetres(double metres) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f mm", 1000 * metres);
    return text;
}

/// The furniture of one storey, as the plan places it.
class StoreyPieces {
public:
    StoreyPieces(const plans::Storey& storey, std::vector<Finding>& findings) : storey_(storey), findings_(findings) {
        for (const Furniture& piece : storey.furniture) {
            UprightBody body = body_of(piece);
            if (std::min(piece.width, piece.depth) < thin || piece.height < thin) continue;
            if (piece.width * piece.depth > largest) continue;
            pieces_.push_back({&piece, std::move(body), piece.width * piece.depth});
        }
    }

    void run() {
        if (pieces_.empty()) return;
        check_walls();
        check_pairs();
        check_doors();
    }

private:
    void add(const Piece& piece, Point at, std::string sentence, std::string hint, ElementRef other) {
        Finding finding{.code = "S6", .severity = Severity::Warning};
        finding.sentence = std::move(sentence);
        finding.hint = std::move(hint);
        finding.point = {at.x, at.y, storey_.elevation + (piece.body.z_low + piece.body.z_high) / 2};
        finding.storey = storey_.id;
        finding.elements = {{"furniture", piece.from->id, piece.from->name}, std::move(other)};
        findings_.push_back(std::move(finding));
    }

    /// The parts of walls, straight one by one.
    void check_walls() {
        std::vector<std::pair<std::uint32_t, UprightBody>> parts;
        std::vector<plans::PlanBox> boxes;
        for (std::uint32_t w = 0; w < storey_.walls.size(); ++w) {
            const plans::Wall& wall = storey_.walls[w];
            const plans::WallAxis axis = axis_of(wall);
            const int count = axis.straight() ? 1 : 2 + int(std::abs(axis.extent()) * 8);
            for (int k = 0; k < count; ++k) {
                parts.push_back({w,
                                 {strip(axis.at(double(k) / count), axis.at(double(k + 1) / count), wall.thickness / 2),
                                  0, std::max(wall.height_at_start, wall.height_at_end)}});
                boxes.push_back(box_around(parts.back().second.footprint));
            }
        }
        const Row row(std::move(boxes));
        for (const Piece& piece : pieces_) {
            double deepest = doubtful;
            const plans::Wall* in = nullptr;
            Point at;
            row.near(box_around(piece.body.footprint), [&](std::uint32_t k) {
                const auto& [w, part] = parts[k];
                if (shared_height(piece.body, part) < doubtful) return;
                const double depth = depth_in(piece.body.footprint, part.footprint);
                if (depth <= deepest || is_built_in(piece, storey_.walls[w])) return;
                const Point middle = middle_of(shared(piece.body.footprint, part.footprint));
                if (stands_in_opening(piece, storey_.walls[w], middle)) return;
                deepest = depth;
                in = &storey_.walls[w];
                at = middle;
            });
            if (in)
                add(piece, at,
                    called(*piece.from) + " stands " + millimetres(deepest) + " in wall " + called(*in) + ".",
                    "Move it out of the wall.", {"wall", in->id, in->name});
        }
    }

    /// Not thicker than the wall, and within it: a window, a niche, a radiator's recess.
    [[nodiscard]] static bool is_built_in(const Piece& piece, const plans::Wall& wall) {
        const plans::WallAxis axis = axis_of(wall);
        const double t = axis.nearest(piece.from->position);
        const Point from = axis.at(t), normal = axis.normal(t);
        return std::all_of(piece.body.footprint.begin(), piece.body.footprint.end(), [&](Point p) {
            return std::abs(plans::dot(p - from, normal)) <= wall.thickness / 2 + built_in;
        });
    }

    [[nodiscard]] bool stands_in_opening(const Piece& piece, const plans::Wall& wall, Point at) const {
        const plans::WallAxis axis = axis_of(wall);
        return std::any_of(storey_.openings.begin(), storey_.openings.end(), [&](const plans::Opening& opening) {
            return opening.wall == wall.id && std::abs(offset_from(axis, opening, at).along) <= opening.width / 2 &&
                   piece.body.z_low < opening.head && piece.body.z_high > opening.sill;
        });
    }

    void check_pairs() {
        std::vector<plans::PlanBox> boxes;
        for (const Piece& piece : pieces_) boxes.push_back(box_around(piece.body.footprint));
        const Row row(boxes);
        for (std::uint32_t a = 0; a < pieces_.size(); ++a) {
            std::vector<std::uint32_t> others;
            row.near(boxes[a], [&](std::uint32_t b) {
                if (b > a) others.push_back(b);
            });
            std::sort(others.begin(), others.end());
            for (const std::uint32_t b : others) check_pair(pieces_[a], pieces_[b]);
        }
    }

    void check_pair(const Piece& a, const Piece& b) {
        const double height = shared_height(a.body, b.body);
        const double depth = depth_in(a.body.footprint, b.body.footprint);
        if (height < doubtful || depth < doubtful) return;
        const Footprint common = shared(a.body.footprint, b.body.footprint);
        const double volume = area_of(common) * height, least = std::min(a.volume(), b.volume());
        const bool are_one = volume >= same_place * (a.volume() + b.volume() - volume);
        const bool are_tall = std::min(a.from->height, b.from->height) >= tall && volume < inserted * least;
        if (!are_one && !are_tall) return;
        add(a, middle_of(common),
            are_one ? called(*a.from) + " and " + called(*b.from) + " stand in the same place."
                    : called(*a.from) + " stands " + millimetres(depth) + " in " + called(*b.from) + ".",
            are_one ? "Remove one of them, if it was placed twice." : "Move one of them.",
            {"furniture", b.from->id, b.from->name});
    }

    void check_doors() {
        std::unordered_map<std::string, const plans::Wall*> walls;
        for (const plans::Wall& wall : storey_.walls) walls.emplace(wall.id, &wall);
        std::vector<plans::PlanBox> boxes;
        for (const Piece& piece : pieces_) boxes.push_back(box_around(piece.body.footprint));
        const Row row(std::move(boxes));
        const WallBodies bodies(storey_);
        std::set<std::pair<const Furniture*, const plans::Opening*>> reported;
        for (const plans::Opening& door : storey_.openings) {
            const auto wall = walls.find(door.wall);
            if (door.kind != plans::OpeningKind::Door || wall == walls.end()) continue;
            const std::uint32_t host = std::uint32_t(wall->second - storey_.walls.data());
            for (const DoorSweep& sweep : door_sweeps(*wall->second, door))
                row.near(box_around(sweep.body.footprint), [&](std::uint32_t k) {
                    const Piece& piece = pieces_[k];
                    const double depth = depth_in_sweep(piece.body, sweep, bodies, host);
                    if (depth < doubtful || !reported.insert({piece.from, &door}).second) return;
                    add(piece, middle_of(shared(piece.body.footprint, sweep.body.footprint)),
                        called(*piece.from) + " stands " + millimetres(depth) + " in the way of door " + called(door) +
                            ".",
                        "Move it away from the door, or turn the leaf to the other side.",
                        {"door", door.id, door.name});
                });
        }
    }

    const plans::Storey& storey_;
    std::vector<Finding>& findings_;
    std::vector<Piece> pieces_;
};

/// Volumes that are objects: a rule has placed them, so that nothing of this may happen.
class ObjectVolumes {
public:
    ObjectVolumes(const Subject& subject, Blame& blame, CheckReport& report)
        : subject_(subject), building_(subject.building), blame_(blame), report_(report) {
        for (const FurnishedObject& object : building_.furnishing.objects)
            if (!object.volume.empty()) furnished_.insert(object.volume);
    }

    void run() {
        for (std::uint32_t v = 0; v < building_.volumes.size(); ++v)
            if (building_.volumes[v].label == Label::Object) check(v);
    }

private:
    void check(std::uint32_t v) {
        if (blame_.volume[v]) {
            ++report_.suppressed;
            return;
        }
        const std::uint32_t own = building_.spaces[building_.volumes[v].space].room;
        const std::optional<std::set<std::uint32_t>> around = places_around(v, own);
        if (!around) return void(++report_.suppressed);
        // Where it fills a part of its room that stairs cut off, it touches no place at all.
        if (own != UINT32_MAX ? !around->empty() && !around->contains(own) : around->size() != 1)
            return blame(v, "does not lie inside one room", {around->begin(), around->end()});
        const std::uint32_t k = building_.spaces[own != UINT32_MAX ? own : *around->begin()].storey;
        if (k >= building_.storeys.size() || !subject_.spaces.storey(k)) return;
        // Furniture is checked by itself: its volume may hold several pieces, and what the plan placed is no fault.
        if (furnished_.contains(building_.spaces[building_.volumes[v].space].id)) return;
        check_doors(v, *subject_.spaces.storey(k));
    }

    /// The rooms, or the exterior, that the object touches, itself or by objects beside it (it may stand in a corner
    /// that they close), until `own` is among them; openings and stairs are no places. None where a volume on the way
    /// is spoilt.
    [[nodiscard]] std::optional<std::set<std::uint32_t>> places_around(std::uint32_t v, std::uint32_t own) const {
        std::set<std::uint32_t> around, seen = {v};
        std::vector<std::uint32_t> queue = {v};
        const auto is_found = [&] { return own == UINT32_MAX ? !around.empty() : around.contains(own); };
        for (std::size_t at = 0; at < queue.size() && !is_found(); ++at)
            for (const std::uint32_t f : subject_.faces.of_volume(queue[at])) {
                const std::uint32_t other = subject_.faces[f].beyond(queue[at]);
                if (other >= building_.volumes.size()) continue;
                if (blame_.volume[other]) return std::nullopt;
                const Volume& beside = building_.volumes[other];
                if (beside.label == Label::Room || beside.label == Label::Exterior) around.insert(beside.space);
                if (beside.label == Label::Object && seen.insert(other).second) queue.push_back(other);
            }
        return around;
    }

    void check_doors(std::uint32_t v, const plans::Storey& storey) {
        const Volume& row = building_.volumes[v];
        const modeler::Piece& piece = building_.pieces[row.piece];
        UprightBody body;
        for (std::uint32_t i = 0; i < piece.corner_count; ++i) {
            const plans::GridPoint p = building_.points[building_.corners[piece.first_corner + i].vertex];
            body.footprint.push_back({building_.frame.world_x(p.x), building_.frame.world_y(p.y)});
        }
        body.z_low = building_.frame.world_z(row.z_low) - storey.elevation;
        body.z_high = building_.frame.world_z(row.z_high) - storey.elevation;
        const WallBodies bodies(storey);
        for (const plans::Opening& door : storey.openings) {
            if (door.kind != plans::OpeningKind::Door) continue;
            const auto wall = std::find_if(storey.walls.begin(), storey.walls.end(),
                                           [&](const plans::Wall& w) { return w.id == door.wall; });
            if (wall == storey.walls.end()) continue;
            const std::uint32_t host = std::uint32_t(wall - storey.walls.begin());
            for (const DoorSweep& sweep : door_sweeps(*wall, door))
                if (depth_in_sweep(body, sweep, bodies, host) > rule_margin) {
                    blame(v, "stands in the way of door " + called(door), {});
                    report_.findings.back().elements.push_back({"door", door.id, door.name});
                    return;
                }
        }
    }

    void blame(std::uint32_t v, const std::string& fault, const std::vector<std::uint32_t>& spaces) {
        Finding finding{.code = "S6", .severity = Severity::Error};
        finding.sentence = "The " + title(building_.spaces[building_.volumes[v].space]) + " " + fault + ".";
        finding.hint = "A rule has placed it, and should not have: report the plan.";
        place_at_volume(building_, v, finding);
        for (const std::uint32_t space : spaces)
            if (!subject_.spaces.volumes(space).empty())
                place_at_volume(building_, subject_.spaces.volumes(space).front(), finding);
        blame_.volume[v] = true;
        report_.findings.push_back(std::move(finding));
    }

    const Subject& subject_;
    const Building& building_;
    Blame& blame_;
    CheckReport& report_;
    std::set<std::string, std::less<>> furnished_;  ///< ids of volumes of the building's furniture
};

}  // namespace

void check_objects(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("S6");
    for (std::uint32_t k = 0; k < subject.building.storeys.size(); ++k)
        if (const plans::Storey* storey = subject.spaces.storey(k)) StoreyPieces(*storey, report.findings).run();
    check_furnished_objects(subject, report);
    if (blame.whole_map) ++report.suppressed;
    else ObjectVolumes(subject, blame, report).run();
}

}  // namespace enfilade::modeler

// S2: doors, windows and openings join two places, and sit in the wall that the plan names.

#include <algorithm>
#include <cmath>
#include <memory>
#include <unordered_map>
#include <unordered_set>

#include "modeler/constraints/constraints.h"
#include "modeler/constraints/map_faces.h"
#include "modeler/constraints/space_index.h"
#include "modeler/constraints/wall_bodies.h"
#include "modeler/place.h"
#include "plans/vector2.h"

namespace enfilade::modeler {
namespace {

Label label_of(plans::OpeningKind kind) {
    switch (kind) {
        case plans::OpeningKind::Door: return Label::Door;
        case plans::OpeningKind::Window: return Label::Window;
        default: return Label::Opening;
    }
}

/// What lies beside an opening in the map.
struct Surroundings {
    std::vector<std::uint32_t> sides[2];  ///< spaces that light enters: to the right of the wall's axis, to its left
    std::vector<std::uint32_t> solids;    ///< spaces around it where it does not
    bool in_ground[2] = {false, false};   ///< a side lies against the ground
    double farthest = 0;                  ///< metres by which a corner lies outside its place in the wall
    bool is_known = true;                 ///< nothing of it is blamed already
};

void add(std::vector<std::uint32_t>& spaces, std::uint32_t space) {
    if (std::find(spaces.begin(), spaces.end(), space) == spaces.end()) spaces.push_back(space);
}

constexpr double slit = 0.05;  ///< metres: narrower openings are lost to whatever is built beside them

class OpeningCheck {
public:
    OpeningCheck(const Subject& subject, Blame& blame, CheckReport& report)
        : building_(subject.building),
          faces_(subject.faces),
          spaces_(subject.spaces),
          blame_(blame),
          report_(report),
          // Outer chords stand as far off as inner ones, and points are rounded twice.
          tolerance_(2 * building_.sagitta + 4 * building_.frame.unit) {}

    void run() {
        for (std::uint32_t k = 0; k < building_.storeys.size(); ++k) {
            storey_ = spaces_.storey(k);
            if (!storey_) continue;
            bodies_.reset();
            walls_.clear();
            for (std::uint32_t w = 0; w < storey_->walls.size(); ++w) walls_.emplace(storey_->walls[w].id, w);
            for (const plans::Opening& opening : storey_->openings) check(opening);
        }
    }

private:
    void check(const plans::Opening& opening) {
        const auto host = walls_.find(opening.wall);
        if (host == walls_.end()) return;
        opening_ = &opening;
        wall_ = host->second;
        const auto space = spaces_.find(label_of(opening.kind), opening.id);
        if (!space || spaces_.volumes(*space).empty()) return check_absence();
        const plans::WallAxis axis = axis_of(storey_->walls[wall_]);
        const Surroundings around = surroundings(*space, axis);
        if (!around.is_known) {
            ++report_.suppressed;
            return;
        }
        // Short thick walls are mostly joints, which are cut at an angle; the strip of a tight arc folds over.
        const double thickness = storey_->walls[wall_].thickness;
        const double joints = is_folded(axis) ? HUGE_VAL : is_short(axis) ? thickness : 0;
        if (around.farthest > tolerance_ + joints)
            return blame(*space, Severity::Error,
                         subject() + " lies " + millimetres(around.farthest) + " away from its place in the wall.",
                         "The model is not of this plan: build it again.");
        const auto host_space = spaces_.find(Label::Wall, storey_->walls[wall_].id);
        if (std::find(around.solids.begin(), around.solids.end(), host_space.value_or(UINT32_MAX)) ==
                around.solids.end() &&
            is_wall_beside(axis))
            return blame(*space, Severity::Error,
                         subject() + " does not touch its wall: " + list(around.solids) + " around it instead.",
                         "The model gives this wall to another element: build it again from the plan, and report it.");
        check_sides(*space, axis, around);
    }

    [[nodiscard]] Surroundings surroundings(std::uint32_t space, const plans::WallAxis& axis) const {
        Surroundings around;
        for (const std::uint32_t v : spaces_.volumes(space)) {
            around.is_known = around.is_known && !blame_.volume[v];
            for (const std::uint32_t f : faces_.of_volume(v)) {
                const MapFace& face = faces_[f];
                const std::uint32_t other = face.beyond(v);
                if (other >= building_.volumes.size()) continue;
                const Volume& beside = building_.volumes[other];
                if (beside.space == space) continue;
                const Face& row = building_.faces[f];
                const bool fits = std::minmax(row.front, row.back) == std::minmax(v, other);
                if (blame_.volume[other] || blame_.face[f] || !fits) around.is_known = false;  // D2 has the last
                if (face.upright())
                    for (const plans::GridPoint foot : face.feet)
                        around.farthest = std::max(around.farthest, distance_outside(axis, foot));
                const int side = side_of(axis, f, v);
                if (!carries_light(beside.label)) add(around.solids, beside.space);
                else if (side != 0) add(around.sides[side > 0], beside.space);
                if (side != 0 && beside.label == Label::Ground) around.in_ground[side > 0] = true;
            }
        }
        return around;
    }

    [[nodiscard]] double distance_outside(const plans::WallAxis& axis, plans::GridPoint point) const {
        const OpeningOffset at = offset_from(axis, *opening_, world(point));
        const double half = storey_->walls[wall_].thickness / 2;
        return std::max({std::abs(at.along) - opening_->width / 2, at.left - half - opening_->depth_left,
                         -at.left - half - opening_->depth_right});
    }

    [[nodiscard]] plans::Point world(plans::GridPoint p) const {
        return {building_.frame.world_x(p.x), building_.frame.world_y(p.y)};
    }

    /// 1 where the face looks to the left of the wall, -1 to its right, 0 along it or up or down.
    [[nodiscard]] int side_of(const plans::WallAxis& axis, std::uint32_t f, std::uint32_t volume) const {
        const Face& row = building_.faces[f];
        if (row.direction != Direction::Side) return 0;
        const plans::Point a = world(building_.points[building_.edges[row.edge].a]);
        const plans::Point b = world(building_.points[building_.edges[row.edge].b]);
        // `front` lies on the left of the edge and looks to the right through it.
        const plans::Point outward = plans::turned_left(b - a) * (row.front == volume ? -1.0 : 1.0);
        const double share = plans::dot(outward, axis.normal(axis.nearest((a + b) * 0.5))) / plans::norm(outward);
        return std::abs(share) < 0.5 ? 0 : share > 0 ? 1 : -1;
    }

    /// Whether the plan has the host wall, and no other, beside the opening or over it.
    [[nodiscard]] bool is_wall_beside(const plans::WallAxis& axis) {
        constexpr double step = 0.01;
        const plans::Wall& wall = storey_->walls[wall_];
        const auto is_host = [&](double along) {
            const double t = (opening_->offset + along) / axis.length();
            return t > 0 && t < 1 && !bodies().at(axis.at(t), {.grown = tolerance_, .except = wall_}) &&
                   !in_other_opening(t);
        };
        const double end = opening_->width / 2;
        for (const double side : {-1.0, 1.0})
            if (is_host(side * end) && is_host(side * (end + step / 2)) && is_host(side * (end + step))) return true;
        const double top = std::min({wall.height_at_start, wall.height_at_end, storey_->height});
        return opening_->head + step < top;
    }

    [[nodiscard]] bool in_other_opening(double t) const {
        return std::any_of(storey_->openings.begin(), storey_->openings.end(), [&](const plans::Opening& other) {
            return &other != opening_ && other.wall == opening_->wall &&
                   std::abs(axis_of(storey_->walls[wall_]).length() * t - other.offset) <= other.width / 2;
        });
    }

    /// The walls of the plan that close one side of the opening for all its width; nothing where any of it is free.
    [[nodiscard]] std::optional<std::uint32_t> wall_before(const plans::WallAxis& axis, int side) {
        constexpr int samples = 8;
        const double depth =
            storey_->walls[wall_].thickness / 2 + (side > 0 ? opening_->depth_left : opening_->depth_right);
        // Right at its mouth, and at some distance: a wall may stand anywhere before it.
        for (const double step : {0.0, 0.01}) {
            std::optional<std::uint32_t> found;
            for (int k = 0; k < samples; ++k) {
                const double along = opening_->offset + opening_->width * ((k + 0.5) / samples - 0.5);
                const plans::Point before = axis.offset(along / axis.length(), side * (depth + step));
                found = bodies().at(before, {.grown = tolerance_, .except = wall_});
                if (!found) break;
            }
            if (found) return found;
        }
        return std::nullopt;
    }

    void check_sides(std::uint32_t space, const plans::WallAxis& axis, const Surroundings& around) {
        for (const int side : {-1, 1}) {
            if (!around.sides[side > 0].empty()) continue;
            if (around.in_ground[side > 0])
                return blame(space, Severity::Warning, subject() + " opens against the ground and leads nowhere.",
                             "Check the elevation of its storey, and the ground level of the plan.");
            const auto wall = wall_before(axis, side);
            // Of short walls and tight arcs it is not clear what their sides are.
            const bool is_doubtful =
                wall || fills_gaps() || opening_->width < slit || is_short(axis) || is_folded(axis);
            if (wall && *wall < storey_->walls.size())
                blame(space, Severity::Warning,
                      subject() + " opens against wall \"" + storey_->walls[*wall].id + "\" and leads nowhere.",
                      "Move the opening or the wall in front of it.");
            else
                blame(space, is_doubtful ? Severity::Warning : Severity::Error,
                      subject() + " leads nowhere: one of its sides is closed" + (wall ? " by a column." : "."),
                      "Look for walls, columns or gaps filled in front of it.");
            return;
        }
        const auto& [right, left] = around.sides;
        if (opening_->kind == plans::OpeningKind::Opening || left.size() != 1 || left != right) return;
        blame(space, Severity::Warning,
              subject() + " has " + title(building_.spaces[left.front()]) + " on both of its sides.",
              "Check that a wall is not missing beside it.");
    }

    [[nodiscard]] bool is_folded(const plans::WallAxis& axis) const {
        return !axis.straight() && axis.radius() < storey_->walls[wall_].thickness;
    }
    [[nodiscard]] bool is_short(const plans::WallAxis& axis) const {
        return axis.length() < 2 * storey_->walls[wall_].thickness;
    }

    /// Whether the plan's stages filled gaps between walls of this storey (P320, P321).
    [[nodiscard]] bool fills_gaps() const {
        return std::any_of(building_.findings.begin(), building_.findings.end(), [&](const Finding& finding) {
            return (finding.code == "P320" || finding.code == "P321") && finding.storey == storey_->id;
        });
    }

    /// An opening of the plan without a volume: nothing to say where the plan's stages said it.
    void check_absence() {
        if (findings_by_element_.empty())
            for (const Finding& finding : building_.findings)
                for (const ElementRef& element : finding.elements) findings_by_element_.insert(element.id);
        if (findings_by_element_.contains(opening_->id)) return;
        // Its volume may be one that is blamed for naming another space (S1).
        if (std::find(blame_.volume.begin(), blame_.volume.end(), true) != blame_.volume.end())
            return void(++report_.suppressed);
        blame(UINT32_MAX, Severity::Warning, subject() + " is not in the model: other elements take its place.",
              "Look for openings, walls or columns that overlap it, and for a ceiling below its sill.");
    }

    [[nodiscard]] WallBodies& bodies() {
        if (!bodies_) bodies_ = std::make_unique<WallBodies>(*storey_);
        return *bodies_;
    }

    [[nodiscard]] std::string subject() const {
        const char* kinds[] = {"Door", "Window", "Opening"};
        const plans::Wall& wall = storey_->walls[wall_];
        const auto name = [](const auto& element) { return element.name.empty() ? element.id : element.name; };
        return std::string(kinds[int(opening_->kind)]) + " \"" + name(*opening_) + "\" in wall \"" + name(wall) + "\"";
    }

    [[nodiscard]] std::string list(const std::vector<std::uint32_t>& spaces) const {
        if (spaces.empty()) return "nothing is";
        std::string text;
        for (std::size_t k = 0; k < std::min<std::size_t>(spaces.size(), 3); ++k)
            text += (k == 0 ? "" : ", ") + title(building_.spaces[spaces[k]]);
        return text + (spaces.size() == 1 ? " is" : " are");
    }

    static std::string millimetres(double metres) {
        char text[32];
        std::snprintf(text, sizeof text, "%.0f mm", 1000 * metres);
        return text;
    }

    void blame(std::uint32_t space, Severity severity, std::string sentence, std::string hint) {
        Finding finding{.code = "S2", .severity = severity, .sentence = std::move(sentence), .hint = std::move(hint)};
        const plans::Wall& wall = storey_->walls[wall_];
        const plans::WallAxis axis = axis_of(wall);
        const plans::Point at = axis.at(std::clamp(opening_->offset / axis.length(), 0.0, 1.0));
        finding.point = {at.x, at.y, storey_->elevation + (opening_->sill + opening_->head) / 2};
        finding.storey = storey_->id;
        const char* kinds[] = {"door", "window", "opening"};
        finding.elements = {{kinds[int(opening_->kind)], opening_->id, opening_->name}, {"wall", wall.id, wall.name}};
        report_.findings.push_back(std::move(finding));
        if (severity != Severity::Error || space == UINT32_MAX) return;
        blame_.space[space] = true;
        for (const std::uint32_t v : spaces_.volumes(space)) blame_.volume[v] = true;
    }

    const Building& building_;
    const MapFaces& faces_;
    const SpaceIndex& spaces_;
    Blame& blame_;
    CheckReport& report_;
    double tolerance_;  ///< metres
    const plans::Storey* storey_ = nullptr;
    const plans::Opening* opening_ = nullptr;
    std::uint32_t wall_ = 0;                                ///< host of the opening
    std::unordered_map<std::string, std::uint32_t> walls_;  ///< of the storey, by id
    std::unique_ptr<WallBodies> bodies_;                    ///< of the storey, where a doubt asks for them
    std::unordered_set<std::string> findings_by_element_;  ///< elements of which the plan's stages had to say something
};

}  // namespace

void check_openings(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("S2");
    if (blame.whole_map) ++report.suppressed;
    else OpeningCheck(subject, blame, report).run();
}

}  // namespace enfilade::modeler

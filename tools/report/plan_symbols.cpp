#include "tools/report/plan_symbols.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "plans/outline.h"
#include "plans/vector2.h"

namespace enfilade::tools {
namespace {

using modeler::Label;
using plans::Point;

/// A hole in a wall as the plan has it.
struct Hole {
    plans::WallAxis axis;
    double from = 0, to = 0;     ///< shares of the axis
    double left = 0, right = 0;  ///< how far it reaches from the axis, both positive
    bool at_start = false;       ///< nearer to the wall's start than to its end
    double width = 0;
    double open_angle = 0;
    std::uint32_t space = 0;

    /// A corner of the hole, on its left or right face.
    [[nodiscard]] Point corner(double share, bool on_left) const { return axis.offset(share, on_left ? left : -right); }
    [[nodiscard]] double middle() const { return (from + to) / 2; }
};

/// Holes of one label that stand in the model. The plan's own list is longer where some could not be built.
std::vector<Hole> holes(const PlanView& view, std::uint32_t storey, Label label) {
    const plans::Storey* plan = view.plan_storey(storey);
    if (!plan) return {};
    std::unordered_map<std::string, const plans::Opening*> openings;
    std::unordered_map<std::string, const plans::Wall*> walls;
    for (const plans::Opening& opening : plan->openings) openings.emplace(opening.id, &opening);
    for (const plans::Wall& wall : plan->walls) walls.emplace(wall.id, &wall);
    std::vector<Hole> all;
    std::uint32_t last = UINT32_MAX;
    for (const modeler::SpacePart& part : view.parts(storey)) {
        const modeler::Space& space = view.space(part.space);
        if (space.label != label || part.space == last) continue;
        last = part.space;
        const auto opening = openings.find(space.id);
        if (opening == openings.end()) continue;
        const auto wall = walls.find(opening->second->wall);
        if (wall == walls.end()) continue;
        const plans::Wall& host = *wall->second;
        const plans::WallAxis axis(host.start, host.end, host.arc_extent, plans::OutlineOptions().flat);
        if (!(axis.length() > 0)) continue;
        const plans::Opening& o = *opening->second;
        const double half = o.width / 2 / axis.length(), at = o.offset / axis.length();
        all.push_back({axis, std::max(0.0, at - half), std::min(1.0, at + half), host.thickness / 2 + o.depth_left,
                       host.thickness / 2 + o.depth_right, at < 0.5, o.width, std::clamp(o.open_angle, 0.0, 3.0),
                       part.space});
    }
    return all;
}

Point world(const PlanView& view, Mm at) {
    return {view.origin()[0] + double(at.x) / 1000, view.origin()[1] + double(at.y) / 1000};
}

/// How much a door would rather open into a space: rooms before corridors before the outside, small before large.
double welcome(const modeler::Space& space) {
    if (space.label == Label::Exterior) return 1e12;
    const bool passes = space.kind == "corridor" || space.kind == "hall" || space.kind == "lobby" ||
                        space.kind == "stairwell" || space.label == Label::Stair || space.label == Label::Shaft;
    return space.area_m2 + (passes ? 1e6 : 0);
}

bool opens_left(const PlanView& view, const Hole& hole, const Passage* passage) {
    if (!passage) return true;
    const Point middle = hole.axis.at(hole.middle()), normal = hole.axis.normal(hole.middle());
    const bool from_is_left = plans::dot(world(view, passage->at_from) - middle, normal) >
                              plans::dot(world(view, passage->at_to) - middle, normal);
    const bool into_from = welcome(view.space(passage->from)) <= welcome(view.space(passage->to));
    return into_from == from_is_left;
}

void add_leaf(const PlanView& view, Point hinge, Point closed, double angle, bool turns_left, DoorPaths& paths) {
    const double turn = turns_left ? angle : -angle;
    const Point arm = closed - hinge;
    const Point end = hinge + arm * std::cos(turn) + plans::turned_left(arm) * std::sin(turn);
    paths.leaves.segment(view.mm(hinge), view.mm(end));
    MmBox& swept = paths.swept.emplace_back();
    for (const Point p : {hinge, closed, end}) swept.add(view.mm(p));
    if (angle < 0.05) return;
    paths.swings.move(view.mm(closed));
    paths.swings.arc(std::llround(1000 * plans::norm(arm)), turns_left, view.mm(end));
}

void add_lines_along(const PlanView& view, const Hole& hole, double offset, SvgPath& path) {
    const int steps = hole.axis.straight() ? 1 : std::max(2, int(std::ceil(hole.width / 0.2)));
    std::vector<Mm> points;
    for (int k = 0; k <= steps; ++k)
        points.push_back(view.mm(hole.axis.offset(hole.from + (hole.to - hole.from) * k / steps, offset)));
    path.polyline(points);
}

}  // namespace

DoorPaths door_paths(const PlanView& view, const Passages& passages, std::uint32_t storey) {
    std::unordered_map<std::uint32_t, const Passage*> by_space;
    for (const Passage& passage : passages.list)
        if (passage.kind == PassageKind::Door) by_space.emplace(passage.space, &passage);
    DoorPaths paths;
    for (const Hole& hole : holes(view, storey, Label::Door)) {
        const auto passage = by_space.find(hole.space);
        const bool left = opens_left(view, hole, passage == by_space.end() ? nullptr : passage->second);
        const Point start = hole.corner(hole.from, left), end = hole.corner(hole.to, left);
        add_lines_along(view, hole, hole.left, paths.sills);
        add_lines_along(view, hole, -hole.right, paths.sills);
        if (hole.width >= 2.6) {
            // Of a garage or a hall: it slides or folds, nothing swings.
            add_lines_along(view, hole, (hole.left - hole.right) / 2, paths.leaves);
        } else if (hole.width >= 1.3) {
            const Point middle = (start + end) * 0.5;
            add_leaf(view, start, middle, hole.open_angle, left, paths);
            add_leaf(view, end, middle, hole.open_angle, !left, paths);
        } else {
            add_leaf(view, hole.at_start ? start : end, hole.at_start ? end : start, hole.open_angle,
                     left == hole.at_start, paths);
        }
    }
    return paths;
}

SvgPath window_paths(const PlanView& view, std::uint32_t storey) {
    SvgPath path;
    for (const Hole& hole : holes(view, storey, Label::Window)) {
        const double middle = (hole.left - hole.right) / 2, apart = std::min(0.03, (hole.left + hole.right) / 6);
        add_lines_along(view, hole, middle + apart, path);
        add_lines_along(view, hole, middle - apart, path);
    }
    return path;
}

SvgPath opening_paths(const PlanView& view, std::uint32_t storey) {
    SvgPath path;
    for (const Hole& hole : holes(view, storey, Label::Opening)) {
        add_lines_along(view, hole, hole.left, path);
        add_lines_along(view, hole, -hole.right, path);
    }
    return path;
}

SvgPath furniture_paths(const PlanView& view, std::uint32_t storey) {
    SvgPath path;
    const plans::Storey* plan = view.plan_storey(storey);
    if (!plan) return path;
    for (const plans::Furniture& piece : plan->furniture) {
        // Lamps and plates are specks on a plan, and what hangs under the ceiling is above it.
        if (std::max(piece.width, piece.depth) < 0.25 || piece.elevation >= 1.8) continue;
        const Point along = {std::cos(piece.angle), std::sin(piece.angle)}, back = plans::turned_left(along);
        const auto corner = [&](double x, double y) {
            return view.mm(piece.position + along * (x * piece.width / 2) + back * (y * piece.depth / 2));
        };
        const std::array<Mm, 4> box = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
        path.ring(box);
        if (piece.depth > 0.25) path.segment(corner(-1, 0.86), corner(1, 0.86));
    }
    return path;
}

}  // namespace enfilade::tools

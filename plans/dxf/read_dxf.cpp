// A DXF drawing as a plan: one storey.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "plans/dxf/drawing.h"
#include "plans/dxf/opening_sizes.h"
#include "plans/dxf/role.h"
#include "plans/dxf/room_names.h"
#include "plans/dxf/sheet.h"
#include "plans/dxf/sheet_unit.h"
#include "plans/dxf/wall_bodies.h"
#include "plans/dxf/wall_runs.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double window_sill = 0.9;
constexpr double usual_head = 2.1;

Finding finding(const char* code, Severity severity, std::string sentence, std::string hint) {
    Finding result{.code = code, .severity = severity, .sentence = std::move(sentence), .hint = std::move(hint)};
    return result;
}

std::string length_text(double metres_long) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f m", metres_long);
    return text;
}

RoleRules rules_of(const ReadOptions& options) {
    if (options.mapping.empty()) return {};
    std::ifstream stream(options.mapping, std::ios::binary);
    if (!stream) throw IoError("The mapping " + options.mapping.string() + " cannot be opened; check its name.");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    return read_mapping(text, options.mapping.string());
}

/// What the drawing does not show is not read, unless its layer was asked for by name.
void leave_out_hidden(Drawing& drawing, std::vector<Finding>& findings) {
    const std::size_t texts = std::erase_if(drawing.texts, [](const DrawingText& text) { return !text.visible; });
    const std::size_t shapes = std::erase_if(drawing.shapes, [](const Shape& shape) { return !shape.visible; });
    if (texts + shapes == 0) return;
    findings.push_back(finding("P728", Severity::Note,
                               "Left out, for their layers are off or frozen: " + std::to_string(shapes) +
                                   (shapes == 1 ? " shape, " : " shapes, ") + std::to_string(texts) +
                                   (texts == 1 ? " text." : " texts."),
                               "To read a layer all the same, name it (--layer); --list-layers shows them."));
}

bool is_wall(Role role) { return role == Role::Wall || role == Role::LowWall; }

/// Lines along the middle of walls become walls of the thickness asked for.
void add_axes(const std::vector<SheetStroke>& strokes, double thickness, WallBodies& bodies) {
    std::vector<SheetStroke> axes = strokes;
    std::erase_if(axes, [](const SheetStroke& s) { return s.role != Role::WallAxis; });
    PairLimits never;
    never.most = 0;
    const WallBodies lines = wall_bodies(axes, never);
    for (WallBody line : lines.single) {
        line.group += std::uint32_t(bodies.groups.size());
        line.thickness = thickness;
        bodies.straight.push_back(line);
    }
    bodies.groups.insert(bodies.groups.end(), lines.groups.begin(), lines.groups.end());
}

/// The layers with the most on them, for whoever has to say which are the walls.
std::string layer_list(const Drawing& drawing) {
    std::vector<const Layer*> layers;
    for (const Layer& layer : drawing.layers)
        if (layer.shape_count > 0) layers.push_back(&layer);
    std::stable_sort(layers.begin(), layers.end(),
                     [](const Layer* l, const Layer* r) { return l->shape_count > r->shape_count; });
    std::string text;
    for (std::size_t k = 0; k < layers.size() && k < 8; ++k)
        text += (k == 0 ? "" : ", ") + ('"' + layers[k]->name + "\" (" + std::to_string(layers[k]->shape_count) + ')');
    return text + (layers.size() > 8 ? ", ..." : "");
}

/// Where no layer is called a wall, the one whose lines make the most wall when paired.
void find_wall_layer(const Drawing& drawing, Roles& roles, const std::string& file, std::vector<Finding>& findings) {
    for (const Shape& shape : drawing.shapes)
        if (const Role role = roles.of(drawing, shape); is_wall(role) || role == Role::WallAxis) return;
    std::uint32_t best = UINT32_MAX;
    double most = 0;
    for (std::uint32_t layer = 0; layer < drawing.layers.size(); ++layer) {
        if (roles.layer[layer] != Role::Unknown || drawing.layers[layer].shape_count == 0) continue;
        Roles tried = roles;
        tried.layer[layer] = Role::Wall;
        const UnitVerdict unit = sheet_unit(drawing, tried);
        std::vector<SheetStroke> walls = sheet_strokes(drawing, tried, metres(unit.unit));
        std::erase_if(walls, [](const SheetStroke& s) { return s.role != Role::Wall; });
        const WallBodies bodies = wall_bodies(walls);
        const double share = bodies.total_length > 0 ? bodies.paired_length / bodies.total_length : 0;
        if (bodies.paired_length * share <= most) continue;
        most = bodies.paired_length * share;
        best = layer;
    }
    if (best == UINT32_MAX)
        throw InputError("P721", file,
                         "No layer of the drawing is known to hold walls, and none looks as if it did; say which by a "
                         "mapping file (--mapping). Its layers: " +
                             layer_list(drawing) + '.');
    roles.layer[best] = Role::Wall;
    findings.push_back(finding("P722", Severity::Warning,
                               "No layer is called after walls: layer \"" + drawing.layers[best].name +
                                   "\" is taken for them, for its lines run in pairs.",
                               "If that is wrong, say which layers are walls by a mapping file (--mapping)."));
}

double decide_unit(const Drawing& drawing, const Roles& roles, const ReadOptions& options,
                   std::vector<Finding>& findings) {
    if (options.unit) return metres(*options.unit);
    const UnitVerdict verdict = sheet_unit(drawing, roles);
    if (verdict.overruled)
        findings.push_back(finding("P723", Severity::Warning,
                                   std::string("The drawing says that it is in ") + plural_of(*drawing.declared_unit) +
                                       ", but is read in " + plural_of(verdict.unit) + ": " + verdict.evidence + ".",
                                   "If that is wrong, give the unit (--units)."));
    else if (verdict.guessed)
        findings.push_back(finding("P724", Severity::Note,
                                   std::string("The drawing names no unit; it is read in ") + plural_of(verdict.unit) +
                                       ": " + verdict.evidence + ".",
                                   "If that is wrong, give the unit (--units)."));
    return metres(verdict.unit);
}

/// A low wall is a parapet where a window stands on it: there the wall goes up, and the window begins at its top.
std::vector<WallRun> with_parapets(const WallRun& run, double storey_height) {
    constexpr double least_piece = 0.05;
    if (!run.height || *run.height >= usual_head || *run.height >= storey_height) return {run};
    const double length = distance(run.start, run.end);
    const Point dir = (run.end - run.start) * (1 / length);
    std::vector<WallRun> pieces;
    double from = 0;
    const auto add = [&](double to, std::optional<double> height) {
        WallRun piece = run;
        piece.start = run.start + dir * from;
        piece.end = run.start + dir * to;
        piece.height = height;
        std::erase_if(piece.openings, [&](const RunOpening& o) {
            const double middle = (o.u0 + o.u1) / 2;
            return middle < from || middle > to || (height.has_value() == (o.kind == OpeningKind::Window));
        });
        for (RunOpening& o : piece.openings) {
            o.u0 = std::max(o.u0 - from, 0.0);
            o.u1 = std::min(o.u1, to) - from;
            if (!height && !o.sill) o.sill = run.height;
        }
        pieces.push_back(std::move(piece));
        from = to;
    };
    for (const RunOpening& opening : run.openings) {
        if (opening.kind != OpeningKind::Window) continue;
        const double u0 = opening.u0 < from + least_piece ? from : opening.u0;
        const double u1 = opening.u1 > length - least_piece ? length : opening.u1;
        if (u1 <= u0) continue;
        if (u0 > from) add(u0, run.height);
        add(u1, std::nullopt);
    }
    if (from < length) add(length, run.height);
    return pieces;
}

void add_wall(Storey& storey, const WallRun& run) {
    Wall wall;
    wall.id = "wall-" + std::to_string(storey.walls.size() + 1);
    wall.start = run.start;
    wall.end = run.end;
    wall.thickness = run.thickness;
    wall.height_at_start = wall.height_at_end = std::min(run.height.value_or(storey.height), storey.height);
    for (const RunOpening& found : run.openings) {
        Opening opening;
        const char* kind = found.kind == OpeningKind::Door     ? "door-"
                           : found.kind == OpeningKind::Window ? "window-"
                                                               : "opening-";
        opening.id = kind + std::to_string(storey.openings.size() + 1);
        opening.kind = found.kind;
        opening.wall = wall.id;
        opening.offset = (found.u0 + found.u1) / 2;
        opening.width = found.u1 - found.u0;
        opening.sill = found.sill.value_or(found.kind == OpeningKind::Window ? window_sill : 0);
        opening.head = std::min(found.head.value_or(usual_head), wall.height_at_start);
        if (opening.head > opening.sill) storey.openings.push_back(std::move(opening));
    }
    storey.walls.push_back(std::move(wall));
}

void add_curved(Storey& storey, const CurvedBody& body) {
    if (body.radius * body.sweep < 0.05) return;
    // A plan's arc stays below a full turn: a ring is two walls.
    const int parts = body.sweep > 3.2 ? 2 : 1;
    for (int part = 0; part < parts; ++part) {
        const double from = body.start + body.sweep * part / parts, to = body.start + body.sweep * (part + 1) / parts;
        const auto at = [&](double a) { return body.centre + Point{std::cos(a), std::sin(a)} * body.radius; };
        Wall wall;
        wall.id = "wall-" + std::to_string(storey.walls.size() + 1);
        wall.start = at(from);
        wall.end = at(to);
        wall.arc_extent = to - from;
        wall.thickness = body.thickness;
        wall.height_at_start = wall.height_at_end = std::min(body.height.value_or(storey.height), storey.height);
        storey.walls.push_back(std::move(wall));
    }
}

void add_mass(Storey& storey, const WallMass& mass) {
    Column column;
    column.id = "column-" + std::to_string(storey.columns.size() + 1);
    column.polygon = mass.polygon;
    if (mass.height && *mass.height < storey.height) column.height = *mass.height;
    storey.columns.push_back(std::move(column));
}

void add_columns(Storey& storey, const Drawing& drawing, const Roles& roles, double scale) {
    for (const Shape& shape : drawing.shapes) {
        if (!shape.closed || shape.stroke_count == 0 || roles.of(drawing, shape) != Role::Column) continue;
        Column column;
        column.id = "column-" + std::to_string(storey.columns.size() + 1);
        for (std::uint32_t s = 0; s < shape.stroke_count; ++s) {
            const Stroke& stroke = drawing.strokes[shape.first_stroke + s];
            column.polygon.push_back(stroke.a * scale);
            if (stroke.bulge == 0) continue;
            const CircleArc arc = circle_arc(stroke);
            const int steps = std::max(2, int(std::ceil(std::abs(arc.sweep) * 4)));
            for (int k = 1; k < steps; ++k) {
                const double a = arc.start + arc.sweep * k / steps;
                column.polygon.push_back((arc.centre + Point{std::cos(a), std::sin(a)} * arc.radius) * scale);
            }
        }
        double area2 = 0;
        for (std::size_t k = 0; k < column.polygon.size(); ++k)
            area2 += cross(column.polygon[k], column.polygon[(k + 1) % column.polygon.size()]);
        if (std::abs(area2) < 2e-4 || std::abs(area2) > 20) continue;  // 1 cm2 to 10 m2
        if (area2 < 0) std::reverse(column.polygon.begin(), column.polygon.end());
        storey.columns.push_back(std::move(column));
    }
}

/// Lines of wall layers that no wall is made of, but for those as short as the ends of walls.
std::optional<Finding> lone_lines(const WallBodies& bodies) {
    double lone = 0;
    std::size_t count = 0;
    const WallBody* longest = nullptr;
    for (const WallBody& line : bodies.single) {
        if (line.u1 - line.u0 < PairLimits{}.most) continue;
        lone += line.u1 - line.u0;
        ++count;
        if (!longest || line.u1 - line.u0 > longest->u1 - longest->u0) longest = &line;
    }
    if (!longest) return std::nullopt;
    Finding left =
        finding("P725", Severity::Warning,
                "Lines of wall layers have no parallel partner at a wall's distance (" + std::to_string(count) +
                    (count == 1 ? " piece, " : " pieces, ") + length_text(lone) + " in all): no wall is made of them.",
                "Draw both faces of these walls, or map their layer to \"ignored\" (--mapping).");
    const Point dir = bodies.groups[longest->group].dir;
    const Point at = dir * ((longest->u0 + longest->u1) / 2) + turned_left(dir) * longest->v;
    left.point = {at.x, at.y, 0};
    return left;
}

/// What the drawing has and the plan has not.
void report_rest(const Drawing& drawing, const Roles& roles, const WallBodies& bodies, bool single_lines,
                 std::vector<Finding>& findings) {
    if (const auto left = single_lines ? std::nullopt : lone_lines(bodies)) findings.push_back(*left);
    std::uint32_t stairs = 0, furniture = 0, unknown = 0;
    for (const Shape& shape : drawing.shapes) {
        const Role role = roles.of(drawing, shape);
        stairs += role == Role::Stair;
        furniture += role == Role::Furniture;
        unknown += role == Role::Unknown;
    }
    if (stairs + furniture + unknown == 0) return;
    std::string text;
    const auto add = [&](std::uint32_t count, const char* what) {
        if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + what;
    };
    add(stairs, "of stairs");
    add(furniture, "of furniture and fixtures");
    add(unknown, "on layers of which nothing is known");
    findings.push_back(finding("P726", Severity::Note,
                               "Shapes of the drawing that the plan does not hold: " + text + ".",
                               "A mapping file (--mapping) can say what a layer or block is."));
}

}  // namespace

Plan read_dxf(std::string_view bytes, const std::string& file_name, const ReadOptions& options) {
    const RoleRules rules = rules_of(options);
    Drawing drawing = select(read_drawing(bytes, file_name), options.layers, options.crop, file_name);
    Plan plan;
    plan.name = std::filesystem::path(file_name).stem().string();
    plan.findings = drawing.findings;
    if (options.layers.empty()) leave_out_hidden(drawing, plan.findings);
    Roles roles = assign_roles(drawing, rules);
    find_wall_layer(drawing, roles, file_name, plan.findings);
    const double scale = decide_unit(drawing, roles, options, plan.findings);

    const std::vector<SheetStroke> strokes = sheet_strokes(drawing, roles, scale);
    std::vector<SheetStroke> wall_strokes = strokes;
    std::erase_if(wall_strokes, [](const SheetStroke& s) { return !is_wall(s.role); });
    WallBodies bodies = wall_bodies(wall_strokes);
    const bool single_lines = bodies.total_length > 0 && bodies.paired_length < 0.4 * bodies.total_length;
    if (single_lines) {
        for (WallBody line : bodies.single) {
            line.thickness = options.wall_thickness;
            bodies.straight.push_back(line);
        }
        plan.findings.push_back(finding("P727", Severity::Note,
                                        "Most walls are drawn as single lines: they get a thickness of " +
                                            std::to_string(int(std::lround(1000 * options.wall_thickness))) + " mm.",
                                        "Another thickness: --wall-thickness-mm."));
    }
    add_axes(strokes, options.wall_thickness, bodies);
    Storey storey;
    storey.id = storey.name = "storey";
    storey.height = options.storey_height;
    std::vector<WallMass> masses;
    std::vector<WallRun> runs = wall_runs(bodies, strokes, single_lines ? nullptr : &masses);
    apply_sizes(runs, size_notes(drawing, scale));
    for (const WallRun& run : runs)
        if (distance(run.start, run.end) > 0.02)
            for (const WallRun& piece : with_parapets(run, storey.height)) add_wall(storey, piece);
    for (const CurvedBody& body : bodies.curved) add_curved(storey, body);
    for (const WallMass& mass : masses) add_mass(storey, mass);
    add_columns(storey, drawing, roles, scale);
    if (storey.walls.empty())
        throw InputError(
            "P721", file_name,
            "The layers of walls hold no two parallel lines at a wall's distance: check the unit (--units), or "
            "say which layers are walls (--mapping). The drawing's layers: " +
                layer_list(drawing) + '.');
    plan.storeys.push_back(std::move(storey));
    report_rest(drawing, roles, bodies, single_lines, plan.findings);
    if (const std::uint32_t outside = name_rooms(place_names(drawing, roles, scale), plan); outside > 0)
        plan.findings.push_back(finding("P729", Severity::Note,
                                        std::to_string(outside) + (outside == 1 ? " name stands" : " names stand") +
                                            " in no room that the walls close.",
                                        "Close the walls around them if they are rooms."));
    return plan;
}

}  // namespace enfilade::plans

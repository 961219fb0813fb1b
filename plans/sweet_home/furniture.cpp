// Pieces of furniture, lights, stairs, and doors and windows as they are placed.
#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <numbers>
#include <sstream>

#include "plans/limits.h"
#include "plans/number_text.h"
#include "plans/rotation.h"
#include "plans/sweet_home/parts.h"
#include "plans/sweet_home/shape.h"
#include "plans/sweet_home/words.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double pi = std::numbers::pi;
constexpr NumberRange extent{0, limits::thickness, true};
constexpr NumberRange height_range{-limits::height / 2, limits::height / 2};  // what stands on it is a height too
constexpr NumberRange source_size{0, 4};                                      // of a lamp's width
constexpr NumberRange source_share{-4, 4};  // of a lamp's box: a source may hang outside of it
constexpr double farthest = limits::coordinate - 10 * limits::thickness;  // a box there lies inside the limits
constexpr NumberRange share{0, 1};
constexpr NumberRange angle_range{-64 * pi, 64 * pi};
constexpr double lumen_of_full_power = 3200;    // the middle setting, 0.5, is a bulb of 800 lm
constexpr double usual_source_radius = 0.0325;  // metres: of a source that tells none

/// The box of a piece as the plan shows it.
struct Box {
    Point middle;
    double angle = 0;  ///< counter-clockwise
    double width = 1;
    double depth = 1;
    double height = 1;
    double elevation = 0;
    bool mirrored = false;
    double pitch = 0;
    double roll = 0;
    std::optional<std::array<double, 3>> model_size;  ///< where it is tilted

    /// A place inside it by shares from its left back corner; the back is up where the angle is 0.
    [[nodiscard]] Point at(double right, double down) const {
        const Point along{std::cos(angle), std::sin(angle)};
        const double x = (mirrored ? 0.5 - right : right - 0.5) * width;
        return middle + along * x - turned_left(along) * ((down - 0.5) * depth);
    }
};

/// The angle in (-pi, pi], turned the other way because y points up here.
double turned_up(double clockwise) {
    const double angle = std::remainder(-clockwise, 2 * pi);
    return angle == 0 ? 0 : angle;
}

/// A tilted piece has a size of its own, and the one of its box in the plan.
void read_tilt(const HomeElement& element, Box& box) {
    box.pitch = std::remainder(element.number("pitch", angle_range, 0), 2 * pi);
    if (box.pitch == 0) box.roll = std::remainder(element.number("roll", angle_range, 0), 2 * pi);
    if (box.pitch == 0 && box.roll == 0) return;
    const auto own = [&](const char* key, double in_plan) { return element.metres(key, extent).value_or(in_plan); };
    box.model_size = {{own("width", box.width), own("depth", box.depth), own("height", box.height)}};
}

std::optional<Box> read_box(const HomeElement& element) {
    Box box;
    const auto middle = point_of(element, "x", "y");
    // Pieces tilted about a horizontal axis have another size in the plan than their model.
    const auto size = [&](const char* key, const char* key_in_plan) {
        return element.has(key_in_plan) ? element.metres(key_in_plan, extent) : element.metres(key, extent);
    };
    const auto width = size("width", "widthInPlan");
    const auto depth = size("depth", "depthInPlan");
    const auto height = size("height", "heightInPlan");
    if (!middle || !width || !depth || !height) return {};
    if (std::abs(middle->x) > farthest || std::abs(middle->y) > farthest) return {};
    box.middle = *middle;
    box.width = *width;
    box.depth = *depth;
    box.height = *height;
    box.elevation = element.metres("elevation", height_range, 0);
    box.angle = turned_up(element.number("angle", angle_range, 0));
    box.mirrored = element.flag("modelMirrored", false);
    read_tilt(element, box);
    return box;
}

std::string model_of(const HomeElement& element) {
    const std::string model = element.text("model");
    return model.empty() ? element.text("catalogId") : model;
}

/// Rows of a rotation in the file's axes (y up, z to the front) in ours (z up, y to the back).
std::optional<std::array<double, 9>> read_rotation(const HomeElement& element) {
    if (!element.has("modelRotation")) return {};
    std::array<double, 9> rows{};
    std::istringstream text(element.text("modelRotation"));
    text.imbue(std::locale::classic());
    for (double& number : rows) text >> number;
    if (!text || !is_rotation(rows)) {
        element.unusable("modelRotation", "no rotation");
        return {};
    }
    // (x, y, z) -> (x, -z, y) on both sides.
    const auto& [xx, xy, xz, yx, yy, yz, zx, zy, zz] = rows;
    const std::array<double, 9> ours = {xx, -xz, xy, -zx, zz, -zy, yx, -yz, yy};
    constexpr std::array<double, 9> identity = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    if (ours == identity) return {};
    return ours;
}

void add_furniture(const HomeElement& element, const Box& box, const std::string& id, Storey& storey) {
    Furniture piece;
    piece.id = id;
    piece.name = element.text("name");
    piece.model = model_of(element);
    piece.position = box.middle;
    piece.elevation = box.elevation;
    piece.angle = box.angle;
    piece.width = box.width;
    piece.depth = box.depth;
    piece.height = box.height;
    piece.mirrored = box.mirrored;
    piece.colour = element.colour("color");
    piece.catalogue = element.text("catalogId");
    if (piece.catalogue == piece.model) piece.catalogue.clear();
    // A library turns its models itself.
    if (!element.text("model").empty()) piece.model_rotation = read_rotation(element);
    piece.model_size = box.model_size;
    piece.pitch = box.pitch;
    piece.roll = box.roll;
    for (const pugi::xml_node node : element.node().children("material")) {
        const HomeElement material = element.child(node);
        if (const auto colour = material.colour("color"); colour && !material.text("name").empty())
            piece.materials.push_back({material.text("name"), *colour});
    }
    storey.furniture.push_back(std::move(piece));
}

/// What Sweet Home 3D's own pictures show: the light of a source grows with the square of its lamp's power and with its
/// colour, and each source of a lamp has all of it (`PhotoRenderer`: radiance 5 power^2 / radius^2 times colour, of a
/// sphere). A dark colour is a weak lamp there; here the flux says so.
double lumen_of(double power, const Colour& colour) {
    const double luminance = 0.2126 * double(colour[0]) + 0.7152 * double(colour[1]) + 0.0722 * double(colour[2]);
    return power * power * lumen_of_full_power * luminance;
}

/// A lamp is a piece of furniture, and one light for each of its sources; with power 0 it is switched off.
void add_lights(const HomeElement& element, const Box& box, const std::string& lamp, Storey& storey, Home& home) {
    const double power = element.number("power", {0, 500}, 0.5);
    if (power == 0) return;
    std::size_t count = 0;
    const auto add = [&](Point position, double elevation, double radius, const Colour& colour) {
        Light light;
        light.id = home.ids.take(lamp + "/source-" + std::to_string(++count), "light");
        light.name = element.text("name");
        light.position = position;
        light.elevation = elevation;
        light.colour = colour;
        light.power_lumen = lumen_of(power, colour);
        light.radius = radius;
        light.furniture = lamp;
        storey.lights.push_back(std::move(light));
    };
    for (const pugi::xml_node node : element.node().children("lightSource")) {
        const HomeElement source = element.child(node);
        const double radius =
            source.has("diameter") ? source.number("diameter", source_size, 0) * box.width / 2 : usual_source_radius;
        add(box.at(source.number("x", source_share, 0.5), source.number("y", source_share, 0.5)),
            box.elevation + source.number("z", source_share, 0.5) * box.height, std::min(radius, limits::thickness),
            source.colour("color").value_or(Colour{1, 1, 1}));
    }
    if (count == 0) add(box.middle, box.elevation + box.height / 2, usual_source_radius, {1, 1, 1});
}

/// The largest ring of the cut-out in its box; the box itself where the shape says nothing usable.
std::vector<Point> footprint(const Box& box, const std::string& shape) {
    std::vector<Point> best = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    if (const auto rings = path_rings(shape)) {
        const auto largest = std::max_element(rings->begin(), rings->end(), [](const auto& a, const auto& b) {
            return std::abs(signed_area(a)) < std::abs(signed_area(b));
        });
        if (largest != rings->end() && std::abs(signed_area(*largest)) > 1e-3) best = *largest;
    }
    for (Point& p : best) p = box.at(std::clamp(p.x, 0.0, 1.0), std::clamp(p.y, 0.0, 1.0));
    return best;
}

/// True where the piece is a stair to a storey above.
bool add_stair(const HomeElement& element, const Box& box, const std::string& id, std::size_t index, Home& home) {
    Storey& storey = home.plan.storeys[index];
    const std::string shape = element.text("staircaseCutOutShape");
    if (shape.empty()) return false;
    const std::string name = element.text("name");
    const bool above = home.plan.storeys.back().elevation > storey.elevation;
    if (!above) {
        home.report(finding_at(storey, "P181", Severity::Note,
                               "The " + element.label() + " at " + place_text(box.middle) +
                                   " leads to no level of the file; it is kept as a piece of furniture.",
                               "Add the level above in Sweet Home 3D if there is one.", {"stair", id, name},
                               box.middle));
        return false;
    }
    storey.stairs.push_back({id, name, footprint(box, shape)});
    return true;
}

OpeningKind kind_of(const HomeElement& element, double sill) {
    if (element.has("isDoor")) return element.flag("isDoor", true) ? OpeningKind::Door : OpeningKind::Window;
    constexpr double step_over = 0.3;  // m
    switch (opening_word(element.text("catalogId") + " " + element.text("name"))) {
        case OpeningWord::Frame: return element.node().child("sash") ? OpeningKind::Door : OpeningKind::Opening;
        case OpeningWord::Window: return OpeningKind::Window;
        case OpeningWord::Door: return sill < 3 * step_over ? OpeningKind::Door : OpeningKind::Window;
        case OpeningWord::WindowDoor:
        case OpeningWord::None: break;
    }
    return sill < step_over ? OpeningKind::Door : OpeningKind::Window;
}

/// How far the leaf turns: the most that any sash does.
double open_angle(const HomeElement& element) {
    double angle = 0;
    for (const pugi::xml_node node : element.node().children("sash")) {
        const HomeElement sash = element.child(node);
        const double start = sash.number("startAngle", angle_range, 0);
        const double end = sash.number("endAngle", angle_range, 0);
        angle = std::max(angle, std::abs(end - start));
    }
    return angle > 0 ? std::min(angle, pi) : pi / 2;
}

/// Part of the box that is cut out of the wall, by shares of its width and height.
struct CutOut {
    double left = 0;
    double right = 1;
    double top = 0;
    double bottom = 1;
    bool shaped = false;  ///< the hole is no rectangle
};

CutOut cut_out(const HomeElement& element) {
    CutOut cut;
    const double left = element.number("wallLeft", {-1, 1}, 0);
    const double top = element.number("wallTop", {-1, 1}, 0);
    const double width = element.number("wallWidth", {0, 1, true}, 1);
    const double height = element.number("wallHeight", {0, 1, true}, 1);
    CutOut shape;
    if (const std::string path = element.text("cutOutShape"); !path.empty()) {
        const auto rings = path_rings(path);
        shape.shaped = !rings.has_value();  // a whole SVG document: its extent is not known here
        double area = 0;
        if (rings && !rings->empty()) {
            shape = {1, 0, 1, 0, false};
            for (const auto& ring : *rings) {
                area += std::abs(signed_area(ring));
                for (const Point p : ring) {
                    shape.left = std::clamp(p.x, 0.0, shape.left);
                    shape.right = std::clamp(p.x, shape.right, 1.0);
                    shape.top = std::clamp(p.y, 0.0, shape.top);
                    shape.bottom = std::clamp(p.y, shape.bottom, 1.0);
                }
            }
            const double box = (shape.right - shape.left) * (shape.bottom - shape.top);
            if (!(shape.right - shape.left > 1e-3) || !(shape.bottom - shape.top > 1e-3)) shape = {};
            else shape.shaped = area < 0.99 * box;
        }
    }
    cut.left = left + width * shape.left;
    cut.right = left + width * shape.right;
    cut.top = top + height * shape.top;
    cut.bottom = top + height * shape.bottom;
    cut.shaped = shape.shaped;
    return cut;
}

void add_opening(const HomeElement& element, const Box& box, const std::string& id, std::size_t index, Home& home) {
    const Storey& storey = home.plan.storeys[index];
    const CutOut cut = cut_out(element);
    PlacedOpening placed;
    Opening& opening = placed.opening;
    opening.id = id;
    opening.name = element.text("name");
    const ElementRef ref{"opening", id, opening.name};
    const double sill = box.elevation + (1 - cut.bottom) * box.height;
    opening.sill = std::abs(sill) < 1e-9 ? 0 : std::max(0.0, sill);
    opening.head = box.elevation + (1 - cut.top) * box.height;
    opening.kind = kind_of(element, opening.sill);
    opening.open_angle = open_angle(element);
    opening.width = (cut.right - cut.left) * box.width;
    if (!(opening.head - opening.sill > 1e-3) || !(opening.width > 1e-3)) {
        home.report(finding_at(storey, "P171", Severity::Error,
                               "The " + element.label() + " at " + place_text(box.middle) +
                                   " is left out: it lies wholly below the floor of its level, or has no extent.",
                               "Raise it or give it a size in Sweet Home 3D.", ref, box.middle));
        return;
    }
    if (cut.shaped)
        home.report(finding_at(storey, "P175", Severity::Note,
                               "The hole of the " + element.label() + " at " + place_text(box.middle) +
                                   " is not rectangular; the rectangle around it is cut out.",
                               "", ref, box.middle));
    placed.middle = box.middle;
    placed.angle = box.angle;
    placed.width = box.width;
    placed.depth = box.depth;
    const double distance = element.number("wallDistance", share, 0);
    const double thickness = std::min(element.number("wallThickness", {0, 1, true}, 1), 1 - std::min(distance, 0.99));
    placed.wall_middle = box.at((cut.left + cut.right) / 2, distance + thickness / 2);
    placed.wall_width = opening.width;
    placed.wall_depth = thickness * box.depth;
    home.openings[index].push_back(std::move(placed));
}

}  // namespace

namespace {

bool is_piece(std::string_view kind) {
    return kind == "pieceOfFurniture" || kind == "doorOrWindow" || kind == "light" || kind == "shelfUnit" ||
           kind == "furnitureGroup";
}

/// Pieces of a group have their places in the plan, not in the group; their level may be the group's.
void read_group(const HomeElement& element, Home& home, const std::string& level) {
    const bool shown = element.flag("visible", true);
    std::size_t pieces = 0;
    for (const pugi::xml_node node : element.node().children()) {
        if (!is_piece(node.name())) continue;
        ++pieces;
        if (shown) read_piece(element.child(node), home, level);
    }
    if (!shown && pieces > 0) home.hidden[home.storey_for(element, level)] += pieces;
}

/// A piece of furniture is no part of the building: without it the rest is as sound as with it, so that all such
/// pieces of a level are told at once. A door that is lost is missed.
void report_unusable_piece(const HomeElement& element, const std::string& id, std::size_t index, Home& home) {
    if (std::string_view(element.node().name()) != "doorOrWindow") {
        home.without_size[index].push_back({"furniture", id, element.text("name")});
        return;
    }
    home.report(finding_at(home.plan.storeys[index], "P170", Severity::Error,
                           "The " + element.label() + " is left out: the file gives it no usable place and size.",
                           "Delete it in Sweet Home 3D and place it again.", {"opening", id, element.text("name")},
                           point_of(element, "x", "y")));
}

}  // namespace

void read_piece(const HomeElement& element, Home& home, const std::string& level_of_group) {
    const std::string level = element.has("level") ? element.text("level") : level_of_group;
    const std::string_view kind = element.node().name();
    if (!is_piece(kind)) return;
    if (kind == "furnitureGroup") return read_group(element, home, level);
    const std::size_t index = home.storey_for(element, level);
    Storey& storey = home.plan.storeys[index];
    const std::string id = home.ids.take(element.text("id"), std::string(kind));
    if (!element.flag("visible", true)) {
        ++home.hidden[index];
        return;
    }
    const std::optional<Box> box = read_box(element);
    if (!box) return report_unusable_piece(element, id, index, home);
    if (kind == "doorOrWindow") return add_opening(element, *box, id, index, home);
    if (add_stair(element, *box, id, index, home)) return;
    add_furniture(element, *box, id, storey);
    if (kind == "light") add_lights(element, *box, id, storey, home);
}

}  // namespace enfilade::plans

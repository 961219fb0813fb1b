// Levels, walls and rooms.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "plans/limits.h"
#include "plans/number_text.h"
#include "plans/sweet_home/parts.h"
#include "plans/sweet_home/words.h"

namespace enfilade::plans {
namespace {

constexpr NumberRange coordinate{-limits::coordinate, limits::coordinate};
constexpr NumberRange any_height{0, limits::height};
constexpr NumberRange positive_height{0, limits::height, true};
constexpr NumberRange positive_thickness{0, limits::thickness, true};
constexpr NumberRange any_elevation{-limits::elevation, limits::elevation};
constexpr double default_thickness = 0.075;  // what Sweet Home 3D gives new walls

struct Level {
    Storey storey;
    std::string file_id;
    double index = 0;
};

/// A level without elevation stands on the one before it in the file.
Level read_level(const HomeElement& element, Home& home, const Storey* before) {
    Level level;
    level.file_id = element.text("id");
    level.index = element.number("elevationIndex", {}, 0);
    Storey& storey = level.storey;
    storey.id = home.ids.take(level.file_id, "level");
    storey.name = element.text("name");
    storey.height = element.metres("height", positive_height, home.wall_height);
    storey.slab_thickness = element.metres("floorThickness", any_height, 0.12);
    const double above = before == nullptr ? 0 : before->elevation + before->height + storey.slab_thickness;
    storey.elevation = element.metres("elevation", any_elevation, std::min(above, limits::elevation));
    if (!element.has("elevation"))
        home.report(finding_at(storey, "P165", Severity::Warning,
                               "The " + element.label() + " has no elevation; it is placed at " +
                                   rounded_text(storey.elevation, 3) + " m.",
                               "Set the elevation of the level in Sweet Home 3D.", {"storey", storey.id, storey.name},
                               {}));
    return level;
}

}  // namespace

HomeIds::HomeIds(pugi::xml_node home) {
    // Groups nest, so all elements are walked; the text was found not to be deep.
    for (pugi::xml_node node = home.first_child(); node;) {
        if (const auto id = node.attribute("id")) given_.emplace(id.value());
        if (node.first_child()) {
            node = node.first_child();
            continue;
        }
        while (node && node != home && !node.next_sibling()) node = node.parent();
        if (!node || node == home) break;
        node = node.next_sibling();
    }
}

std::string HomeIds::take(std::string id, const std::string& kind) {
    if (id.empty()) return numbered(kind);
    if (taken_.insert(id).second) return id;
    count_.try_emplace(id, 1);
    return numbered(id);
}

std::string HomeIds::numbered(const std::string& stem) {
    for (std::size_t& count = count_[stem];;) {
        std::string id = stem + "-" + std::to_string(++count);
        if (!given_.contains(id) && taken_.insert(id).second) return id;
    }
}

std::size_t Home::storey_for(const HomeElement& element, const std::string& level) {
    const auto found = storey_of.find(level);
    if (found != storey_of.end()) return found->second;
    if (storey_of.empty() && level.empty()) return 0;  // a home without levels is one storey
    std::size_t storey = 0;
    while (storey + 1 < plan.storeys.size() && plan.storeys[storey].elevation < 0) ++storey;
    const Storey& taken = plan.storeys[storey];
    report(finding_at(
        taken, "P161", Severity::Warning,
        "The " + element.label() +
            (level.empty() ? " names no level" : " names the level \"" + level + "\", which the file lacks") +
            "; it is placed on \"" + (taken.name.empty() ? taken.id : taken.name) + "\".",
        "Give it a level in Sweet Home 3D.", {element.node().name(), element.text("id"), element.text("name")}, {}));
    return storey;
}

std::optional<Point> point_of(const HomeElement& element, const char* x, const char* y) {
    const std::optional<double> right = element.metres(x, coordinate);
    const std::optional<double> down = element.metres(y, coordinate);
    if (!right || !down) return {};
    return Point{*right, *down == 0 ? 0 : -*down};
}

Finding finding_at(const Storey& storey, const char* code, Severity severity, std::string sentence, std::string hint,
                   const ElementRef& element, std::optional<Point> place) {
    Finding finding;
    finding.code = code;
    finding.severity = severity;
    finding.sentence = std::move(sentence);
    finding.hint = std::move(hint);
    if (place) finding.point = std::array<double, 3>{place->x, place->y, storey.elevation};
    finding.storey = storey.id;
    finding.elements.push_back(element);
    return finding;
}

std::string place_text(Point place) { return "(" + rounded_text(place.x, 2) + ", " + rounded_text(place.y, 2) + ")"; }

void read_levels(const HomeElement& element, Home& home) {
    home.wall_height = element.metres("wallHeight", positive_height, 2.5);
    std::vector<Level> levels;
    for (const pugi::xml_node node : element.node().children("level"))
        levels.push_back(read_level(element.child(node), home, levels.empty() ? nullptr : &levels.back().storey));
    if (levels.empty()) {
        Storey storey;
        storey.id = home.ids.take("", "level");
        storey.height = home.wall_height;
        storey.slab_thickness = 0.12;
        levels.push_back({storey, "", 0});
    }
    std::stable_sort(levels.begin(), levels.end(), [](const Level& a, const Level& b) {
        if (a.storey.elevation != b.storey.elevation) return a.storey.elevation < b.storey.elevation;
        return a.index != b.index ? a.index < b.index : a.storey.id < b.storey.id;
    });
    for (Level& level : levels) {
        if (!level.file_id.empty()) home.storey_of.emplace(level.file_id, home.plan.storeys.size());
        home.plan.storeys.push_back(std::move(level.storey));
    }
    home.openings.resize(home.plan.storeys.size());
    home.hidden.resize(home.plan.storeys.size());
    home.without_size.resize(home.plan.storeys.size());
}

void read_wall(const HomeElement& element, Home& home) {
    Storey& storey = home.plan.storeys[home.storey_for(element, element.text("level"))];
    Wall wall;
    wall.id = home.ids.take(element.text("id"), "wall");
    const std::optional<Point> start = point_of(element, "xStart", "yStart");
    const std::optional<Point> end = point_of(element, "xEnd", "yEnd");
    if (!start || !end) {
        home.report(finding_at(
            storey, "P162", Severity::Error,
            "The wall \"" + wall.id + "\" is left out: its two ends are not given as finite numbers.",
            "Delete the wall in Sweet Home 3D and draw it again.", {"wall", wall.id, ""}, start ? start : end));
        return;
    }
    wall.start = *start;
    wall.end = *end;
    // Positive arcs turn clockwise there, seen from above; counter-clockwise here.
    const double full_turn = std::nextafter(2 * std::numbers::pi, 0.0);
    wall.arc_extent = 0 - element.number("arcExtent", {-full_turn, full_turn}, 0);
    if (const double half = std::abs(wall.arc_extent) / 2;
        half > std::numbers::pi / 2 &&
        std::hypot(end->x - start->x, end->y - start->y) / (2 * std::sin(half)) > limits::thickness) {
        home.report(finding_at(storey, "P166", Severity::Warning,
                               "The wall \"" + wall.id + "\" is an arc of more than " +
                                   rounded_text(limits::thickness, 0) + " m radius; it is made straight.",
                               "Set its arc extent in Sweet Home 3D.", {"wall", wall.id, ""}, start));
        wall.arc_extent = 0;
    }
    wall.thickness = element.metres("thickness", positive_thickness, default_thickness);
    wall.height_at_start = element.metres("height", any_height, home.wall_height);
    wall.height_at_end = element.metres("heightAtEnd", any_height, wall.height_at_start);
    wall.left_colour = element.colour("leftSideColor");
    wall.right_colour = element.colour("rightSideColor");
    wall.left_texture = element.texture("leftSideTexture");
    wall.right_texture = element.texture("rightSideTexture");
    storey.walls.push_back(std::move(wall));
}

void read_room(const HomeElement& element, Home& home) {
    Storey& storey = home.plan.storeys[home.storey_for(element, element.text("level"))];
    Room room;
    room.id = home.ids.take(element.text("id"), "room");
    room.name = element.text("name");
    room.kind = room_kind(room.name);
    room.floor_colour = element.colour("floorColor");
    room.ceiling_colour = element.colour("ceilingColor");
    room.floor_texture = element.texture("floorTexture");
    room.ceiling_texture = element.texture("ceilingTexture");
    std::size_t unusable = 0;
    for (const pugi::xml_node node : element.node().children("point")) {
        if (const auto point = point_of(element.child(node), "x", "y")) room.polygon.push_back(*point);
        else ++unusable;
    }
    const ElementRef ref{"room", room.id, room.name};
    if (room.polygon.size() < 3) {
        home.report(finding_at(storey, "P163", Severity::Error,
                               "The " + element.label() + " is left out: it has fewer than three usable corners.",
                               "Draw the room again in Sweet Home 3D.", ref,
                               room.polygon.empty() ? std::nullopt : std::optional(room.polygon.front())));
        return;
    }
    if (unusable > 0)
        home.report(finding_at(storey, "P164", Severity::Warning,
                               "The " + element.label() + " has " + std::to_string(unusable) +
                                   " corners that are no finite numbers; the others are kept.",
                               "Draw the room again in Sweet Home 3D.", ref, room.polygon.front()));
    storey.rooms.push_back(std::move(room));
}

}  // namespace enfilade::plans

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <unordered_set>

#include "base/error.h"
#include "plans/json_fields.h"
#include "plans/limits.h"
#include "plans/number_text.h"
#include "plans/read.h"
#include "plans/rotation.h"

namespace enfilade::plans {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int format_version = 1;

constexpr Range any_height{0, limits::height};
constexpr Range positive_height{0, limits::height, true};
constexpr Range any_elevation{-limits::elevation, limits::elevation};
constexpr Range extent{0, limits::coordinate, true};
constexpr Range whole_turns{-64 * pi, 64 * pi};

/// Reads one plan; keeps the ids seen so far, with their places, to refuse the second use of one.
class PlanReader {
public:
    PlanReader(const JsonValue& root, JsonSource source) : root_(root), source_(std::move(source)) {}

    Plan read() {
        const Fields fields(root_, keys::plan, source_);
        read_unit(fields);
        check_version(fields);
        Plan plan;
        plan.name = fields.text("name", "");
        if (fields.has("ground_level")) plan.ground_level = fields.length("ground_level", any_elevation);
        if (fields.has("site_margin")) plan.site_margin = fields.length("site_margin", extent);
        (void)fields.at("storeys");
        for (const JsonValue& item : fields.list("storeys")) {
            const double floor = plan.storeys.empty() ? 0 : plan.storeys.back().elevation + plan.storeys.back().height;
            plan.storeys.push_back(read_storey(item, plan.storeys.empty(), floor, plan.storeys.size() + 1));
        }
        for (const JsonValue& item : fields.list("findings")) plan.findings.push_back(read_finding(item));
        return plan;
    }

private:
    void read_unit(const Fields& fields) {
        static constexpr std::pair<std::string_view, double> units[] = {
            {"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"ft", 0.3048}, {"in", 0.0254}};
        const std::string text = fields.text("units", "m");
        for (const auto& [name, metres] : units) {
            if (text != name) continue;
            source_.unit = metres;
            return;
        }
        refuse(source_, "P105", fields.at("units").place, "\"units\" must be \"m\", \"cm\", \"mm\", \"ft\" or \"in\".");
    }

    void check_version(const Fields& fields) {
        const double version = fields.number("format_version", {0, 1e6}, format_version);
        if (version != format_version)
            refuse(source_, "P105", fields.at("format_version").place,
                   "This program reads format_version 1 of the plan format; the file has another one.");
    }

    /// The element's id, or `<parent>/<kind>-<number>` where the file gives none.
    std::string read_id(const Fields& fields, const std::string& parent, const char* kind, std::size_t number) {
        const JsonValue* value = fields.find("id");
        std::string id = fields.text("id", parent + kind + "-" + std::to_string(number));
        const JsonPlace place = value != nullptr ? value->place : fields.place();
        if (id.empty()) refuse(source_, "P105", place, "An id must not be empty.");
        const auto [found, fresh] = ids_.emplace(id, place);
        if (!fresh)
            refuse(source_, "P106", place,
                   "The id \"" + id + "\" is used twice; its first use is in line " +
                       std::to_string(found->second.line) + ".");
        return id;
    }

    Storey read_storey(const JsonValue& value, bool lowest, double ceiling_below, std::size_t number) {
        const Fields fields(value, keys::storey, source_);
        Storey storey;
        storey.id = read_id(fields, "", "storey", number);
        storey.name = fields.text("name", "");
        storey.height = fields.length("height", positive_height, storey.height);
        storey.slab_thickness = fields.length("slab_thickness", any_height, storey.slab_thickness);
        storey.elevation =
            fields.length("elevation", any_elevation, lowest ? 0 : ceiling_below + storey.slab_thickness);
        const std::string parent = storey.id + "/";
        const auto read_list = [&](const char* key, auto& elements, auto read_element) {
            const JsonValue::Array& items = fields.list(key);
            elements.reserve(items.size());
            for (const JsonValue& item : items)
                elements.push_back((this->*read_element)(item, storey, elements.size() + 1));
        };
        read_list("walls", storey.walls, &PlanReader::read_wall);
        read_list("openings", storey.openings, &PlanReader::read_opening);
        check_hosts(fields.list("openings"), storey);
        read_list("rooms", storey.rooms, &PlanReader::read_room);
        read_list("columns", storey.columns, &PlanReader::read_column);
        read_list("stairs", storey.stairs, &PlanReader::read_stair);
        read_list("shafts", storey.shafts, &PlanReader::read_shaft);
        read_list("lights", storey.lights, &PlanReader::read_light);
        read_list("furniture", storey.furniture, &PlanReader::read_furniture);
        return storey;
    }

    std::optional<SurfaceTexture> read_texture(const JsonValue* value) {
        if (value == nullptr) return std::nullopt;
        const Fields fields(*value, keys::texture, source_);
        SurfaceTexture texture;
        texture.picture = fields.text("picture");
        texture.width = fields.length("width", {1e-3, 1e3});
        texture.height = fields.length("height", {1e-3, 1e3});
        texture.angle = fields.angle("angle", {-2 * pi, 2 * pi}, 0);
        if (fields.has("offset")) {
            const Point offset = fields.point("offset");  // of repeats: no unit of length
            texture.offset_x = offset.x / source_.unit;
            texture.offset_y = offset.y / source_.unit;
        }
        return texture;
    }

    Wall read_wall(const JsonValue& value, const Storey& storey, std::size_t number) {
        const Fields fields(value, keys::wall, source_);
        Wall wall;
        wall.id = read_id(fields, storey.id + "/", "wall", number);
        wall.name = fields.text("name", "");
        wall.start = fields.point("start");
        wall.end = fields.point("end");
        const double below_full_turn = std::nextafter(2 * pi, 0.0);
        wall.arc_extent = fields.angle("arc_extent", {-below_full_turn, below_full_turn}, 0);
        wall.thickness = fields.length("thickness", {0, limits::thickness, true}, wall.thickness);
        const double height = fields.length("height", any_height, storey.height);
        wall.height_at_start = fields.length("height_at_start", any_height, height);
        wall.height_at_end = fields.length("height_at_end", any_height, height);
        wall.left_colour = fields.colour("left_colour");
        wall.right_colour = fields.colour("right_colour");
        wall.left_texture = read_texture(fields.find("left_texture"));
        wall.right_texture = read_texture(fields.find("right_texture"));
        return wall;
    }

    Opening read_opening(const JsonValue& value, const Storey& storey, std::size_t number) {
        const Fields fields(value, keys::opening, source_);
        Opening opening;
        opening.id = read_id(fields, storey.id + "/", "opening", number);
        opening.name = fields.text("name", "");
        const std::string kind = fields.text("kind", "door");
        if (kind == "door") opening.kind = OpeningKind::Door;
        else if (kind == "window") opening.kind = OpeningKind::Window;
        else if (kind == "opening") opening.kind = OpeningKind::Opening;
        else
            refuse(source_, "P105", fields.at("kind").place,
                   "\"kind\" of an opening must be \"door\", \"window\" or \"opening\".");
        opening.wall = fields.text("wall");
        opening.offset = fields.length("offset", {-limits::coordinate, limits::coordinate});
        opening.width = fields.length("width", extent, opening.width);
        opening.sill = fields.length("sill", any_height, opening.kind == OpeningKind::Window ? 0.9 : 0);
        opening.head = fields.length("head", positive_height, std::min(opening.head, storey.height));
        opening.open_angle = fields.angle("open_angle", {-pi, pi}, opening.open_angle);
        opening.depth_left = fields.length("depth_left", {0, limits::thickness}, 0);
        opening.depth_right = fields.length("depth_right", {0, limits::thickness}, 0);
        if (!(opening.head > opening.sill))
            refuse(source_, "P105", value.place,
                   "The head of the opening \"" + opening.id + "\" must lie above its sill.");
        return opening;
    }

    void check_hosts(const JsonValue::Array& items, const Storey& storey) {
        std::unordered_set<std::string_view> walls;
        for (const Wall& wall : storey.walls) walls.insert(wall.id);
        for (std::size_t k = 0; k < items.size(); ++k) {
            const Opening& opening = storey.openings[k];
            if (walls.contains(opening.wall)) continue;
            std::string sentence = "The opening \"" + opening.id + "\" names the wall \"" + opening.wall +
                                   "\", but the storey \"" + storey.id + "\" has no such wall";
            const std::vector<std::string_view> known = walls.size() <= 10000
                                                            ? std::vector<std::string_view>(walls.begin(), walls.end())
                                                            : std::vector<std::string_view>();
            const auto near = nearest_word(opening.wall, sorted(known));
            sentence += near ? "; did you mean \"" + std::string(*near) + "\"?" : ".";
            refuse(source_, "P107", items[k].find("wall")->place, sentence);
        }
    }
    static std::vector<std::string_view> sorted(std::vector<std::string_view> words) {
        std::sort(words.begin(), words.end());
        return words;
    }

    Room read_room(const JsonValue& value, const Storey& storey, std::size_t number) {
        const Fields fields(value, keys::room, source_);
        Room room;
        room.id = read_id(fields, storey.id + "/", "room", number);
        room.name = fields.text("name", "");
        room.kind = fields.text("kind", room.kind);
        room.polygon = fields.points("polygon");
        room.floor_colour = fields.colour("floor_colour");
        room.ceiling_colour = fields.colour("ceiling_colour");
        room.floor_texture = read_texture(fields.find("floor_texture"));
        room.ceiling_texture = read_texture(fields.find("ceiling_texture"));
        return room;
    }

    std::vector<Point> read_outline(const Fields& fields) {
        const JsonValue* circle = fields.find("circle");
        if (circle == nullptr) return fields.points("polygon");
        if (fields.has("polygon"))
            refuse(source_, "P105", circle->place, "\"polygon\" and \"circle\" say the same thing; keep one.");
        return read_circle(*circle);
    }

    /// Corners on the circle, so many that no side strays more than 1 mm from it, by fours for symmetry.
    std::vector<Point> read_circle(const JsonValue& value) {
        const Fields fields(value, keys::circle, source_);
        const Point centre = fields.point("centre");
        const double radius = fields.length("radius", {0, limits::thickness, true});
        const double sagitta = std::min(1e-3, radius);
        const double fit = 4 * std::ceil(pi / std::acos(1 - sagitta / radius) / 4);
        const double sides = std::floor(fields.number("sides", {3, 1000}, std::clamp(fit, 12.0, 256.0)));
        std::vector<Point> corners;
        for (double k = 0; k < sides; ++k) {
            const double angle = 2 * pi * k / sides;
            corners.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
        }
        return corners;
    }

    Column read_column(const JsonValue& value, const Storey& storey, std::size_t number) {
        const Fields fields(value, keys::column, source_);
        Column column;
        column.id = read_id(fields, storey.id + "/", "column", number);
        column.name = fields.text("name", "");
        column.polygon = read_outline(fields);
        column.height = fields.length("height", any_height, 0);
        return column;
    }

    Stair read_stair(const JsonValue& value, const Storey& storey, std::size_t number) {
        const Fields fields(value, keys::stair, source_);
        Stair stair;
        stair.id = read_id(fields, storey.id + "/", "stair", number);
        stair.name = fields.text("name", "");
        stair.polygon = fields.points("polygon");
        return stair;
    }

    Shaft read_shaft(const JsonValue& value, const Storey& storey, std::size_t number) {
        const Fields fields(value, keys::shaft, source_);
        Shaft shaft;
        shaft.id = read_id(fields, storey.id + "/", "shaft", number);
        shaft.name = fields.text("name", "");
        shaft.polygon = read_outline(fields);
        return shaft;
    }

    /// In lumen, or in candela in every direction.
    double read_power(const Fields& fields, double fallback) {
        const JsonValue* candela = fields.find("intensity_candela");
        if (candela == nullptr) return fields.number("power_lumen", {0, limits::lumen}, fallback);
        if (fields.has("power_lumen"))
            refuse(source_, "P105", candela->place,
                   "\"power_lumen\" and \"intensity_candela\" say the same thing; keep one.");
        return 4 * pi * fields.number("intensity_candela", {0, limits::lumen / (4 * pi)});
    }

    Light read_light(const JsonValue& value, const Storey& storey, std::size_t number) {
        const Fields fields(value, keys::light, source_);
        Light light;
        light.id = read_id(fields, storey.id + "/", "light", number);
        light.name = fields.text("name", "");
        light.position = fields.point("position");
        light.elevation = fields.length("elevation", {-limits::height, limits::height}, light.elevation);
        if (const auto colour = fields.colour("colour")) light.colour = *colour;
        light.power_lumen = read_power(fields, light.power_lumen);
        light.radius = fields.length("radius", {0, limits::thickness}, light.radius);
        light.furniture = fields.text("furniture", "");
        return light;
    }

    Furniture read_furniture(const JsonValue& value, const Storey& storey, std::size_t number) {
        const Fields fields(value, keys::furniture, source_);
        Furniture piece;
        piece.id = read_id(fields, storey.id + "/", "furniture", number);
        piece.name = fields.text("name", "");
        piece.model = fields.text("model", "");
        piece.position = fields.point("position");
        piece.elevation = fields.length("elevation", {-limits::height, limits::height}, piece.elevation);
        piece.angle = fields.angle("angle", whole_turns, piece.angle);
        piece.width = fields.length("width", extent, piece.width);
        piece.depth = fields.length("depth", extent, piece.depth);
        piece.height = fields.length("height", extent, piece.height);
        piece.mirrored = fields.flag("mirrored", false);
        piece.colour = fields.colour("colour");
        piece.catalogue = fields.text("catalogue", "");
        if (fields.has("model_rotation")) piece.model_rotation = read_rotation(fields);
        if (fields.has("model_size")) piece.model_size = read_numbers<3>(fields, "model_size", extent, source_.unit);
        piece.pitch = fields.angle("pitch", whole_turns, 0);
        piece.roll = fields.angle("roll", whole_turns, 0);
        for (const JsonValue& item : fields.list("materials")) {
            const Fields material(item, keys::material, source_);
            const auto colour = material.colour("colour");
            piece.materials.push_back({material.text("name"), colour ? *colour : FurnitureMaterial{}.colour});
        }
        return piece;
    }

    /// n numbers in a row, in a range.
    template <std::size_t n>
    std::array<double, n> read_numbers(const Fields& fields, std::string_view key, Range range, double scale) {
        const JsonValue& value = fields.at(key);
        const std::string wanted = std::to_string(n) + " numbers, " + (range.low_open ? "more than " : "at least ") +
                                   number_text(range.low) + " and at most " + number_text(range.high);
        const JsonValue::Array* items = value.array();
        if (items == nullptr || items->size() != n) fields.wrong_kind(key, value, wanted.c_str());
        std::array<double, n> numbers{};
        for (std::size_t k = 0; k < n; ++k) {
            const double* number = (*items)[k].number();
            if (number == nullptr) fields.wrong_kind(key, (*items)[k], wanted.c_str());
            numbers[k] = *number * scale;
            const bool above = range.low_open ? numbers[k] > range.low : numbers[k] >= range.low;
            if (!above || !(numbers[k] <= range.high))
                refuse(source_, "P105", (*items)[k].place,
                       "\"" + std::string(key) + "\" of a piece of furniture must be " + wanted + ".");
        }
        return numbers;
    }

    std::array<double, 9> read_rotation(const Fields& fields) {
        const auto rows = read_numbers<9>(fields, "model_rotation", {-10, 10}, 1);
        if (!is_rotation(rows))
            refuse(source_, "P105", fields.at("model_rotation").place,
                   "\"model_rotation\" of a piece of furniture must hold three rows that turn its mesh: each of length "
                   "1, at right angles to each other.");
        return rows;
    }

    Finding read_finding(const JsonValue& value) {
        const Fields fields(value, keys::finding, source_);
        Finding finding;
        finding.code = fields.text("code");
        const std::string severity = fields.text("severity", "warning");
        if (severity == "note") finding.severity = Severity::Note;
        else if (severity == "warning") finding.severity = Severity::Warning;
        else if (severity == "error") finding.severity = Severity::Error;
        else
            refuse(source_, "P105", fields.at("severity").place,
                   "\"severity\" of a finding must be \"note\", \"warning\" or \"error\".");
        finding.sentence = fields.text("sentence");
        finding.hint = fields.text("hint", "");
        if (fields.has("point")) finding.point = read_place(fields);
        finding.storey = fields.text("storey", "");
        for (const JsonValue& item : fields.list("elements")) {
            const Fields element(item, keys::element, source_);
            finding.elements.push_back({element.text("kind"), element.text("id"), element.text("name", "")});
        }
        finding.moved_mm = fields.number("moved_mm", {0, 1e12}, 0);
        return finding;
    }

    std::array<double, 3> read_place(const Fields& fields) {
        const JsonValue& value = fields.at("point");
        std::array<double, 3> place{};
        const JsonValue::Array* items = value.array();
        if (items == nullptr || items->size() != 3) fields.wrong_kind("point", value, "a point [x, y, z]");
        for (std::size_t k = 0; k < 3; ++k) {
            const double* number = (*items)[k].number();
            if (number == nullptr) fields.wrong_kind("point", (*items)[k], "a point [x, y, z] of numbers");
            place[k] = *number * source_.unit;
        }
        return place;
    }

    const JsonValue& root_;
    JsonSource source_;
    std::unordered_map<std::string, JsonPlace> ids_;
};

}  // namespace

Plan read_json(std::string_view text, const std::string& file_name) {
    const JsonValue root = parse_json(text, file_name);
    return PlanReader(root, {file_name, 1}).read();
}

}  // namespace enfilade::plans

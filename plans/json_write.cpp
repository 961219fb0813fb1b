#include <cmath>
#include <type_traits>

#include "plans/number_text.h"
#include "plans/read.h"
#include "plans/utf8.h"

namespace enfilade::plans {
namespace {

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : to_utf8(text)) {
        switch (c) {
            case '"': out += "\\\""; break;
            case '\\': out += "\\\\"; break;
            case '\n': out += "\\n"; break;
            case '\r': out += "\\r"; break;
            case '\t': out += "\\t"; break;
            default:
                if (static_cast<unsigned char>(c) < 0x20) {
                    constexpr const char* digits = "0123456789abcdef";
                    const auto byte = static_cast<unsigned char>(c);
                    out += std::string("\\u00") + digits[byte >> 4] + digits[byte & 15];
                } else {
                    out += c;
                }
        }
    }
    return out + "\"";
}

std::string point_text(Point point) { return "[" + number_text(point.x) + ", " + number_text(point.y) + "]"; }

std::string polygon_text(const std::vector<Point>& polygon) {
    std::string out = "[";
    for (std::size_t k = 0; k < polygon.size(); ++k) out += (k == 0 ? "" : ", ") + point_text(polygon[k]);
    return out + "]";
}

std::string colour_text(const Colour& colour) {
    return "[" + number_text(colour[0]) + ", " + number_text(colour[1]) + ", " + number_text(colour[2]) + "]";
}

/// One element on one line: {"key": value, ...}.
class Line {
public:
    Line& raw(const char* key, const std::string& value) {
        text_ += (text_.empty() ? "" : ", ") + ("\"" + std::string(key) + "\": ") + value;
        return *this;
    }
    Line& text(const char* key, const std::string& value) { return raw(key, quoted(value)); }
    Line& text_unless_empty(const char* key, const std::string& value) {
        return value.empty() ? *this : text(key, value);
    }
    Line& number(const char* key, double value) { return raw(key, number_text(value)); }
    Line& number_unless(const char* key, double value, double usual) {
        return value == usual ? *this : number(key, value);
    }
    Line& colour(const char* key, const std::optional<Colour>& value) {
        return value ? raw(key, colour_text(*value)) : *this;
    }
    Line& texture(const char* key, const std::optional<SurfaceTexture>& value) {
        if (!value) return *this;
        Line inside;
        inside.text("picture", value->picture).number("width", value->width).number("height", value->height);
        inside.number_unless("angle", value->angle, 0);
        if (value->offset_x != 0 || value->offset_y != 0)
            inside.raw("offset", point_text({value->offset_x, value->offset_y}));
        return raw(key, inside.done());
    }
    [[nodiscard]] std::string done() const { return "{" + text_ + "}"; }

private:
    std::string text_;
};

template <std::size_t n>
std::string numbers_text(const std::array<double, n>& numbers) {
    std::string text;
    for (const double number : numbers) text += (text.empty() ? "[" : ", ") + number_text(number);
    return text + "]";
}

template <class Element>
Line begin(const Element& element) {
    Line line;
    line.text("id", element.id).text_unless_empty("name", element.name);
    return line;
}

std::string write_element(const Wall& wall) {
    Line line = begin(wall);
    line.raw("start", point_text(wall.start)).raw("end", point_text(wall.end));
    line.number_unless("arc_extent", wall.arc_extent, 0).number("thickness", wall.thickness);
    if (wall.height_at_start == wall.height_at_end) line.number("height", wall.height_at_start);
    else line.number("height_at_start", wall.height_at_start).number("height_at_end", wall.height_at_end);
    line.colour("left_colour", wall.left_colour).colour("right_colour", wall.right_colour);
    return line.texture("left_texture", wall.left_texture).texture("right_texture", wall.right_texture).done();
}

std::string write_element(const Opening& opening) {
    static constexpr const char* kinds[] = {"door", "window", "opening"};
    return begin(opening)
        .text("kind", kinds[static_cast<int>(opening.kind)])
        .text("wall", opening.wall)
        .number("offset", opening.offset)
        .number("width", opening.width)
        .number("sill", opening.sill)
        .number("head", opening.head)
        .number_unless("open_angle", opening.open_angle, Opening{}.open_angle)
        .number_unless("depth_left", opening.depth_left, 0)
        .number_unless("depth_right", opening.depth_right, 0)
        .done();
}

std::string write_element(const Room& room) {
    return begin(room)
        .text("kind", room.kind)
        .raw("polygon", polygon_text(room.polygon))
        .colour("floor_colour", room.floor_colour)
        .colour("ceiling_colour", room.ceiling_colour)
        .texture("floor_texture", room.floor_texture)
        .texture("ceiling_texture", room.ceiling_texture)
        .done();
}

std::string write_element(const Column& column) {
    return begin(column).raw("polygon", polygon_text(column.polygon)).number_unless("height", column.height, 0).done();
}

std::string write_element(const Stair& stair) {
    return begin(stair).raw("polygon", polygon_text(stair.polygon)).done();
}

std::string write_element(const Shaft& shaft) {
    return begin(shaft).raw("polygon", polygon_text(shaft.polygon)).done();
}

std::string write_element(const Light& light) {
    return begin(light)
        .raw("position", point_text(light.position))
        .number("elevation", light.elevation)
        .raw("colour", colour_text(light.colour))
        .number("power_lumen", light.power_lumen)
        .number_unless("radius", light.radius, 0)
        .text_unless_empty("furniture", light.furniture)
        .done();
}

std::string write_element(const Furniture& piece) {
    Line line = begin(piece);
    line.text_unless_empty("model", piece.model)
        .raw("position", point_text(piece.position))
        .number_unless("elevation", piece.elevation, 0)
        .number_unless("angle", piece.angle, 0)
        .number("width", piece.width)
        .number("depth", piece.depth)
        .number("height", piece.height);
    if (piece.mirrored) line.raw("mirrored", "true");
    line.colour("colour", piece.colour).text_unless_empty("catalogue", piece.catalogue);
    if (piece.model_rotation) line.raw("model_rotation", numbers_text(*piece.model_rotation));
    if (piece.model_size) line.raw("model_size", numbers_text(*piece.model_size));
    line.number_unless("pitch", piece.pitch, 0).number_unless("roll", piece.roll, 0);
    if (piece.materials.empty()) return line.done();
    std::string materials;
    for (const FurnitureMaterial& material : piece.materials)
        materials += (materials.empty() ? "" : ", ") +
                     Line().text("name", material.name).raw("colour", colour_text(material.colour)).done();
    return line.raw("materials", "[" + materials + "]").done();
}

std::string write_element(const Finding& finding) {
    Line line;
    line.text("code", finding.code).text("severity", name_of(finding.severity)).text("sentence", finding.sentence);
    line.text_unless_empty("hint", finding.hint);
    if (finding.point) {
        const auto& [x, y, z] = *finding.point;
        if (std::isfinite(x) && std::isfinite(y) && std::isfinite(z))
            line.raw("point", "[" + number_text(x) + ", " + number_text(y) + ", " + number_text(z) + "]");
    }
    line.text_unless_empty("storey", finding.storey);
    if (!finding.elements.empty()) {
        std::string elements;
        for (const ElementRef& element : finding.elements) {
            const Line named =
                Line().text("kind", element.kind).text("id", element.id).text_unless_empty("name", element.name);
            elements += (elements.empty() ? "" : ", ") + named.done();
        }
        line.raw("elements", "[" + elements + "]");
    }
    return line.number_unless("moved_mm", finding.moved_mm, 0).done();
}

template <class Element>
void write_list(std::string& out, const char* key, const std::vector<Element>& elements, const std::string& indent) {
    if (elements.empty()) return;
    out += ",\n" + indent + "\"" + key + "\": [";
    for (std::size_t k = 0; k < elements.size(); ++k) {
        out += (k == 0 ? "\n" : ",\n") + indent + "  ";
        out += write_element(elements[k]);
    }
    out += "\n" + indent + "]";
}

void write_storey(std::string& out, const Storey& storey) {
    const std::string indent = "      ";
    out += "    {\n" + indent + "\"id\": " + quoted(storey.id);
    const auto add = [&](const char* key, const std::string& value) {
        out += ",\n" + indent + "\"" + key + "\": " + value;
    };
    if (!storey.name.empty()) add("name", quoted(storey.name));
    add("elevation", number_text(storey.elevation));
    add("height", number_text(storey.height));
    add("slab_thickness", number_text(storey.slab_thickness));
    write_list(out, "walls", storey.walls, indent);
    write_list(out, "openings", storey.openings, indent);
    write_list(out, "rooms", storey.rooms, indent);
    write_list(out, "columns", storey.columns, indent);
    write_list(out, "stairs", storey.stairs, indent);
    write_list(out, "shafts", storey.shafts, indent);
    write_list(out, "lights", storey.lights, indent);
    write_list(out, "furniture", storey.furniture, indent);
    out += "\n    }";
}

}  // namespace

std::string write_json(const Plan& plan) {
    std::string out = "{\n  \"format_version\": 1";
    if (!plan.name.empty()) out += ",\n  \"name\": " + quoted(plan.name);
    if (plan.ground_level) out += ",\n  \"ground_level\": " + number_text(*plan.ground_level);
    if (plan.site_margin) out += ",\n  \"site_margin\": " + number_text(*plan.site_margin);
    out += ",\n  \"storeys\": [";
    for (std::size_t k = 0; k < plan.storeys.size(); ++k) {
        out += k == 0 ? "\n" : ",\n";
        write_storey(out, plan.storeys[k]);
    }
    out += plan.storeys.empty() ? "]" : "\n  ]";
    write_list(out, "findings", plan.findings, "  ");
    out += "\n}\n";
    return out;
}

}  // namespace enfilade::plans

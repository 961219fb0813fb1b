#include <cmath>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "modeler/lighting/lamp_keys.h"
#include "modeler/lighting/lamp_rules.h"
#include "plans/json_fields.h"

namespace enfilade::modeler {
namespace {

using plans::Fields;
using plans::JsonValue;

constexpr plans::Range kelvins{1667, 25000};
constexpr plans::Range lumens{0, 1e6};
constexpr plans::Range radii{0, 10};
constexpr double most_lamps = 1e6;

class LampRuleReader {
public:
    explicit LampRuleReader(const std::string& file) : source_{file, 1} {}

    LampRules read(const JsonValue& root) const {
        const Fields fields(root, keys::lamp_rules, source_);
        LampRules rules = own_lamp_rules();
        rules.source = source_.file;
        if (fields.number("format_version", {0, 1e6}, 1) != 1)
            refuse(fields.at("format_version"),
                   "This program reads format_version 1 of lamp rules; the file has another.");
        rules.utilisation = fields.number("utilisation", {0, 1, true}, rules.utilisation);
        rules.count = read_count(fields);
        rules.replace = fields.flag("replace", rules.replace);
        if (fields.has("rooms")) {
            rules.rooms.clear();
            for (const JsonValue& item : fields.list("rooms")) add(item, read_room(item), rules.rooms);
        }
        if (fields.has("pieces")) {
            rules.pieces.clear();
            for (const JsonValue& item : fields.list("pieces")) add(item, read_piece(item), rules.pieces);
        }
        if (const JsonValue* outdoor = fields.find("outdoor")) read_outdoor(*outdoor, rules.outdoor);
        return rules;
    }

private:
    [[noreturn]] void refuse(const JsonValue& at, const std::string& sentence) const {
        plans::refuse(source_, "P105", at.place, sentence);
    }

    std::uint32_t read_count(const Fields& fields) const {
        const double count = fields.number("count", {0, most_lamps}, 0);
        if (count != std::floor(count)) refuse(fields.at("count"), "\"count\" must be a whole number.");
        return std::uint32_t(count);
    }

    template <class Rule>
    void add(const JsonValue& at, Rule rule, std::vector<Rule>& to) const {
        if (rule.kind.empty()) refuse(at, "\"kind\" must be a text that is not empty.");
        for (const Rule& other : to)
            if (other.kind == rule.kind)
                refuse(at, "The kind \"" + rule.kind.substr(0, 80) + "\" is told twice; keep one of them.");
        to.push_back(std::move(rule));
    }

    RoomLight read_room(const JsonValue& value) const {
        const Fields fields(value, keys::room_light, source_);
        RoomLight room;
        room.kind = fields.text("kind");
        room.lux = fields.number("lux", {0, 1e5}, room.lux);
        room.area = fields.number("area", {0.01, 1e6}, room.area);
        room.drop = fields.length("drop", {0.001, 100}, room.drop);
        room.kelvin = fields.number("kelvin", kelvins, room.kelvin);
        room.radius = fields.length("radius", radii, room.radius);
        return room;
    }

    PieceLight read_piece(const JsonValue& value) const {
        const Fields fields(value, keys::piece_light, source_);
        PieceLight piece;
        piece.kind = fields.text("kind");
        piece.lumen = fields.number("lumen", lumens, piece.lumen);
        piece.kelvin = fields.number("kelvin", kelvins, piece.kelvin);
        piece.radius = fields.length("radius", radii, piece.radius);
        piece.height = fields.number("height", {0, 1}, piece.height);
        piece.lights_room = fields.flag("lights_room", piece.lights_room);
        return piece;
    }

    void read_outdoor(const JsonValue& value, OutdoorLight& to) const {
        const Fields fields(value, keys::outdoor, source_);
        to.spacing = fields.length("spacing", {0, 1e6}, to.spacing);
        to.count = read_count(fields);
        to.elevation = fields.length("elevation", {0.01, 1000}, to.elevation);
        to.lumen = fields.number("lumen", lumens, to.lumen);
        to.kelvin = fields.number("kelvin", kelvins, to.kelvin);
        to.radius = fields.length("radius", radii, to.radius);
        to.entrance_lumen = fields.number("entrance_lumen", lumens, to.entrance_lumen);
    }

    plans::JsonSource source_;
};

}  // namespace

LampRules read_lamp_rules_text(std::string_view text, const std::string& file_name) {
    try {
        const JsonValue root = plans::parse_json(text, file_name);
        return LampRuleReader(file_name).read(root);
    } catch (const InputError& error) {
        // The JSON reader is the plans', its codes too: P101 ... P105 of plans are U101 ... U105 of rules.
        throw InputError("U" + error.code.substr(1), error.file, error.line, error.column, error.what());
    }
}

LampRules read_lamp_rules(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file))
        throw IoError("The lamp rule file \"" + file.string() + "\" cannot be read.");
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    return read_lamp_rules_text(text, file.string());
}

}  // namespace enfilade::modeler

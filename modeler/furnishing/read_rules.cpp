#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include "base/error.h"
#include "modeler/furnishing/rule_keys.h"
#include "modeler/furnishing/rules.h"
#include "plans/json_fields.h"

namespace enfilade::modeler {
namespace {

using plans::Fields;
using plans::JsonValue;

constexpr std::array relations = {Relation::AgainstWall, Relation::NearWindow, Relation::Middle, Relation::Rows,
                                  Relation::OnWall,      Relation::Ceiling,    Relation::Beside, Relation::InFront,
                                  Relation::Around,      Relation::OnTop,      Relation::Under,  Relation::Above,
                                  Relation::Opposite,    Relation::InRow};
bool is_relative(Relation relation) { return relation >= Relation::Beside; }

constexpr double most_objects = 1000;
constexpr int deepest = 6;

class RuleReader {
public:
    RuleReader(const JsonValue& root, const std::string& file) : root_(root), source_{file, 1} {}

    Rules read() {
        const Fields fields(root_, keys::rules, source_);
        Rules rules;
        rules.source = source_.file;
        if (fields.number("format_version", {0, 1e6}, 1) != 1)
            refuse(fields.at("format_version"), "This program reads format_version 1 of rules; the file has another.");
        rules.temperature = fields.number("temperature", {0, 100}, rules.temperature);
        for (const JsonValue& item : fields.list("kinds")) kinds_.push_back(read_kind(item));
        (void)fields.at("rooms");
        std::set<std::string> seen;
        for (const JsonValue& item : fields.list("rooms")) {
            rules.rooms.push_back(read_room(item));
            if (!seen.insert(rules.rooms.back().kind).second)
                refuse(item, "The room \"" + rules.rooms.back().kind + "\" has rules twice; keep one of them.");
        }
        rules.kinds = std::move(kinds_);
        return rules;
    }

private:
    [[noreturn]] void refuse(const JsonValue& at, const std::string& sentence) const {
        plans::refuse(source_, "P105", at.place, sentence);
    }

    std::string read_word(const JsonValue& value, const char* what) const {
        const std::string* text = value.string();
        if (text == nullptr || text->empty())
            plans::refuse(source_, "P103", value.place, std::string(what) + " must be a text that is not empty.");
        return *text;
    }

    std::vector<std::string> read_words(const Fields& fields, const char* key, const char* what) const {
        std::vector<std::string> words;
        const JsonValue* value = fields.find(key);
        if (value == nullptr) return words;
        if (const JsonValue::Array* list = value->array())
            for (const JsonValue& item : *list) words.push_back(read_word(item, what));
        else words.push_back(read_word(*value, what));
        return words;
    }

    KindRule read_kind(const JsonValue& value) {
        const Fields fields(value, keys::kind, source_);
        KindRule kind;
        kind.kind = read_word(fields.at("kind"), "\"kind\"");
        for (const KindRule& other : kinds_)
            if (other.kind == kind.kind)
                refuse(value, "The kind \"" + kind.kind + "\" is told twice; keep one of them.");
        read_clearance(fields, kind.clearance);
        read_score(fields, kind.score);
        return kind;
    }

    static void read_clearance(const Fields& fields, Clearance& to) {
        const plans::Range free{0, 5};
        to.front = fields.length("front", free, to.front);
        to.behind = fields.length("behind", free, to.behind);
        to.sides = fields.length("sides", free, to.sides);
        to.one_side = fields.length("one_side", free, to.one_side);
    }

    void read_score(const Fields& fields, ScoreWeights& to) const {
        const JsonValue* value = fields.find("score");
        if (value == nullptr) return;
        const Fields score(*value, keys::score, source_);
        const auto weight = [&](const char* key, double& at) { at = score.number(key, {-100, 100}, at); };
        weight("corner", to.corner);
        weight("window", to.window);
        weight("door", to.door);
        weight("wall_middle", to.wall_middle);
        weight("centre", to.centre);
        weight("open_front", to.open_front);
        weight("near", to.near);
        weight("facing", to.facing);
        weight("gap", to.gap);
    }

    RoomRules read_room(const JsonValue& value) {
        const Fields fields(value, keys::room, source_);
        RoomRules room;
        room.kind = read_word(fields.at("kind"), "\"kind\"");
        room.names = read_words(fields, "names", "A name");
        for (const JsonValue& item : fields.list("objects")) room.objects.push_back(read_object(item, 0));
        return room;
    }

    ObjectRule read_object(const JsonValue& value, int depth) {
        if (depth > deepest) refuse(value, "Objects that come with objects may be nested 6 deep at most.");
        const Fields fields(value, keys::object, source_);
        ObjectRule rule;
        (void)fields.at("object");
        rule.object = read_words(fields, "object", "An object");
        if (rule.object.empty()) refuse(fields.at("object"), "\"object\" must name a kind, or a list of them.");
        for (const KindRule& kind : kinds_)
            if (kind.kind == rule.object.front()) {
                rule.clearance = kind.clearance;
                rule.score = kind.score;
            }
        rule.place = read_relation(fields, depth);
        read_count(fields, rule);
        rule.probability = fields.number("probability", {0, 1}, 1);
        rule.least_area = fields.number("least_area", {0, 1e9}, 0);
        rule.most_area = fields.number("most_area", {0, 1e9}, rule.most_area);
        rule.gap = fields.length("gap", {0, 20}, default_gap(rule.place));
        rule.most_gap = fields.length("most_gap", {0, 20}, std::max(rule.gap, 4.0));
        if (rule.most_gap < rule.gap) refuse(fields.at("most_gap"), "\"most_gap\" must not be less than \"gap\".");
        rule.elevation = fields.length("elevation", {0, 100}, -1.0);
        rule.turned = fields.flag("turned", false);
        rule.needed = fields.flag("needed", false);
        if (rule.needed && depth == 0)
            refuse(fields.at("needed"), "Only objects that come \"with\" another can be needed by it.");
        rule.near = fields.text("near", "");
        rule.facing = fields.text("facing", "");
        rule.unless = fields.text("unless", "");
        read_clearance(fields, rule.clearance);
        read_score(fields, rule.score);
        for (const JsonValue& item : fields.list("with")) rule.with.push_back(read_object(item, depth + 1));
        return rule;
    }

    static double default_gap(Relation place) {
        switch (place) {
            case Relation::Beside: return 0.03;
            case Relation::Around: return 0.05;
            case Relation::InFront: return 0.1;
            case Relation::Opposite: return 1.5;
            case Relation::Above: return 0.25;
            default: return 0;
        }
    }

    Relation read_relation(const Fields& fields, int depth) const {
        const std::string text = fields.text("place", depth == 0 ? "against_wall" : "beside");
        std::vector<std::string_view> known;
        for (const Relation relation : relations) {
            if (name_of(relation) == text) {
                if (is_relative(relation) && depth == 0)
                    refuse(fields.at("place"), "\"" + text +
                                                   "\" is a place beside another object: write the rule into "
                                                   "the \"with\" of that object.");
                if (!is_relative(relation) && depth > 0)
                    refuse(fields.at("place"), "\"" + text +
                                                   "\" is a place in the room: an object in \"with\" needs one "
                                                   "relative to its object, as \"beside\" or \"on_top\".");
                return relation;
            }
            known.push_back(name_of(relation));
        }
        std::string sentence = "\"place\" knows no \"" + text.substr(0, 80) + "\"";
        if (const auto near = plans::nearest_word(text, known)) {
            sentence += "; did you mean \"" + std::string(*near) + "\"?";
        } else {
            sentence += "; it may be";
            for (const std::string_view word : known)
                sentence += (word == known.front() ? " " : ", ") + std::string(word);
            sentence += ".";
        }
        refuse(fields.at("place"), sentence);
    }

    void read_count(const Fields& fields, ObjectRule& rule) const {
        rule.per_area = fields.number("per_area", {0, 1e6, true}, 1e7);
        const bool by_area = fields.has("per_area");
        if (!by_area) rule.per_area = 0;
        if (by_area) rule.least = 0, rule.most = std::uint32_t(most_objects);
        const JsonValue* value = fields.find("count");
        if (value == nullptr) return;
        const auto whole = [&](const JsonValue& item) {
            const double* number = item.number();
            if (number == nullptr || *number < 0 || *number > most_objects || *number != std::floor(*number))
                refuse(item, "\"count\" must be a whole number from 0 to 1000, or two of them: [least, most].");
            return std::uint32_t(*number);
        };
        if (const JsonValue::Array* both = value->array()) {
            if (both->size() != 2) refuse(*value, "\"count\" must have two numbers: [least, most].");
            rule.least = whole((*both)[0]);
            rule.most = whole((*both)[1]);
            if (rule.least > rule.most) refuse(*value, "The first number of \"count\" must not be above the second.");
        } else {
            rule.least = rule.most = whole(*value);
        }
    }

    const JsonValue& root_;
    plans::JsonSource source_;
    std::vector<KindRule> kinds_;
};

}  // namespace

Rules read_rules_text(std::string_view text, const std::string& file_name) {
    try {
        const JsonValue root = plans::parse_json(text, file_name);
        return RuleReader(root, file_name).read();
    } catch (const InputError& error) {
        // The JSON reader is the plans', its codes too: P101 ... P105 of plans are U101 ... U105 of rules.
        throw InputError("U" + error.code.substr(1), error.file, error.line, error.column, error.what());
    }
}

Rules read_rules(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file))
        throw IoError("The rule file \"" + file.string() + "\" cannot be read.");
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    return read_rules_text(text, file.string());
}

}  // namespace enfilade::modeler

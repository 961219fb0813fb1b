#include "plans/json_fields.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/error.h"
#include "plans/colour.h"
#include "plans/limits.h"
#include "plans/number_text.h"

namespace enfilade::plans {
namespace {

std::string quoted(std::string_view key) { return "\"" + std::string(key) + "\""; }

std::string with_article(std::string_view object) {
    const bool vowel = std::string_view("aeiou").find(object.front()) != std::string_view::npos;
    return (vowel ? "an " : "a ") + std::string(object);
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({substituted, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

std::string range_text(Range range, const char* unit) {
    const std::string suffix = *unit == '\0' ? "" : std::string(" ") + unit;
    return (range.low_open ? "more than " : "at least ") + rounded_text(range.low, 6) + " and at most " +
           rounded_text(range.high, 6) + suffix;
}

std::optional<Colour> hex_colour(const std::string& text) {
    std::uint32_t rgb = 0;
    if (text.size() != 7 || text[0] != '#') return {};
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, rgb, 16);
    if (error != std::errc() || end != text.data() + 7) return {};
    return colour_from_rgb(rgb);
}

}  // namespace

void refuse(const JsonSource& source, const char* code, JsonPlace place, const std::string& sentence) {
    throw InputError(code, source.file, place.line, place.column, sentence);
}

std::optional<std::string_view> nearest_word(std::string_view word, std::span<const std::string_view> known) {
    std::optional<std::string_view> best;
    std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
    if (word.size() > 64) return {};
    for (const std::string_view candidate : known) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < best_distance) {
            best_distance = distance;
            best = candidate;
        }
    }
    return best;
}

Fields::Fields(const JsonValue& value, const JsonKeys& keys, const JsonSource& source)
    : value_(value), keys_(keys), source_(source) {
    const JsonValue::Object* members = value.object();
    if (members == nullptr)
        refuse(source, "P103", value.place,
               "This must be " + with_article(keys.object) + " object {...}, but is " + value.kind_name() + ".");
    for (const JsonMember& member : *members) {
        if (std::find(keys.keys.begin(), keys.keys.end(), member.key) != keys.keys.end()) continue;
        std::string sentence =
            "The key " + quoted(member.key.substr(0, 80)) + " is not known in " + with_article(keys.object);
        if (const auto near = nearest_word(member.key, keys.keys)) {
            sentence += "; did you mean " + quoted(*near) + "?";
        } else {
            sentence += "; it may have";
            for (const std::string_view key : keys.keys)
                sentence += (key == keys.keys.front() ? " " : ", ") + std::string(key);
            sentence += ".";
        }
        refuse(source, "P102", member.place, sentence);
    }
}

void Fields::wrong_kind(std::string_view key, const JsonValue& value, const char* wanted) const {
    refuse(source_, "P103", value.place,
           quoted(key) + " of " + with_article(keys_.object) + " must be " + wanted + ", but is " + value.kind_name() +
               ".");
}

const JsonValue& Fields::at(std::string_view key) const {
    const JsonValue* value = find(key);
    if (value == nullptr)
        refuse(source_, "P104", value_.place,
               "This " + std::string(keys_.object) + " lacks the key " + quoted(key) + ".");
    return *value;
}

std::string Fields::text(std::string_view key, std::optional<std::string> fallback) const {
    if (fallback && !has(key)) return *fallback;
    const JsonValue& value = at(key);
    const std::string* text = value.string();
    if (text == nullptr) wrong_kind(key, value, "a text");
    return *text;
}

double Fields::checked(std::string_view key, const JsonValue& value, Range range, double scale,
                       const char* unit) const {
    const double* number = value.number();
    if (number == nullptr) wrong_kind(key, value, "a number");
    const double scaled = *number * scale;
    const bool above = range.low_open ? scaled > range.low : scaled >= range.low;
    if (!(above && scaled <= range.high))  // so written, a NaN would fail too
        refuse(source_, "P105", value.place,
               quoted(key) + " of " + with_article(keys_.object) + " must be " + range_text(range, unit) + ", but is " +
                   number_text(scaled) + (*unit == '\0' ? "" : std::string(" ") + unit) + ".");
    return scaled;
}

double Fields::number(std::string_view key, Range range, std::optional<double> fallback) const {
    if (fallback && !has(key)) return *fallback;
    return checked(key, at(key), range, 1, "");
}

double Fields::length(std::string_view key, Range range, std::optional<double> fallback) const {
    if (fallback && !has(key)) return *fallback;
    return checked(key, at(key), range, source_.unit, "m");
}

double Fields::angle(std::string_view key, Range range, double fallback) const {
    const std::string in_degrees = std::string(key) + "_deg";
    const JsonValue* degrees = find(in_degrees);
    const JsonValue* radians = find(key);
    if (degrees != nullptr && radians != nullptr)
        refuse(source_, "P105", degrees->place,
               quoted(key) + " and " + quoted(in_degrees) + " say the same thing; keep one.");
    if (degrees != nullptr) return checked(in_degrees, *degrees, range, std::numbers::pi / 180, "radians");
    if (radians != nullptr) return checked(key, *radians, range, 1, "radians");
    return fallback;
}

bool Fields::flag(std::string_view key, bool fallback) const {
    const JsonValue* value = find(key);
    if (value == nullptr) return fallback;
    if (value->boolean() == nullptr) wrong_kind(key, *value, "true or false");
    return *value->boolean();
}

Point Fields::read_point(std::string_view key, const JsonValue& value) const {
    const JsonValue::Array* items = value.array();
    if (items == nullptr || items->size() != 2) wrong_kind(key, value, "a point [x, y]");
    const Range range{-limits::coordinate, limits::coordinate};
    return {checked(key, (*items)[0], range, source_.unit, "m"), checked(key, (*items)[1], range, source_.unit, "m")};
}

Point Fields::point(std::string_view key) const { return read_point(key, at(key)); }

std::vector<Point> Fields::points(std::string_view key) const {
    const JsonValue& value = at(key);
    const JsonValue::Array* items = value.array();
    if (items == nullptr) wrong_kind(key, value, "a list of points [[x, y], ...]");
    std::vector<Point> points;
    points.reserve(items->size());
    for (const JsonValue& item : *items) points.push_back(read_point(key, item));
    return points;
}

std::optional<Colour> Fields::colour(std::string_view key) const {
    const JsonValue* value = find(key);
    if (value == nullptr) return {};
    if (const std::string* text = value->string())
        if (const auto colour = hex_colour(*text)) return colour;
    const JsonValue::Array* items = value->array();
    if (items == nullptr || items->size() != 3)
        wrong_kind(key, *value, "\"#rrggbb\" or a list of three numbers from 0 to 1");
    Colour colour{};
    for (std::size_t k = 0; k < 3; ++k) colour[k] = static_cast<float>(checked(key, (*items)[k], {0, 1}, 1, ""));
    return colour;
}

const JsonValue::Array& Fields::list(std::string_view key) const {
    static const JsonValue::Array empty;
    const JsonValue* value = find(key);
    if (value == nullptr) return empty;
    if (value->array() == nullptr) wrong_kind(key, *value, "a list [...]");
    return *value->array();
}

}  // namespace enfilade::plans

#include "plans/floorspace/entry.h"

#include <cmath>

#include "plans/number_text.h"

namespace enfilade::plans {
namespace {

std::string quoted(std::string_view key) { return "\"" + std::string(key) + "\""; }

}  // namespace

std::string one(std::string_view object) {
    const bool vowel = std::string_view("aeiou").find(object.front()) != std::string_view::npos;
    return (vowel ? "an " : "a ") + std::string(object);
}

FloorEntry::FloorEntry(const JsonValue& value, const char* object, const JsonSource& source)
    : value_(value), object_(object), source_(source) {
    if (value.object() == nullptr)
        fail("P103", value.place, "This must be " + one(object) + " object {...}, but is " + value.kind_name() + ".");
}

void FloorEntry::fail(const char* code, JsonPlace place, const std::string& sentence) const {
    refuse(source_, code, place, sentence);
}

void FloorEntry::wrong_kind(std::string_view key, const JsonValue& value, const char* wanted) const {
    fail("P103", value.place,
         quoted(key) + " of " + one(object_) + " must be " + wanted + ", but is " + value.kind_name() + ".");
}

const JsonValue* FloorEntry::find(std::string_view key) const {
    const JsonValue* value = value_.find(key);
    return value == nullptr || std::holds_alternative<std::monostate>(value->data) ? nullptr : value;
}

const JsonValue& FloorEntry::at(std::string_view key) const {
    const JsonValue* value = find(key);
    if (value == nullptr)
        fail("P104", value_.place, "This " + std::string(object_) + " lacks the key " + quoted(key) + ".");
    return *value;
}

std::string FloorEntry::text(std::string_view key) const {
    const JsonValue* value = find(key);
    if (value == nullptr) return {};
    if (value->string() == nullptr) wrong_kind(key, *value, "a text");
    return *value->string();
}

std::string FloorEntry::id_of(std::string_view key, const JsonValue& value) const {
    if (const std::string* text = value.string()) return *text;
    const double* number = value.number();
    if (number == nullptr || std::floor(*number) != *number || std::abs(*number) > 1e15)
        wrong_kind(key, value, "an id (a text or a whole number)");
    return number_text(*number);
}

std::string FloorEntry::id(std::string_view key) const { return id_of(key, at(key)); }

std::string FloorEntry::id_or_empty(std::string_view key) const {
    const JsonValue* value = find(key);
    return value == nullptr ? std::string() : id_of(key, *value);
}

double FloorEntry::number_of(std::string_view key, const JsonValue& value, Range range, double scale,
                             const char* unit) const {
    const double* number = value.number();
    if (number == nullptr) wrong_kind(key, value, "a number");
    const double scaled = *number * scale;
    if (!(scaled >= range.low && scaled <= range.high)) {
        const std::string suffix = *unit == '\0' ? "" : std::string(" ") + unit;
        fail("P105", value.place,
             quoted(key) + " of " + one(object_) + " must be at least " + rounded_text(range.low, 6) + " and at most " +
                 rounded_text(range.high, 6) + suffix + ", but is " + number_text(scaled) + suffix + ".");
    }
    return scaled;
}

std::optional<double> FloorEntry::number(std::string_view key, Range range) const {
    const JsonValue* value = find(key);
    if (value == nullptr) return {};
    return number_of(key, *value, range);
}

std::optional<double> FloorEntry::length(std::string_view key, Range range) const {
    const JsonValue* value = find(key);
    if (value == nullptr) return {};
    return number_of(key, *value, range, source_.unit, "m");
}

bool FloorEntry::flag(std::string_view key) const {
    const JsonValue* value = find(key);
    if (value == nullptr) return false;
    if (value->boolean() == nullptr) wrong_kind(key, *value, "true or false");
    return *value->boolean();
}

const JsonValue::Array& FloorEntry::list(std::string_view key) const {
    static const JsonValue::Array empty;
    const JsonValue* value = find(key);
    if (value == nullptr) return empty;
    if (value->array() == nullptr) wrong_kind(key, *value, "a list [...]");
    return *value->array();
}

std::vector<std::string> FloorEntry::ids(std::string_view key) const {
    std::vector<std::string> ids;
    for (const JsonValue& item : list(key)) ids.push_back(id_of(key, item));
    return ids;
}

}  // namespace enfilade::plans

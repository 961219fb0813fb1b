#pragma once
// The members of one JSON object, read with their kind, unit and range; what does not fit is refused with its place.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plans/json_keys.h"
#include "plans/json_value.h"
#include "plans/plan.h"

namespace enfilade::plans {

/// The text being read: its name for complaints, its unit of length in metres.
struct JsonSource {
    std::string file;
    double unit = 1;
};

[[noreturn]] void refuse(const JsonSource& source, const char* code, JsonPlace place, const std::string& sentence);

/// Bounds of a number, in the unit of the plan model (metres, radians).
struct Range {
    double low;
    double high;
    bool low_open = false;  ///< `low` itself is refused
};

class Fields {
public:
    /// Throws InputError P103 where `value` is no object, P102 where it has a key that is not in `keys`.
    Fields(const JsonValue& value, const JsonKeys& keys, const JsonSource& source);

    [[nodiscard]] const JsonValue* find(std::string_view key) const { return value_.find(key); }
    [[nodiscard]] bool has(std::string_view key) const { return find(key) != nullptr; }
    [[nodiscard]] JsonPlace place() const { return value_.place; }
    /// Throws InputError P104 where the key is missing.
    [[nodiscard]] const JsonValue& at(std::string_view key) const;

    // Each returns the fallback where the key is missing, and throws P104 where there is no fallback either,
    // P103 for another kind of value, P105 out of range.
    [[nodiscard]] std::string text(std::string_view key, std::optional<std::string> fallback = {}) const;
    [[nodiscard]] double number(std::string_view key, Range range, std::optional<double> fallback = {}) const;
    [[nodiscard]] double length(std::string_view key, Range range, std::optional<double> fallback = {}) const;
    /// In radians under `key`, or in degrees under `key` + "_deg"; both at once are refused.
    [[nodiscard]] double angle(std::string_view key, Range range, double fallback) const;
    [[nodiscard]] bool flag(std::string_view key, bool fallback) const;
    [[nodiscard]] Point point(std::string_view key) const;
    [[nodiscard]] std::vector<Point> points(std::string_view key) const;
    /// Linear [r, g, b], or sRGB "#rrggbb".
    [[nodiscard]] std::optional<Colour> colour(std::string_view key) const;
    /// The items of a list; none where the key is missing.
    [[nodiscard]] const JsonValue::Array& list(std::string_view key) const;

    [[noreturn]] void wrong_kind(std::string_view key, const JsonValue& value, const char* wanted) const;

private:
    [[nodiscard]] double checked(std::string_view key, const JsonValue& value, Range range, double scale,
                                 const char* unit) const;
    [[nodiscard]] Point read_point(std::string_view key, const JsonValue& value) const;

    const JsonValue& value_;
    const JsonKeys& keys_;
    const JsonSource& source_;
};

/// The entry of `known` that is spelled most like `word`, or nothing where none is near.
[[nodiscard]] std::optional<std::string_view> nearest_word(std::string_view word,
                                                           std::span<const std::string_view> known);

}  // namespace enfilade::plans

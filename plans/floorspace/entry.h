#pragma once
// The members of one object of a FloorspaceJS file: null counts as missing, keys that say nothing here are passed over.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plans/json_fields.h"

namespace enfilade::plans {

/// Unlike `Fields`, which reads our own format and refuses what it does not know.
class FloorEntry {
public:
    /// `object`: what the thing is called in sentences. Throws InputError P103 where `value` is no object.
    FloorEntry(const JsonValue& value, const char* object, const JsonSource& source);

    [[nodiscard]] JsonPlace place() const { return value_.place; }
    /// The member, or nullptr where it is missing or null.
    [[nodiscard]] const JsonValue* find(std::string_view key) const;
    /// Throws InputError P104 where it is missing or null.
    [[nodiscard]] const JsonValue& at(std::string_view key) const;

    // Each throws P103 for another kind of value, P105 out of range, with line and column.
    [[nodiscard]] std::string text(std::string_view key) const;  ///< empty where missing
    /// A text, or a whole number as text: old files have numbers for ids. Throws P104 where it is missing.
    [[nodiscard]] std::string id(std::string_view key) const;
    [[nodiscard]] std::string id_or_empty(std::string_view key) const;
    [[nodiscard]] std::optional<double> number(std::string_view key, Range range) const;
    /// In metres; `range` too.
    [[nodiscard]] std::optional<double> length(std::string_view key, Range range) const;
    [[nodiscard]] bool flag(std::string_view key) const;  ///< false where missing
    /// The items of a list; none where it is missing.
    [[nodiscard]] const JsonValue::Array& list(std::string_view key) const;
    [[nodiscard]] std::vector<std::string> ids(std::string_view key) const;

    [[nodiscard]] double number_of(std::string_view key, const JsonValue& value, Range range, double scale = 1,
                                   const char* unit = "") const;
    [[noreturn]] void wrong_kind(std::string_view key, const JsonValue& value, const char* wanted) const;
    [[noreturn]] void fail(const char* code, JsonPlace place, const std::string& sentence) const;

private:
    [[nodiscard]] std::string id_of(std::string_view key, const JsonValue& value) const;

    const JsonValue& value_;
    const char* object_;
    const JsonSource& source_;
};

/// "a story", "an edge".
[[nodiscard]] std::string one(std::string_view object);

}  // namespace enfilade::plans

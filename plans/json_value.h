#pragma once
// A JSON text as values that know their place, so that every complaint can name a line and a column.

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace enfilade::plans {

/// Line and column of a value in its text, both from 1; columns count code points.
struct JsonPlace {
    int line = 1;
    int column = 1;
};

struct JsonMember;

struct JsonValue {
    using Array = std::vector<JsonValue>;
    using Object = std::vector<JsonMember>;  ///< in the order of the text, no key twice

    std::variant<std::monostate, bool, double, std::string, Array, Object> data;
    JsonPlace place;

    [[nodiscard]] const bool* boolean() const { return std::get_if<bool>(&data); }
    [[nodiscard]] const double* number() const { return std::get_if<double>(&data); }
    [[nodiscard]] const std::string* string() const { return std::get_if<std::string>(&data); }
    [[nodiscard]] const Array* array() const { return std::get_if<Array>(&data); }
    [[nodiscard]] const Object* object() const { return std::get_if<Object>(&data); }
    /// "a number", "a text", ...: for sentences.
    [[nodiscard]] const char* kind_name() const;
    /// The member of an object, or nullptr.
    [[nodiscard]] const JsonValue* find(std::string_view key) const;
};

struct JsonMember {
    std::string key;
    JsonPlace place;  ///< of the key
    JsonValue value;
};

/// Parses RFC 8259 JSON plus `//` and `/* */` comments and a byte order mark. Nesting is bounded (64), texts are
/// checked to be UTF-8, numbers to be finite. Throws InputError P101 with line and column. Cost: linear.
[[nodiscard]] JsonValue parse_json(std::string_view text, const std::string& file_name);

}  // namespace enfilade::plans

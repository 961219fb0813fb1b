#pragma once
// Text of strangers inside a page: names, file names, sentences.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace enfilade::tools {

/// As content or as a quoted attribute of HTML and SVG: marks escaped, bytes that are no UTF-8 and control characters
/// replaced by U+FFFD.
[[nodiscard]] std::string escaped(std::string_view text);

/// JSON that may stand in a `<script>`: no `<`, so nothing in it ends the element.
[[nodiscard]] std::string script_json(const nlohmann::ordered_json& json);

/// With `digits` digits after the point.
[[nodiscard]] std::string decimal(double value, int digits);

/// "12.4 m²", "0.32 m²", "1,240 m²"
[[nodiscard]] std::string area_text(double square_metres);

}  // namespace enfilade::tools

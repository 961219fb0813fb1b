#pragma once
// Numbers of a DXF text, and a spelling of them that every locale reads alike.

#include <optional>
#include <string>
#include <string_view>

namespace enfilade::plans::dxf {

/// The number, blanks around it allowed, a comma taken for a point; nothing where the text is none, or one that is not
/// finite.
[[nodiscard]] std::optional<double> real_of(std::string_view text);

/// The whole number, cut to the range of 32 bits; nothing where the text is none. Digits after a point are ignored.
[[nodiscard]] std::optional<int> whole_of(std::string_view text);

/// Appends the number as digits and exponent without a point ("15e-1"): the same number in every locale.
void append_pointless(std::string& out, double value);

}  // namespace enfilade::plans::dxf

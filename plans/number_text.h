#pragma once
// Numbers as text, the same on every machine and in every locale.

#include <charconv>
#include <string>

namespace enfilade::plans {

/// The shortest text that reads back as the same number; no exponent where plain digits are as clear.
template <class Real>
[[nodiscard]] std::string number_text(Real value) {
    if (value == 0) return "0";  // -0 too
    char buffer[400];
    const Real size = value < 0 ? -value : value;
    const bool plain = size >= Real(1e-5) && size < Real(1e12);
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value,
                                      plain ? std::chars_format::fixed : std::chars_format::general);
    return std::string(buffer, result.ptr);
}

/// With at most `digits` digits after the point and no trailing zeros: for sentences.
[[nodiscard]] inline std::string rounded_text(double value, int digits) {
    char buffer[400];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, digits);
    std::string text(buffer, result.ptr);
    if (text.find('.') != std::string::npos) {
        while (text.back() == '0') text.pop_back();
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

}  // namespace enfilade::plans

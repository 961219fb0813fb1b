#include "plans/dxf/number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace enfilade::plans::dxf {
namespace {

std::string_view bare(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
    return text;
}

std::optional<double> parsed(std::string_view text) {
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ptr != text.data() + text.size() || text.empty()) return std::nullopt;
    // Too small for a double is 0; too large has no value.
    if (result.ec == std::errc::result_out_of_range) {
        const std::size_t exponent = text.find_first_of("eE");
        const bool tiny = exponent != std::string_view::npos && exponent + 1 < text.size() && text[exponent + 1] == '-';
        return tiny ? std::optional<double>(0) : std::nullopt;
    }
    if (result.ec != std::errc() || !std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace

std::optional<double> real_of(std::string_view text) {
    text = bare(text);
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) return parsed(text);
    std::string with_point(text);
    with_point[comma] = '.';
    return parsed(with_point);
}

std::optional<int> whole_of(std::string_view text) {
    const std::optional<double> value = real_of(text);
    if (!value) return std::nullopt;
    constexpr double low = std::numeric_limits<int>::min();
    constexpr double high = std::numeric_limits<int>::max();
    return static_cast<int>(std::clamp(std::trunc(*value), low, high));
}

void append_pointless(std::string& out, double value) {
    char buffer[64];
    const auto written = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific);
    const std::string_view text(buffer, static_cast<std::size_t>(written.ptr - buffer));
    const std::size_t mark = text.find('e');
    int exponent = 0;
    const char* const digits = text.data() + mark + (text[mark + 1] == '+' ? 2 : 1);
    std::from_chars(digits, text.data() + text.size(), exponent);
    const std::size_t point = text.substr(0, mark).find('.');
    if (point == std::string_view::npos) {
        out += text.substr(0, mark);
    } else {
        out += text.substr(0, point);
        out += text.substr(point + 1, mark - point - 1);
        exponent -= static_cast<int>(mark - point - 1);
    }
    if (exponent != 0) {
        out += 'e';
        out += std::to_string(exponent);
    }
}

}  // namespace enfilade::plans::dxf

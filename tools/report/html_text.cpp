#include "tools/report/html_text.h"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "plans/utf8.h"
#include "tools/console.h"

namespace enfilade::tools {

std::string escaped(std::string_view text) {
    std::string out;
    out.reserve(text.size() + 16);
    for (const char c : plans::to_utf8(text)) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            case '\'': out += "&#39;"; break;
            default:
                if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7F)
                    out += "\xEF\xBF\xBD";
                else out += c;
        }
    }
    return out;
}

std::string script_json(const nlohmann::ordered_json& json) {
    std::string out;
    for (const char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) {
        if (c == '<') out += "\\u003c";
        else out += c;
    }
    return out;
}

std::string decimal(double value, int digits) {
    char buffer[400];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, digits);
    return std::string(buffer, result.ptr);
}

std::string area_text(double square_metres) {
    if (square_metres >= 1000) return grouped(static_cast<unsigned long long>(std::llround(square_metres))) + " m²";
    return decimal(square_metres, square_metres < 1 ? 2 : square_metres < 100 ? 1 : 0) + " m²";
}

}  // namespace enfilade::tools

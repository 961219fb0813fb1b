#pragma once
// Text inside XML 1.0 documents.

#include <string>
#include <string_view>

#include "plans/utf8.h"

namespace enfilade::modeler {

/// `text` as character data or attribute value: markup is escaped, characters that XML 1.0 forbids are left out, and
/// bytes that are not UTF-8 become U+FFFD. Line breaks and tabs are kept as references, which attributes do not lose.
[[nodiscard]] inline std::string xml_text(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    const std::string clean = plans::to_utf8(text);
    for (std::size_t at = 0; at < clean.size(); ++at) {
        const char c = clean[at];
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            case '\t': out += "&#9;"; break;
            case '\n': out += "&#10;"; break;
            case '\r': out += "&#13;"; break;
            case '\xEF':
                // U+FFFE and U+FFFF are no characters of XML.
                if (clean.compare(at, 2, "\xEF\xBF") == 0 && static_cast<unsigned char>(clean[at + 2]) >= 0xBE) at += 2;
                else out += c;
                break;
            default:
                if (static_cast<unsigned char>(c) >= ' ') out += c;
        }
    }
    return out;
}

}  // namespace enfilade::modeler

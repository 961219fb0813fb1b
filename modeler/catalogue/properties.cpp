#include "modeler/catalogue/properties.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "plans/utf8.h"

namespace enfilade::modeler {
namespace {

bool is_utf8(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = plans::utf8_length(text, at);
        if (length == 0) return false;
        at += length;
    }
    return true;
}

void append_code_point(std::string& out, std::uint32_t code) {
    const auto byte = [&](std::uint32_t value) { out.push_back(static_cast<char>(value)); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) return byte(0xC0 | code >> 6), byte(0x80 | (code & 0x3F));
    if (code < 0x10000) return byte(0xE0 | code >> 12), byte(0x80 | (code >> 6 & 0x3F)), byte(0x80 | (code & 0x3F));
    byte(0xF0 | code >> 18), byte(0x80 | (code >> 12 & 0x3F)), byte(0x80 | (code >> 6 & 0x3F));
    byte(0x80 | (code & 0x3F));
}

std::string utf8_from_latin(std::string_view bytes) {
    std::string out;
    out.reserve(bytes.size());
    for (const char c : bytes) append_code_point(out, static_cast<unsigned char>(c));
    return out;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\f'; }

/// One line as Java means it: continued lines joined, blanks at the front of each dropped; escapes stand as they were.
class LogicalLines {
public:
    explicit LogicalLines(std::string_view text) : text_(text) {}

    bool next(std::string& line) {
        line.clear();
        while (at_ < text_.size()) {
            std::string_view natural = take_natural();
            if (natural.empty() || natural.front() == '#' || natural.front() == '!') continue;
            while (is_continued(natural)) {
                line.append(natural.substr(0, natural.size() - 1));
                if (at_ >= text_.size()) return true;
                natural = take_natural();
            }
            line.append(natural);
            return true;
        }
        return false;
    }

private:
    std::string_view take_natural() {
        const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
        std::string_view line = text_.substr(at_, end - at_);
        at_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
        while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
        return line;
    }

    static bool is_continued(std::string_view line) {
        std::size_t slashes = 0;
        while (slashes < line.size() && line[line.size() - 1 - slashes] == '\\') ++slashes;
        return slashes % 2 == 1;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

/// Four hexadecimal digits, or nothing.
bool read_unit(std::string_view text, std::uint32_t& unit) {
    if (text.size() < 4) return false;
    unit = 0;
    for (const char c : text.substr(0, 4)) {
        const int digit = c >= '0' && c <= '9'   ? c - '0'
                          : c >= 'a' && c <= 'f' ? c - 'a' + 10
                          : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                 : -1;
        if (digit < 0) return false;
        unit = unit << 4 | static_cast<std::uint32_t>(digit);
    }
    return true;
}

/// The code point of the four digits at `at` (behind a \u); two of them where they are a pair. `at` moves behind it.
std::uint32_t read_escaped_code(std::string_view text, std::size_t& at, std::uint32_t unit) {
    at += 4;
    std::uint32_t low = 0;
    if (unit < 0xD800 || unit > 0xDFFF) return unit;
    const bool is_pair = unit < 0xDC00 && text.substr(at, 2) == "\\u" && read_unit(text.substr(at + 2), low) &&
                         low >= 0xDC00 && low <= 0xDFFF;
    if (!is_pair) return 0xFFFD;
    at += 6;
    return 0x10000 + ((unit - 0xD800) << 10) + (low - 0xDC00);
}

std::string unescaped(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at++];
        if (c != '\\' || at == text.size()) {
            if (c != '\\') out.push_back(c);
            continue;
        }
        const char escaped = text[at++];
        std::uint32_t unit = 0;
        if (escaped == 'u' && read_unit(text.substr(at), unit))
            append_code_point(out, read_escaped_code(text, at, unit));
        else if (escaped == 't') out.push_back('\t');
        else if (escaped == 'n') out.push_back('\n');
        else if (escaped == 'r') out.push_back('\r');
        else if (escaped == 'f') out.push_back('\f');
        else out.push_back(escaped);
    }
    return out;
}

/// Where the key ends: at the first separator that no backslash hides.
std::size_t key_end(std::string_view line) {
    for (std::size_t at = 0; at < line.size(); ++at) {
        if (line[at] == '\\') ++at;
        else if (line[at] == '=' || line[at] == ':' || is_blank(line[at])) return at;
    }
    return line.size();
}

}  // namespace

std::map<std::string, std::string, std::less<>> read_properties(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    const std::string text = is_utf8(bytes) ? std::string(bytes) : utf8_from_latin(bytes);
    std::map<std::string, std::string, std::less<>> properties;
    LogicalLines lines(text);
    for (std::string line; lines.next(line);) {
        const std::size_t end = key_end(line);
        std::size_t value = end;
        while (value < line.size() && is_blank(line[value])) ++value;
        if (value < line.size() && (line[value] == '=' || line[value] == ':')) ++value;
        while (value < line.size() && is_blank(line[value])) ++value;
        const std::string_view view = line;
        properties.insert_or_assign(unescaped(view.substr(0, end)),
                                    unescaped(view.substr(std::min(value, view.size()))));
    }
    return properties;
}

}  // namespace enfilade::modeler

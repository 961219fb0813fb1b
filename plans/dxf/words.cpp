#include "plans/dxf/words.h"

#include <iconv.h>

#include <algorithm>
#include <cstdint>

#include "plans/utf8.h"

namespace enfilade::plans::dxf {
namespace {

iconv_t opened(void* converter) { return static_cast<iconv_t>(converter); }

bool all_digits(std::string_view text) {
    return !text.empty() && text.size() <= 5 && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// The name that iconv knows: "ANSI_1252" is CP1252, "dos850" is CP850, "ISO8859-1" is ISO-8859-1. Empty for what no
/// CAD program writes, for iconv knows more than a file should be able to ask for.
std::string iconv_name(std::string_view page) {
    std::string name;
    for (const char c : page.substr(0, 40)) {
        if (c >= 'a' && c <= 'z') name += static_cast<char>(c - 'a' + 'A');
        else if (c != '-' && c != '_' && c != ' ') name += c;
    }
    const std::string_view whole = name;
    for (const std::string_view prefix : {"ANSI", "DOS", "CP"})
        if (whole.starts_with(prefix) && all_digits(whole.substr(prefix.size())))
            return "CP" + std::string(whole.substr(prefix.size()));
    if (whole.starts_with("ISO8859") && all_digits(whole.substr(7))) return "ISO-8859-" + name.substr(7);
    if (name == "ASCII") return "CP1252";
    if (name == "MACROMAN" || name == "MACINTOSH") return "MACINTOSH";
    if (name == "UTF8") return "UTF-8";
    for (const char* known : {"BIG5", "GB2312", "JOHAB"})
        if (name == known) return name;
    return {};
}

void append_utf8(std::string& out, std::uint32_t code) {
    if (code == 0 || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) code = 0xFFFD;
    const auto byte = [&](std::uint32_t value) { out += static_cast<char>(value); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) {
        byte(0xC0 | code >> 6);
    } else if (code < 0x10000) {
        byte(0xE0 | code >> 12);
        byte(0x80 | (code >> 6 & 0x3F));
    } else {
        byte(0xF0 | code >> 18);
        byte(0x80 | (code >> 12 & 0x3F));
        byte(0x80 | (code >> 6 & 0x3F));
    }
    byte(0x80 | (code & 0x3F));
}

int digit_of(char c, int base) {
    const int value = c >= '0' && c <= '9'   ? c - '0'
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                             : 99;
    return value < base ? value : -1;
}

/// The number that `digits` characters at `at` spell, or -1.
std::int32_t number_at(std::string_view text, std::size_t at, std::size_t digits, int base) {
    if (at + digits > text.size()) return -1;
    std::int32_t value = 0;
    for (std::size_t k = 0; k < digits; ++k) {
        const int digit = digit_of(text[at + k], base);
        if (digit < 0) return -1;
        value = value * base + digit;
    }
    return value;
}

/// "\U+00DC" becomes its character, in pairs of surrogates too; "\M+1..." (a byte pair of some Asian page) is unknown.
std::string without_escapes(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        if (text.substr(at).starts_with("\\U+")) {
            const std::int32_t code = number_at(text, at + 3, 4, 16);
            if (code >= 0) {
                at += 7;
                const std::int32_t low = text.substr(at).starts_with("\\U+") ? number_at(text, at + 3, 4, 16) : -1;
                if (code >= 0xD800 && code < 0xDC00 && low >= 0xDC00 && low < 0xE000) {
                    append_utf8(out, 0x10000u + (static_cast<std::uint32_t>(code - 0xD800) << 10) +
                                         static_cast<std::uint32_t>(low - 0xDC00));
                    at += 7;
                } else {
                    append_utf8(out, static_cast<std::uint32_t>(code));
                }
                continue;
            }
        }
        if (text.substr(at).starts_with("\\M+") && number_at(text, at + 3, 5, 16) >= 0) {
            out += "\xEF\xBF\xBD";
            at += 8;
            continue;
        }
        out += text[at++];
    }
    return out;
}

/// "%%d", "%%065" and their like at `at`: what stands for them is appended. Their length, or 0.
std::size_t percent_code(std::string_view text, std::size_t at, std::string& out) {
    if (!text.substr(at).starts_with("%%") || at + 2 >= text.size()) return 0;
    const std::int32_t number = number_at(text, at + 2, 3, 10);
    if (number >= 0 && number < 256) {
        append_utf8(out, static_cast<std::uint32_t>(number));
        return 5;
    }
    switch (text[at + 2]) {
        case 'd':
        case 'D': out += "\xC2\xB0"; return 3;
        case 'p':
        case 'P': out += "\xC2\xB1"; return 3;
        case 'c':
        case 'C': out += "\xE2\x8C\x80"; return 3;  // the diameter sign
        case 'u':
        case 'U':
        case 'o':
        case 'O':
        case 'k':
        case 'K': return 3;
        case '%': out += '%'; return 3;
        default: return 0;
    }
}

/// "^I" is a tab, "^J" a new line, "^ " a caret. Their length, or 0.
std::size_t caret_code(std::string_view text, std::size_t at, std::string& out) {
    if (text[at] != '^' || at + 1 >= text.size()) return 0;
    const char next = text[at + 1];
    if (next == ' ') out += '^';
    else if (next == 'J') out += '\n';
    else if (next >= '@' && next <= '_') out += ' ';
    else return 0;
    return 2;
}

/// No control characters but new lines, no blanks around the text.
std::string tidy(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 && c != '\n') c = ' ';
    const std::size_t first = text.find_first_not_of(" \n");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \n") - first + 1);
}

/// A stacked fraction, from behind "\S" to its semicolon: "1/2", "1#2" and "1^2" are all 1/2.
std::size_t stacked(std::string_view text, std::size_t at, std::string& out) {
    while (at < text.size() && text[at] != ';') {
        if (text[at] == '\\' && at + 1 < text.size()) out += text[++at];
        else if (text[at] == '#' || text[at] == '^') out += '/';
        else out += text[at];
        ++at;
    }
    return at + 1;
}

/// What follows a backslash at `at - 1`; the place behind it.
std::size_t mtext_code(std::string_view text, std::size_t at, std::string& out) {
    switch (text[at]) {
        case 'P':
        case 'N':
        case 'X': out += '\n'; return at + 1;
        case '~': out += ' '; return at + 1;
        case '\\':
        case '{':
        case '}': out += text[at]; return at + 1;
        case 'L':
        case 'l':
        case 'O':
        case 'o':
        case 'K':
        case 'k': return at + 1;
        case 'S': return stacked(text, at + 1, out);
        case 'A':
        case 'C':
        case 'c':
        case 'F':
        case 'f':
        case 'H':
        case 'p':
        case 'Q':
        case 'T':
        case 'W': {
            const std::size_t end = text.find(';', at);
            return end == std::string_view::npos ? text.size() : end + 1;
        }
        default: out += '\\'; return at;
    }
}

}  // namespace

Words::~Words() { close(); }

void Words::close() {
    if (converter_ != nullptr) iconv_close(opened(converter_));
    converter_ = nullptr;
}

void Words::set_version(std::string_view version) { utf8_ = version.starts_with("AC") && version >= "AC1021"; }

bool Words::set_code_page(std::string_view name) {
    close();
    page_ = iconv_name(name);
    const iconv_t tried = page_.empty() ? iconv_t(-1) : iconv_open("UTF-8", page_.c_str());
    if (tried == iconv_t(-1)) {
        page_ = "CP1252";
        return utf8_;
    }
    iconv_close(tried);
    return true;
}

/// Bytes that the page lacks become U+FFFD, one each.
std::string Words::converted(std::string_view bytes) {
    if (converter_ == nullptr) {
        const iconv_t tried = iconv_open("UTF-8", page_.c_str());
        if (tried == iconv_t(-1)) return to_utf8(bytes);
        converter_ = tried;
    }
    iconv(opened(converter_), nullptr, nullptr, nullptr, nullptr);
    std::string in(bytes);
    std::string out(bytes.size() * 4 + 16, '\0');
    char* from = in.data();
    char* to = out.data();
    std::size_t left = in.size();
    std::size_t room = out.size();
    while (left > 0) {
        if (iconv(opened(converter_), &from, &left, &to, &room) != static_cast<std::size_t>(-1) || left == 0) break;
        if (room < 8) break;
        for (const char c : {'\xEF', '\xBF', '\xBD'}) *to++ = c;
        room -= 3;
        ++from;
        --left;
    }
    out.resize(static_cast<std::size_t>(to - out.data()));
    return to_utf8(out);
}

std::string Words::utf8(std::string_view bytes) {
    const bool ascii =
        std::none_of(bytes.begin(), bytes.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
    std::string text = ascii ? std::string(bytes) : utf8_ ? to_utf8(bytes) : converted(bytes);
    return text.find("\\U+") == std::string::npos && text.find("\\M+") == std::string::npos ? text
                                                                                            : without_escapes(text);
}

std::string shortened(const std::string& text, std::size_t most) {
    if (text.size() <= most) return text;
    std::size_t end = 0;
    for (std::size_t at = 0; at <= most; at += std::max<std::size_t>(utf8_length(text, at), 1)) end = at;
    return text.substr(0, end) + "...";
}

std::string plain_text(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t length = percent_code(text, at, out);
        if (length == 0) length = caret_code(text, at, out);
        if (length == 0) {
            out += text[at];
            length = 1;
        }
        at += length;
    }
    return tidy(std::move(out));
}

std::string plain_mtext(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == '\\' && at + 1 < text.size()) {
            at = mtext_code(text, at + 1, out);
            continue;
        }
        std::size_t length = percent_code(text, at, out);
        if (length == 0) length = caret_code(text, at, out);
        if (length == 0) {
            if (text[at] != '{' && text[at] != '}') out += text[at];
            length = 1;
        }
        at += length;
    }
    return tidy(std::move(out));
}

}  // namespace enfilade::plans::dxf

#include "modeler/meshes/json_cursor.h"

#include <algorithm>
#include <charconv>

#include "base/error.h"
#include "modeler/meshes/mesh_text.h"
#include "plans/utf8.h"

namespace enfilade::modeler {
namespace {

constexpr std::size_t max_depth = 512;

void append_code_point(std::string& out, std::uint32_t code) {
    const auto push = [&](std::uint32_t byte) { out += static_cast<char>(byte); };
    if (code < 0x80) return push(code);
    if (code < 0x800) {
        push(0xC0 | (code >> 6));
    } else if (code < 0x10000) {
        push(0xE0 | (code >> 12));
        push(0x80 | ((code >> 6) & 0x3F));
    } else {
        push(0xF0 | (code >> 18));
        push(0x80 | ((code >> 12) & 0x3F));
        push(0x80 | ((code >> 6) & 0x3F));
    }
    push(0x80 | (code & 0x3F));
}

}  // namespace

void JsonCursor::fail(const char* code, const std::string& sentence) const {
    MeshText(text_, file_).fail_at(at_, code, sentence);
}

char JsonCursor::peek() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\r' || text_[at_] == '\t'))
        ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
}

void JsonCursor::open(char bracket, const char* what, const char* kind) {
    if (peek() == '\0') fail("P808", "The text ends too early: is the file complete?");
    if (peek() != bracket) fail("P809", std::string(what) + " must be " + kind + ".");
    ++at_;
}

bool JsonCursor::closes(char bracket) {
    if (peek() != bracket) return false;
    ++at_;
    return true;
}

bool JsonCursor::continues(char bracket) {
    const char c = peek();
    if (c == '\0') fail("P808", "The text ends too early: is the file complete?");
    if (c != ',' && c != bracket) fail("P808", std::string("A ',' or '") + bracket + "' is expected here.");
    ++at_;
    return c == ',';
}

void JsonCursor::expect_colon() {
    if (peek() != ':') fail("P808", "A ':' is expected after a key.");
    ++at_;
}

std::string JsonCursor::string(const char* what) {
    if (peek() != '"') fail("P809", std::string(what) + " must be a text in double quotes.");
    ++at_;
    std::string out;
    for (;;) {
        if (at_ >= text_.size() || text_[at_] == '\n') fail("P808", "A text is not closed by a double quote.");
        const char c = text_[at_];
        if (c == '"') break;
        if (c == '\\') {
            append_escape(out);
            continue;
        }
        const std::size_t length = plans::utf8_length(text_, at_);
        if (length == 0) fail("P808", "This byte is not UTF-8; save the file with UTF-8 encoding.");
        out.append(text_, at_, length);
        at_ += length;
    }
    ++at_;
    return out;
}

void JsonCursor::append_escape(std::string& out) {
    static constexpr std::string_view letters = "\"\\/bfnrt", meant = "\"\\/\b\f\n\r\t";
    const char c = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
    if (const std::size_t k = letters.find(c); c != '\0' && k != std::string_view::npos) {
        out += meant[k];
        at_ += 2;
        return;
    }
    if (c != 'u') fail("P808", "This is no escape that JSON knows.");
    std::uint32_t code = hex4();
    if (code >= 0xD800 && code <= 0xDBFF && text_.substr(at_).starts_with("\\u")) {
        const std::uint32_t low = hex4();
        code = low >= 0xDC00 && low <= 0xDFFF ? 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00) : 0xD800;
    }
    if (code >= 0xD800 && code <= 0xDFFF) fail("P808", "This surrogate escape lacks its other half.");
    append_code_point(out, code);
}

std::uint32_t JsonCursor::hex4() {
    const std::string_view digits = text_.substr(at_, 6).substr(2);
    std::uint32_t code = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (digits.size() != 4 || error != std::errc() || end != digits.data() + 4)
        fail("P808", "Four hexadecimal digits must follow \\u.");
    at_ += 6;
    return code;
}

std::string_view JsonCursor::number_text(const char* what) {
    const char first = peek();
    std::size_t end = at_;
    while (end < text_.size() && std::string_view("+-.0123456789eE").find(text_[end]) != std::string_view::npos) ++end;
    if (end == at_ || first == '+' || first == '.' || first == 'e' || first == 'E')
        fail("P809", std::string(what) + " must be a number.");
    return text_.substr(at_, end - at_);
}

double JsonCursor::number(const char* what) {
    const std::string_view text = number_text(what);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument || end != text.data() + text.size())
        fail("P808", in_quotes(text) + " is no number.");
    const bool is_tiny = error == std::errc::result_out_of_range && text.find("e-") != std::string_view::npos;
    if (is_tiny) value = 0;
    else if (error != std::errc() || !is_coordinate(value))
        fail("P803", std::string(what) + " is " + in_quotes(text) + ": it must be below 1e12.");
    at_ += text.size();
    return value;
}

std::int64_t JsonCursor::integer(const char* what) {
    const std::string_view text = number_text(what);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        fail("P809", std::string(what) + " must be a whole number.");
    at_ += text.size();
    return value;
}

void JsonCursor::skip_string() {
    for (++at_; at_ < text_.size() && text_[at_] != '"' && text_[at_] != '\n'; ++at_)
        if (text_[at_] == '\\') ++at_;
    if (at_ >= text_.size() || text_[at_] != '"') fail("P808", "A text is not closed by a double quote.");
    ++at_;
}

void JsonCursor::skip() {
    std::string open;  // brackets not yet closed
    do {
        const char c = peek();
        if (c == '{' || c == '[') {
            open += c;
            if (open.size() > max_depth) fail("P808", "Values are nested more than 512 deep.");
            ++at_;
        } else if (c == '"') {
            skip_string();
        } else if (c == '}' || c == ']') {
            if (open.empty() || open.back() != (c == '}' ? '{' : '[')) fail("P808", "This bracket closes none.");
            open.pop_back();
            ++at_;
        } else if ((c == ',' || c == ':') && !open.empty()) {
            ++at_;
        } else {
            const std::size_t end = std::min(text_.find_first_of(",:]}[{\" \t\r\n", at_), text_.size());
            if (end == at_) fail("P808", "A value is expected here: is the file complete?");
            at_ = end;
        }
    } while (!open.empty());
}

}  // namespace enfilade::modeler

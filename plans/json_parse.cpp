#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "base/error.h"
#include "plans/json_value.h"
#include "plans/utf8.h"

namespace enfilade::plans {
namespace {

constexpr int max_depth = 64;
constexpr std::size_t max_members = 256;  // no object of ours has more keys; bounds the look for duplicates

bool is_digit(char c) { return c >= '0' && c <= '9'; }

void append_code_point(std::string& out, std::uint32_t code) {
    const auto push = [&](std::uint32_t byte) { out += static_cast<char>(byte); };
    if (code < 0x80) {
        push(code);
    } else if (code < 0x800) {
        push(0xC0 | (code >> 6));
        push(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        push(0xE0 | (code >> 12));
        push(0x80 | ((code >> 6) & 0x3F));
        push(0x80 | (code & 0x3F));
    } else {
        push(0xF0 | (code >> 18));
        push(0x80 | ((code >> 12) & 0x3F));
        push(0x80 | ((code >> 6) & 0x3F));
        push(0x80 | (code & 0x3F));
    }
}

class Parser {
public:
    Parser(std::string_view text, const std::string& file_name) : text_(text), file_(file_name) {}

    JsonValue document() {
        if (text_.starts_with("\xEF\xBB\xBF")) at_ = line_start_ = 3;
        skip_space();
        JsonValue value = parse_value(0);
        skip_space();
        if (!ended()) fail("Nothing may follow the closing bracket of the document, but " + here() + " stands here.");
        return value;
    }

private:
    [[nodiscard]] bool ended() const { return at_ >= text_.size(); }
    [[nodiscard]] char peek() const { return ended() ? '\0' : text_[at_]; }

    [[nodiscard]] JsonPlace place_of(std::size_t at) const {
        int column = 1;
        for (std::size_t k = line_start_; k < at; ++k)
            if ((static_cast<unsigned char>(text_[k]) & 0xC0u) != 0x80u) ++column;
        return {line_, column};
    }
    // Columns are counted from the last counted place of the same line, so that a plan on one line costs linear time.
    [[nodiscard]] JsonPlace place() {
        if (counted_line_start_ != line_start_ || counted_at_ > at_) {
            counted_line_start_ = counted_at_ = line_start_;
            counted_column_ = 1;
        }
        for (; counted_at_ < at_; ++counted_at_)
            if ((static_cast<unsigned char>(text_[counted_at_]) & 0xC0u) != 0x80u) ++counted_column_;
        return {line_, counted_column_};
    }

    [[noreturn]] void fail_at(std::size_t at, const std::string& sentence) const {
        const JsonPlace where = place_of(at);
        throw InputError("P101", file_, where.line, where.column, sentence);
    }
    [[noreturn]] void fail(const std::string& sentence) const { fail_at(at_, sentence); }

    /// What stands at the reading position, for a sentence.
    [[nodiscard]] std::string here() const {
        if (ended()) return "the end of the file";
        const auto c = static_cast<unsigned char>(text_[at_]);
        if (c < 0x20 || c == 0x7F) return "a control character";
        const std::size_t length = utf8_length(text_, at_);
        if (length == 0) return "a byte that is not UTF-8";
        return "'" + std::string(text_.substr(at_, length)) + "'";
    }

    void newline() {
        ++line_;
        line_start_ = at_;
    }

    void skip_space() {
        while (!ended()) {
            const char c = text_[at_];
            if (c == '\n') {
                ++at_;
                newline();
            } else if (c == ' ' || c == '\t' || c == '\r') {
                ++at_;
            } else if (c == '/') {
                skip_comment();
            } else {
                return;
            }
        }
    }

    void skip_comment() {
        const std::string_view rest = text_.substr(at_);
        if (rest.starts_with("//")) {
            while (!ended() && text_[at_] != '\n') ++at_;
        } else if (rest.starts_with("/*")) {
            const std::size_t close = text_.find("*/", at_ + 2);
            if (close == std::string_view::npos) fail("This comment is never closed by */.");
            while (at_ < close + 2)
                if (text_[at_++] == '\n') newline();
        } else {
            fail("A '/' begins a comment only as // or /*.");
        }
    }

    JsonValue parse_value(int depth) {
        if (depth > max_depth) fail("Values are nested more than " + std::to_string(max_depth) + " deep.");
        JsonValue value;
        value.place = place();
        switch (peek()) {
            case '{': value.data = parse_object(depth); break;
            case '[': value.data = parse_array(depth); break;
            case '"': value.data = parse_string(); break;
            default: parse_literal(value);
        }
        return value;
    }

    void parse_literal(JsonValue& value) {
        if (is_digit(peek()) || peek() == '-') {
            value.data = parse_number();
            return;
        }
        std::size_t end = at_;
        const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
        while (end < text_.size() && end - at_ < 40 && is_letter(text_[end])) ++end;
        const std::string_view word = text_.substr(at_, end - at_);
        if (word == "true" || word == "false") {
            value.data = word == "true";
        } else if (word == "NaN" || word == "Infinity") {
            fail(std::string(word) + " is not a number that a plan can hold.");
        } else if (word.empty()) {
            fail("A value is expected here, but " + here() + " stands here.");
        } else if (word != "null") {
            fail("A value is expected here; texts and keys need double quotes around them.");
        }
        at_ = end;
    }

    double parse_number() {
        const std::size_t begin = at_;
        if (peek() == '-') ++at_;
        if (!is_digit(peek())) fail_at(begin, "A minus sign must be followed by a number.");
        if (peek() == '0' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))
            fail_at(begin, "A number must not begin with a superfluous 0.");
        skip_digits();
        if (peek() == '.') {
            ++at_;
            if (!is_digit(peek())) fail_at(begin, "A digit must follow the decimal point.");
            skip_digits();
        }
        if (peek() == 'e' || peek() == 'E') {
            ++at_;
            if (peek() == '+' || peek() == '-') ++at_;
            if (!is_digit(peek())) fail_at(begin, "A digit must follow the exponent sign.");
            skip_digits();
        }
        double number = 0;
        const auto [end, error] = std::from_chars(text_.data() + begin, text_.data() + at_, number);
        if (error == std::errc::result_out_of_range) {
            // Too small is as good as zero; too large is no length.
            if (const std::string digits(text_.substr(begin, at_ - begin));
                std::abs(std::strtod(digits.c_str(), nullptr)) > 1)
                fail_at(begin, "The number " + digits.substr(0, 40) + " is too large.");
            number = 0;
        }
        return number;
    }
    void skip_digits() {
        while (is_digit(peek())) ++at_;
    }

    std::string parse_string() {
        const std::size_t begin = at_++;
        std::string out;
        for (;;) {
            if (ended() || text_[at_] == '\n')
                fail_at(begin, "This text is never closed by a double quote on its line.");
            const char c = text_[at_];
            if (c == '"') break;
            if (c == '\\') {
                parse_escape(out);
                continue;
            }
            if (static_cast<unsigned char>(c) < 0x20)
                fail("A control character in a text must be written as an escape.");
            const std::size_t length = utf8_length(text_, at_);
            if (length == 0) fail("This byte is not UTF-8; save the file with UTF-8 encoding.");
            out.append(text_, at_, length);
            at_ += length;
        }
        ++at_;
        return out;
    }

    void parse_escape(std::string& out) {
        const std::size_t begin = at_++;
        const char c = peek();
        ++at_;
        switch (c) {
            case '"': out += '"'; return;
            case '\\': out += '\\'; return;
            case '/': out += '/'; return;
            case 'b': out += '\b'; return;
            case 'f': out += '\f'; return;
            case 'n': out += '\n'; return;
            case 'r': out += '\r'; return;
            case 't': out += '\t'; return;
            case 'u': break;
            default: fail_at(begin, "This is no escape that JSON knows; a backslash itself is written twice.");
        }
        std::uint32_t code = parse_hex(begin);
        if (code >= 0xD800 && code <= 0xDBFF && text_.substr(at_).starts_with("\\u")) {
            at_ += 2;
            const std::uint32_t low = parse_hex(begin);
            if (low < 0xDC00 || low > 0xDFFF) fail_at(begin, "This surrogate escape lacks its second half.");
            code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
        } else if (code >= 0xD800 && code <= 0xDFFF) {
            fail_at(begin, "This surrogate escape stands alone.");
        }
        append_code_point(out, code);
    }

    std::uint32_t parse_hex(std::size_t begin) {
        std::uint32_t code = 0;
        const std::string_view digits = text_.substr(at_, 4);
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
        if (digits.size() != 4 || error != std::errc() || end != digits.data() + 4)
            fail_at(begin, "Four hexadecimal digits must follow \\u.");
        at_ += 4;
        return code;
    }

    JsonValue::Array parse_array(int depth) {
        JsonValue::Array items;
        ++at_;
        skip_space();
        if (peek() == ']') return ++at_, items;
        for (;;) {
            items.push_back(parse_value(depth + 1));
            skip_space();
            if (peek() == ']') break;
            if (peek() != ',') fail("A ',' or ']' is expected after this item, but " + here() + " stands here.");
            ++at_;
            skip_space();
            if (peek() == ']') fail("A list must not end with a comma.");
        }
        ++at_;
        return items;
    }

    JsonValue::Object parse_object(int depth) {
        JsonValue::Object members;
        ++at_;
        skip_space();
        if (peek() == '}') return ++at_, members;
        for (;;) {
            if (peek() != '"') fail("A key in double quotes is expected, but " + here() + " stands here.");
            JsonMember member;
            member.place = place();
            const std::size_t key_at = at_;
            member.key = parse_string();
            for (const JsonMember& other : members)
                if (other.key == member.key) fail_at(key_at, "The key \"" + member.key + "\" stands here twice.");
            if (members.size() >= max_members)
                fail_at(key_at, "An object has more than " + std::to_string(members.size()) + " keys.");
            skip_space();
            if (peek() != ':') fail("A ':' is expected after the key \"" + member.key + "\".");
            ++at_;
            skip_space();
            member.value = parse_value(depth + 1);
            members.push_back(std::move(member));
            skip_space();
            if (peek() == '}') break;
            if (peek() != ',') fail("A ',' or '}' is expected after this value, but " + here() + " stands here.");
            ++at_;
            skip_space();
            if (peek() == '}') fail("An object must not end with a comma.");
        }
        ++at_;
        return members;
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::size_t line_start_ = 0;
    std::size_t counted_line_start_ = 0;
    std::size_t counted_at_ = 0;
    int counted_column_ = 1;
};

}  // namespace

const char* JsonValue::kind_name() const {
    static constexpr const char* names[] = {"null", "true or false", "a number", "a text", "a list", "an object"};
    return names[data.index()];
}

const JsonValue* JsonValue::find(std::string_view key) const {
    if (const Object* members = object())
        for (const JsonMember& member : *members)
            if (member.key == key) return &member.value;
    return nullptr;
}

JsonValue parse_json(std::string_view text, const std::string& file_name) { return Parser(text, file_name).document(); }

}  // namespace enfilade::plans

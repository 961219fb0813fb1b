#include "modeler/meshes/mesh_text.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>

#include "base/error.h"
#include "plans/utf8.h"

namespace enfilade::modeler {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v' || c == '\0'; }
bool is_space(char c) { return is_blank(c) || c == '\n'; }

}  // namespace

std::string in_quotes(std::string_view text) {
    std::string out = plans::to_utf8(text.substr(0, 40));
    for (char& c : out)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
    return "\"" + out + (text.size() > 40 ? "...\"" : "\"");
}

bool MeshText::is_continued() const {
    if (!continuation_ || bytes_[at_] != '\\') return false;
    const std::size_t after = at_ + 1 < bytes_.size() && bytes_[at_ + 1] == '\r' ? at_ + 2 : at_ + 1;
    return after < bytes_.size() && bytes_[after] == '\n';
}

bool MeshText::next_in_line() {
    while (!ended()) {
        const char c = bytes_[at_];
        if (is_blank(c)) {
            ++at_;
        } else if (c == '\\' && is_continued()) {
            at_ = bytes_.find('\n', at_) + 1;
        } else if (c == '\n' || (comments_ && c == '#')) {
            return false;
        } else {
            return true;
        }
    }
    return false;
}

bool MeshText::next() {
    while (!next_in_line()) {
        if (ended()) return false;
        skip_line();
    }
    return true;
}

void MeshText::skip_line() {
    const std::size_t end = bytes_.find('\n', at_);
    at_ = end == std::string_view::npos ? bytes_.size() : end + 1;
}

std::string MeshText::rest_of_line() {
    next_in_line();
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    std::string_view rest = bytes_.substr(at_, end - at_);
    while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
    return plans::to_utf8(rest.substr(0, 200));
}

std::string_view MeshText::word() {
    token_ = at_;
    while (!ended() && !is_space(bytes_[at_]) && !(comments_ && bytes_[at_] == '#')) ++at_;
    return bytes_.substr(token_, at_ - token_);
}

double MeshText::coordinate() {
    std::string_view text = word();
    if (text.empty() && ended()) fail("P805", "The file ends where a number is expected: is it complete?");
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = error != std::errc::invalid_argument && end == text.data() + text.size();
    if (!is_number && tolerant_) return std::numeric_limits<double>::quiet_NaN();
    if (!is_number)
        fail("P802", text.empty() ? "A number is expected at the end of this line."
                                  : "A number is expected here, but " + in_quotes(text) + " stands here.");
    // Out of range is also what is too small to be told from 0.
    if (error == std::errc::result_out_of_range) value = std::strtod(std::string(text).c_str(), nullptr);
    if (!is_coordinate(value) && tolerant_) return std::numeric_limits<double>::quiet_NaN();
    if (!is_coordinate(value))
        fail("P803",
             "The coordinate " + in_quotes(text) + " is not a finite number below 1e12; export the mesh again.");
    return value;
}

std::int64_t MeshText::integer() {
    const std::string_view text = word();
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        fail("P802", text.empty() ? "A whole number is expected at the end of this line."
                                  : "A whole number is expected here, but " + in_quotes(text) + " stands here.");
    return value;
}

std::int64_t MeshText::integer_before(char stop, std::string_view* behind) {
    const std::string_view text = word();
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || (end != text.data() + text.size() && *end != stop))
        fail("P802", "A vertex number is expected here, but " + in_quotes(text) + " stands here.");
    if (behind != nullptr) {
        const auto read = static_cast<std::size_t>(end - text.data());
        *behind = text.substr(std::min(read + 1, text.size()));
    }
    return value;
}

void MeshText::fail(const char* code, const std::string& sentence) const { fail_at(token_, code, sentence); }

void MeshText::fail_at(std::size_t position, const char* code, const std::string& sentence) const {
    const std::string_view before = bytes_.substr(0, std::min(position, bytes_.size()));
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 == 0
    int column = 1;
    for (const char c : before.substr(line_start))
        if ((static_cast<unsigned char>(c) & 0xC0u) != 0x80u) ++column;
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    throw InputError(code, file_, static_cast<int>(line), column, sentence);
}

}  // namespace enfilade::modeler

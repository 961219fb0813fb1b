// The header of a .npy file: a magic word, a version, a length, and a dictionary as Python writes it.

#include <algorithm>
#include <cstdint>
#include <optional>

#include "base/error.h"
#include "tools/npy.h"

namespace enfilade::tools {
namespace {

constexpr std::string_view magic = "\x93NUMPY";

class HeaderParser {
public:
    HeaderParser(std::string_view text, std::size_t place, const std::string& file)
        : text_(text), place_(place), file_(file) {}

    NpyHeader parse() {
        NpyHeader header;
        bool has_descr = false, has_order = false, has_shape = false;
        expect('{');
        while (!take('}')) {
            const std::string key = string();
            expect(':');
            if (key == "descr" && !has_descr) {
                has_descr = true;
                header.descr = descr();
                if (header.descr == "[") return header;  // fields: not ours, whatever they are
            } else if (key == "fortran_order" && !has_order) {
                has_order = true;
                header.is_fortran = truth();
            } else if (key == "shape" && !has_shape) {
                has_shape = true;
                header.shape = shape();
            } else {
                refuse();
            }
            if (!take(',') && peek() != '}') refuse();
        }
        skip_space();
        if (at_ != text_.size() || !has_descr || !has_order || !has_shape) refuse();
        return header;
    }

private:
    [[noreturn]] void refuse() const {
        throw InputError("F140", file_,
                         "The header of the .npy file is damaged at byte " + std::to_string(place_ + at_) +
                             ": write the array again with numpy.save.");
    }
    void skip_space() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\t')) ++at_;
    }
    char peek() {
        skip_space();
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char c) {
        if (peek() != c) return false;
        ++at_;
        return true;
    }
    void expect(char c) {
        if (!take(c)) refuse();
    }
    std::string string() {
        const char quote = peek();
        if (quote != '\'' && quote != '"') refuse();
        const std::size_t end = text_.find(quote, ++at_);
        if (end == std::string_view::npos) refuse();
        const std::string word(text_.substr(at_, end - at_));
        at_ = end + 1;
        return word;
    }
    std::string descr() { return peek() == '[' ? "[" : string(); }
    bool truth() {
        skip_space();
        for (const std::string_view word : {"True", "False"})
            if (text_.substr(at_, word.size()) == word) {
                at_ += word.size();
                return word == "True";
            }
        refuse();
    }
    std::vector<std::uint64_t> shape() {
        std::vector<std::uint64_t> sizes;
        expect('(');
        while (!take(')')) {
            if (peek() < '0' || peek() > '9') refuse();
            std::uint64_t size = 0;
            for (; at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9'; ++at_) {
                if (size > (INT64_MAX - 9) / 10) refuse();
                size = 10 * size + std::uint64_t(text_[at_] - '0');
            }
            if (at_ < text_.size() && text_[at_] == 'L') ++at_;  // Python 2
            sizes.push_back(size);
            if (!take(',') && peek() != ')') refuse();
        }
        return sizes;
    }

    std::string_view text_;
    std::size_t place_;
    const std::string& file_;
    std::size_t at_ = 0;
};

}  // namespace

NpyHeader parse_npy_header(std::string_view head, const std::string& file) {
    const auto refuse = [&](const std::string& sentence) { throw InputError("F140", file, sentence); };
    if (head.starts_with("PK"))
        refuse(
            "This is an archive of several arrays (.npz): write the rays alone, with numpy.save(\"rays.npy\", rays).");
    if (!head.starts_with(magic)) refuse("This is no .npy file: write the rays with numpy.save(\"rays.npy\", rays).");
    const auto byte = [&](std::size_t i) { return std::uint32_t(static_cast<unsigned char>(head[i])); };
    const std::size_t version = head.size() > 6 ? byte(6) : 0;
    const std::size_t begin = version == 1 ? 10 : 12;
    if (head.size() < begin) refuse("The .npy file is cut off in its header: write the array again with numpy.save.");
    if (version < 1 || version > 3)
        refuse("The .npy file has version " + std::to_string(version) +
               "; 1 to 3 are read: write the array again with numpy.save.");
    const std::uint64_t length =
        version == 1 ? byte(8) | byte(9) << 8 : byte(8) | byte(9) << 8 | byte(10) << 16 | std::uint64_t(byte(11)) << 24;
    if (begin + length > longest_npy_header)
        refuse("The header of the .npy file claims " + std::to_string(length) +
               " bytes, which no array of rays needs: write the array again with numpy.save.");
    if (begin + length > head.size())
        refuse("The .npy file is cut off in its header: write the array again with numpy.save.");
    NpyHeader header = HeaderParser(head.substr(begin, std::size_t(length)), begin, file).parse();
    header.data_offset = begin + length;
    return header;
}

}  // namespace enfilade::tools

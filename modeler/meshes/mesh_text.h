#pragma once
// The bytes of a mesh file, read token by token, with the place of every complaint.

#include <cstdint>
#include <string>
#include <string_view>

namespace enfilade::modeler {

/// What tolerant readers write for a vertex that cannot exist: no mesh has as many.
inline constexpr std::uint32_t absent_vertex = UINT32_MAX;
/// Coordinates beyond this are refused: their products must stay finite.
inline constexpr double max_coordinate = 1e12;
/// Corners of all faces: a map has four darts for each, numbered in 32 bits.
inline constexpr std::uint64_t max_corners = (std::uint64_t{1} << 30) - 1;

class MeshText {
public:
    MeshText(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

    [[nodiscard]] bool ended() const { return at_ >= bytes_.size(); }
    [[nodiscard]] std::size_t position() const { return at_; }
    [[nodiscard]] std::size_t remaining() const { return bytes_.size() - at_; }
    [[nodiscard]] std::string_view bytes() const { return bytes_; }
    [[nodiscard]] const std::string& file() const { return file_; }
    void seek(std::size_t at) { at_ = at; }

    /// `#` begins a comment in what follows; a backslash at the end of a line continues it.
    void set_comments(bool on) { comments_ = on; }
    void set_continuation(bool on) { continuation_ = on; }
    /// Coordinates that are none are NaN from now on, and no fault.
    void set_tolerant(bool on) { tolerant_ = on; }
    [[nodiscard]] bool is_tolerant() const { return tolerant_; }

    /// To the next token of this line; false where the line has no more.
    bool next_in_line();
    /// To the next token of the file; false where there is none.
    bool next();
    /// Behind the end of this line.
    void skip_line();
    /// The rest of the line, without blanks at its ends.
    [[nodiscard]] std::string rest_of_line();

    /// The token here, and past it.
    std::string_view word();
    /// A coordinate. Throws P802 for what is no number, P803 where it is not finite or too large.
    double coordinate();
    /// Throws P802 for what is no whole number.
    std::int64_t integer();
    /// The whole number at the front of a token, which ends at a blank or at `stop`.
    std::int64_t integer_before(char stop, std::string_view* behind = nullptr);

    /// Throws InputError with the line of the token read last.
    [[noreturn]] void fail(const char* code, const std::string& sentence) const;
    [[noreturn]] void fail_at(std::size_t position, const char* code, const std::string& sentence) const;

private:
    [[nodiscard]] bool is_continued() const;

    std::string_view bytes_;
    const std::string& file_;
    std::size_t at_ = 0;
    std::size_t token_ = 0;
    bool comments_ = false;
    bool continuation_ = false;
    bool tolerant_ = false;
};

/// `text` cut to what fits into a sentence, without control characters.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// Finite, and so small that products of three stay finite.
[[nodiscard]] inline bool is_coordinate(double value) { return value >= -max_coordinate && value <= max_coordinate; }

}  // namespace enfilade::modeler

#pragma once
// The lines of a DXF text: a group code, then its value, and so on to the end.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace enfilade::plans::dxf {

struct Pair {
    int code = 0;
    std::string_view value;  ///< without the end of line and the blanks before it
    int line = 0;            ///< of the code; the value stands on the next one
};

enum class PairState { Pair, End, NoCode, HalfPair };

/// Splits a text into pairs. Lines end in LF or CR LF.
class PairScanner {
public:
    explicit PairScanner(std::string_view bytes);

    /// The next pair, or why there is none.
    PairState next(Pair& pair);
    /// Of the line read last.
    [[nodiscard]] int line() const { return line_; }

private:
    bool next_line(std::string_view& text);

    std::string_view rest_;
    int line_ = 0;
};

/// Throws InputError where the text is no DXF drawing whose sections are whole: DWG and binary files, lines out of
/// step, a file that is cut off, a record of more than `largest_record` pairs. What it lets pass consists of sections
/// of records, which a pair of code 0 begins.
void check_structure(std::string_view bytes, const std::string& file_name, std::size_t largest_record = SIZE_MAX);

}  // namespace enfilade::plans::dxf

#pragma once
// How every library of Enfilade says that it cannot go on (README.md of this folder).

#include <stdexcept>
#include <string>
#include <utility>

namespace enfilade {

/// The user's file, plan or flag is wrong: `main` prints it once and exits with 2.
/// `line` and `column` start at 1; 0 means that the fault has no place in the text.
class InputError : public std::runtime_error {
public:
    InputError(std::string code_, std::string file_, int line_, int column_, const std::string& sentence)
        : std::runtime_error(sentence), code(std::move(code_)), file(std::move(file_)), line(line_), column(column_) {}
    InputError(std::string code_, std::string file_, const std::string& sentence)
        : InputError(std::move(code_), std::move(file_), 0, 0, sentence) {}

    /// "file:line:column: sentence", leaving out what is unknown.
    [[nodiscard]] std::string located() const {
        std::string text = file;
        if (line > 0) text += ":" + std::to_string(line) + (column > 0 ? ":" + std::to_string(column) : "");
        return text.empty() ? what() : text + ": " + what();
    }

    std::string code;
    std::string file;
    int line;
    int column;
};

/// A file or device would not do its part: exit code 3.
class IoError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace enfilade

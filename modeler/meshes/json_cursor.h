#pragma once
// JSON read where it stands, without building a tree: city models have hundreds of megabytes.

#include <cstdint>
#include <string>
#include <string_view>

namespace enfilade::modeler {

/// A place in a JSON text. Reading a value moves behind it. Everything throws InputError P808 with line and column
/// where the text is not well-formed JSON, P809 where a value is of another kind than the one asked for.
class JsonCursor {
public:
    JsonCursor(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    [[nodiscard]] std::size_t position() const { return at_; }
    /// The text from one position to another.
    [[nodiscard]] std::string between(std::size_t from, std::size_t to) const {
        return std::string(text_.substr(from, to - from));
    }
    void seek(std::size_t at) { at_ = at; }

    /// First character of the value here; 0 at the end of the text.
    [[nodiscard]] char peek();

    /// Calls `read(key)` for each member; it has to read or `skip` the value.
    template <class Read>
    void members(const char* what, Read&& read) {
        open('{', what, "an object");
        for (bool more = !closes('}'); more; more = continues('}')) {
            const std::string key = string("a key");
            expect_colon();
            read(key);
        }
    }

    /// Calls `read(index)` for each item; it has to read or `skip` it.
    template <class Read>
    void items(const char* what, Read&& read) {
        open('[', what, "a list");
        std::uint64_t index = 0;
        for (bool more = !closes(']'); more; more = continues(']')) read(index++);
    }

    [[nodiscard]] std::string string(const char* what);
    /// Finite and below 1e12, else P803.
    [[nodiscard]] double number(const char* what);
    [[nodiscard]] std::int64_t integer(const char* what);
    /// Past a value of any kind, nested up to 512 deep.
    void skip();

    [[noreturn]] void fail(const char* code, const std::string& sentence) const;

private:
    void open(char bracket, const char* what, const char* kind);
    bool closes(char bracket);
    bool continues(char bracket);
    void expect_colon();
    [[nodiscard]] std::string_view number_text(const char* what);
    void skip_string();
    void append_escape(std::string& out);
    [[nodiscard]] std::uint32_t hex4();

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
};

}  // namespace enfilade::modeler

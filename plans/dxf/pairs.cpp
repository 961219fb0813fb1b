#include "plans/dxf/pairs.h"

#include <charconv>

#include "base/error.h"

namespace enfilade::plans::dxf {
namespace {

constexpr std::size_t largest_file = std::size_t{1} << 30;

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

std::string_view without_indent(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    return text;
}

/// Something of a line that a message can show.
std::string shown(std::string_view text) {
    std::string out;
    for (const char c : text.substr(0, 40)) out += c >= ' ' && c <= '~' ? c : '?';
    return "\"" + out + (text.size() > 40 ? "...\"" : "\"");
}

/// What is no DXF text at all, told by its first bytes.
void refuse_other_formats(std::string_view bytes, const std::string& file) {
    if (bytes.starts_with("AutoCAD Binary DXF"))
        throw InputError("P701", file, "This is a binary DXF file; save the drawing as a DXF text (ASCII DXF).");
    if (bytes.size() >= 6 && bytes.starts_with("AC10") && bytes[4] >= '0' && bytes[4] <= '9' && bytes[5] >= '0' &&
        bytes[5] <= '9')
        throw InputError("P700", file,
                         "This is a DWG file (" + std::string(bytes.substr(0, 6)) +
                             "); open it in a CAD program and save it as DXF.");
    if (bytes.size() > largest_file)
        throw InputError("P708", file, "The drawing is larger than 1 GiB, which no plan needs.");
}

/// The order of sections, records and the end of the file.
class StructureCheck {
public:
    StructureCheck(std::string_view bytes, const std::string& file, std::size_t largest_record)
        : scanner_(bytes), file_(file), largest_record_(largest_record) {}

    void run() {
        Pair pair;
        while (next(pair)) {
            if (pair.code == 999) continue;
            if (pair.code != 0) {
                if (++in_record_ > largest_record_)
                    refuse("P708", pair.line,
                           "The drawing has an entity of more than " + std::to_string(largest_record_) +
                               " values, which no plan needs.");
                if (!inside_) refuse_start(pair, "this pair belongs to no section");
                continue;
            }
            in_record_ = 0;
            if (pair.value == "EOF") {
                if (inside_)
                    refuse("P703", pair.line,
                           "The file is cut off: its section " + section_ + " has no end; save the drawing again.");
                if (sections_ == 0) refuse("P702", pair.line, "The drawing is empty: it has no section.");
                return;
            }
            if (pair.value == "SECTION") open(pair);
            else if (pair.value == "ENDSEC") close(pair);
            else if (!inside_) refuse_start(pair, shown(pair.value) + " stands outside of the sections");
        }
    }

private:
    [[noreturn]] void refuse(const char* code, int line, const std::string& sentence) const {
        throw InputError(code, file_, line, 0, sentence);
    }

    [[noreturn]] void refuse_start(const Pair& pair, const std::string& what) const {
        if (sections_ == 0)
            refuse("P702", pair.line,
                   "This is no DXF drawing: it does not begin with a section; choose a drawing saved as DXF text.");
        refuse("P704", pair.line, "The drawing is damaged: " + what + "; save it again.");
    }

    /// False never: the end comes with the pair "EOF", or is refused.
    bool next(Pair& pair) {
        switch (scanner_.next(pair)) {
            case PairState::Pair: break;
            case PairState::End:
            case PairState::HalfPair:
                if (sections_ == 0) refuse_start(pair, "");
                refuse("P703", scanner_.line(),
                       "The file is cut off: it ends without \"EOF\"; save the drawing again.");
            case PairState::NoCode:
                if (sections_ == 0) refuse_start(pair, "");
                refuse("P704", pair.line,
                       "The drawing is damaged: a group code (a whole number) belongs here, not " + shown(pair.value) +
                           "; save it again.");
        }
        if (pair.value.find('\0') != std::string_view::npos)
            refuse("P701", pair.line + 1,
                   "The file holds zero bytes, as no DXF text does; save the drawing as DXF text.");
        return true;
    }

    void open(const Pair& at) {
        if (inside_)
            refuse(
                "P704", at.line,
                "The drawing is damaged: section " + section_ + "\" does not end before the next one; save it again.");
        ++sections_;
        Pair name;
        do next(name);
        while (name.code == 999);
        if (name.code != 2)
            refuse("P704", name.line, "The drawing is damaged: a section without a name; save it again.");
        section_ = shown(name.value);
        inside_ = true;
    }

    void close(const Pair& at) {
        if (!inside_) refuse_start(at, "a section ends that did not begin");
        inside_ = false;
    }

    PairScanner scanner_;
    const std::string& file_;
    std::size_t largest_record_;
    std::size_t in_record_ = 0;
    std::string section_;
    bool inside_ = false;
    int sections_ = 0;
};

}  // namespace

PairScanner::PairScanner(std::string_view bytes) : rest_(bytes) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

bool PairScanner::next_line(std::string_view& text) {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    text = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_;
    return true;
}

PairState PairScanner::next(Pair& pair) {
    std::string_view text;
    pair.line = line_ + 1;
    if (!next_line(text)) return PairState::End;
    text = without_indent(trimmed(text));
    const auto result = std::from_chars(text.data(), text.data() + text.size(), pair.code);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size()) {
        // Blank lines, or the end mark of old systems, where the text stops: no pair was begun.
        if (text.find_first_not_of('\x1A') == std::string_view::npos &&
            rest_.find_first_not_of("\r\n\t \x1A") == std::string_view::npos)
            return PairState::End;
        pair.value = text;
        return PairState::NoCode;
    }
    if (!next_line(text)) return PairState::HalfPair;
    pair.value = trimmed(text);
    if (pair.code == 0) pair.value = without_indent(pair.value);
    return PairState::Pair;
}

void check_structure(std::string_view bytes, const std::string& file_name, std::size_t largest_record) {
    refuse_other_formats(bytes, file_name);
    StructureCheck(bytes, file_name, largest_record).run();
}

}  // namespace enfilade::plans::dxf

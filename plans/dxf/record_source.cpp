#include "plans/dxf/record_source.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "plans/dxf/number.h"

namespace enfilade::plans::dxf {
namespace {

/// dxflib cuts lines at 1023 bytes.
constexpr std::size_t longest_text = 1000;

constexpr std::array entity_kinds = {
    std::string_view("LINE"),      std::string_view("LWPOLYLINE"), std::string_view("POLYLINE"),
    std::string_view("VERTEX"),    std::string_view("SEQEND"),     std::string_view("ARC"),
    std::string_view("CIRCLE"),    std::string_view("ELLIPSE"),    std::string_view("SPLINE"),
    std::string_view("SOLID"),     std::string_view("TRACE"),      std::string_view("3DFACE"),
    std::string_view("TEXT"),      std::string_view("MTEXT"),      std::string_view("ATTRIB"),
    std::string_view("DIMENSION"), std::string_view("INSERT")};

constexpr std::array settings = {std::string_view("$ACADVER"), std::string_view("$DWGCODEPAGE"),
                                 std::string_view("$INSUNITS"), std::string_view("$LUNITS"),
                                 std::string_view("$MEASUREMENT")};

template <class List>
bool holds(const List& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

bool is_real(int code) { return (code >= 10 && code <= 59) || code == 210 || code == 220 || code == 230; }
bool is_whole(int code) { return code == 62 || (code >= 70 && code <= 79); }
bool is_text(int code) { return code == 1 || code == 2 || code == 3 || code == 8; }

/// The parts of a sequence that begins with another record.
bool continues(std::string_view kind) { return kind == "VERTEX" || kind == "SEQEND" || kind == "ATTRIB"; }

/// Of these a wrong number is passed on as one beyond all bounds, which the whole shape does not survive.
bool poisoned(std::string_view kind) { return kind == "VERTEX" || kind == "POLYLINE" || kind == "BLOCK"; }

bool usable(std::string_view text) {
    const std::optional<double> value = real_of(text);
    return value && std::abs(*value) <= largest_number;
}

}  // namespace

RecordSource::RecordSource(std::string_view bytes, std::map<std::string, LeftOut>& left_out)
    : scanner_(bytes), left_out_by_block_(left_out) {}

RecordSource::int_type RecordSource::underflow() {
    if (!fill()) return traits_type::eof();
    setg(text_.data(), text_.data(), text_.data() + text_.size());
    return traits_type::to_int_type(text_.front());
}

LeftOut& RecordSource::left_out() { return left_out_by_block_[block_]; }

/// Puts the next wanted record into `text_`; at the end the mark by which dxflib completes the last one.
bool RecordSource::fill() {
    text_.clear();
    while (next_record()) {
        if (!wanted()) continue;
        line_ = next_line_;
        next_line_ = head_.line;
        write_record();
        return true;
    }
    if (ended_) return false;
    ended_ = true;
    line_ = next_line_;
    text_ = "0\nEOF\n";
    return true;
}

/// Reads `head_` (code 0, or 9 in the header) and `pairs_`, what belongs to it. Groups of other programs ("{...}"),
/// extended data and objects embedded in others are left out: their codes mean something else.
bool RecordSource::next_record() {
    pairs_.clear();
    Pair pair;
    if (!has_ahead_) {
        do {
            if (scanner_.next(pair) != PairState::Pair) return false;
        } while (pair.code != 0);
        ahead_ = pair;
    }
    head_ = ahead_;
    has_ahead_ = false;
    if (head_.code == 0 && head_.value == "EOF") return false;
    bool foreign = false;
    bool embedded = false;
    while (scanner_.next(pair) == PairState::Pair) {
        if (pair.code == 0 || (pair.code == 9 && section_ == Section::Header) ||
            (pair.code == 9 && head_.value == "SECTION")) {
            ahead_ = pair;
            has_ahead_ = true;
            break;
        }
        if (pair.code == 102) foreign = pair.value.starts_with("{");
        if (pair.code == 101) embedded = true;
        if (!foreign && !embedded &&
            (is_real(pair.code) || is_text(pair.code) || is_whole(pair.code) || pair.code == 60 || pair.code == 67))
            pairs_.push_back(pair);
    }
    return true;
}

int RecordSource::whole(int code, int otherwise) const {
    for (const Pair& pair : pairs_)
        if (pair.code == code) return whole_of(pair.value).value_or(otherwise);
    return otherwise;
}

std::string_view RecordSource::text(int code) const {
    for (const Pair& pair : pairs_)
        if (pair.code == code) return pair.value;
    return {};
}

void RecordSource::enter_section(std::string_view name) {
    section_ = name == "HEADER"     ? Section::Header
               : name == "TABLES"   ? Section::Tables
               : name == "BLOCKS"   ? Section::Blocks
               : name == "ENTITIES" ? Section::Entities
                                    : Section::Other;
    layer_table_ = false;
    skip_block_ = false;
    skip_vertices_ = false;
    block_.clear();
}

/// Whether dxflib is to see the record.
bool RecordSource::wanted() {
    if (head_.code == 0 && head_.value == "SECTION") enter_section(text(2));
    else if (head_.code == 0 && head_.value == "ENDSEC") section_ = Section::Other;
    else switch (section_) {
            case Section::Header: return head_.code == 9 && holds(settings, head_.value) && !pairs_.empty();
            case Section::Tables: return wanted_in_tables();
            case Section::Blocks: return wanted_in_blocks();
            case Section::Entities: return wanted_entity();
            case Section::Other: break;
        }
    return false;
}

bool RecordSource::wanted_in_tables() {
    if (head_.value == "TABLE") layer_table_ = text(2) == "LAYER";
    else if (head_.value == "ENDTAB") layer_table_ = false;
    return layer_table_ && head_.value == "LAYER" && !text(2).empty();
}

bool RecordSource::wanted_in_blocks() {
    if (head_.value == "BLOCK") {
        skip_block_ = text(2).empty();
        skip_vertices_ = false;
        block_ = folded(std::string(text(2).substr(0, longest_text)));
        return !skip_block_;
    }
    if (head_.value == "ENDBLK") {
        const bool named = !block_.empty();
        block_.clear();
        skip_block_ = false;
        return named;
    }
    // What stands between the blocks belongs to none.
    return !skip_block_ && !block_.empty() && wanted_entity();
}

bool RecordSource::wanted_entity() {
    const std::string_view kind = head_.value;
    if (continues(kind) && kind != "SEQEND") {
        if (skip_vertices_) return false;
        // Bit 16: a control point of a polyline bent to a spline, whose curve stands beside it.
        if (kind == "VERTEX") return (whole(70, 0) & 16) == 0;
        return !is_broken();
    }
    if (kind == "SEQEND") {
        skip_vertices_ = false;
        return true;
    }
    skip_vertices_ = counted_out();
    return !skip_vertices_;
}

/// Whether the record is left out, which is then counted.
bool RecordSource::counted_out() {
    const std::string_view kind = head_.value;
    if (kind == "ATTDEF") return true;  // what an attribute is to look like, not a text of the drawing
    // In a block the flag tells where it was drawn, not where it is inserted.
    if (block_.empty() && whole(67, 0) != 0) {
        left_out().paper_space.add(head_.line);
        return true;
    }
    if ((whole(60, 0) & 1) != 0) {
        left_out().invisible.add(head_.line);
        return true;
    }
    if (!holds(entity_kinds, kind)) {
        std::string name;
        for (const char c : kind.substr(0, 40)) name += c >= ' ' && c <= '~' ? c : '?';
        // A hostile file has a new name each time.
        std::map<std::string, Tally>& kinds = left_out().unknown_kinds;
        kinds[kinds.size() < 100 || kinds.contains(name) ? name : "of other kinds"].add(head_.line);
        return true;
    }
    // Bits 16 and 64: meshes in space, drawn as polylines only by name.
    if (kind == "POLYLINE" && (whole(70, 0) & (16 | 64)) != 0) {
        left_out().meshes.add(head_.line);
        return true;
    }
    const bool nameless = kind == "INSERT" && text(2).empty();
    if (nameless || (!poisoned(kind) && is_broken())) {
        left_out().broken.add(head_.line);
        return true;
    }
    return false;
}

bool RecordSource::is_broken() const {
    return std::any_of(pairs_.begin(), pairs_.end(),
                       [](const Pair& pair) { return is_real(pair.code) && !usable(pair.value); });
}

void RecordSource::write_record() {
    text_ += head_.code == 9 ? "9\n" : "0\n";
    text_ += head_.value;
    text_ += '\n';
    if (head_.value == "LWPOLYLINE" || head_.value == "SPLINE") write_curve_counts();
    bool vertex = false;
    for (const Pair& pair : pairs_) {
        if (pair.code == 10) vertex = true;
        if (head_.value == "LWPOLYLINE") {
            // A bulge before the first vertex would be written before the first element of a buffer.
            if (!vertex && pair.code != 8 && pair.code != 38 && pair.code != 70 && pair.code < 210) continue;
            if (pair.code >= 40 && pair.code <= 59 && pair.code != 42) continue;
        }
        if (head_.value == "SPLINE" && pair.code >= 72 && pair.code <= 74) continue;
        // dxflib tells the style of a dimension, which nobody asks for, and not the block that draws it.
        if (head_.value == "DIMENSION" && (pair.code == 2 || pair.code == 3)) {
            if (pair.code == 2) write_text(3, pair.value);
            continue;
        }
        // By the angle dxflib asks for a version that it has not set.
        if (head_.value == "MTEXT" && pair.code == 50) continue;
        write_pair(pair);
    }
    if (head_.value == "SOLID" || head_.value == "TRACE" || head_.value == "3DFACE") write_last_corner();
}

/// A face without a fourth corner is a triangle: dxflib would take the origin.
void RecordSource::write_last_corner() {
    const auto given = [&](int code) {
        return std::any_of(pairs_.begin(), pairs_.end(), [&](const Pair& pair) { return pair.code == code; });
    };
    if (given(13) || given(23)) return;
    for (Pair pair : pairs_)
        if (pair.code == 12 || pair.code == 22 || pair.code == 32) {
            pair.code += 1;
            write_pair(pair);
        }
}

/// The counts by which dxflib takes memory: true ones, before all else.
void RecordSource::write_curve_counts() {
    const auto count = [&](int code) {
        return std::to_string(
            std::count_if(pairs_.begin(), pairs_.end(), [&](const Pair& pair) { return pair.code == code; }));
    };
    if (head_.value == "LWPOLYLINE") text_ += "90\n" + count(10) + "\n";
    else text_ += "72\n" + count(40) + "\n73\n" + count(10) + "\n74\n" + count(11) + "\n";
}

void RecordSource::write_pair(const Pair& pair) {
    if (is_text(pair.code)) return write_text(pair.code, pair.value);
    const bool whole_number = is_whole(pair.code);
    const std::optional<double> value = real_of(pair.value);
    if (!whole_number && head_.code == 0 && poisoned(head_.value) && !usable(pair.value)) {
        text_ += std::to_string(pair.code) + "\n1e300\n";
        return;
    }
    if ((!whole_number && !is_real(pair.code)) || !value) return;
    // What dxflib takes anyway where it is absent: it spends most of its time on numbers.
    const bool height = pair.code >= 30 && pair.code <= 37;
    if (*value == (pair.code == 230 ? 1 : 0) && (height || pair.code >= 210)) return;
    text_ += std::to_string(pair.code);
    text_ += '\n';
    if (whole_number) text_ += std::to_string(whole_of(pair.value).value_or(0));
    else append_pointless(text_, *value);
    text_ += '\n';
}

void RecordSource::write_text(int code, std::string_view value) {
    const auto cut = [](std::string_view text) {
        std::size_t end = std::min(text.size(), longest_text);
        // Not within a UTF-8 sequence.
        for (int back = 0; back < 3 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u;
             ++back)
            --end;
        return text.substr(0, end);
    };
    const bool several = head_.value == "MTEXT" && (code == 1 || code == 3);
    while (several && value.size() > longest_text) {
        const std::string_view part = cut(value);
        text_ += "3\n";
        text_ += part;
        text_ += '\n';
        value.remove_prefix(part.size());
    }
    if (value.size() > longest_text) {
        left_out().cut_texts.add(head_.line);
        value = cut(value);
    }
    text_ += std::to_string(code);
    text_ += '\n';
    text_ += value;
    text_ += '\n';
}

}  // namespace enfilade::plans::dxf

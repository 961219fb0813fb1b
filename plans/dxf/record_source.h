#pragma once
// What dxflib is given to read. It trusts its input: a count that lies makes it write beyond its buffers, a line of
// 1024 bytes makes it loop for ever, numbers follow the global locale. So it only sees records of kinds we ask for, put
// together anew: the pairs that count, counts that are true, short lines, numbers spelled without a point.

#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

#include "plans/dxf/entities.h"
#include "plans/dxf/pairs.h"

namespace enfilade::plans::dxf {

/// A stream of such records. \pre check_structure(bytes) let it pass
class RecordSource : public std::streambuf {
public:
    RecordSource(std::string_view bytes, std::map<std::string, LeftOut>& left_out);

    /// The line where the record begins that dxflib reports at this moment: it does so when it sees the next one.
    [[nodiscard]] int line() const { return line_; }

protected:
    int_type underflow() override;

private:
    enum class Section { Other, Header, Tables, Blocks, Entities };

    bool next_record();
    bool fill();
    void enter_section(std::string_view name);
    bool wanted();
    bool wanted_in_tables();
    bool wanted_in_blocks();
    bool wanted_entity();
    bool counted_out();
    bool is_broken() const;
    [[nodiscard]] int whole(int code, int otherwise) const;
    [[nodiscard]] std::string_view text(int code) const;
    void write_record();
    void write_curve_counts();
    void write_last_corner();
    void write_pair(const Pair& pair);
    void write_text(int code, std::string_view value);
    LeftOut& left_out();

    PairScanner scanner_;
    std::map<std::string, LeftOut>& left_out_by_block_;
    Section section_ = Section::Other;
    bool layer_table_ = false;
    bool skip_block_ = false;     ///< in a block without a name
    bool skip_vertices_ = false;  ///< of a polyline, attributes of an insertion, that is left out itself
    std::string block_;           ///< key of the block being read; "" in model space
    Pair ahead_;                  ///< the head of the next record
    bool has_ahead_ = false;
    bool ended_ = false;
    Pair head_;
    std::vector<Pair> pairs_;
    std::string text_;  ///< what the stream gives out
    int line_ = 0;
    int next_line_ = 0;
};

}  // namespace enfilade::plans::dxf

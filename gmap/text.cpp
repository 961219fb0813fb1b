#include "gmap/text.h"

#include <algorithm>
#include <array>
#include <istream>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace enfilade::gmap {

namespace {

/// The next line that says something, as a stream of its words; counts lines for messages.
class Lines {
public:
    explicit Lines(std::istream& in) : in_(in) {}

    std::istringstream next(const char* expected) {
        for (std::string line; std::getline(in_, line);) {
            ++number_;
            line.erase(std::min(line.find('#'), line.size()));
            if (line.find_first_not_of(" \t\r") != std::string::npos) return std::istringstream(line);
        }
        ++number_;
        refuse(expected);
    }

    /// Whether nothing but comments follows.
    bool at_end() {
        for (std::string line; std::getline(in_, line);) {
            ++number_;
            line.erase(std::min(line.find('#'), line.size()));
            if (line.find_first_not_of(" \t\r") != std::string::npos) return false;
        }
        return true;
    }

    [[noreturn]] void refuse(const std::string& expected) const {
        throw std::invalid_argument("Line " + std::to_string(number_) + " of the map: expected " + expected + ".");
    }

private:
    std::istream& in_;
    int number_ = 0;
};

/// Streams would take "-1" for an unsigned number.
bool read_number(std::istream& words, std::uint32_t& value) {
    std::string word;
    if (!(words >> word) || word.size() > 10 || word.find_first_not_of("0123456789") != std::string::npos) return false;
    const unsigned long long number = std::stoull(word);
    if (number >= detail::none_u32) return false;
    value = static_cast<std::uint32_t>(number);
    return true;
}

}  // namespace

void write_text(const Map& map, std::ostream& out) {
    Map compacted = map;
    compacted.compact();
    const MapArrays& arrays = compacted.arrays();
    out << "enfilade-gmap 1\ndarts " << compacted.dart_count() << " vertices " << compacted.vertex_count() << " edges "
        << compacted.edge_count() << " faces " << compacted.face_count() << " volumes " << compacted.volume_count()
        << '\n';
    for (std::size_t d = 0; d < compacted.dart_bound(); ++d) {
        for (std::size_t i = 0; i < 4; ++i) out << arrays.alpha[i][d] << ' ';
        for (std::size_t i = 0; i < 4; ++i) out << arrays.cell_id[i][d] << (i < 3 ? ' ' : '\n');
    }
}

Map read_text(std::istream& in) {
    Lines lines(in);
    std::string word;
    {
        std::istringstream head = lines.next("'enfilade-gmap 1'");
        std::uint32_t version = 0;
        if (!(head >> word) || word != "enfilade-gmap" || !read_number(head, version) || version != 1 || (head >> word))
            lines.refuse("'enfilade-gmap 1'");
    }
    const char* counts_expected = "'darts N vertices N edges N faces N volumes N'";
    std::istringstream counts = lines.next(counts_expected);
    std::array<std::uint32_t, 5> count{};
    constexpr std::array<const char*, 5> names{"darts", "vertices", "edges", "faces", "volumes"};
    for (std::size_t k = 0; k < names.size(); ++k)
        if (!(counts >> word) || word != names[k] || !read_number(counts, count[k])) lines.refuse(counts_expected);
    if (counts >> word) lines.refuse(counts_expected);

    MapArrays arrays;
    arrays.cell_bound = {count[1], count[2], count[3], count[4]};
    for (std::uint32_t d = 0; d < count[0]; ++d) {
        std::istringstream words = lines.next("a dart: eight numbers");
        for (auto* group : {&arrays.alpha, &arrays.cell_id})
            for (std::vector<std::uint32_t>& array : *group) {
                std::uint32_t value = 0;
                if (!read_number(words, value)) lines.refuse("eight numbers below 4294967295");
                array.push_back(value);
            }
        if (words >> word) lines.refuse("eight numbers and no more");
    }
    if (!lines.at_end()) lines.refuse("no more than " + std::to_string(count[0]) + " darts");
    return Map(std::move(arrays));
}

}  // namespace enfilade::gmap

#include "gmap/map.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "gmap/access.h"

namespace enfilade::gmap {

using detail::none_u32;

namespace {

void check_lengths(const MapArrays& arrays) {
    const std::size_t length = arrays.alpha[0].size();
    for (std::size_t i = 0; i < 4; ++i)
        if (arrays.alpha[i].size() != length || arrays.cell_id[i].size() != length)
            throw std::invalid_argument("The eight arrays of a map must have one length.");
    if (length >= none_u32) throw std::invalid_argument("A map holds fewer than 2^32 - 1 darts.");
}

/// Whether slot `d` is a gap; throws where it is half one.
bool is_gap(const MapArrays& arrays, std::size_t d) {
    if (arrays.alpha[0][d] != none_u32) return false;
    for (std::size_t i = 0; i < 4; ++i)
        if (arrays.alpha[i][d] != none_u32 || arrays.cell_id[i][d] != none_u32)
            throw std::invalid_argument("Slot " + std::to_string(d) + " of the map is neither a dart nor a gap.");
    return true;
}

void check_ranges(const MapArrays& arrays, std::size_t d) {
    for (std::size_t i = 0; i < 4; ++i) {
        const std::uint32_t to = arrays.alpha[i][d];
        if (to >= arrays.alpha[i].size() || arrays.alpha[0][to] == none_u32)
            throw std::invalid_argument("alpha" + std::to_string(i) + " of dart " + std::to_string(d) +
                                        " leads to no dart.");
        if (arrays.cell_id[i][d] >= arrays.cell_bound[i])
            throw std::invalid_argument("The " + std::to_string(i) + "-cell of dart " + std::to_string(d) +
                                        " is beyond the number of cells.");
    }
}

}  // namespace

Map::Map(MapArrays arrays) : arrays_(std::move(arrays)) {
    check_lengths(arrays_);
    const std::size_t bound = dart_bound();
    for (std::size_t i = 0; i < 4; ++i)
        if (arrays_.cell_bound[i] > bound)
            throw std::invalid_argument("A map cannot have more cells of one dimension than darts.");
    for (std::size_t d = bound; d-- > 0;) {
        if (is_gap(arrays_, d)) {
            gaps_.push_back(static_cast<std::uint32_t>(d));
            continue;
        }
        ++dart_count_;
        check_ranges(arrays_, d);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        std::vector<bool> used(arrays_.cell_bound[i], false);
        for (const std::uint32_t id : arrays_.cell_id[i])
            if (id != none_u32) used[id] = true;
        cell_count_[i] = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
    }
}

DartId Map::add_dart() {
    const DartId d = detail::MapAccess::new_dart(*this);
    for (int i = 0; i < 4; ++i) detail::MapAccess::cell(*this, i, d) = detail::MapAccess::new_cell(*this, i);
    return d;
}

bool Map::remove_dart(DartId d) {
    if (!contains(d) || !is_free<0>(d) || !is_free<1>(d) || !is_free<2>(d) || !is_free<3>(d)) return false;
    for (int i = 0; i < 4; ++i) detail::MapAccess::drop_cell(*this, i);
    detail::MapAccess::erase_dart(*this, d);
    return true;
}

void Map::append(const Map& other) {
    if (&other == this) return append(Map(other));
    const auto offset = static_cast<std::uint32_t>(dart_bound());
    if (other.dart_bound() >= none_u32 - offset) throw std::length_error("A map holds fewer than 2^32 - 1 darts.");
    const auto shift_into = [](std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& from,
                               std::uint32_t by) {
        to.reserve(to.size() + from.size());
        for (const std::uint32_t id : from) to.push_back(id == none_u32 ? id : id + by);
    };
    for (std::size_t i = 0; i < 4; ++i) {
        shift_into(arrays_.alpha[i], other.arrays_.alpha[i], offset);
        shift_into(arrays_.cell_id[i], other.arrays_.cell_id[i], arrays_.cell_bound[i]);
        arrays_.cell_bound[i] += other.arrays_.cell_bound[i];
        cell_count_[i] += other.cell_count_[i];
    }
    dart_count_ += other.dart_count_;
    for (const std::uint32_t gap : other.gaps_) gaps_.push_back(gap + offset);
}

Renumbering Map::compact() {
    Renumbering result;
    result.darts.assign(dart_bound(), none<DartId>);
    for (std::size_t i = 0; i < 4; ++i) result.cells[i].assign(arrays_.cell_bound[i], none_u32);
    std::uint32_t dart_total = 0;
    for (std::size_t d = 0; d < dart_bound(); ++d) {
        if (arrays_.alpha[0][d] == none_u32) continue;
        result.darts[d] = DartId{dart_total++};
        for (std::size_t i = 0; i < 4; ++i) result.cells[i][arrays_.cell_id[i][d]] = 0;
    }
    for (std::size_t i = 0; i < 4; ++i) {
        std::uint32_t next = 0;
        for (std::uint32_t& id : result.cells[i])
            if (id != none_u32) id = next++;
        arrays_.cell_bound[i] = next;
        for (std::size_t d = 0; d < result.darts.size(); ++d) {
            if (result.darts[d] == none<DartId>) continue;
            const std::size_t to = index(result.darts[d]);
            arrays_.alpha[i][to] = static_cast<std::uint32_t>(result.darts[arrays_.alpha[i][d]]);
            arrays_.cell_id[i][to] = result.cells[i][arrays_.cell_id[i][d]];
        }
        arrays_.alpha[i].resize(dart_total);
        arrays_.cell_id[i].resize(dart_total);
    }
    gaps_.clear();
    return result;
}

std::size_t Map::memory_bytes() const noexcept {
    std::size_t bytes = gaps_.capacity() * sizeof(std::uint32_t);
    for (std::size_t i = 0; i < 4; ++i)
        bytes += (arrays_.alpha[i].capacity() + arrays_.cell_id[i].capacity()) * sizeof(std::uint32_t);
    return bytes;
}

namespace detail {

DartId MapAccess::new_dart(Map& map, DartId like) {
    std::uint32_t d = 0;
    if (!map.gaps_.empty()) {
        d = map.gaps_.back();
        map.gaps_.pop_back();
    } else {
        if (map.dart_bound() + 1 >= none_u32) throw std::length_error("A map holds fewer than 2^32 - 1 darts.");
        d = static_cast<std::uint32_t>(map.dart_bound());
        for (std::size_t i = 0; i < 4; ++i) {
            map.arrays_.alpha[i].push_back(d);
            map.arrays_.cell_id[i].push_back(none_u32);
        }
    }
    for (std::size_t i = 0; i < 4; ++i) {
        map.arrays_.alpha[i][d] = d;
        map.arrays_.cell_id[i][d] = like == none<DartId> ? none_u32 : map.arrays_.cell_id[i][index(like)];
    }
    ++map.dart_count_;
    return DartId{d};
}

void MapAccess::erase_dart(Map& map, DartId d) {
    for (std::size_t i = 0; i < 4; ++i) {
        map.arrays_.alpha[i][index(d)] = none_u32;
        map.arrays_.cell_id[i][index(d)] = none_u32;
    }
    map.gaps_.push_back(static_cast<std::uint32_t>(d));
    --map.dart_count_;
}

std::uint32_t MapAccess::new_cell(Map& map, int i) {
    const auto dimension = static_cast<std::size_t>(i);
    ++map.cell_count_[dimension];
    return map.arrays_.cell_bound[dimension]++;
}

Map MapAccess::adopt(MapArrays arrays, const std::array<std::size_t, 4>& cell_count) {
    Map map;
    map.arrays_ = std::move(arrays);
    map.dart_count_ = map.dart_bound();
    map.cell_count_ = cell_count;
    return map;
}

}  // namespace detail

}  // namespace enfilade::gmap

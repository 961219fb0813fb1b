#pragma once
// Orbits and cells as ranges: the darts reached from one dart by some of the involutions.

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <ranges>
#include <vector>

#include "gmap/map.h"

namespace enfilade::gmap {

namespace detail {

/// A set of ids that grows with its content and not with the map: orbits are mostly of a few dozen darts.
class IdSet {
public:
    /// Whether `id` was absent.
    bool insert(std::uint32_t id);
    [[nodiscard]] bool contains(std::uint32_t id) const;
    [[nodiscard]] std::size_t size() const noexcept { return size_; }

private:
    void grow();

    std::vector<std::uint32_t> slots_;
    std::size_t size_ = 0;
};

/// Bit i set: alpha_i generates the orbit.
template <int... I>
inline constexpr unsigned generators = (0u | ... | (1u << I));

/// An i-cell is the orbit of all involutions but alpha_i.
[[nodiscard]] constexpr unsigned cell_generators(int i) { return 0xfu & ~(1u << i); }

}  // namespace detail

/// The darts of an orbit, breadth first from the first one, found as they are asked for: whoever stops early pays for
/// no more. A forward range that holds its own marks; one object belongs to one thread, any number of them may read one
/// map.
class Orbit {
public:
    Orbit(const Map& map, DartId first, unsigned generators) : map_(&map), generators_(generators), found_{first} {}

    class iterator {
    public:
        using value_type = DartId;
        using difference_type = std::ptrdiff_t;
        using iterator_concept = std::forward_iterator_tag;

        iterator() = default;
        explicit iterator(Orbit* orbit) : orbit_(orbit) {}
        DartId operator*() const { return orbit_->found_[at_]; }
        iterator& operator++() {
            ++at_;
            return *this;
        }
        iterator operator++(int) {
            iterator before = *this;
            ++at_;
            return before;
        }
        friend bool operator==(const iterator& a, const iterator& b) { return a.at_ == b.at_; }
        bool operator==(std::default_sentinel_t) const { return !orbit_->reach(at_); }

    private:
        Orbit* orbit_ = nullptr;
        std::size_t at_ = 0;
    };

    [[nodiscard]] iterator begin() { return iterator(this); }
    [[nodiscard]] std::default_sentinel_t end() const { return {}; }

private:
    /// Finds darts until there is one at `position`; false where the orbit ends before.
    bool reach(std::size_t position);
    [[nodiscard]] bool add(DartId d);

    const Map* map_;
    unsigned generators_;
    std::vector<DartId> found_;
    std::size_t expanded_ = 0;
    detail::IdSet set_;  ///< filled only once `found_` is too long to be searched
};

/// The orbit <alpha_I...> of `d`. orbit<1, 2>(map, d): the umbrella of d's vertex within its volume.
template <int... I>
[[nodiscard]] Orbit orbit(const Map& map, DartId d) {
    static_assert(((0 <= I && I <= 3) && ...));
    return Orbit(map, d, detail::generators<I...>);
}

/// All darts of the I-cell of `d`.
template <int I>
[[nodiscard]] Orbit cell(const Map& map, DartId d) {
    return Orbit(map, d, detail::cell_generators(I));
}

/// The darts of the I-cell of `d` that lie in its volume: umbrella, edge of the shell, side of the face.
template <int I>
[[nodiscard]] Orbit cell_in_volume(const Map& map, DartId d) {
    static_assert(0 <= I && I <= 2);
    return Orbit(map, d, detail::cell_generators(I) & 0x7u);
}

/// One dart of each I-cell, the lowest, by ascending cell id. Cost: one pass over the darts.
template <int I>
[[nodiscard]] auto cells(const Map& map) {
    return map.representatives<I>() | std::views::filter([](DartId d) { return d != none<DartId>; });
}

/// One dart of each I-cell that touches the J-cell of `d`, in the order of the J-cell's orbit.
template <int I, int J>
[[nodiscard]] std::vector<DartId> incident_cells(const Map& map, DartId d) {
    std::vector<DartId> result;
    detail::IdSet seen;
    for (const DartId x : cell<J>(map, d))
        if (seen.insert(static_cast<std::uint32_t>(index(map.cell_id<I>(x))))) result.push_back(x);
    return result;
}

}  // namespace enfilade::gmap

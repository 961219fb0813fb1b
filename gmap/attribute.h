#pragma once
// Values of cells, apart from the map, that survive its operations.

#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

#include "gmap/changes.h"
#include "gmap/map.h"

namespace enfilade::gmap {

/// What becomes of a value when its cell is split or merged.
template <class T>
struct AttributePolicy {
    /// Value of a cell that came from nothing.
    T created{};
    /// Value of the new part; may change that of the kept part. Default: both parts have the value of the whole.
    std::function<T(T& kept)> on_split = [](T& kept) { return kept; };
    /// Value of the union. Default: that of the cell whose id is kept.
    std::function<T(const T& kept, const T& gone)> on_merge = [](const T& kept, const T&) { return kept; };
};

/// One `T` per cell of the dimension that `Id` names (any; 0, 2 and 3 are the usual ones), indexed by cell id.
/// It holds no reference to the map: hand it the `Changes` of each operation, in order.
template <class Id, class T>
class Attribute {
    static_assert(!std::is_same_v<T, bool>, "use std::uint8_t: a vector<bool> has no references");

public:
    Attribute() = default;
    explicit Attribute(const Map& map, T initial = {}, AttributePolicy<T> policy = {})
        : values_(map.cell_bound<dimension_of<Id>>(), std::move(initial)), policy_(std::move(policy)) {}

    [[nodiscard]] T& operator[](Id id) { return values_[index(id)]; }
    [[nodiscard]] const T& operator[](Id id) const { return values_[index(id)]; }
    [[nodiscard]] std::size_t size() const noexcept { return values_.size(); }
    [[nodiscard]] std::size_t memory_bytes() const noexcept { return values_.capacity() * sizeof(T); }

    /// Applies what an operation did to the cells.
    void follow(const Changes& changes) {
        for (const CellChange& change : changes.cells) {
            if (change.dimension != dimension_of<Id>) continue;
            switch (change.kind) {
                case CellChange::Kind::Created: put(change.cell, policy_.created); break;
                case CellChange::Kind::Split: put(change.other, policy_.on_split(values_[change.cell])); break;
                case CellChange::Kind::Merged:
                    values_[change.cell] = policy_.on_merge(values_[change.cell], values_[change.other]);
                    break;
                case CellChange::Kind::Removed: break;
            }
        }
    }

    /// Applies `Map::compact`.
    void follow(const Renumbering& renumbering) {
        const auto& to = renumbering.cells[dimension_of<Id>];
        std::size_t kept = 0;
        for (std::size_t old = 0; old < to.size(); ++old) {
            if (to[old] == detail::none_u32) continue;
            if (kept != old) values_[kept] = std::move(values_[old]);
            ++kept;
        }
        values_.erase(values_.begin() + static_cast<std::ptrdiff_t>(kept), values_.end());
    }

private:
    void put(std::uint32_t id, T value) {
        if (id >= values_.size()) values_.resize(id + std::size_t{1}, policy_.created);
        values_[id] = std::move(value);
    }

    std::vector<T> values_;
    AttributePolicy<T> policy_;
};

}  // namespace enfilade::gmap

#pragma once
// Things that hang together, found out pair by pair ("union-find").

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace enfilade {

/// The numbers 0 to count - 1, each in a set of its own at first. A set is named by its lowest member, so that neither
/// its name nor the order of the sets depends on the order in which they were joined. n operations: O(n log n) at worst
/// (Tarjan and van Leeuwen, "Worst-case analysis of set union algorithms", 1984: halving without ranks), in practice
/// linear.
class DisjointSets {
public:
    DisjointSets() = default;
    explicit DisjointSets(std::size_t count) { reset(count); }

    /// Starts anew, in the memory it has. \pre count < 2^32
    void reset(std::size_t count) {
        parent_.resize(count);
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    [[nodiscard]] std::size_t size() const noexcept { return parent_.size(); }

    /// The lowest member of the set that holds `k`. \pre k < size(). Shortens the way, hence not const: not for several
    /// threads at once.
    [[nodiscard]] std::uint32_t find(std::uint32_t k) noexcept {
        while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
        return k;
    }

    /// Makes one set of those of `a` and `b`. False where they were one already. \pre a, b < size()
    bool join(std::uint32_t a, std::uint32_t b) noexcept {
        a = find(a), b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
        return a != b;
    }

    /// find() of each number. [size()]
    [[nodiscard]] std::vector<std::uint32_t> lowest() {
        // No parent is above its child: ascending, each one's parent has its own name already.
        for (std::uint32_t& parent : parent_) parent = parent_[parent];
        return parent_;
    }

    /// The sets, in order of their lowest members; the members of each ascend.
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> groups() {
        std::vector<std::vector<std::uint32_t>> result;
        std::vector<std::uint32_t> place(parent_.size());  // of the sets, by their names
        for (std::uint32_t k = 0; k < parent_.size(); ++k) {
            const std::uint32_t name = find(k);
            if (name == k) place[k] = static_cast<std::uint32_t>(result.size()), result.emplace_back();
            result[place[name]].push_back(k);
        }
        return result;
    }

private:
    std::vector<std::uint32_t> parent_;  ///< never above the number itself
};

}  // namespace enfilade

#pragma once
// Equal points get one number.

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

namespace enfilade::modeler {

using MeshPoint = std::array<double, 3>;

/// A hash table from points to numbers, in order of their first use. 0 and -0 are equal.
class PointIndex {
public:
    explicit PointIndex(std::size_t expected = 0) { grow(expected * 2 + 16); }

    /// The number of the point equal to `point`, which is `points.size()` where it is new: the caller appends it then.
    std::uint32_t find_or_add(const MeshPoint& point, const std::vector<MeshPoint>& points) {
        if (points.size() * 2 >= slots_.size()) rehash(points);
        std::size_t slot = hash(point) & (slots_.size() - 1);
        while (slots_[slot] != empty) {
            if (points[slots_[slot]] == point) return slots_[slot];
            slot = (slot + 1) & (slots_.size() - 1);
        }
        slots_[slot] = static_cast<std::uint32_t>(points.size());
        return slots_[slot];
    }

    /// The number of the point equal to `point`, or nothing.
    [[nodiscard]] std::optional<std::uint32_t> find(const MeshPoint& point,
                                                    const std::vector<MeshPoint>& points) const {
        std::size_t slot = hash(point) & (slots_.size() - 1);
        for (; slots_[slot] != empty; slot = (slot + 1) & (slots_.size() - 1))
            if (points[slots_[slot]] == point) return slots_[slot];
        return std::nullopt;
    }

private:
    static constexpr std::uint32_t empty = UINT32_MAX;

    static std::uint64_t hash(const MeshPoint& point) {
        std::uint64_t h = 0x9E3779B97F4A7C15ull;
        for (const double x : point) {
            h = (h ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0xBF58476D1CE4E5B9ull;
            h ^= h >> 29;
        }
        return h ^ (h >> 32);
    }
    void grow(std::size_t least) { slots_.assign(std::bit_ceil(least), empty); }
    void rehash(const std::vector<MeshPoint>& points) {
        grow(slots_.size() * 2);
        for (std::uint32_t k = 0; k < points.size(); ++k) {
            std::size_t slot = hash(points[k]) & (slots_.size() - 1);
            while (slots_[slot] != empty) slot = (slot + 1) & (slots_.size() - 1);
            slots_[slot] = k;
        }
    }

    std::vector<std::uint32_t> slots_;
};

}  // namespace enfilade::modeler

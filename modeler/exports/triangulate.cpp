#include "modeler/exports/triangulate.h"

#include <cstddef>

namespace enfilade::modeler {

namespace {

/// Twice the area of (a, b, c), positive when counter-clockwise.
std::int64_t area2(const GridPoint2& a, const GridPoint2& b, const GridPoint2& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The ring as a list from which ears are cut (Meisters 1975: a simple ring always has two).
class EarClipper {
public:
    explicit EarClipper(std::span<const GridPoint2> ring) : ring_(ring), next_(ring.size()), previous_(ring.size()) {
        const auto count = std::uint32_t(ring.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            next_[i] = i + 1 == count ? 0 : i + 1;
            previous_[i] = i == 0 ? count - 1 : i - 1;
        }
        for (std::uint32_t i = 0; i < count; ++i)
            if (turn(i) <= 0) blunt_.push_back(i);
    }

    std::vector<std::array<std::uint32_t, 3>> run() {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        triangles.reserve(ring_.size() - 2);
        std::uint32_t corner = 0;
        std::size_t tried = 0;
        for (std::size_t left = ring_.size(); left > 3;) {
            // After a whole turn without an ear the ring is not simple: go on with what is at hand.
            if (tried < left && !is_ear(corner)) {
                corner = next_[corner];
                ++tried;
                continue;
            }
            triangles.push_back({previous_[corner], corner, next_[corner]});
            corner = cut(corner);
            tried = 0;
            --left;
        }
        triangles.push_back({previous_[corner], corner, next_[corner]});
        return triangles;
    }

private:
    std::int64_t turn(std::uint32_t i) const { return area2(ring_[previous_[i]], ring_[i], ring_[next_[i]]); }

    /// A corner that turns left, and whose triangle holds no other corner, its third side included.
    bool is_ear(std::uint32_t i) const {
        if (turn(i) <= 0) return false;
        const std::uint32_t before = previous_[i];
        const std::uint32_t after = next_[i];
        for (const std::uint32_t other : blunt_) {
            if (other == before || other == i || other == after) continue;
            const GridPoint2& p = ring_[other];
            if (area2(ring_[before], ring_[i], p) >= 0 && area2(ring_[i], ring_[after], p) >= 0 &&
                area2(ring_[after], ring_[before], p) >= 0)
                return false;
        }
        return true;
    }

    /// Takes corner `i` out; returns where to go on: two further, so that triangles do not all fan from one corner.
    std::uint32_t cut(std::uint32_t i) {
        const std::uint32_t before = previous_[i];
        const std::uint32_t after = next_[i];
        next_[before] = after;
        previous_[after] = before;
        std::erase_if(blunt_, [&](std::uint32_t other) {
            return other == i || ((other == before || other == after) && turn(other) > 0);
        });
        return next_[after];
    }

    std::span<const GridPoint2> ring_;
    std::vector<std::uint32_t> next_;
    std::vector<std::uint32_t> previous_;
    std::vector<std::uint32_t> blunt_;  ///< corners that do not turn left: only they can lie inside an ear
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const GridPoint2> ring) {
    if (ring.size() < 3) return {};
    return EarClipper(ring).run();
}

}  // namespace enfilade::modeler

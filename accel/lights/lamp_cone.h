#pragma once
// Inside of accel: the cone of a lamp's light behind the portals that it has crossed (README.md, "Planes").

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace enfilade::accel::detail {

/// Metres, counted from the lamp.
struct ConeVector {
    double x = 0, y = 0, z = 0;
};
[[nodiscard]] inline ConeVector operator+(const ConeVector& a, const ConeVector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] inline ConeVector operator-(const ConeVector& a, const ConeVector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] inline ConeVector operator*(double s, const ConeVector& a) { return {s * a.x, s * a.y, s * a.z}; }
[[nodiscard]] inline double dot(const ConeVector& a, const ConeVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] inline ConeVector cross(const ConeVector& a, const ConeVector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline double length(const ConeVector& a) { return std::sqrt(dot(a, a)); }

/// Some planes of a LampCones, which bound one beam.
struct ConePlanes {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// The cones of one lamp's beams. Planes pass through the lamp; their normals, of length 1, point inward. Each cone
/// holds all lines through the lamp that come within `slack` of what is left of each portal on the way: never too few.
class LampCones {
public:
    /// slack: metres, more than 0.
    explicit LampCones(double slack) : slack_(slack) {}

    void clear() { planes_.clear(); }
    [[nodiscard]] double slack() const { return slack_; }
    [[nodiscard]] std::span<const ConeVector> planes(const ConePlanes& of) const {
        return {planes_.data() + of.first, of.count};
    }

    /// The cone behind one more portal; nothing where no line gets there. portal: convex, clockwise as seen from the
    /// lamp; outward: its normal, away from the lamp. What of the older planes touches the lit part of the portal
    /// stays; planes of portals that the lamp is in or next to are left out, as all lines cross those.
    std::optional<ConePlanes> behind(const ConePlanes& cone, std::span<const ConeVector> portal,
                                     const ConeVector& outward);
    /// Whether the last call of `behind` has found a portal whose plane holds the lamp, and the lamp beside it: it is
    /// crossed by lines along that plane alone.
    [[nodiscard]] bool is_last_edge_on() const { return is_last_edge_on_; }
    /// Whether another cone holds all lines that the last call of `behind` has found.
    [[nodiscard]] bool is_last_within(const ConePlanes& other) const;
    /// What holds no place but those of one plane: that through the lamp, square to the normal.
    ConePlanes nothing_beside(const ConeVector& normal);

private:
    struct Vertex {
        ConeVector at;
        std::uint32_t edge;  ///< what bounds the polygon from here on: a plane of the cone, or of the portal
    };

    bool clip(const ConeVector& normal, std::uint32_t edge);
    [[nodiscard]] std::optional<ConeVector> plane_of(const ConeVector& from, const ConeVector& to) const;
    [[nodiscard]] bool is_over(std::span<const ConeVector> portal, const ConeVector& outward) const;
    void add_ends(const ConeVector& outward);
    void begin_with(std::span<const ConeVector> portal);

    double slack_;
    std::vector<ConeVector> planes_;
    std::vector<Vertex> lit_;    ///< the portal, as far as it is lit
    std::vector<Vertex> spare_;  ///< between two clips
    bool is_last_edge_on_ = false;
};

}  // namespace enfilade::accel::detail

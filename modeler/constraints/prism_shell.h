#pragma once
// Volumes that are prisms, as all are in a sound building: their shells need no search for faces that meet.

#include "modeler/constraints/face_rings.h"

namespace enfilade::modeler {

/// Whether the shell of a volume is a right prism over one simple polygon. Then no two of its faces meet but in what
/// they share, because
/// - its level faces lie at two heights, and at each the edges that two of them share cancel out, seen
/// counter-clockwise,
///   up to the sides of the polygon: so they cover it once (two chains with one border are equal);
/// - its upright faces are rectangles, each over one side, and those over one side stack up without gap from the lower
///   height to the upper one.
/// False says nothing: other shells may be sound, too. \pre the faces' rings are simple, no two vertices lie at one
/// point, the topology is sound. Cost: n log n for n corners.
class PrismShells {
public:
    explicit PrismShells(const FaceRings& rings) : rings_(rings) {}
    [[nodiscard]] bool is_prism(std::uint32_t volume);

private:
    /// A rectangle over a side of the plan, whose ends are packed into 64 bits, the lower one first.
    struct Stand {
        std::uint64_t foot = 0, other_foot = 0;
        std::int32_t z_low = 0, z_high = 0;
        auto operator<=>(const Stand&) const = default;
    };
    /// An edge of a level face, counter-clockwise.
    struct LevelEdge {
        std::uint32_t from = 0, to = 0;
    };

    [[nodiscard]] bool find_heights(std::uint32_t volume);
    [[nodiscard]] bool add_stand(std::uint32_t face);
    void add_level(std::uint32_t face, std::vector<LevelEdge>& edges) const;
    [[nodiscard]] bool sides_stack_up();
    /// Leaves the edges of one face alone; false where more than two run between the same vertices, or alike.
    [[nodiscard]] static bool cancel(std::vector<LevelEdge>& edges);
    /// Whether the edges run over the sides, all of them, once.
    [[nodiscard]] bool runs_over_sides(const std::vector<LevelEdge>& edges);
    [[nodiscard]] bool is_one_simple_ring(std::vector<LevelEdge>& edges) const;
    [[nodiscard]] std::uint64_t foot(std::uint32_t vertex) const {
        const Point3& p = rings_.point(vertex);
        return std::uint64_t(std::uint32_t(p[0])) << 32 | std::uint32_t(p[1]);
    }

    const FaceRings& rings_;
    std::int32_t z_low_ = 0, z_high_ = 0;
    std::vector<Stand> stands_;
    std::vector<std::array<std::uint64_t, 2>> sides_, over_;
    std::array<std::vector<LevelEdge>, 2> levels_;  ///< lower, upper
};

}  // namespace enfilade::modeler

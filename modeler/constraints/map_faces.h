#pragma once
// The faces of the map as its darts tell them: which volumes they part and where they lie. Computed anew from the map,
// so that the building's tables can be held against it.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "modeler/building.h"

namespace enfilade::modeler {

struct MapFace {
    std::array<std::uint32_t, 2> volumes = {UINT32_MAX, UINT32_MAX};  ///< ascending; UINT32_MAX: none
    std::uint32_t dart = UINT32_MAX;                                  ///< one of its darts; UINT32_MAX: not in the map
    std::int32_t z_low = INT32_MAX;
    std::int32_t z_high = INT32_MIN;
    std::array<plans::GridPoint, 2> feet;  ///< of an upright face: the two points of the plan over which it stands
    std::uint8_t foot_count = 0;           ///< points of the plan under its vertices, 3 standing for more than two
    bool joins_two = true;                 ///< not three volumes or more (T4)

    [[nodiscard]] bool in_map() const { return dart != UINT32_MAX; }
    [[nodiscard]] bool level() const { return z_low == z_high; }
    [[nodiscard]] bool upright() const { return foot_count == 2; }
    [[nodiscard]] std::uint32_t beyond(std::uint32_t volume) const {
        return volumes[0] == volume ? volumes[1] : volumes[0];
    }
};

/// Works for any arrays that `gmap::Map` takes: it reads cell ids alone, and no orbit.
class MapFaces {
public:
    explicit MapFaces(const Building& building);

    [[nodiscard]] std::size_t size() const { return faces_.size(); }
    [[nodiscard]] const MapFace& operator[](std::uint32_t face) const { return faces_[face]; }
    /// The faces of a volume, ascending.
    [[nodiscard]] std::span<const std::uint32_t> of_volume(std::uint32_t volume) const {
        return std::span(of_volume_).subspan(first_[volume], first_[volume + 1] - first_[volume]);
    }
    /// Whether the volume has darts.
    [[nodiscard]] bool in_map(std::uint32_t volume) const { return first_[volume] < first_[volume + 1]; }
    /// Whether the map gives the volume the shape that its row says: upright sides from `z_low` to `z_high`, and level
    /// faces at these two heights alone. Where it does not, its geometry is at fault (G), and rules about what stands
    /// on what say nothing about it.
    [[nodiscard]] bool is_prism(std::uint32_t volume) const { return prism_[volume]; }
    /// Where a level face shows to the volume: -1 below it, 1 above it, 0 for sides. \pre is_prism(volume)
    [[nodiscard]] int side(const MapFace& face, std::uint32_t volume) const;

private:
    const Building* building_;
    std::vector<MapFace> faces_;
    std::vector<std::uint32_t> first_;  ///< [volume + 1] into of_volume_
    std::vector<std::uint32_t> of_volume_;
    std::vector<bool> prism_;
};

/// Twice the area within the ring of a level face, in square grid units, 0 or more, walked by its darts.
[[nodiscard]] std::int64_t area2(const Building& building, const MapFace& face);

/// A point on the face, away from its border, in world metres.
[[nodiscard]] std::array<double, 3> middle(const Building& building, const MapFace& face);

}  // namespace enfilade::modeler

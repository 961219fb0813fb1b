#pragma once
// Where a person can walk in a scene: from cell to cell through doors, openings and cuts, and up and down stairs.

#include <cstdint>
#include <optional>
#include <vector>

#include "accel/scene.h"
#include "render/vec.h"

namespace enfilade::tools {

/// How high people look from, above the floor they stand on, metres.
inline constexpr double walking_eye_height = 1.6;

/// A way from one cell to its neighbour, high and low enough to walk through; or up or down a stairwell.
struct Gate {
    accel::CellId from;
    accel::CellId to;
    render::Vec3d eye;  ///< in the middle of the gate, at the height of the eyes; metres, scene frame
    render::Vec3d way;  ///< across it, from `from` to `to`: length 1, level; zero where is_level
    double width;       ///< metres; of stairwells twice the room around their middles
    bool is_level;      ///< a floor or ceiling of a stairwell
};

/// The gates of every cell where people walk: rooms, doors, openings and stairs at least 1.8 m high. The outdoors and
/// windows are left out.
class Walkways {
public:
    explicit Walkways(const accel::SceneView& scene);

    [[nodiscard]] bool is_walkable(accel::CellId cell) const;
    /// Middle of the cell, at the height of the eyes of who stands there.
    [[nodiscard]] render::Vec3d middle(accel::CellId cell) const { return middles_[index(cell)]; }
    /// Metres from the middle to the nearest side of the cell.
    [[nodiscard]] double room_around(accel::CellId cell) const;
    /// Metres from a point of the cell to where it ends in a level direction of length 1.
    [[nodiscard]] double depth(accel::CellId cell, render::Vec3d point, render::Vec3d direction) const;
    /// Whether one walks from this cell straight into the outdoors.
    [[nodiscard]] bool leads_outdoors(accel::CellId cell) const;

    /// [cell_count]: cells with the same number can be walked to from each other.
    [[nodiscard]] std::vector<std::uint32_t> parts() const;

    /// Ways from one cell to all others, by metres walked; narrow gates count as detours.
    struct Ways {
        std::vector<double> metres;             ///< [cell_count]; infinite where no way leads
        std::vector<std::uint32_t> last_gates;  ///< [cell_count]: by which the way enters the cell
    };
    [[nodiscard]] Ways ways_from(accel::CellId cell) const;
    /// The gates on the way to `cell`, in walking order. \pre it can be reached
    [[nodiscard]] std::vector<Gate> gates_to(const Ways& ways, accel::CellId cell) const;

private:
    void add_side_gates(accel::CellId cell);
    void add_level_gate(accel::CellId cell, accel::Target target, double z);

    const accel::SceneView& scene_;
    std::vector<render::Vec3d> middles_;
    std::vector<Gate> gates_;             ///< by `from`
    std::vector<std::uint32_t> offsets_;  ///< [cell_count + 1]
};

}  // namespace enfilade::tools

#pragma once
// What beams light of each cell: where light that goes on from there begins.

#include <cstdint>
#include <optional>
#include <vector>

#include "accel/beam.h"

namespace enfilade::modeler {

/// Of every cell the hull of what any beam lights in it.
class LitRegions {
public:
    explicit LitRegions(const accel::SceneView& scene);
    /// What the beam of this step lights of its cell.
    void add(const accel::BeamStep& step);
    /// All of a cell.
    void add_cell(accel::CellId cell);
    void merge(const LitRegions& other);

    [[nodiscard]] bool is_lit(accel::CellId cell) const { return !parts_[index(cell)].corners.empty(); }
    /// The cells that are lit, ascending.
    [[nodiscard]] std::vector<accel::CellId> cells() const;
    /// What is lit of a cell, rounded outward to the grid. \pre is_lit(cell)
    [[nodiscard]] accel::BeamSource region(accel::CellId cell) const;

private:
    struct Part {
        std::vector<accel::PlanPoint> corners;  ///< a hull
        std::int64_t z_low = 0, z_high = 0;
        bool is_whole = false;
    };
    void add(const accel::BeamSource& whole, std::vector<accel::PlanPoint> corners, std::int64_t z_low,
             std::int64_t z_high);

    accel::SceneView scene_;
    std::vector<Part> parts_;  ///< [cell]
};

}  // namespace enfilade::modeler

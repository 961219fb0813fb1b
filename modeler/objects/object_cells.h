#pragma once
// Which cells of a scene an object is seen in.

#include <array>
#include <cstdint>
#include <vector>

#include "accel/scene_input.h"
#include "modeler/objects/object_box.h"
#include "plans/grid.h"

namespace enfilade::modeler {

/// Finds the cells whose prisms share a place with boxes.
class ObjectCellFinder {
public:
    /// `input` must outlive it and not change. Cost: linear in cells
    ObjectCellFinder(const accel::SceneInput& input, const plans::GridFrame& frame);

    /// Ascending: the cells of `space` that the box touches, and those that it reaches into from there through portals
    /// that are no panes: an object in a doorway, on a window's sill, over an open border is not cut off. The box has
    /// to go through the portal itself, so that it does not depend on how rooms are cut.
    [[nodiscard]] std::vector<std::uint32_t> cells_of(const ObjectBox& box, std::uint32_t space) const;

private:
    struct GridBox;
    [[nodiscard]] bool meets(const GridBox& box, std::uint32_t cell, double margin) const;
    [[nodiscard]] std::size_t last_section(std::uint32_t cell) const;
    void add_neighbours(const GridBox& box, std::uint32_t cell, std::vector<std::uint32_t>& found) const;

    const accel::SceneInput& input_;
    plans::GridFrame frame_;
    std::vector<std::array<std::int32_t, 4>> bounds_;   ///< [cell] least and greatest x, least and greatest y
    std::vector<std::vector<std::uint32_t>> of_space_;  ///< cells, ascending
};

}  // namespace enfilade::modeler

#pragma once
// A storey as SVG: what an architect's plan shows, in layers that a page switches on and off.

#include <set>
#include <string>

#include "tools/report/cell_layers.h"
#include "tools/report/passages.h"
#include "tools/report/plan_view.h"

namespace enfilade::tools {

/// The inside of an `<svg>` whose user unit is the metre: a `<g class="layer layer-X">` for each layer X, and hidden
/// outlines (class "mark") of the elements whose ids are `blamed`. Rooms and marks name their element in `data-el`.
/// `cells`: null where the layers of cells, portals and their graph are left out.
[[nodiscard]] std::string storey_drawing(const PlanView& view, const Passages& passages, std::uint32_t storey,
                                         const CellPaths* cells, const std::set<std::string>& blamed);

/// What all storeys are drawn in, for `viewBox`: metres from the drawings' origin, y down.
struct DrawnBox {
    double x = 0, y = 0, width = 1, height = 1;
};
[[nodiscard]] DrawnBox drawn_box(const PlanView& view);

/// Only what the storey's walls fill, light: a ground for other drawings.
[[nodiscard]] std::string wall_ground(const PlanView& view, std::uint32_t storey);

}  // namespace enfilade::tools

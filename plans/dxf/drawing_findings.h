#pragma once
// What reading a drawing left out or changed, as findings.

#include "plans/dxf/block_costs.h"
#include "plans/dxf/flat_shapes.h"

namespace enfilade::plans::dxf {

/// Adds one finding for each kind of thing, with how many there are and the first line. Only model space and the blocks
/// that it uses count.
void add_findings(Drawing& drawing, const Contents& contents, const BlockUse& use, const FlatShapes& shapes);

}  // namespace enfilade::plans::dxf

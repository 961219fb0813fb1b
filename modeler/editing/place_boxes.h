#pragma once
// A stack with boxes standing in its rooms.

#include <memory>
#include <string>
#include <vector>

#include "modeler/editing/box.h"
#include "modeler/stack.h"

namespace enfilade::modeler {

/// The stack with all of these boxes: each becomes a space labelled Object, and slices of its columns. Points, edges,
/// regions and spaces of `bare` keep their numbers (an edge on which a box ends becomes a chain whose first part has
/// its number), so that regions that no box touches are the same in both. The result knows `bare` and the boxes, by
/// ascending id. Throws InputError P503 to P506 where boxes cannot stand so (docs/findings.md).
/// \pre `bare` holds no boxes. Cost: linear, and the corners of each room with boxes times its boxes
[[nodiscard]] Stack place_boxes(const std::shared_ptr<const Stack>& bare, std::vector<Box> boxes);

/// 'the box "desk"'
[[nodiscard]] std::string called(const Box& box);

}  // namespace enfilade::modeler

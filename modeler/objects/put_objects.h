#pragma once
// Objects put into a building.

#include <vector>

#include "accel/parallel_for.h"
#include "base/finding.h"
#include "modeler/building.h"

namespace enfilade::modeler {

/// The building with these objects, in the way that `furnishing.cells` says; what it held before goes.
/// With `Cut`, the boxes of objects become volumes labelled Object (editing/edit.h); objects of one room whose boxes
/// share a place share a volume. An object that cannot be a volume (it fills its room, stands in no room, is thinner
/// than the grid can hold) is listed by the cells around it, and `findings` says so.
/// A building read back from a file (it holds no stack) keeps the volumes of a former `Cut`: they do not show.
/// \pre the building holds its stack, or `furnishing.cells` is List. Throws nothing but what `insert_boxes` does not
/// foresee. Cost: List: linear in the objects; Cut: as `insert_boxes`
[[nodiscard]] Building put_objects(const Building& building, Furnishing furnishing, std::vector<Finding>& findings,
                                   const accel::Executor& executor = accel::SerialExecutor());

}  // namespace enfilade::modeler

#pragma once
// Boxes put into the rooms of a building, and taken out again.

#include <span>
#include <string_view>

#include "accel/parallel_for.h"
#include "modeler/building.h"
#include "modeler/editing/box.h"

namespace enfilade::modeler {

/// What an edit had to do.
struct EditCount {
    std::size_t regions = 0;    ///< of the building that it made
    std::size_t cut_again = 0;  ///< of them; the others are as they were
};

/// The building with each box as volumes labelled Object, with the box's id and name. Its floor is the footprint as far
/// as it lies in the room; over it the room is cut in slices, from its floor to the box, the box, from there to its
/// ceiling. Works on buildings of whole rooms and of convex cells, and stays what it is. Only regions that a box
/// touches are cut again; the result is the building that `realise` makes of its stack, and the same whether boxes come
/// one by one or all at once, in any order.
///
/// - Boxes of one room may touch, stand on each other, or above each other with different footprints (each of them is
///   then several volumes of one space). Boxes that share a place thicker than `least_thickness` are refused (P504);
///   of a thinner one the box with the lower id keeps it.
/// - A box that goes through a wall, straight or curved, is clipped; parts on several sides of a column or a corner are
///   several volumes of its space. One of which less than `least_thickness` is left, or that misses its room in height,
///   is refused (P505): so are footprints one unit thick. Heights of one unit are kept.
/// - A corner that lies within `least_thickness` of a wall's corner or side is put there; floor thinner than that
///   between a box and a wall belongs to the box. So boxes stand flush with walls turned by any angle.
/// - As large as the room, it leaves the room what is above or below; boxes that leave it nothing are refused (P506).
/// - On the edge of a stair's hole it is cut along the edge: two volumes, the one over the hole with a portal down.
/// - Through an open border between two rooms it is clipped there, as by a wall.
/// - For what is no room, with no height, with a ring that is not convex, or with an id that is taken: P503.
///
/// Throws InputError with these codes, and leaves `building` as it is. \pre the building holds its stack (it comes from
/// `build`, `convexify` or an edit). Cost: the regions cut again, then linear in the building.
[[nodiscard]] Building insert_boxes(const Building& building, std::span<const Box> boxes,
                                    const accel::Executor& executor = accel::SerialExecutor(),
                                    EditCount* count = nullptr);

/// The building with exactly these boxes, whatever stands in it. Throws and costs as `insert_boxes`. \pre as above
[[nodiscard]] Building with_boxes(const Building& building, std::vector<Box> boxes,
                                  const accel::Executor& executor = accel::SerialExecutor(),
                                  EditCount* count = nullptr);

/// The building without the box of that id: as if it had never been put in. Throws InputError P507 where there is none.
/// \pre as above
[[nodiscard]] Building remove_box(const Building& building, std::string_view id,
                                  const accel::Executor& executor = accel::SerialExecutor(),
                                  EditCount* count = nullptr);

}  // namespace enfilade::modeler

#pragma once
// Books that stand, lie, lean.

#include <cstdint>

#include "modeler/catalogue/own/shapes.h"
#include "plans/random.h"

namespace enfilade::modeler::own {

/// A book that stands on z = 0 with its spine towards -y: x from 0 to its thickness, y from 0 to its depth. Boards, a
/// rounded spine, the pages set back between them; at detail 3 the pages come in sheets.
void book(Shaper& shaper, Size size, const Paint& cover);

/// Books from `from.x` to `to_x` on a shelf at `from.z`, spines at `from.y`: of several heights up to `most_height`,
/// the row ends early now and then, the last one leaning or some lying.
void book_row(Shaper& shaper, Vec from, double to_x, double most_height, double depth, plans::Random& random);

/// Books that lie on top of each other about the origin, spines towards -y.
void book_stack(Shaper& shaper, int count, Size most, plans::Random& random);

}  // namespace enfilade::modeler::own

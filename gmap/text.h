#pragma once
// A map as text: to look at, to compare in a version control, to write by hand in a test.

#include <iosfwd>

#include "gmap/map.h"

namespace enfilade::gmap {

/// Writes
///     enfilade-gmap 1
///     darts 96 vertices 8 edges 12 faces 6 volumes 2
/// and one line a dart: alpha0 alpha1 alpha2 alpha3 vertex edge face volume. A map with gaps is written as if
/// compacted.
void write_text(const Map& map, std::ostream& out);

/// Reads it back. Lines may hold comments after #. The map is what the text says, sound or not: `validate` it.
/// Throws std::invalid_argument with the line where the text is no map.
[[nodiscard]] Map read_text(std::istream& in);

}  // namespace enfilade::gmap

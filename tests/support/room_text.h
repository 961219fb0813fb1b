#pragma once
// A room as text: to keep the one on which a cutter failed.

#include <iosfwd>
#include <string>

#include "tests/support/room.h"

namespace enfilade::testing {

/// Lines that begin with # are remarks. A line `x y` a point, a blank line, then a line `from to line tag look faces` a
/// side.
void write_room(std::ostream& out, const Room& room);
[[nodiscard]] Room read_room(std::istream& in);
/// As the initialisers of a named regression test.
[[nodiscard]] std::string source_of(const Room& room);

}  // namespace enfilade::testing

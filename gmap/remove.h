#pragma once
// Cells taken away, so that their neighbours merge: the inverse of `gmap/insert.h` and of `close`.

#include <optional>

#include "gmap/changes.h"
#include "gmap/map.h"

namespace enfilade::gmap {

/// Removes the vertex of `d`, which joins two edges and no more; they become one, the lower id stays.
/// Without an answer, and without any change, where the vertex has another degree or its edges would stay open.
[[nodiscard]] std::optional<Changes> remove_vertex(Map& map, DartId d);

/// Removes the edge of `d`: its two faces become one, the lower id stays; an edge that dangles in its face goes with
/// its tip. Without an answer, and without any change, where more than two faces meet, where the face is the same on
/// both sides without dangling (its outline would fall apart into two rings), or where a face would stay open.
[[nodiscard]] std::optional<Changes> remove_edge(Map& map, DartId d);

/// Removes the face of `d`: its two volumes become one, the lower id stays; a fin, attached to its one volume along a
/// single run of edges, goes with its free edges. Without an answer, and without any change, where the volume is the
/// same on both sides otherwise, or would stay open. Volumes that meet in several faces touch themselves in the others
/// afterwards: remove those with care (T4 finds them).
[[nodiscard]] std::optional<Changes> remove_face(Map& map, DartId d);

/// Removes the volume of `d` with all of its darts; its faces become 3-free where a neighbour keeps them. Undoes
/// `close`.
[[nodiscard]] std::optional<Changes> remove_volume(Map& map, DartId d);

}  // namespace enfilade::gmap

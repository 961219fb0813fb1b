#pragma once
// New cells inside old ones: a vertex in an edge, an edge in a face, a face in a volume. Each keeps V - E + F - C.

#include <optional>
#include <span>

#include "gmap/changes.h"
#include "gmap/map.h"

namespace enfilade::gmap {

/// Cuts the edge of `d` by a new vertex. `dart`: alpha<0>(d), at the new vertex. The half at `d` keeps the edge's id.
/// Without an answer where `d` is no dart. Undone by `remove_vertex(dart)`. Cost: the darts of the edge.
[[nodiscard]] std::optional<Changes> insert_vertex(Map& map, DartId d);

/// Joins two corners of a face by a new edge, which splits it; a corner is the place between a dart and its alpha<1>.
/// `dart`: the dart of the new edge next to `d`. The part with `d` keeps the face's id. The edge lies on both sides of
/// the face. Without an answer, and without any change, where the corners are one, lie on different faces or on
/// different sides of one, or where the face is not closed. Neighbouring corners enclose a face of two edges: T6 will
/// say so. Undone by `remove_edge(dart)`. Cost: the darts of the face.
[[nodiscard]] std::optional<Changes> insert_edge(Map& map, DartId d, DartId e);

/// Spans a new face along a closed path on the shell of a volume, which splits it. `path[k]` leads along its edge from
/// its own vertex to that of path[k + 1]; all of its darts lie on one side of the path: from alpha<0>(path[k]),
/// alpha<1> and then alpha<2>, alpha<1> again and again lead to path[k + 1] without crossing the path. That side keeps
/// the volume's id. `dart`: the dart of the new face next to path[0]. Without an answer, and without any change, where
/// the path is not like that, meets itself, or touches a free dart. Undone by `remove_face(dart)`. Cost: the darts of
/// the volume.
[[nodiscard]] std::optional<Changes> insert_face(Map& map, std::span<const DartId> path);

}  // namespace enfilade::gmap

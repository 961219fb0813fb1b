#pragma once
// The graph of a scene as Graphviz draws it.

#include <string>

#include "accel/scene.h"

namespace enfilade::modeler {

enum class GraphLevel : std::uint8_t {
    Spaces,  ///< a node a room, door, window, ...; an edge for all portals of one kind between two of them
    Cells,   ///< a node a convex cell, an edge a portal
};

/// An undirected graph in the DOT language. Storeys (at cell level: spaces) are clusters; rooms are boxes with their
/// floor area, doors and windows small ellipses; edges say how many square metres are open, glass is dashed and cuts
/// of one space are dotted. Each node has its place in the plan (1:40), storeys over each other, so that
/// `dot -Tsvg` draws what one recognises; `-Kfdp` makes a layout of its own, with the clusters drawn.
/// About 150 bytes a node and 60 an edge.
[[nodiscard]] std::string to_dot(const accel::SceneView& scene, GraphLevel level = GraphLevel::Spaces);

}  // namespace enfilade::modeler

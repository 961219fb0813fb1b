#pragma once
// A model in the frame, the units and the size of the catalogue.

#include <array>
#include <optional>
#include <string>

#include "modeler/catalogue/object_mesh.h"
#include "modeler/catalogue/raw_mesh.h"

namespace enfilade::modeler {

using Rotation = std::array<double, 9>;  ///< rows

inline constexpr Rotation no_rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/// Where a model's front looks, once it stands upright in our frame.
enum class Front : std::uint8_t { MinusY, PlusY, MinusX, PlusX };

/// How a model is brought into our frame, in this order.
struct Fitting {
    Rotation rotation = no_rotation;  ///< in the axes of the file
    std::optional<UpAxis> up;         ///< nothing: what its format usually has
    Front front = Front::MinusY;      ///< is turned to -y
    double unit = 1;                  ///< metres a unit of the file
    std::optional<std::array<double, 3>>
        size;  ///< of the box, metres: each side is scaled by itself; else `unit` holds
    friend bool operator==(const Fitting&, const Fitting&) = default;
};

/// A box by its two corners.
struct MeshBox {
    std::array<double, 3> low = {0, 0, 0};
    std::array<double, 3> high = {0, 0, 0};
    [[nodiscard]] double side(std::size_t k) const { return high[k] - low[k]; }
};

/// Of all vertices; a point at the origin where there are none.
[[nodiscard]] MeshBox box_of(const ObjectMesh& mesh);

/// The extent of what the triangles use, turned upright, in units of the file.
[[nodiscard]] std::array<double, 3> natural_size(const RawMesh& raw, const Fitting& fitting);

/// The mesh as described in object_mesh.h: vertices at one place become one (no coordinate moves), unused ones go, and
/// triangles that cannot be seen (opacity 0) are left out, though the box is of all. Sides without extent are not
/// scaled. The order of triangles is the file's. Cost: n log n.
[[nodiscard]] ObjectMesh fitted(const RawMesh& raw, const Fitting& fitting, std::string name);

}  // namespace enfilade::modeler

#pragma once
// Floors furnished by our own rules with our own pieces, for benchmarks.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "accel/scene.h"
#include "modeler/building.h"
#include "modeler/furnishing/furnish.h"
#include "plans/plan.h"

namespace enfilade::tools {

/// Seconds of each step from a plan to a scene, on all cores.
struct FurnishTimes {
    double rooms = 0;      ///< modelling and cutting
    double catalogue = 0;  ///< opening it
    double placing = 0;    ///< by rule; meshes are read on the way
    double putting = 0;    ///< objects into cells
    double scene = 0;      ///< checking and exporting
    [[nodiscard]] double all() const { return rooms + catalogue + placing + putting + scene; }
};

struct FurnishedFloor {
    std::string name;
    modeler::Building building;  ///< convex, furnished
    std::vector<modeler::RoomFurnished> rooms;
    FurnishTimes times;
    accel::Scene scene;

    /// Triangles of all meshes once.
    [[nodiscard]] std::size_t unique_triangles() const { return scene.view().mesh_triangles.size(); }
    /// Triangles of all objects.
    [[nodiscard]] std::size_t instanced_triangles() const;
    /// What tracers read of the rooms, without what stands in them.
    [[nodiscard]] std::size_t room_bytes() const;
    /// Meshes and objects.
    [[nodiscard]] std::size_t object_bytes() const;
};

struct FloorOptions {
    std::uint32_t detail = 4;            ///< of our pieces
    std::uint32_t object_triangles = 0;  ///< meshes of more are decimated to this; 0: never
    std::uint64_t seed = 1;
    modeler::ObjectCells cells = modeler::ObjectCells::List;
    std::vector<std::uint32_t> spaces = {};  ///< the rooms to furnish; empty: all
};
[[nodiscard]] FurnishedFloor furnished_floor(std::string name, const plans::Plan& plan, const FloorOptions& options);
/// The same of rooms that are modelled already. \pre rooms is convex
[[nodiscard]] FurnishedFloor furnished_floor(std::string name, const modeler::Building& rooms,
                                             const FloorOptions& options);

}  // namespace enfilade::tools

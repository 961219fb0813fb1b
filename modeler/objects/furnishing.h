#pragma once
// What stands in a building: objects that share meshes.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "modeler/catalogue/object_mesh.h"

namespace enfilade::modeler {

/// An object at its place. Metres and radians, in the frame of the building's plan (not of its grid).
struct FurnishedObject {
    std::string id;  ///< its own: "living-room/chair-2", or the plan's
    std::string name;
    std::string model;        ///< id of its catalogue entry
    std::uint32_t mesh = 0;   ///< into Furnishing::meshes
    std::uint32_t space = 0;  ///< the room (or the exterior) that it stands in: into Building::spaces
    std::array<double, 3> position = {0, 0, 0};  ///< middle of the bottom of its box; z as storeys' elevations
    double angle = 0;                            ///< counter-clockwise, about the vertical; 0: the front towards -y
    std::array<double, 3> size = {1, 1, 1};      ///< width, depth, height of its box: its mesh is scaled to that
    bool mirrored = false;                       ///< left and right of the mesh exchanged
    std::array<double, 9> turned = {1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< the mesh before it is scaled: rows, not singular
    std::optional<std::array<float, 3>> colour;                  ///< of the whole object, linear RGB
    bool by_rule = false;                                        ///< placed by rule: S6 is strict about it
    std::string stands_on;                                       ///< id of the object that carries it; empty: none
    std::string volume;  ///< id of the Object space that holds it (`Cut`); empty: it is listed by its room's cells
    friend bool operator==(const FurnishedObject&, const FurnishedObject&) = default;
};

/// How objects and cells know each other.
enum class ObjectCells {
    List,  ///< rooms stay whole: each cell lists the objects whose boxes share a place with it
    Cut    ///< each object is a volume of its own, around which its room is cut (Maria et al. 2013)
};

struct Furnishing {
    std::vector<std::shared_ptr<const ObjectMesh>> meshes;
    std::vector<FurnishedObject> objects;  ///< by ascending id
    ObjectCells cells = ObjectCells::List;
    [[nodiscard]] bool empty() const { return objects.empty(); }
};

/// The rows of 3 x 4 numbers that take the object's mesh to the plan's frame: turned, scaled from the mesh's own box
/// (after it was turned) to `size`, mirrored, turned by `angle`, moved. Sizes of flat meshes are not scaled.
[[nodiscard]] std::array<double, 12> plan_from_mesh(const FurnishedObject& object, const ObjectMesh& mesh);

}  // namespace enfilade::modeler

#pragma once
// One object of a building, moved, turned, added or removed.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "modeler/building.h"

namespace enfilade::tools {

/// What an edit makes of the furniture.
struct EditedObjects {
    modeler::Furnishing furnishing;
    std::vector<std::string> ids;  ///< ascending: what was moved, added or removed
    std::string what;              ///< "moved table-1 and what stands on it (2 objects)"
};

/// A place on the plan, metres; without z on the floor, or as high as before.
struct PlaceAt {
    double x = 0;
    double y = 0;
    std::optional<double> z;
};
/// "X,Y" or "X,Y,Z". \throws InputError (F117)
[[nodiscard]] PlaceAt parse_place(const std::string& text);

/// What stands on an object goes with it. \throws InputError: F119 where there is no object of that id, with the
/// nearest one; F120 where the place lies in a wall, a slab or beyond the site
[[nodiscard]] EditedObjects moved(const modeler::Building& building, const std::string& id, const PlaceAt& at,
                                  std::optional<double> angle);
[[nodiscard]] EditedObjects turned(const modeler::Building& building, const std::string& id, double by);
[[nodiscard]] EditedObjects removed(const modeler::Building& building, const std::string& id);
/// model: of an object that the building holds, an entry of our own or of the catalogues, or a kind of them. id: empty
/// for one made from the model. \throws InputError: F121 where there is no such model; F122 where the id is taken
[[nodiscard]] EditedObjects added(const modeler::Building& building, const std::string& model, const std::string& id,
                                  const PlaceAt& at, double angle,
                                  const std::vector<std::filesystem::path>& catalogues);

}  // namespace enfilade::tools

#pragma once
// What catalogue.json says of the meshes beside it (docs/catalogues.md).

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "modeler/catalogue/fit_mesh.h"

namespace enfilade::modeler {

/// Of one mesh, or of all that have no word of their own.
struct SidecarEntry {
    std::optional<std::string> name;
    std::optional<std::string> kind;
    std::optional<std::string> category;
    std::optional<std::array<double, 3>> size;  ///< metres; sides of 0 follow the first that is given
    std::optional<double> unit;                 ///< metres a unit of the file
    std::optional<UpAxis> up;
    std::optional<std::string> front;  ///< "+x" ... "-z": an axis of the file
    std::optional<double> elevation;
    std::optional<double> top;
    std::optional<std::string> creator;
    std::optional<std::string> licence;
};

struct Sidecar {
    SidecarEntry defaults;
    std::map<std::string, SidecarEntry, std::less<>> meshes;  ///< by name in the folder
};

/// \throws InputError P101-P105 with line and column for what is no JSON, an unknown key, or a value out of its range
[[nodiscard]] Sidecar read_sidecar(std::string_view text, const std::string& file);

/// What holds for a mesh: its own words before the defaults'.
[[nodiscard]] SidecarEntry words_for(const Sidecar& sidecar, std::string_view mesh);

/// Where an axis of the file points to once `up` is up; nothing where it points up or down, or is no axis.
[[nodiscard]] std::optional<Front> front_along(std::string_view axis, UpAxis up);

}  // namespace enfilade::modeler

#pragma once
// Material libraries of OBJ files.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace enfilade::modeler {

struct MtlMaterial {
    std::optional<std::array<double, 3>> diffuse;  ///< Kd as written, in [0, 1]: sRGB (README.md)
    double opacity = 1;                            ///< d, or 1 - Tr
    double mirror = 0;                             ///< mean of Ks where illum is 3, 5 or 8: reflection without glass
    std::string image;                             ///< map_Kd, without its options; empty: none
};

/// The materials by name. What is no number, and every other statement, is passed over; never fails.
[[nodiscard]] std::map<std::string, MtlMaterial, std::less<>> read_mtl(std::string_view bytes);

/// A colour by the words of a material's name, sRGB in [0, 1]: "dkgrey", "flltbrown", "Wood_pine". For models that name
/// materials that no file defines, as those of Sweet Home 3D's own catalogue do.
[[nodiscard]] std::optional<std::array<double, 3>> colour_of_name(std::string_view name);

}  // namespace enfilade::modeler

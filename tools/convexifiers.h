#pragma once
// The names of the ways to cut rooms into convex cells, as --convexify takes them.

#include <array>
#include <string>
#include <string_view>

#include "modeler/convexify.h"

namespace enfilade::tools {

struct NamedConvexifier {
    const char* name;
    modeler::Convexifier convexifier;
};
inline constexpr std::array named_convexifiers = {
    NamedConvexifier{"sah", modeler::Convexifier::Sah},
    NamedConvexifier{"hertel-mehlhorn", modeler::Convexifier::HertelMehlhorn},
    NamedConvexifier{"diagonals", modeler::Convexifier::Diagonals},
};

[[nodiscard]] const char* name_of(modeler::Convexifier convexifier);

/// Throws InputError F103 where no convexifier has this name.
[[nodiscard]] modeler::Convexifier convexifier_of(std::string_view name);

}  // namespace enfilade::tools

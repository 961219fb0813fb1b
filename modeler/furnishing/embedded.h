#pragma once
// Files of the tree that are part of the program: written into embedded.cpp.in when the build is configured.

#include <string_view>

namespace enfilade::modeler::embedded {

extern const std::string_view own_rules;  ///< modeler/furnishing/own_rules.json

}  // namespace enfilade::modeler::embedded

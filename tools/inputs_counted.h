#pragma once
// inputs_counted.json, built into the program.

#include <string_view>

namespace enfilade::tools {

extern const std::string_view inputs_counted;

}  // namespace enfilade::tools

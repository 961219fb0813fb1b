#pragma once
// "did you mean": the known word that is nearest to a mistyped one.

#include <span>
#include <string>
#include <string_view>

namespace enfilade::tools {

/// " (did you mean \"build\"?)", or nothing where no known word is near.
[[nodiscard]] std::string suggestion(std::string_view word, std::span<const std::string> known);

}  // namespace enfilade::tools

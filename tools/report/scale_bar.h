#pragma once
// A bar that shows how long a round number of metres is.

#include <string>

namespace enfilade::tools {

/// The longest of 1, 2 and 5 times a power of ten that is at most `longest`; metres. \pre longest > 0
[[nodiscard]] double round_length(double longest);

/// "5 m", "20 cm"
[[nodiscard]] std::string length_text(double metres);

}  // namespace enfilade::tools

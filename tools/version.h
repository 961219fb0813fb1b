#pragma once

namespace enfilade::tools {
inline constexpr const char* version = ENFILADE_VERSION;  // of CMakeLists.txt
}  // namespace enfilade::tools

#pragma once
// Is this JSON a FloorspaceJS floor plan? Told by the keys of its outermost object, without parsing the rest.

#include <string_view>

namespace enfilade::plans {

/// True where the outermost object has "stories", or else "application" or "project", and none of the keys of our own
/// format ("storeys", "format_version"). The text may be cut off or malformed: what can be read decides. Cost: linear.
[[nodiscard]] bool is_floorspace(std::string_view text);

}  // namespace enfilade::plans

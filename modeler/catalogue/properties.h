#pragma once
// Java's .properties files, in which Sweet Home 3D describes its libraries.

#include <map>
#include <string>
#include <string_view>

namespace enfilade::modeler {

/// Keys and values in UTF-8, as java.util.Properties reads them: comments, continued lines, `=`, `:` or blanks behind a
/// key, escapes (\t, \n, \u and four digits, with surrogate pairs). Text that is not UTF-8 is ISO-8859-1. The last of
/// equal keys wins. Never fails: a half escape is taken as it stands. Cost: linear.
[[nodiscard]] std::map<std::string, std::string, std::less<>> read_properties(std::string_view bytes);

}  // namespace enfilade::modeler

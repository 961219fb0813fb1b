#pragma once
// What codes of findings mean, in the words of docs/checks.md and docs/findings.md, which are built in.

#include <string>
#include <string_view>

namespace enfilade::tools {

/// Plain text without marks; empty where the documents have no row for the code.
[[nodiscard]] std::string meaning_of(std::string_view code);

}  // namespace enfilade::tools

#pragma once
// Files of the tree that are part of the program: written into embedded.cpp.in when the build is configured.

#include <string_view>

namespace enfilade::tools::embedded {

extern const std::string_view page_style;     ///< tools/report/page.css
extern const std::string_view page_script;    ///< tools/report/page.js
extern const std::string_view checks_page;    ///< docs/checks.md
extern const std::string_view findings_page;  ///< docs/findings.md

}  // namespace enfilade::tools::embedded

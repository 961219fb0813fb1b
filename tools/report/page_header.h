#pragma once
// The top of the report: the verdict, what was checked, and how much of everything there is.

#include <string>

#include "tools/check_report.h"
#include "tools/report/passages.h"

namespace enfilade::tools {

/// "sound", "not sound", "not checked": as the report in JSON has it.
[[nodiscard]] std::string verdict_text(const ReportSubject& subject, const modeler::CheckReport& report);

/// `view`, `passages`: null where nothing can be drawn; `building`: null for a stripped scene.
[[nodiscard]] std::string page_header(const ReportSubject& subject, const modeler::CheckReport& report,
                                      const modeler::Building* building, const PlanView* view);

/// A row for each code that was checked or found: its meaning and how often.
[[nodiscard]] std::string code_table(const modeler::CheckReport& report);

}  // namespace enfilade::tools

#pragma once
// The report as one page: the storeys drawn, findings pinned on them and listed, the graph of rooms.

#include <string>

#include "tools/check_report.h"

namespace enfilade::tools {

struct PageOptions {
    std::size_t cell_bytes = 12'000'000;  ///< cells and portals are left out, and that is said, where they take more
};

/// HTML that needs no other file and no network. `building`: null where there is none (a stripped scene): the page then
/// has the findings alone, as it has where the model is too damaged to be drawn. The same input gives the same bytes.
[[nodiscard]] std::string report_page(const ReportSubject& subject, const modeler::CheckReport& report,
                                      const modeler::Building* building, const PageOptions& options = {});

}  // namespace enfilade::tools

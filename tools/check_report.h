#pragma once
// What `check` found, for people and for programs.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "modeler/check.h"

namespace enfilade::tools {

/// What a report is about.
struct ReportSubject {
    std::string input;  ///< file that was checked
    std::string
        certificate;  ///< of a scene: "certified", "differs at ...", "uncertified: no model group"; of a plan: empty
};

/// Whether the exit code says so: errors always, warnings with --strict.
[[nodiscard]] bool has_defects(const modeler::CheckReport& report, bool strict);

/// `limit` findings of each severity at most.
[[nodiscard]] std::string report_text(const ReportSubject& subject, const modeler::CheckReport& report,
                                      std::size_t limit = SIZE_MAX);
/// docs/check.schema.json
[[nodiscard]] nlohmann::ordered_json report_json(const ReportSubject& subject, const modeler::CheckReport& report);

/// JSON as a file holds it, with a line end; bytes that are no UTF-8 (names of old files) are replaced.
[[nodiscard]] std::string dump(const nlohmann::ordered_json& json);

/// Throws InputError where a report's name ends in none of .html, .json and .txt; nothing where it is empty.
void need_report_name(const std::filesystem::path& file);

/// Writes the report as `file`'s extension says; `building` is drawn in a page, null where there is none.
/// Throws InputError as `need_report_name`, IoError.
void write_report(const std::filesystem::path& file, const ReportSubject& subject, const modeler::CheckReport& report,
                  const modeler::Building* building);

}  // namespace enfilade::tools

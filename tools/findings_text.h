#pragma once
// Findings as people and programs read them.

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "base/finding.h"

namespace enfilade::tools {

/// How many findings there are of each severity, by `Severity`.
struct SeverityCounts {
    std::array<std::size_t, 3> of = {};
    [[nodiscard]] std::size_t operator[](Severity severity) const { return of[std::size_t(severity)]; }
};
[[nodiscard]] SeverityCounts count(std::span<const Finding> findings);

/// "2 errors, 1 warning and 5 notes"; "no findings".
[[nodiscard]] std::string counts_text(std::span<const Finding> findings);

/// All of them, errors first, each with its code, place and remedy. At most `limit` of one severity, with a line that
/// says how many more there are.
[[nodiscard]] std::string findings_text(std::span<const Finding> findings, std::size_t limit = SIZE_MAX);

/// The array `findings` of docs/check.schema.json.
[[nodiscard]] nlohmann::ordered_json findings_json(std::span<const Finding> findings);

}  // namespace enfilade::tools

#pragma once
// Plans from files: one entry, the reader chosen by content, then by extension.

#include <filesystem>
#include <span>
#include <string>

#include "plans/plan.h"

namespace enfilade::plans {

/// Reads a plan in any known format (native JSON, Sweet Home 3D). Throws InputError with the place, IoError where the
/// file cannot be read.
[[nodiscard]] Plan read(const std::filesystem::path& file);

/// Our own JSON: schema in docs/plan.schema.json, comments allowed, unknown keys refused.
[[nodiscard]] Plan read_json(std::string_view text, const std::string& file_name);
[[nodiscard]] std::string write_json(const Plan& plan);

/// A Sweet Home 3D home: zip with Home.xml (lengths in centimetres, y down).
[[nodiscard]] Plan read_sweet_home(std::span<const std::byte> bytes, const std::string& file_name);

/// Sizes in metres.
struct CleanOptions {
    double join_gap = 0.05;  ///< wall ends this close to another wall's end or face are brought to it; 0: none
    double step = 0.25;      ///< sloped wall tops are cut into steps of at most this height, greater than 0
};

/// Repairs what can be repaired and says so in `findings` (docs/findings.md, P2..): storeys out of order or too close,
/// wall ends that nearly meet, walls drawn twice, sloped tops, openings beyond their wall, elements without extent.
/// What cannot be used is left out with an error. Idempotent; the order of elements does not matter.
/// \pre ids are unique within the plan
[[nodiscard]] Plan clean(Plan plan, const CleanOptions& options = {});

}  // namespace enfilade::plans

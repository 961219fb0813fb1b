#pragma once
// From blocks of entities to flat geometry: every insertion carried out.

#include <string>

#include "plans/dxf/drawing.h"
#include "plans/dxf/entities.h"

namespace enfilade::plans::dxf {

/// Model space of `contents` with its insertions. Throws InputError where blocks stand in themselves, or where they ask
/// for more than `limits`; that is counted before anything is made.
[[nodiscard]] Drawing explode(const Contents& contents, const DrawingLimits& limits, const std::string& file_name);

}  // namespace enfilade::plans::dxf

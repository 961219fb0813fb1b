#pragma once
// Inside of accel: building and parsing the bytes of a scene file.

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "accel/scene_file.h"

namespace enfilade::accel::detail {

/// Lays out arrays (their bytes and `sha256` given) behind a header and a section table.
[[nodiscard]] Scene::Storage lay_out(double unit, const std::array<double, 3>& origin,
                                     std::span<const SceneArray> arrays);

/// Reads header and table, checks them against the size and against each other, and points the view at the arrays.
/// \throws InputError (F1, F2, F3)
[[nodiscard]] Scene parse(Scene::Storage storage, const std::string& file_name);

/// `parse`, then `validate`, then the hashes if asked for. \throws InputError
[[nodiscard]] Scene parse_and_validate(Scene::Storage storage, const std::string& file_name,
                                       const ReadOptions& options);

/// Zeroed memory aligned to 64 bytes.
[[nodiscard]] std::shared_ptr<std::byte> allocate_aligned(std::size_t size);

}  // namespace enfilade::accel::detail

#pragma once
// Our own pieces of furniture: parametric, so that the default needs no files.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "modeler/catalogue/catalogue.h"

namespace enfilade::modeler {

/// A piece that this program makes itself.
struct OwnPiece {
    CatalogueEntry entry;                                ///< without triangles and defects, which depend on the detail
    ObjectMesh (*make)(std::uint32_t detail) = nullptr;  ///< 1 to 8; at the size that the entry states
};

/// By ascending id.
[[nodiscard]] std::span<const OwnPiece> own_pieces();

}  // namespace enfilade::modeler

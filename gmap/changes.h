#pragma once
// What an operation did to the cells, so that whatever is keyed by cell id can follow.

#include <cstdint>
#include <vector>

#include "gmap/ids.h"

namespace enfilade::gmap {

/// One cell that came, went, was split or merged.
struct CellChange {
    enum class Kind {
        Created,  ///< `cell` is new
        Split,    ///< `other` is new and was a part of `cell`
        Merged,   ///< `other` is gone and is a part of `cell` now
        Removed   ///< `cell` is gone
    };
    Kind kind;
    int dimension;
    std::uint32_t cell;
    std::uint32_t other = detail::none_u32;

    friend bool operator==(const CellChange&, const CellChange&) = default;
};

/// All that one operation changed, in the order in which followers have to apply it.
struct Changes {
    std::vector<CellChange> cells;
    DartId dart = none<DartId>;  ///< a dart of the cell that was inserted; each operation says which
};

}  // namespace enfilade::gmap

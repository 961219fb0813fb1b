#pragma once
// Words and usual sizes of each kind of furniture.

#include <array>
#include <span>
#include <string_view>

namespace enfilade::modeler {

struct KindWords {
    std::string_view kind;
    std::string_view phrases;     ///< plain words (furnishing/plain_words.h), '|' between them
    std::array<double, 2> width;  ///< metres, from and to
    std::array<double, 2> depth;
    std::array<double, 2> height;
    std::array<double, 2> elevation = {0, 0.6};
};

/// Of two rows that fit equally well, the first counts.
[[nodiscard]] std::span<const KindWords> kind_table();

/// Phrases whose holders are of no kind, though they hold words of one: "shower curtain".
[[nodiscard]] std::string_view phrases_of_no_kind();

/// Categories of things that stand in no room.
[[nodiscard]] std::string_view categories_of_no_kind();

}  // namespace enfilade::modeler

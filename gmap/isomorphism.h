#pragma once
// Whether two maps are the same but for the numbering of their darts.

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "gmap/map.h"

namespace enfilade::gmap {

/// What a dart has to agree in besides its links, e.g. the label of its volume. Different things need different
/// numbers.
using DartLabel = std::function<std::uint64_t(DartId)>;

/// A bijection of darts that commutes with all alphas and keeps the labels: for each slot of `a` the dart of `b`,
/// `none` for gaps. Without an answer where there is none. The maps may have several connected pieces; both empty: the
/// empty one. Cell ids are not compared. Cost: a few sorts of the darts (colour refinement), then one walk for most
/// maps.
[[nodiscard]] std::optional<std::vector<DartId>> find_isomorphism(const Map& a, const Map& b,
                                                                  const DartLabel& label_a = {},
                                                                  const DartLabel& label_b = {});

/// Whether `find_isomorphism` has an answer.
[[nodiscard]] bool is_isomorphic(const Map& a, const Map& b, const DartLabel& label_a = {},
                                 const DartLabel& label_b = {});

/// The isomorphism of the connected piece of `from` that sends it to `to`, if there is one: [dart_bound of a], `none`
/// beyond the piece. Cost: the darts of the piece, or until the first difference.
[[nodiscard]] std::optional<std::vector<DartId>> extend_isomorphism(const Map& a, DartId from, const Map& b, DartId to);

}  // namespace enfilade::gmap

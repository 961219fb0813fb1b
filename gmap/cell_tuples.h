#pragma once
// A closed 3-map from its faces: a dart is the tuple (volume, face, edge, vertex) and alpha<i> changes the i-th id.

#include <array>
#include <cstdint>
#include <vector>

#include "gmap/defect.h"
#include "gmap/map.h"

namespace enfilade::gmap {

/// Faces as rings of vertices, each between two volumes. Flat arrays, ids dense from 0.
struct CellTuples {
    std::uint32_t vertex_count = 0;
    std::uint32_t volume_count = 0;
    std::vector<std::uint32_t> ring_first;                    ///< [face_count + 1] into `ring`
    std::vector<std::uint32_t> ring;                          ///< vertex ids, in order around the face, either direction
    std::vector<std::array<std::uint32_t, 2>> face_volumes;   ///< [face_count] the volumes on its two sides
};

/// Builds the map. Dart order (documented, others rely on it): face f with ring length n owns the darts
/// 4 * ring_first[f] ... + 4n; side s of it starts at 4 * ring_first[f] + s * 2n; there, dart 2k is (edge k, vertex k) and
/// 2k + 1 is (edge k, vertex k + 1 mod n), edge k joining vertices k and k + 1.
/// Vertex, face and volume ids of the map are those of `tuples`; edge ids are given by vertex pair, in order of first use.
/// A third dart on one (volume, edge, vertex) key, or a lone one, stays free there and is reported in `defects`, never overwritten.
/// Uses all cores when asked to. Cost: n log n in the darts of one volume, linear in volumes.
[[nodiscard]] Map build_map(const CellTuples& tuples, std::vector<Defect>& defects);

}  // namespace enfilade::gmap

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
    std::vector<std::uint32_t> ring_first;                   ///< [face_count + 1] into `ring`
    std::vector<std::uint32_t> ring;                         ///< vertex ids, in order around the face, either direction
    std::vector<std::array<std::uint32_t, 2>> face_volumes;  ///< [face_count] the volumes on its two sides

    [[nodiscard]] std::size_t face_count() const noexcept { return face_volumes.size(); }
    [[nodiscard]] std::size_t dart_count() const noexcept { return 4 * ring.size(); }
};

/// Builds the map. Dart order (documented, others rely on it): face f with ring length n owns the darts
/// 4 * ring_first[f] ... + 4n; side s of it starts at 4 * ring_first[f] + s * 2n; there, dart 2k is (edge k, vertex k)
/// and 2k + 1 is (edge k, vertex k + 1 mod n), edge k joining vertices k and k + 1. Vertex, face and volume ids of the
/// map are those of `tuples`; edge ids are given by vertex pair, in order of first use. Only alpha<2> has to be found:
/// of the darts with one (volume, edge, vertex) the first two in dart order are linked. A third dart on one key, or a
/// lone one, stays free there and is appended to `defects` (T4, T2), never overwritten; an edge that joins a vertex to
/// itself, and a face without edges, too (T6). `validate` finds such places again as T2: report one list. The result
/// does not depend on `threads`. Throws std::invalid_argument where an index is out of range. Cost: linear in the
/// darts, but for edges or vertices with very many faces, which are sorted.
[[nodiscard]] Map build_map(const CellTuples& tuples, std::vector<Defect>& defects, unsigned threads = 1);

}  // namespace enfilade::gmap

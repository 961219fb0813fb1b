#pragma once
// What the paper counts of its octrees (Portalez and Duguet 2016, tables 1 and 3, section 5.1), of any mesh.

#include <cstddef>

#include "accel/octree/rope_octree.h"

namespace enfilade::accel {

/// Of one tree.
struct RopeTreeFigures {
    std::size_t leaves = 0;
    std::size_t empty_leaves = 0;  ///< of them: without triangles
    std::size_t references = 0;    ///< triangles of all leaves
    std::size_t neighbours = 0;    ///< addresses of neighbours, of all leaves
    std::uint32_t deepest = 0;     ///< level of the deepest leaf
    RopeBytes stored;              ///< with stored boxes
    RopeBytes implicit;            ///< with boxes that are computed
    double build_seconds = 0;      ///< from triangles to the tree
    double link_seconds = 0;       ///< from the tree to the four arrays, boxes stored

    [[nodiscard]] double triangles_a_leaf() const {  ///< of leaves that have some
        return leaves == empty_leaves ? 0
                                      : static_cast<double>(references) / static_cast<double>(leaves - empty_leaves);
    }
    [[nodiscard]] double neighbours_a_leaf() const {
        return leaves == 0 ? 0 : static_cast<double>(neighbours) / static_cast<double>(leaves);
    }
};

struct RopeFigures {
    std::size_t triangles = 0;                 ///< of the mesh that can be hit
    RopeTreeFigures free, balanced;            ///< neighbours of any size; the paper's
    [[nodiscard]] double leaf_ratio() const {  ///< table 1
        return free.leaves == 0 ? 0 : static_cast<double>(balanced.leaves) / static_cast<double>(free.leaves);
    }
};

/// Depth of the paper's octree for a mesh as large as one of its three (section 5.2): 8 for the bunny, 10 for the
/// armadillo, 11 for the dragon, and what lies between.
[[nodiscard]] std::uint32_t paper_depth(std::size_t triangles);

/// The paper's trees: as deep as paper_depth says, split by count alone.
[[nodiscard]] OctreeOptions paper_options(std::size_t triangles);

/// Builds both trees and lays out each. Exceptions: as RopeOctree's.
[[nodiscard]] RopeFigures rope_figures(const MeshPart& mesh, OctreeOptions options, const Executor& executor);

}  // namespace enfilade::accel

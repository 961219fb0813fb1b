#pragma once
// Very many lamps: far ones that stand together are one lamp for a cell (after the light cuts of Walter et al. 2005,
// per receiving cell instead of per pixel).

#include <cstddef>
#include <vector>

#include "accel/lights/light_trees.h"

namespace enfilade::accel {

struct LightClusterOptions {
    /// The largest size of a cluster, as a share of its distance to the cell that it lights. Where all of its lamps are
    /// seen, what it gives is wrong by less than ((1 - error)^-2 - 1) of it, by the inverse square; cosines and shadows
    /// that part its lamps add to that. 0: no clusters.
    double error = 0;
};

/// The lists of cells with clusters in the place of their lamps. A cluster is a lamp of its own: the sum of the
/// intensities at their mean place. Movable; views stay valid while it lives.
class LightClusters {
public:
    /// The scene's lights, then the clusters: for a copy of the SceneView. Not for LampSearch::Naive, which would count
    /// the lamps and their clusters.
    [[nodiscard]] ArrayView<Light> lights() const { return {lights_.data(), lights_.size()}; }
    /// The trees with the clusters' lists. \pre `trees` are those that the clusters were made of
    [[nodiscard]] LightTreesView lists(LightTreesView trees) const;
    /// Lamps of which clusters can be: at most one less than the scene's.
    [[nodiscard]] std::size_t cluster_count() const { return lights_.size() - lamp_count_; }
    /// Those that a cell lists.
    [[nodiscard]] std::size_t listed_count() const { return listed_count_; }
    [[nodiscard]] std::size_t bytes() const;

private:
    friend LightClusters cluster_lights(const SceneView&, const LightTreesView&, const LightClusterOptions&,
                                        const Executor&);
    std::size_t lamp_count_ = 0;
    std::size_t listed_count_ = 0;
    std::vector<Light> lights_;
    std::vector<std::uint32_t> cell_offsets_;
    std::vector<CellLight> cell_lights_;
};

/// Clusters are of lamps in one cell, all of which the lit cell lists; balls stay alone. Where all of the lit cell sees
/// all of them in the same tint, past no object, the cluster has a beam without planes: it is seen as they are. Else it
/// has none and takes a walk, and is made only where that costs less than the planes of its lamps. The same on any
/// number of threads. \pre 0 <= error < 1
[[nodiscard]] LightClusters cluster_lights(const SceneView& view, const LightTreesView& trees,
                                           const LightClusterOptions& options, const Executor& executor);

}  // namespace enfilade::accel

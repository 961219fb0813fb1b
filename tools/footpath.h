#pragma once
// The line along which eyes are carried through a building.

#include <cstddef>
#include <span>
#include <vector>

#include "accel/scene.h"
#include "render/vec.h"

namespace enfilade::tools {

/// Whether eyes can be carried straight from a to b: nothing in the way, `clearance` metres to both sides, and at the
/// height of the knees. \pre a and b at the height of eyes; metres, scene frame
[[nodiscard]] bool can_walk(const accel::SceneView& scene, render::Vec3d a, render::Vec3d b, double clearance);

/// A line through the building and what has been walked of it at each of its points.
class Footpath {
public:
    /// Shortens the way through `points`, each of which is seen from the one before, and rounds its corners where there
    /// is room to. `stops`: indices of points, ascending, that the path passes, or comes near to where it turns round.
    Footpath(const accel::SceneView& scene, std::span<const render::Vec3d> points, std::span<const std::size_t> stops);

    [[nodiscard]] const std::vector<render::Vec3d>& points() const { return points_; }
    [[nodiscard]] double length() const { return walked_.empty() ? 0 : walked_.back(); }
    /// The place after so many metres; beyond the ends it goes straight on.
    [[nodiscard]] render::Vec3d at(double metres) const;
    /// Where a walker looks there: ahead, of length 1 in the level, without jerks, and never steeply.
    [[nodiscard]] render::Vec3d look(double metres) const;

private:
    void measure();

    std::vector<render::Vec3d> points_;
    std::vector<double> walked_;
    /// In strides: the direction walked, as an angle that runs on through full turns, and its rise by run.
    std::vector<double> headings_, slopes_;
};

}  // namespace enfilade::tools

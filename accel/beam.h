#pragma once
// Beams: all that can be seen from a point, a box, a cell or a room, by casting a beam through portals, clipping it at
// each (README.md of this folder, "Beams"). Never a cell too few; how many too many is measured there.

#include <cstdint>
#include <span>
#include <vector>

#include "accel/beam_limit.h"
#include "accel/beam_source.h"
#include "accel/beam_step.h"
#include "accel/scene.h"

namespace enfilade::accel {

struct BeamOptions {
    /// Grid units by which a ray may miss a portal's edge and still count as through. 0: geometry alone, exact lines;
    /// 1 covers a walk in double precision; one in float needs its error band (render/oracle.h) in units.
    std::int64_t margin = 0;
    bool through_glass = true;
    /// [portal_count], or empty: no ray passes where it is not 0.
    std::span<const std::uint8_t> closed = {};
    /// Once this many beams have come through a portal from one side, the next ones are widened to cover each other
    /// instead of being followed one by one: the work is linear in what is visible. 0: never.
    std::uint32_t max_beams = 64;
    std::uint32_t max_depth = UINT32_MAX;  ///< portals that are crossed at most
    /// Rays may rise and fall on their way, as long as they keep their line on the plan, as light does between level
    /// mirrors (render/mirror.h). Only that line decides then what is reached.
    bool any_height = false;
};

/// Walks beams, one source after the other; its memory is kept between them, so that a walk costs what it sees, not
/// what the building holds. The order of steps is that of the scene's sections, depth first. The scene must outlive it.
///
///     BeamWalker walker(scene.view());
///     walker.start(source);
///     while (const BeamStep* step = walker.next())
///         if (!interesting(step->cell)) walker.prune();
class BeamWalker {
public:
    explicit BeamWalker(const SceneView& view, const BeamOptions& options = {});
    /// Forgets what was before. \pre source.cell is a cell of the scene
    void start(BeamSource source);
    /// Goes on with what the floor of the cell that `step` got to throws back, where it is a mirror and the beam gets
    /// down to it: from that cell upwards. source: from which the step's beam has come; `source()` is its mirror image
    /// then. Widened like a beam that begins at the step's last gate. \pre step is of a walker with these options
    void start_mirrored(BeamSource source, const BeamStep& step);
    /// The next cell, valid until the next call; the first one is the source's own. nullptr at the end.
    const BeamStep* next();
    /// The beam of the last step goes no further.
    void prune() { is_pruned_ = true; }
    [[nodiscard]] const BeamSource& source() const { return source_; }

private:
    struct Pending {
        BeamStep step;
        std::size_t history_size;  ///< of the ends that were known when all its siblings were found
    };

    void expand(const BeamStep& step);
    void expand_side(const BeamStep& step, const Cell& cell, std::uint32_t section);
    void expand_level(const BeamStep& step, Level level, Target target, PortalId portal, double z);
    void enter(const BeamStep& from, PortalId portal, Target target, const Beam& beam, bool is_level);
    [[nodiscard]] bool is_open(const BeamStep& step, PortalId portal, Target target) const;
    [[nodiscard]] bool is_on_path(CellId cell) const;
    [[nodiscard]] PlanPoint corner(std::uint32_t section) const;
    [[nodiscard]] double units(float metres) const { return double{metres} * per_unit_; }

    SceneView view_;
    BeamOptions options_;
    double per_unit_;
    BeamSource source_;
    Interval source_z_;
    PlanHistory history_;
    BeamLimit limit_;
    std::vector<Pending> pending_;
    BeamStep current_;
    bool is_pruned_ = true;
    std::uint32_t step_count_ = 0;
    std::vector<CellId> path_;                  ///< cells from the source's to the current one
    std::vector<std::uint32_t> path_begin_;     ///< [path_.size()]: of the last widened beam on it
    std::vector<std::uint32_t> place_on_path_;  ///< [cell_count], where path_ says the same cell
    std::vector<PlanPoint> corners_;            ///< of the cell at hand
};

/// The cells that beams from these sources get to, the sources' own included, in ascending order.
[[nodiscard]] std::vector<CellId> reachable_cells(const SceneView& view, std::span<const BeamSource> sources,
                                                  const BeamOptions& options = {});
[[nodiscard]] std::vector<CellId> reachable_cells(const SceneView& view, const BeamSource& source,
                                                  const BeamOptions& options = {});

}  // namespace enfilade::accel

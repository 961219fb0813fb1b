#pragma once
// Inside of accel: follows a lamp's light through portals, one cone for each way.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/lights/lamp_cone.h"
#include "accel/scene.h"

namespace enfilade::accel::detail {

/// One way of a lamp's light into a cell.
struct LampStep {
    CellId cell;
    std::uint32_t parent;          ///< its own number at the lamp
    PortalId portal;               ///< through which it came; none at the lamp
    ConePlanes reach;              ///< of all that a walk in float may find
    ConePlanes light;              ///< of the light itself
    std::uint32_t before_in_cell;  ///< the step before it in its cell; 2^32 - 1 for none
    bool is_dark;                  ///< reached by rounding alone
};

struct LampWalkOptions {
    double margin = 0;     ///< metres by which a walk may miss a portal's edge; more than 0
    double precision = 0;  ///< metres within which `light` is right; more than 0, at most the margin
    bool through_glass = true;
    std::uint32_t most_steps = UINT32_MAX;
};

/// Walks lamps, one after the other; its memory is kept between them. The scene must outlive it.
class LampWalk {
public:
    LampWalk(const SceneView& view, const LampWalkOptions& options)
        : view_(view), options_(options), light_(options.precision), last_in_cell_(view.cells.size(), UINT32_MAX) {}

    /// Parents come before children. radius (metres): the steps are those of a ball's light, `light` that of its
    /// centre. Returns false where more steps than allowed would be needed; `steps` holds too few then.
    bool follow(CellId cell, const std::array<float, 3>& lamp, double radius = 0);
    [[nodiscard]] std::span<const LampStep> steps() const { return steps_; }
    [[nodiscard]] std::span<const ConeVector> light(const LampStep& step) const { return light_.planes(step.light); }
    /// The same, without those on whose inner side all of the step's cell lies.
    void light_in_cell(const LampStep& step, std::vector<ConeVector>& planes) const;

private:
    void expand(std::uint32_t number);
    void expand_side(std::uint32_t number, std::uint32_t section, std::uint32_t next);
    void expand_level(std::uint32_t number, bool is_up);
    /// outward: the portal's normal. before: how far (metres) the lamp lies before its plane.
    void enter(std::uint32_t number, PortalId portal, Target target, const ConeVector& outward, double before);
    [[nodiscard]] ConePlanes light_behind(const LampStep& step, const ConeVector& outward, double before,
                                          bool& is_dark);
    [[nodiscard]] bool is_open(const LampStep& step, PortalId portal, Target target) const;
    [[nodiscard]] bool is_known(CellId cell) const;
    void forget();
    [[nodiscard]] bool is_on_way(std::uint32_t number, CellId cell) const;
    [[nodiscard]] ConeVector from_lamp(std::uint32_t section, float z) const;

    const SceneView& view_;
    LampWalkOptions options_;
    std::array<float, 3> lamp_ = {};
    LampCones reach_{1};
    LampCones light_;
    std::vector<LampStep> steps_;
    std::vector<std::uint32_t> last_in_cell_;  ///< [cell_count] the last step into it
    std::vector<ConeVector> portal_;           ///< at hand
};

}  // namespace enfilade::accel::detail

#pragma once
// From a plan to a labelled building.

#include "modeler/building.h"
#include "plans/layout.h"
#include "plans/plan.h"
#include "plans/read.h"

namespace enfilade::modeler {

struct BuildOptions {
    plans::CleanOptions clean;
    plans::ArrangeOptions arrange;
    bool opaque_glass = false;  ///< windows end rays (for tests)
};

/// Cleans and arranges the plan, stacks its storeys and raises them: every room is whole, every volume a ball
/// (Horna et al. 2007; 2-model, "Labels"). What was repaired, left out or doubtful is in `findings`.
/// Throws InputError where nothing can be built: no storey, or a plan too large for the grid that was asked for.
[[nodiscard]] Building build(const plans::Plan& plan, const BuildOptions& options = {});

}  // namespace enfilade::modeler

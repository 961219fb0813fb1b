#pragma once
// Scenes in which a wrong face always shows: each source face has a colour of its own.

#include "accel/scene_input.h"

namespace enfilade::test {

/// `input` with a material for each source face. Red is 1, so that the shares of green and blue tell the face whatever
/// light falls on it; faces with neighbouring numbers get hues that lie far apart.
[[nodiscard]] accel::SceneInput with_own_colours(accel::SceneInput input);

/// `input` with panes that tint nothing, as the oracle sees them.
[[nodiscard]] accel::SceneInput with_clear_panes(accel::SceneInput input);

}  // namespace enfilade::test

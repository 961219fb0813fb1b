#pragma once
// The dial's options that change no scene (bench_dial_tracers.cpp).

#include <string>

#include "accel/scene.h"
#include "tools/bench.h"

namespace enfilade::tools {

/// Rows for --real, --tracer and the sizes of packets: speed, and errors against the oracle or the scalar picture.
void dial_tracers(Bench& bench, const accel::SceneView& scene, const std::string& name);

}  // namespace enfilade::tools

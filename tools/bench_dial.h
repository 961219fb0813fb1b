#pragma once
// The dial's options that change no scene (bench_dial_tracers.cpp).

#include <string>

#include "accel/scene.h"
#include "tools/bench.h"

namespace enfilade::tools {

/// Rows for --real, --tracer and the sizes of packets: speed, and errors against the oracle or the scalar picture.
void dial_tracers(Bench& bench, const accel::SceneView& scene, const std::string& name);

/// Rows for --detail, --object-triangles, --objects, --object-accel and the scope of furnishing: time, memory, speed,
/// and pixels unlike those of the finest value (bench_dial_objects.cpp).
void dial_objects(Bench& bench);

/// Rows for the options of octrees, against the default's on the same rays (bench_dial_octree.cpp): time, memory,
/// speed, and rays that are answered otherwise.
void dial_octrees(Bench& bench);

/// Rows for the ways to find lamps, their precision, samples a pixel, and paths (bench_dial_lights.cpp): time of a
/// picture, memory, and how far it is from walks to all lamps in double precision, or from many samples.
void dial_lights(Bench& bench);

/// Rows for the options of the cuda tracer (bench_dial_device.cpp): pixels unlike the scalar tracer's, memory, and the
/// time of a picture where there is a card.
void dial_device(Bench& bench, const accel::SceneView& scene, const std::string& name);

}  // namespace enfilade::tools

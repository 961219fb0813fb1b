#pragma once
// In which cell each pixel of a picture sees something: what baselines are told, who know nothing of cells.

#include <cstdint>
#include <vector>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/object_tracer.h"
#include "tools/gpu/tried_scene.h"

namespace enfilade::tools::gpu {

/// [side * side], rows from the top; any cell where nothing is seen. objects: nullptr: rooms are bare
[[nodiscard]] std::vector<std::uint32_t> known_cells(const accel::SceneView& scene, const TriedView& view, int side,
                                                     const render::ObjectTracer* objects,
                                                     const accel::Executor& executor);

}  // namespace enfilade::tools::gpu

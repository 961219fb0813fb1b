#pragma once
// The limit of every tracer of pictures: writing the framebuffer.

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/framebuffer.h"
#include "tools/floor_views.h"

namespace enfilade::tools {

/// Whether there are lanes to fill with.
[[nodiscard]] bool has_fill_limit();

/// Fills a view's framebuffer as packets do, with Lambert's shading, as if each tile of 64 x 64 pixels saw but the face
/// that its first ray meets: faces known, nothing is traced. \pre has_fill_limit()
void fill_limit(const accel::SceneView& scene, const PreparedView& view, const accel::Executor& executor,
                render::Framebuffer& image);

}  // namespace enfilade::tools

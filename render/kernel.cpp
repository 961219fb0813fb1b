#include "render/kernel.h"

#include "accel/locate.h"
#include "render/kernel_sets.h"
#include "render/trace_rays.h"

namespace enfilade::render {
namespace detail {

const Kernels& kernels() {
#if defined(ENFILADE_HAS_FMA_KERNELS)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return fma_kernels;
#endif
    return portable_kernels;
}

const Kernels& portable_kernel_set() { return portable_kernels; }

std::uint32_t cell_at(const accel::SceneView& scene, const double* point) {
    const std::optional<accel::CellId> cell = accel::locate(scene, {point[0], point[1], point[2]});
    return static_cast<std::uint32_t>(cell.value_or(none<accel::CellId>));
}

bool cell_holds(const accel::SceneView& scene, std::uint32_t cell, const double* point) {
    return accel::contains(scene, static_cast<accel::CellId>(cell), {point[0], point[1], point[2]});
}

}  // namespace detail

#if !defined(ENFILADE_HAS_LANES)
namespace detail {
const LaneKernels* lane_kernels() { return nullptr; }
}  // namespace detail
#endif

void trace_rays(const accel::SceneView& scene, std::span<const RayQuery> rays, std::span<RayHit> hits,
                Precision precision, RayStats* stats) {
    const detail::RayJob job = {&scene, rays.data(), hits.data(), std::min(rays.size(), hits.size()), stats};
    const detail::Kernels& kernels = detail::kernels();
    (precision == Precision::Float ? kernels.rays_float : kernels.rays_double)(job);
}

RayHit trace_ray(const accel::SceneView& scene, const RayQuery& ray, Precision precision) {
    RayHit hit;
    trace_rays(scene, {&ray, 1}, {&hit, 1}, precision);
    return hit;
}

}  // namespace enfilade::render

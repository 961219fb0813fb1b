#include "render/kernel.h"

#include <array>

#include "accel/locate.h"
#include "render/kernel_sets.h"
#include "render/trace_rays.h"

namespace enfilade::render {
namespace detail {

namespace {

/// The sets that this machine runs, the fastest first. Asked once: the answer does not change.
struct KernelSets {
    std::array<const Kernels*, 3> sets = {};
    std::size_t count = 0;

    KernelSets() {
#if defined(ENFILADE_HAS_FMA_KERNELS)
        const bool has_fma = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                             __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
        const bool has_avx512 = has_fma && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                                __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq");
        if (has_avx512) sets[count++] = &avx512_kernels;
        if (has_fma) sets[count++] = &fma_kernels;
#endif
        sets[count++] = &portable_kernels;
    }
};

const KernelSets& sets_of_this_machine() {
    static const KernelSets all;
    return all;
}

}  // namespace

std::span<const Kernels* const> kernel_sets() {
    const KernelSets& all = sets_of_this_machine();
    return {all.sets.data(), all.count};
}

const Kernels& kernels() { return *sets_of_this_machine().sets[0]; }

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
                Precision precision, RayStats* stats, const ObjectTracer* objects) {
    const detail::RayJob job = {&scene, rays.data(), hits.data(), std::min(rays.size(), hits.size()), stats, objects};
    const detail::Kernels& kernels = detail::kernels();
    (precision == Precision::Float ? kernels.rays_float : kernels.rays_double)(job);
}

RayHit trace_ray(const accel::SceneView& scene, const RayQuery& ray, Precision precision, const ObjectTracer* objects) {
    RayHit hit;
    trace_rays(scene, {&ray, 1}, {&hit, 1}, precision, nullptr, objects);
    return hit;
}

}  // namespace enfilade::render

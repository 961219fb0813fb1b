// Walks through octrees by Highway: compiled once for every instruction set, the best one chosen at run time.

#include <hwy/detect_targets.h>
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/lanes/octree.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include <algorithm>
#include <limits>

#include "render/object_rays.h"
#include "render/octree_kernels.h"
#include "render/octree_walk.h"

#if HWY_TARGET == HWY_EMU128 || HWY_TARGET == HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {
const detail::OctreeKernels* octree_kernel_set() { return nullptr; }
}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
#else

// In the order in which they stand on each other.
#include "render/lanes/lanes-inl.h"
//
#include "render/lanes/octree_ray-inl.h"
//
#include "render/lanes/octree_bricks-inl.h"
//
#include "render/lanes/octree_sixteen-inl.h"
//
#include "render/lanes/octree_packet_leaf-inl.h"
//
#include "render/lanes/octree_beam-inl.h"
//
#include "render/lanes/octree_packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

const detail::OctreeKernels* octree_kernel_set() {
    static const detail::OctreeKernels kernels = {
        hwy::TargetName(HWY_TARGET), octree_nearest,  octree_blocked, octree_nearest16,
        octree_nearest16_apart,      octree_blocked16};
    return &kernels;
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();

#endif

#if HWY_ONCE
namespace enfilade::render {

HWY_EXPORT(octree_kernel_set);

const detail::OctreeKernels* detail::octree_lane_kernels() { return HWY_DYNAMIC_DISPATCH(octree_kernel_set)(); }

}  // namespace enfilade::render
#endif

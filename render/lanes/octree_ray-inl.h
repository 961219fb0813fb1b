// One ray through an octree, a register of triangles at a time.
// No include guard: octree.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

bool octree_nearest(const accel::OctreeView& tree, ObjectRay& ray) {
    return detail::octree_kernels().nearest(tree, ray);
}

bool octree_blocked(const accel::OctreeView& tree, const ObjectRay& ray) {
    return detail::octree_kernels().blocked(tree, ray);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();

// Sixteen rays through an octree that have nothing to do with each other: one by one. Going on in turn, by stages, hid
// their waiting and cost as much (README.md, "Octrees").
// No include guard: octree.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

void octree_nearest16_apart(const accel::OctreeView& tree, const std::int32_t* valid, ObjectRays& rays) {
    one_by_one(valid, rays, [&](ObjectRay& ray) { return octree_nearest(tree, ray); });
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();

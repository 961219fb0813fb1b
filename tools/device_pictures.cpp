#include "tools/device_pictures.h"

#include "base/error.h"
#include "tools/bench.h"

namespace enfilade::tools {

namespace {

std::unique_ptr<render::cuda::Device> opened(const TracerChoice::Device& choice, const accel::Executor& executor) {
    return choice.is_host ? render::cuda::open_host(executor) : render::cuda::open_card(choice.card);
}

bool is_octree(const ObjectAccelChoice& objects) {
    return objects.kind == render::ObjectAccelKind::Automatic || objects.kind == render::ObjectAccelKind::Octree;
}

}  // namespace

DevicePictures::DevicePictures(const TracerChoice::Device& choice, const accel::Executor& executor)
    : executor_(executor), device_(opened(choice, executor)) {}

void DevicePictures::show(const accel::SceneView& scene, const TracerChoice& tracer, const ObjectAccelChoice& objects) {
    render::cuda::PictureOptions options;
    options.inside = is_octree(objects) ? render::cuda::InsideKind::Octree : render::cuda::InsideKind::Bvh;
    options.octrees = objects.octree;
    options.octrees.cost = render::cuda::device_octree_options().cost;
    options.precision = tracer.precision;
    options.mirror_floor = tracer.mirror_floor;
    options.executor = &executor_;
    objects_ = counted_objects(scene);
    objects_.seconds = seconds_of([&] { pictures_.emplace(*device_, scene, options); });
    objects_.accel = is_octree(objects) ? "octree" : "plain";
    objects_.bytes = pictures_->object_bytes();
}

render::Image DevicePictures::trace(const render::Camera& camera, const render::TraceOptions& options) {
    return pictures_->trace(camera, options);
}

void check_device_objects(const ObjectAccelChoice& objects) {
    if (objects.octree.layout == accel::OctreeLayout::Ropes)
        throw InputError(
            "F139", "", "--tracer cuda walks octrees of our own layout: leave out --octree-layout, or give it linked.");
}

}  // namespace enfilade::tools

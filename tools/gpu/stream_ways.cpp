#include "tools/gpu/stream_ways.h"

#include <optional>

namespace enfilade::tools::gpu {

namespace {

using render::cuda::Device;
using render::cuda::DeviceHits;
using render::cuda::DeviceRays;
using render::cuda::DeviceSegments;
using render::cuda::InsideKind;

/// Our own streams.
class Walks : public StreamMaker {
public:
    Walks(Device& device, const accel::SceneView& scene, const render::cuda::DeviceStreamOptions& options)
        : stream_(device, scene, options) {}

    void nearest(const DeviceRays& rays, const DeviceHits& hits) override { stream_.nearest(rays, hits); }
    void visible(const DeviceSegments& segments, std::uint8_t* visible) override { stream_.visible(segments, visible); }
    std::size_t bytes() const override { return stream_.bytes(); }

private:
    render::cuda::DeviceStream stream_;
};

template <InsideKind inside>
std::unique_ptr<StreamMaker> open_walks(Device& device, const accel::SceneView& scene, bool with_objects,
                                        const accel::Executor& executor) {
    if (!with_objects && inside != InsideKind::Octree) return nullptr;  // bare rooms are the same for both
    render::cuda::DeviceStreamOptions options;
    if (with_objects) options.inside = inside;
    options.executor = &executor;
    return std::make_unique<Walks>(device, scene, options);
}

}  // namespace

const std::vector<StreamWay>& stream_ways() {
    using render::ObjectAccelKind;
    static const std::vector<StreamWay> ways = {
        {"cells, a thread a ray", true, true, ObjectAccelKind::Octree, open_walks<InsideKind::Octree>},
        {"cells, BVHs inside of objects", true, true, ObjectAccelKind::Plain, open_walks<InsideKind::Bvh>},
    };
    return ways;
}

}  // namespace enfilade::tools::gpu

#include "tools/gpu/check_frames.h"

#include <algorithm>
#include <map>
#include <memory>

#include "render/trace.h"
#include "tools/gpu/frame_ways.h"
#include "tools/gpu/inside_tracers.h"
#include "tools/gpu/own_colours.h"
#include "tools/gpu/picture_difference.h"
#include "tools/gpu/prepared_scene.h"

namespace enfilade::tools::gpu {

namespace {

/// The scalar tracer's pictures of one task, one a view.
std::vector<render::Framebuffer> expected_frames(const FrameScene& scene, const FrameTask& task,
                                                 const std::vector<TriedView>& views, int side,
                                                 const render::ObjectTracer* objects, const accel::Executor& executor) {
    render::LambertOptions options;
    options.tracer = render::Tracer::Scalar;
    options.mirror_floor = task.mirror_floor;
    options.objects = task.with_objects ? objects : nullptr;
    render::Lamps lamps;
    if (task.lamps) {
        lamps = {scene.trees, *task.lamps, scene.exposure};
        options.lamps = &lamps;
    }
    std::vector<render::Framebuffer> frames;
    for (const TriedView& view : views) {
        render::Framebuffer& frame = frames.emplace_back(side, side);
        trace_lambert(scene.scene, view.frame(side), view.start, options, executor, frame);
    }
    return frames;
}

Agreement judged(const PictureDifference& all, const FrameTask& task, const FrameWay& way, bool on_card) {
    Agreement row;
    row.what = task.name;
    row.way = way.name;
    row.asked = all.pixels;
    row.leaks = all.leaks;
    row.fault = all.first;
    const bool must_be_exact = way.is_exact && !on_card;
    row.same = must_be_exact ? all.exact : all.same;
    row.explained = all.at_edges;
    row.bound = must_be_exact ? "the same bits" : task.lamps ? "2 steps of 255" : "1 step of 255";
    const std::uint64_t wrong = task.lamps && !must_be_exact ? all.unexplained : all.pixels - row.same;
    const std::uint64_t most = must_be_exact ? 0 : allowed_to_differ(all.pixels);
    row.is_right = all.leaks == 0 && wrong <= most;
    return row;
}

}  // namespace

std::vector<Agreement> check_frames(render::cuda::Device& device, const TriedScene& scene, const CheckOptions& options,
                                    const accel::Executor& executor) {
    const OwnColours coloured(scene.view());
    const PreparedScene prepared(scene, coloured.view(), executor);
    const FrameScene& shared = prepared.frames();
    const InsideTracers inside(shared.scene, executor);
    const std::vector<TriedView> views(
        scene.views.begin(),
        scene.views.begin() + static_cast<std::ptrdiff_t>(std::min(options.views, scene.views.size())));

    std::vector<Agreement> rows;
    for (const FrameTask& task : frame_tasks()) {
        if (!prepared.has(task)) continue;
        std::map<render::ObjectAccelKind, std::vector<render::Framebuffer>> expected;
        for (const FrameWay& way : frame_ways()) {
            const std::unique_ptr<FrameMaker> maker = way.open(device, shared, task, executor);
            if (maker == nullptr) continue;
            std::vector<render::Framebuffer>& wanted = expected[way.inside];
            if (wanted.empty())
                wanted = expected_frames(shared, task, views, options.side, inside.of(way.inside), executor);
            maker->set_views(views, options.side);
            PictureDifference all;
            for (std::size_t v = 0; v < views.size(); ++v) {
                render::Framebuffer actual;
                maker->draw(v);
                maker->read(actual);
                PictureDifference found = difference(wanted[v], actual, task.lamps ? 2 : 1);
                if (!found.first.empty()) found.first += " of view " + views[v].name;
                all.add(found);
            }
            Agreement& row = rows.emplace_back(judged(all, task, way, device.is_card()));
            row.scene = scene.name;
        }
    }
    return rows;
}

}  // namespace enfilade::tools::gpu

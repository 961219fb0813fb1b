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
    row.is_right =
        (all.leaks == 0 || !way.is_ours) && wrong <= (must_be_exact ? 0 : allowed_to_differ(all.pixels, way.is_ours));
    return row;
}

/// Pictures of one scene in one dress: as it is for ours, with clear panes for baselines.
class FrameCheck {
public:
    FrameCheck(render::cuda::Device& device, const TriedScene& scene, bool of_ours, const CheckOptions& options,
               const accel::Executor& executor)
        : device_(device),
          options_(options),
          executor_(executor),
          of_ours_(of_ours),
          coloured_(scene.view(), !of_ours),
          prepared_(scene, coloured_.view(), executor),
          inside_(coloured_.view(), executor),
          views_(scene.views.begin(),
                 scene.views.begin() + static_cast<std::ptrdiff_t>(std::min(options.views, scene.views.size()))) {}

    [[nodiscard]] bool has(const FrameTask& task) const { return prepared_.has(task); }

    void check(const FrameTask& task, std::vector<Agreement>& rows) {
        std::map<render::ObjectAccelKind, std::vector<render::Framebuffer>> expected;
        for (const FrameWay& way : frame_ways()) {
            if (way.is_ours != of_ours_) continue;
            const std::unique_ptr<FrameMaker> maker = way.open(device_, prepared_.frames(), task, executor_);
            if (maker == nullptr) continue;
            std::vector<render::Framebuffer>& wanted = expected[way.inside];
            if (wanted.empty())
                wanted =
                    expected_frames(prepared_.frames(), task, views_, options_.side, inside_.of(way.inside), executor_);
            Agreement& row = rows.emplace_back(judged(compare(*maker, wanted, task), task, way, device_.is_card()));
            row.scene = prepared_.tried().name;
        }
    }

private:
    [[nodiscard]] PictureDifference compare(FrameMaker& maker, const std::vector<render::Framebuffer>& wanted,
                                            const FrameTask& task) const {
        maker.set_views(views_, options_.side);
        PictureDifference all;
        for (std::size_t v = 0; v < views_.size(); ++v) {
            render::Framebuffer actual;
            maker.draw(v);
            maker.read(actual);
            PictureDifference found = difference(wanted[v], actual, task.lamps ? 2 : 1);
            if (!found.first.empty()) found.first += " of view " + views_[v].name;
            all.add(found);
        }
        return all;
    }

    render::cuda::Device& device_;
    const CheckOptions& options_;
    const accel::Executor& executor_;
    bool of_ours_;
    OwnColours coloured_;
    PreparedScene prepared_;
    InsideTracers inside_;
    std::vector<TriedView> views_;
};

}  // namespace

std::vector<Agreement> check_frames(render::cuda::Device& device, const TriedScene& scene, const CheckOptions& options,
                                    const accel::Executor& executor) {
    std::vector<Agreement> rows;
    for (const bool of_ours : {true, false}) {
        FrameCheck check(device, scene, of_ours, options, executor);
        for (const FrameTask& task : frame_tasks())
            if (check.has(task)) check.check(task, rows);
    }
    return rows;
}

}  // namespace enfilade::tools::gpu

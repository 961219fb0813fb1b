#include "tools/cut_building.h"

#include "base/error.h"
#include "modeler/export_scene.h"
#include "render/trace.h"
#include "tools/even_rays.h"

namespace enfilade::tools {

CutBuilding cut_building(const modeler::Building& whole, const modeler::ConvexifyOptions& options) {
    CutBuilding cut;
    const modeler::Building building = modeler::convexify(whole, options);
    cut.scene = modeler::export_scene(building, {}, "{}");
    cut.figures = cut_figures(building, cut.scene);
    for (const accel::Cell& cell : cut.scene.view().cells) cut.parents.push_back(building.volumes[cell.volume].parent);
    const std::vector<modeler::RegionCut> cuts =
        modeler::cut_regions(whole.stack, {true, options.convexifier, options.cost}, accel::SerialExecutor());
    cut.rooms = room_pieces(whole.stack, cuts);
    for (const modeler::RegionCut& region : cuts) {
        cut.moved += region.moved;
        cut.fallen_back += region.fallen_back;
    }
    return cut;
}

SameRays::SameRays(std::vector<const accel::SceneView*> scenes, std::size_t ray_count, std::size_t view_count, int side)
    : scenes_(std::move(scenes)),
      views_(scenes_.size()),
      pixels_a_view_(std::size_t(side) * std::size_t(side)),
      framebuffer_(side, side) {
    rays_ = rays_in_all(scenes_, even_rays(*scenes_.front(), ray_count, 17));
    hits_.resize(rays_.front().size());
    for (const render::Camera& camera : floor_views(*scenes_.front(), view_count, side)) {
        std::vector<PreparedView> of_all;
        try {
            for (const accel::SceneView* scene : scenes_) of_all.push_back(prepared(*scene, {camera}).front());
        } catch (const InputError&) {
            continue;  // the eye is in a wall
        }
        for (std::size_t k = 0; k < scenes_.size(); ++k) views_[k].push_back(of_all[k]);
    }
}

std::vector<std::function<void()>> SameRays::random() {
    std::vector<std::function<void()>> competitors;
    for (std::size_t k = 0; k < scenes_.size(); ++k)
        competitors.emplace_back([this, k] { render::trace_rays(*scenes_[k], rays_[k], hits_); });
    return competitors;
}

std::vector<std::function<void()>> SameRays::primary(render::Tracer tracer) {
    std::vector<std::function<void()>> competitors;
    for (std::size_t k = 0; k < scenes_.size(); ++k)
        competitors.emplace_back([this, k, tracer] {
            const accel::SerialExecutor one_thread;
            for (const PreparedView& view : views_[k])
                render::trace_lambert(*scenes_[k], view.frame, view.start, {.tracer = tracer}, one_thread,
                                      framebuffer_);
        });
    return competitors;
}

SameRays::Agreement SameRays::agreement(std::size_t scene, std::size_t reference) const {
    std::vector<render::RayHit> hits(ray_count()), others(ray_count());
    render::trace_rays(*scenes_[scene], rays_[scene], hits);
    render::trace_rays(*scenes_[reference], rays_[reference], others);
    const auto face_of = [](const accel::SceneView& view, const render::RayHit& hit) {
        const accel::SourceFace& face = view.source_faces[index(hit.source_face)];
        return std::pair(view.string(view.spaces[index(face.space)].id), face.surface);
    };
    Agreement agreement;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].status != render::WalkStatus::Hit) {
            ++agreement.leaks;
            continue;
        }
        if (others[i].status != render::WalkStatus::Hit) continue;
        if (face_of(*scenes_[scene], hits[i]) != face_of(*scenes_[reference], others[i])) ++agreement.differ;
    }
    return agreement;
}

}  // namespace enfilade::tools

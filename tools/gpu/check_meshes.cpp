#include "tools/gpu/check_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "render/math.h"
#include "render/octree_walk.h"
#include "tools/gpu/check_streams.h"
#include "tools/gpu/mesh_ways.h"

namespace enfilade::tools::gpu {

namespace {

using render::cuda::OctreeAnswer;
using render::cuda::OctreeRay;

std::vector<OctreeAnswer> expected_answers(const accel::LinkedOctree& tree, const std::vector<OctreeRay>& rays,
                                           const accel::Executor& executor) {
    std::vector<OctreeAnswer> answers(rays.size());
    accel::parallel_for(executor, rays.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            render::ObjectRay ray = render::cuda::object_ray_of(rays[i]);
            render::NoOctreeEvents none;
            render::octree_walk<false>(tree.view(), ray, none);
            answers[i] = {ray.far, ray.triangle};
        }
    });
    return answers;
}

std::string words(std::size_t i, const OctreeRay& ray, const OctreeAnswer& want, const OctreeAnswer& got) {
    std::array<char, 300> text;
    std::snprintf(text.data(), text.size(),
                  "ray %zu from (%a, %a, %a) along (%a, %a, %a): triangle %d at %.9g instead of %d at %.9g", i,
                  double{ray.origin[0]}, double{ray.origin[1]}, double{ray.origin[2]}, double{ray.direction[0]},
                  double{ray.direction[1]}, double{ray.direction[2]}, static_cast<int>(got.triangle), double{got.t},
                  static_cast<int>(want.triangle), double{want.t});
    return text.data();
}

/// Checks one batch by all ways.
class MeshCheck {
public:
    MeshCheck(render::cuda::Device& device, const std::string& scene, const MeshOnHost& mesh)
        : device_(device), scene_(scene), mesh_(mesh) {}

    void check(const std::string& what, MeshRays& rays, std::vector<Agreement>& rows) {
        const std::vector<OctreeRay> asked = rays.batch.rays();
        std::map<MeshTree, std::vector<OctreeAnswer>> expected;
        for (const MeshWay& way : mesh_ways()) {
            std::vector<OctreeAnswer>& wanted = expected[way.tree];
            if (wanted.empty()) wanted = expected_answers(mesh_.linked(way.tree), asked, mesh_.executor());
            const std::unique_ptr<MeshMaker> maker = way.open(device_, mesh_);
            maker->nearest(rays);
            rows.push_back(judged(what, way, asked, wanted, maker->answers(rays)));
        }
    }

private:
    [[nodiscard]] Agreement judged(const std::string& what, const MeshWay& way, const std::vector<OctreeRay>& asked,
                                   const std::vector<OctreeAnswer>& wanted,
                                   const std::vector<OctreeAnswer>& got) const {
        const bool must_be_exact = way.is_exact && !device_.is_card();
        Agreement row;
        row.scene = scene_;
        row.what = what;
        row.way = way.name;
        row.asked = asked.size();
        row.bound = must_be_exact ? "the same bits" : "1e-5 of the distance";
        for (std::size_t i = 0; i < asked.size(); ++i) {
            const bool is_named = got[i].triangle == wanted[i].triangle;
            const bool is_hit = wanted[i].triangle != render::no_triangle;
            const double error = std::abs(double{got[i].t} - double{wanted[i].t});
            const bool is_same =
                is_named &&
                (!is_hit || (must_be_exact ? got[i].t == wanted[i].t : error <= distance_share * double{wanted[i].t}));
            if (is_named && is_hit) row.distance_error = std::max(row.distance_error, error);
            row.same += is_same ? 1 : 0;
            if (!is_same && row.fault.empty()) row.fault = words(i, asked[i], wanted[i], got[i]);
        }
        row.is_right = row.asked - row.same <= (must_be_exact ? 0 : allowed_to_differ(row.asked, way.is_ours));
        return row;
    }

    render::cuda::Device& device_;
    const std::string& scene_;
    const MeshOnHost& mesh_;
};

}  // namespace

std::vector<Agreement> check_meshes(render::cuda::Device& device, const TriedScene& scene, const CheckOptions& options,
                                    const accel::Executor& executor) {
    const MeshOnHost mesh(scene.view(), executor);
    MeshCheck check(device, scene.name, mesh);
    const render::cuda::DeviceOctree tree(device, upload_octree(device, mesh.linked(MeshTree::Ours)), {});
    const std::size_t rays = render::cuda::TiledPixels{options.side, options.side}.count();
    std::vector<Agreement> rows;
    MeshRays primary(device, rays, true), diffuse(device, rays, false);
    primary.batch.primary(scene.views[0].frame(options.side), options.side, options.side);
    primary.batch.nearest(tree, {});
    diffuse.batch.diffuse(primary.batch, tree, 1);
    primary.copy(device);
    diffuse.copy(device);
    check.check("mesh, primary rays", primary, rows);
    check.check("mesh, diffuse rays", diffuse, rows);
    return rows;
}

}  // namespace enfilade::tools::gpu

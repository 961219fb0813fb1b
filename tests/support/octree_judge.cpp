#include "tests/support/octree_judge.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <sstream>

#include "render/object_rays.h"
#include "tests/support/instruction_sets.h"

namespace enfilade::test {
namespace {

using render::no_triangle;
using render::ObjectRay;
using render::ObjectRays;

/// To the last bit, but that 0 may be -0.
bool same(float a, float b) { return a == b; }

bool same_answer(const ObjectRay& a, const ObjectRay& b) {
    return a.triangle == b.triangle && same(a.far, b.far) && same(a.u, b.u) && same(a.v, b.v) &&
           same(a.normal_x, b.normal_x) && same(a.normal_y, b.normal_y) && same(a.normal_z, b.normal_z);
}

ObjectRays together(const std::vector<ObjectRay>& rays, std::size_t first) {
    ObjectRays all = {};
    for (std::size_t i = 0; i < 16; ++i) {
        const ObjectRay& ray = rays[std::min(first + i, rays.size() - 1)];
        all.origin_x[i] = ray.origin_x;
        all.origin_y[i] = ray.origin_y;
        all.origin_z[i] = ray.origin_z;
        all.near[i] = ray.near;
        all.direction_x[i] = ray.direction_x;
        all.direction_y[i] = ray.direction_y;
        all.direction_z[i] = ray.direction_z;
        all.far[i] = ray.far;
        all.mask[i] = ~0u;
        all.triangle[i] = ray.triangle;
        all.geometry[i] = all.instance[i] = no_triangle;
    }
    return all;
}

ObjectRay one_of(const ObjectRays& all, const ObjectRay& asked, std::size_t i) {
    ObjectRay ray = asked;
    ray.far = all.far[i];
    ray.normal_x = all.normal_x[i];
    ray.normal_y = all.normal_y[i];
    ray.normal_z = all.normal_z[i];
    ray.u = all.u[i];
    ray.v = all.v[i];
    ray.triangle = all.triangle[i];
    return ray;
}

class Judge {
public:
    Judge(const TriedMesh& mesh, const accel::OctreeView& tree, const std::vector<ObjectRay>& rays)
        : mesh_(mesh), tree_(tree), rays_(rays) {
        for (const ObjectRay& ray : rays) {
            expected_.push_back(mesh.nearest(ray));
            tally.hits += expected_.back().triangle != no_triangle;
        }
        tally.rays = rays.size();
    }

    void ask(const OctreeVariant& variant) {
        for (std::size_t i = 0; i < rays_.size(); ++i) {
            ObjectRay answered = rays_[i];
            const bool is_hit = variant.kernels->nearest(tree_, answered);
            compare(i, answered, variant.name + " nearest");
            if (is_hit != (answered.triangle != no_triangle)) report(i, answered, variant.name + " says otherwise");
            const bool is_blocked = variant.kernels->blocked(tree_, rays_[i]);
            if (is_blocked == (expected_[i].triangle != no_triangle)) continue;
            // Any triangle blocks; nothing but the answer of nearest tells which.
            if (is_beside(i, expected_[i]) || is_beside(i, answered)) ++tally.beside;
            else report(i, answered, variant.name + (is_blocked ? " is blocked" : " is not blocked"));
        }
        for (std::size_t first = 0; first < rays_.size(); first += 16) {
            ask16(first, variant.kernels->nearest16, variant.name + " nearest16");
            ask16(first, variant.kernels->nearest16_apart, variant.name + " nearest16_apart");
        }
    }

    OctreeTally tally;

private:
    using Ask16 = void (*)(const accel::OctreeView&, const std::int32_t*, ObjectRays&);

    void ask16(std::size_t first, Ask16 nearest, const std::string& who) {
        ObjectRays all = together(rays_, first);
        alignas(64) std::array<std::int32_t, 16> valid{};
        // Every third group has holes.
        for (std::size_t i = 0; i < 16; ++i)
            valid[i] = first + i < rays_.size() && (first / 16 % 3 != 0 || i % 5 != 3) ? -1 : 0;
        nearest(tree_, valid.data(), all);
        for (std::size_t i = 0; i < 16 && first + i < rays_.size(); ++i) {
            const ObjectRay answered = one_of(all, rays_[first + i], i);
            if (valid[i] != 0) compare(first + i, answered, who);
            else if (!same_answer(answered, rays_[first + i])) report(first + i, answered, who + " (not valid)");
        }
    }

    void compare(std::size_t i, const ObjectRay& answered, const std::string& who) {
        if (same_answer(answered, expected_[i])) return;
        if (is_beside(i, expected_[i]) || is_beside(i, answered)) {
            ++tally.beside;
            return;
        }
        report(i, answered, who);
    }

    /// Whether the test itself takes another place for the meeting than one by the triangle.
    [[nodiscard]] bool is_beside(std::size_t i, const ObjectRay& answered) const {
        return answered.triangle < mesh_.triangles().size() &&
               mesh_.off_triangle(rays_[i], answered.triangle) > 0.5 * accel::octree_slack;
    }

    void report(std::size_t i, const ObjectRay& answered, const std::string& who) {
        if (++tally.wrong > 1) return;
        const ObjectRay &ray = rays_[i], &right = expected_[i];
        std::ostringstream text;
        text << std::setprecision(9) << who << ", ray " << i << " from (" << ray.origin_x << ", " << ray.origin_y
             << ", " << ray.origin_z << ") along (" << ray.direction_x << ", " << ray.direction_y << ", "
             << ray.direction_z << "), [" << ray.near << ", " << ray.far << "]: triangle "
             << static_cast<int>(answered.triangle) << " at " << answered.far << ", expected "
             << static_cast<int>(right.triangle) << " at " << right.far;
        if (right.triangle != no_triangle) text << ", " << mesh_.off_triangle(ray, right.triangle) << " off";
        tally.first_wrong = text.str();
    }

    const TriedMesh& mesh_;
    const accel::OctreeView tree_;
    const std::vector<ObjectRay>& rays_;
    std::vector<ObjectRay> expected_;
};

}  // namespace

const std::vector<OctreeVariant>& octree_variants() {
    static const std::vector<OctreeVariant> variants = [] {
        std::vector<OctreeVariant> all = {{"scalar", &render::detail::octree_kernels()}};
        for (const InstructionSet& set : instruction_sets()) {
            const UsingInstructionSet using_it(set);
            const render::detail::OctreeKernels* kernels = render::detail::octree_lane_kernels();
            if (kernels != nullptr) all.push_back({set.name, kernels});
        }
        return all;
    }();
    return variants;
}

void OctreeTally::add(const OctreeTally& other) {
    rays += other.rays;
    hits += other.hits;
    beside += other.beside;
    wrong += other.wrong;
    if (first_wrong.empty()) first_wrong = other.first_wrong;
}

OctreeTally judge_octree(const TriedMesh& mesh, const accel::OctreeView& tree, const std::vector<ObjectRay>& rays) {
    Judge judge(mesh, tree, rays);
    for (const OctreeVariant& variant : octree_variants()) judge.ask(variant);
    return judge.tally;
}

}  // namespace enfilade::test

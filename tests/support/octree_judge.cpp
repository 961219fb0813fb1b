#include "tests/support/octree_judge.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <sstream>

#include "render/octree_kernels.h"
#include "render/rope_walk.h"
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
    Judge(const TriedMesh& mesh, const std::vector<ObjectRay>& rays) : mesh_(mesh), rays_(rays) {
        for (const ObjectRay& ray : rays) {
            expected_.push_back(mesh.nearest(ray));
            tally.hits += expected_.back().triangle != no_triangle;
        }
        tally.rays = rays.size();
    }

    void ask(const OctreeWalk& walk) {
        for (std::size_t i = 0; i < rays_.size(); ++i) {
            ObjectRay answered = rays_[i];
            const bool is_hit = walk.nearest(answered);
            compare(i, answered, walk.name + " nearest");
            if (is_hit != (answered.triangle != no_triangle)) report(i, answered, walk.name + " says otherwise");
            const bool is_blocked = walk.blocked(rays_[i]);
            if (is_blocked == (expected_[i].triangle != no_triangle)) continue;
            // Any triangle blocks; nothing but the answer of nearest tells which.
            if (is_beside(i, expected_[i]) || is_beside(i, answered)) ++tally.beside;
            else report(i, answered, walk.name + (is_blocked ? " is blocked" : " is not blocked"));
        }
        if (!walk.nearest16) return;
        for (std::size_t first = 0; first < rays_.size(); first += 16) {
            ask16(first, walk.nearest16, walk.name + " nearest16");
            ask16(first, walk.nearest16_apart, walk.name + " nearest16_apart");
        }
    }

    OctreeTally tally;

private:
    using Ask16 = std::function<void(const std::int32_t*, ObjectRays&)>;

    void ask16(std::size_t first, const Ask16& nearest, const std::string& who) {
        ObjectRays all = rays_together(rays_, first);
        alignas(64) std::array<std::int32_t, 16> valid{};
        // Every third group has holes.
        for (std::size_t i = 0; i < 16; ++i)
            valid[i] = first + i < rays_.size() && (first / 16 % 3 != 0 || i % 5 != 3) ? -1 : 0;
        nearest(valid.data(), all);
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
    const std::vector<ObjectRay>& rays_;
    std::vector<ObjectRay> expected_;
};

template <class T>
OctreeWalk rope_walk_of(const std::string& name, const accel::RopeView& tree) {
    return {name,
            [=](ObjectRay& ray) {
                render::NoRopeEvents events;
                return render::rope_walk<T, false>(tree, ray, events);
            },
            [=](const ObjectRay& ray) {
                ObjectRay asked = ray;
                render::NoRopeEvents events;
                return render::rope_walk<T, true>(tree, asked, events);
            },
            {},
            {}};
}

}  // namespace

ObjectRays rays_together(const std::vector<ObjectRay>& rays, std::size_t first) {
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

std::vector<OctreeWalk> octree_walks(const TriedOctree& octree) {
    using render::detail::OctreeKernels;
    std::vector<OctreeWalk> walks;
    const auto add = [&](const std::string& name, const OctreeKernels* kernels) {
        const accel::OctreeView tree = octree.view();
        walks.push_back(
            {name, [=](ObjectRay& ray) { return kernels->nearest(tree, ray); },
             [=](const ObjectRay& ray) { return kernels->blocked(tree, ray); },
             [=](const std::int32_t* valid, ObjectRays& rays) { kernels->nearest16(tree, valid, rays); },
             [=](const std::int32_t* valid, ObjectRays& rays) { kernels->nearest16_apart(tree, valid, rays); }});
    };
    add("scalar", &render::detail::octree_kernels());
    for (const InstructionSet& set : instruction_sets()) {
        const UsingInstructionSet using_it(set);
        const OctreeKernels* kernels = render::detail::octree_lane_kernels();
        if (kernels != nullptr) add(set.name, kernels);
    }
    walks.push_back(rope_walk_of<float>("balanced ropes", octree.stored_ropes()));
    walks.push_back(rope_walk_of<float>("free ropes", octree.free_ropes()));
    walks.push_back(rope_walk_of<double>("free ropes in double", octree.free_ropes()));
    return walks;
}

void OctreeTally::add(const OctreeTally& other) {
    rays += other.rays;
    hits += other.hits;
    beside += other.beside;
    wrong += other.wrong;
    if (first_wrong.empty()) first_wrong = other.first_wrong;
}

OctreeTally judge_octree(const TriedMesh& mesh, const std::vector<OctreeWalk>& walks,
                         const std::vector<ObjectRay>& rays) {
    Judge judge(mesh, rays);
    for (const OctreeWalk& walk : walks) judge.ask(walk);
    return judge.tally;
}

}  // namespace enfilade::test

// Whole walks through deep octrees, held against the ray itself.

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "render/rope_walk.h"
#include "tools/deep_octree.h"
#include "tools/exact_exit.h"
#include "tools/exit_study.h"
#include "tools/study_rays.h"

namespace enfilade::tools {
namespace {

constexpr std::size_t deep_places = 12;

/// A mesh as large as the lattice: one triangle between two of its corners.
struct LargeTriangle {
    std::array<accel::Vertex, 3> places;
    accel::MeshTriangle triangle = {{0, 1, 2}, {}};
    std::array<std::uint32_t, 1> used = {0};

    explicit LargeTriangle(const accel::OctreeFrame& frame) {
        const auto at = [&](double x, double y, double z) {
            return accel::Vertex{static_cast<float>(frame.low[0] + x * study_size),
                                 static_cast<float>(frame.low[1] + y * study_size),
                                 static_cast<float>(frame.low[2] + z * study_size)};
        };
        places = {at(0, 0, 0), at(1, 1, 1), at(0, 0, 1)};
    }
    [[nodiscard]] accel::MeshPart part() const { return {places.data(), &triangle, used}; }
};

struct Events : render::NoRopeEvents {
    std::vector<accel::RopeAddress> leaves;
    std::uint64_t returns = 0, recovered = 0;
    void entered_leaf(accel::RopeAddress leaf, std::uint32_t) { leaves.push_back(leaf); }
    void recovered_exit(accel::RopeAddress) { ++recovered; }
    void came_back(accel::RopeAddress) { ++returns; }
};

/// The part of a ray in a cube that is wider by `slack` on all sides; empty: the first is the larger.
std::pair<double, double> part_of(const ExactRay& ray, const accel::RopeCube& cube, double slack) {
    double enter = 0, leave = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const double low = cube.low[k] - slack, high = double{1} * cube.low[k] + cube.width + slack;
        const double o = ray.origin(k), d = ray.direction(k);
        if (d == 0) {
            if (o < low || o > high) return {1, 0};
            continue;
        }
        enter = std::max(enter, ((d > 0 ? low : high) - o) / d);
        leave = std::min(leave, ((d > 0 ? high : low) - o) / d);
    }
    return {enter, leave};
}

/// Whether the leaves that were visited, widened, hold all of the ray that lies in the octree's cube.
bool is_covered(const accel::RopeView& view, const ExactRay& ray, const std::vector<accel::RopeAddress>& leaves,
                double slack) {
    const std::uint32_t side = 1u << view.frame.depth;
    const auto [begin, end] = part_of(ray, {{0, 0, 0}, side, 0}, 0);
    if (begin > end) return true;
    std::vector<std::pair<double, double>> parts;
    for (const accel::RopeAddress leaf : leaves) {
        const auto part = part_of(ray, accel::cube_of(view, leaf), slack * side);
        if (part.first <= part.second) parts.push_back(part);
    }
    std::ranges::sort(parts);
    double covered = begin;
    for (const auto& [from, to] : parts) {
        if (from > covered) return false;
        covered = std::max(covered, to);
    }
    return covered >= end;
}

template <class T>
void walk(const accel::RopeView& view, const StudyRay& asked, double slack, WalkRecovery& row) {
    const ExactRay exact(view.frame, asked.origin, asked.direction);
    const render::RopeRay<T> ray = render::rope_ray<T>(view.frame, asked.origin.data(), asked.direction.data());
    render::RopePart<T> part = {0, T(1e30), render::invalid_exit};
    Events events;
    ++row.rays;
    if (render::part_in_cube(view, ray, part))
        render::walk_ropes(
            view, ray, part, [](accel::RopeAddress) { return false; }, [](T) { return false; }, events);
    for (const accel::RopeAddress leaf : events.leaves) {
        const accel::RopeCube cube = accel::cube_of(view, leaf);
        T from[3];
        render::from_leaving_corner(ray, cube, from);
        const std::uint32_t face = render::out_face(ray.octant, render::plucker_signs(ray.direction, from));
        if (face != render::invalid_exit && !exact.leaves_by(cube, face)) ++row.wrong;
    }
    row.crossings += events.leaves.size();
    row.invalid += events.recovered;
    row.came_back += events.returns;
    if (!is_covered(view, exact, events.leaves, slack)) ++row.unrecovered;
}

void study(WalkRecovery& single, WalkRecovery& twice, std::uint64_t rays, std::uint64_t seed, double slack) {
    const accel::OctreeFrame frame = study_frame(single.depth, single.offset);
    const LargeTriangle mesh(frame);
    StudyRandom random(seed);
    const auto side = static_cast<double>(frame.side());
    std::vector<std::array<double, 3>> about;
    for (std::size_t i = 0; i < deep_places; ++i)
        about.push_back({side * random.next(), side * random.next(), side * random.next()});
    const accel::Octree tree = deep_octree(mesh.part(), {frame, about, single.is_balanced});
    const accel::RopeOctree ropes(tree, mesh.part(), {single.is_balanced, false}, accel::SerialExecutor());
    for (std::uint64_t i = 0; i < rays; ++i) {
        const StudyRay ray = study_ray(frame, about[random.below(about.size())], random);
        walk<float>(ropes.view(), ray, slack, single);
        walk<double>(ropes.view(), ray, slack, twice);
    }
}

}  // namespace

std::vector<WalkRecovery> walk_recoveries(std::uint64_t rays_a_row, std::uint64_t seed, const accel::Executor& executor,
                                          double slack) {
    constexpr std::size_t offsets = std::size(study_offsets);
    std::vector<WalkRecovery> rows(std::size(study_depths) * offsets * 4);
    executor.run(rows.size() / 2, [&](std::size_t i) {
        const std::uint32_t depth = study_depths[i / 2 / offsets];
        const double offset = study_offsets[i / 2 % offsets];
        rows[2 * i] = {depth, offset, false, i % 2 == 0};
        rows[2 * i + 1] = {depth, offset, true, i % 2 == 0};
        study(rows[2 * i], rows[2 * i + 1], rays_a_row, seed + i, slack);
    });
    return rows;
}

}  // namespace enfilade::tools

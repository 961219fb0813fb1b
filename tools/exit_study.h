#pragma once
// How often rounding makes a ray leave a leaf by the wrong face, by the depth of the leaf and the place of the object
// (3-tracing.md's table), and that no walk is lost by it.

#include <cstdint>
#include <vector>

#include "accel/octree/octree.h"
#include "accel/parallel_for.h"

namespace enfilade::tools {

inline constexpr std::uint32_t study_depths[] = {8, 12, 16, 20};
inline constexpr double study_offsets[] = {0, 1e3, 1e5, 1e6};  ///< of the object from the origin, in its sizes

/// Of single decisions in leaves of the smallest size. Right is what twice the precision of double says of the rays as
/// they are, in float.
struct ExitRate {
    std::uint32_t depth;
    double offset;
    bool is_double;
    bool is_about_origin;  ///< the paper's form, moments about the scene's origin; else about the leaf's corner (ours)
    std::uint64_t crossings = 0;
    std::uint64_t wrong = 0;    ///< the table names another face
    std::uint64_t invalid = 0;  ///< the table says 7
    [[nodiscard]] double wrong_a_million() const {
        return 1e6 * static_cast<double>(wrong) / static_cast<double>(crossings);
    }
    [[nodiscard]] double invalid_a_million() const {
        return 1e6 * static_cast<double>(invalid) / static_cast<double>(crossings);
    }
};

/// For all depths and offsets, the four forms on the same rays. Deterministic. Cost: about 0.2 us a crossing, each of
/// which is asked of four forms.
[[nodiscard]] std::vector<ExitRate> exit_rates(std::uint64_t crossings_a_row, std::uint64_t seed,
                                               const accel::Executor& executor);

/// Of whole walks (render/rope_walk.h) through octrees that are deep about some points, of rays that pass these.
struct WalkRecovery {
    std::uint32_t depth;
    double offset;
    bool is_double;
    bool is_balanced;
    std::uint64_t rays = 0;
    std::uint64_t crossings = 0;
    std::uint64_t wrong = 0;      ///< the table names another face than the leaf's right one
    std::uint64_t invalid = 0;    ///< the table says 7, or a face along which the ray goes
    std::uint64_t came_back = 0;  ///< leaves left before they were come to, after a wrong exit
    /// Walks that pass over a place of the ray: some point of it in the octree's cube lies in none of the leaves that
    /// were visited, each wider by the slack by which its list of triangles is. Of those a triangle might be missed.
    std::uint64_t unrecovered = 0;
};

/// For all depths, offsets, float and double, balanced and free. slack: in sides of the root; less of it shows what it
/// is for. Deterministic. Cost: about 50 us a ray.
[[nodiscard]] std::vector<WalkRecovery> walk_recoveries(std::uint64_t rays_a_row, std::uint64_t seed,
                                                        const accel::Executor& executor,
                                                        double slack = accel::octree_slack);

}  // namespace enfilade::tools

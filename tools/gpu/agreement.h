#pragma once
// What checks find out, row by row.

#include <cstddef>
#include <cstdint>
#include <string>

namespace enfilade::tools::gpu {

/// A row of the report.
struct Agreement {
    std::string scene, what, way;
    std::uint64_t asked = 0;  ///< pixels or rays
    std::uint64_t same = 0;
    std::uint64_t explained = 0;  ///< of the others: at edges, or too near to where a baseline's ray starts
    std::uint64_t leaks = 0;
    double distance_error = 0;  ///< of rays that met the same: the largest, metres
    std::string bound;          ///< in words: what counts as the same
    bool is_right = true;
    std::string fault;  ///< the first one, with its pixel or ray; empty where there is none
};

/// Answers of which more than this share differ are wrong: one in a hundred thousand.
inline constexpr double most_differing = 1e-5;

/// Of baselines one in five hundred: they know no cells, so rays that pass edges closely, or start within a millimetre
/// of another surface, end elsewhere. It is shown that they trace the same scene, no more.
inline constexpr double most_differing_of_baselines = 2e-3;

/// How many answers may differ.
[[nodiscard]] inline std::uint64_t allowed_to_differ(std::uint64_t asked, bool is_ours) {
    return static_cast<std::uint64_t>((is_ours ? most_differing : most_differing_of_baselines) *
                                      static_cast<double>(asked));
}

struct CheckOptions {
    int side = 1024;             ///< of pictures, pixels
    std::size_t views = 2;       ///< of each scene, at most
    std::size_t rays = 1 << 21;  ///< of each batch
};

}  // namespace enfilade::tools::gpu

#include "tools/exit_study.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "render/rope_exit.h"
#include "tools/exact_exit.h"
#include "tools/study_rays.h"

namespace enfilade::tools {
namespace {

constexpr std::uint64_t crossings_in_a_row = 16;  ///< of one ray, one after the other

/// One form of the decision, ready for one ray.
template <class T>
class Form {
public:
    Form(const accel::OctreeFrame& frame, const StudyRay& ray)
        : frame_(frame), near_(render::rope_ray<T>(frame, ray.origin.data(), ray.direction.data())) {
        T o[3], d[3];
        for (std::size_t k = 0; k < 3; ++k) {
            o[k] = static_cast<T>(ray.origin[k]);
            d[k] = static_cast<T>(ray.direction[k]);
        }
        line_ = render::plucker_line(o, d);
    }

    /// What the table says.
    [[nodiscard]] std::uint32_t about_corner(const accel::RopeCube& cube) const {
        T from[3];
        render::from_leaving_corner(near_, cube, from);
        return render::out_face(near_.octant, render::plucker_signs(near_.direction, from));
    }
    [[nodiscard]] std::uint32_t about_origin(const accel::RopeCube& cube) const {
        T corner[3];  // as a box in the scene's own space would be stored
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t cell = cube.low[k] + ((near_.octant >> k & 1u) != 0 ? cube.width : 0u);
            corner[k] = static_cast<T>(double{frame_.low[k]} + cell / double{frame_.cells_a_unit[k]});
        }
        return render::out_face(near_.octant, render::plucker_signs_at(line_, corner));
    }

private:
    const accel::OctreeFrame& frame_;
    render::RopeRay<T> near_;
    render::PluckerLine<T> line_;
};

void count(const ExactRay& exact, const accel::RopeCube& cube, std::uint32_t face, ExitRate& rate) {
    ++rate.crossings;
    if (face == render::invalid_exit) ++rate.invalid;
    else if (!exact.leaves_by(cube, face)) ++rate.wrong;
}

/// Goes through the smallest cells of a full lattice, by the right faces, and asks all forms in each.
void study(std::array<ExitRate, 4>& rates, std::uint64_t crossings, std::uint64_t seed) {
    const accel::OctreeFrame frame = study_frame(rates[0].depth, rates[0].offset);
    StudyRandom random(seed);
    const auto side = static_cast<double>(frame.side());
    while (rates[0].crossings < crossings) {
        const std::array<double, 3> to = {side * random.next(), side * random.next(), side * random.next()};
        const StudyRay ray = study_ray(frame, to, random);
        const ExactRay exact(frame, ray.origin, ray.direction);
        const Form<float> single(frame, ray);
        const Form<double> twice(frame, ray);
        accel::RopeCube cube = {{}, 1, frame.depth};
        for (std::size_t k = 0; k < 3; ++k)
            cube.low[k] = static_cast<std::uint32_t>(std::clamp(exact.origin(k) + exact.direction(k), 0.0, side - 1));
        for (std::uint64_t i = 0; i < crossings_in_a_row; ++i) {
            count(exact, cube, single.about_corner(cube), rates[0]);
            count(exact, cube, single.about_origin(cube), rates[1]);
            count(exact, cube, twice.about_corner(cube), rates[2]);
            count(exact, cube, twice.about_origin(cube), rates[3]);
            const std::uint32_t face = exact.exit(cube);
            if (face >= accel::rope_faces) break;
            const auto axis = static_cast<std::size_t>(accel::axis_of(face));
            if (accel::is_high(face) ? cube.low[axis] + 1 == (1u << frame.depth) : cube.low[axis] == 0) break;
            cube.low[axis] += accel::is_high(face) ? 1u : ~0u;
        }
    }
}

}  // namespace

std::vector<ExitRate> exit_rates(std::uint64_t crossings_a_row, std::uint64_t seed, const accel::Executor& executor) {
    constexpr std::size_t offsets = std::size(study_offsets);
    std::vector<std::array<ExitRate, 4>> rates(std::size(study_depths) * offsets);
    executor.run(rates.size(), [&](std::size_t row) {
        const std::uint32_t depth = study_depths[row / offsets];
        const double offset = study_offsets[row % offsets];
        for (std::size_t form = 0; form < 4; ++form) rates[row][form] = {depth, offset, form >= 2, form % 2 == 1};
        study(rates[row], crossings_a_row, seed + row);
    });
    std::vector<ExitRate> all;
    for (const auto& row : rates) all.insert(all.end(), row.begin(), row.end());
    return all;
}

}  // namespace enfilade::tools

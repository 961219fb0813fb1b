// The paper's two tables and what surrounds them, against geometry.

#include "render/rope_exit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace enfilade::render {
namespace {

using accel::axis_of;
using accel::is_high;

/// Small whole numbers, so that nothing is rounded.
class WholeNumbers {
public:
    double between(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
    }

private:
    std::mt19937 random_{11};
};

/// For each octant and signs the face whose plane comes first, of rays with whole numbers; 7: no such ray.
TEST(RopeExit, TableOfFacesIsWhatGeometrySays) {
    std::array<std::array<std::uint32_t, 8>, 8> expected;
    for (auto& row : expected) row.fill(invalid_exit);
    WholeNumbers numbers;
    for (int i = 0; i < 40000; ++i) {
        const auto octant = static_cast<std::uint32_t>(i) % 8;
        std::array<double, 3> d, from, t;
        for (std::size_t k = 0; k < 3; ++k) {
            const double up = (octant >> k & 1u) != 0 ? 1 : -1;
            d[k] = up * numbers.between(1, 4);
            t[k] = numbers.between(1, 40);
            from[k] = -t[k] * d[k];  // the corner's planes are t[k] away
        }
        if (t[0] == t[1] || t[1] == t[2] || t[0] == t[2]) continue;
        const int axis = t[0] < t[1] && t[0] < t[2] ? 0 : t[1] < t[2] ? 1 : 2;
        const std::uint32_t face = accel::face_at(axis, (octant >> axis & 1u) != 0);
        const std::uint32_t signs = plucker_signs(d.data(), from.data());
        ASSERT_TRUE(expected[octant][signs] == invalid_exit || expected[octant][signs] == face);
        expected[octant][signs] = face;
    }
    int silent = 0;
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
        for (std::uint32_t signs = 0; signs < 8; ++signs) {
            EXPECT_EQ(out_face(octant, signs), expected[octant][signs]) << "octant " << octant << ", signs " << signs;
            silent += expected[octant][signs] == invalid_exit;
        }
    }
    EXPECT_EQ(silent, 16);
}

TEST(RopeExit, TableOfQuartersIsWhatGeometrySays) {
    std::array<std::array<std::uint32_t, 8>, 6> expected;
    for (auto& row : expected) row.fill(99);
    WholeNumbers numbers;
    for (int i = 0; i < 60000; ++i) {
        const auto face = static_cast<std::uint32_t>(i) % 6;
        const auto axis = static_cast<std::size_t>(axis_of(face));
        const std::size_t u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
        const double a = numbers.between(-9, 9), b = numbers.between(-9, 9), back = numbers.between(1, 5);
        if (a == 0 || b == 0) continue;
        std::array<double, 3> d, from;
        for (double& x : d) x = numbers.between(-5, 5);
        d[axis] = (is_high(face) ? 1 : -1) * numbers.between(1, 5);
        from[axis] = 0;
        from[u] = a;
        from[v] = b;  // on the face, seen from its middle; the ray started before
        for (std::size_t k = 0; k < 3; ++k) from[k] -= back * d[k];
        const std::uint32_t signs = plucker_signs(d.data(), from.data());
        const std::uint32_t quarter = (a > 0 ? 1u : 0u) + (b > 0 ? 2u : 0u);
        ASSERT_TRUE(expected[face][signs] == 99 || expected[face][signs] == quarter);
        expected[face][signs] = quarter;
    }
    for (std::uint32_t face = 0; face < 6; ++face)
        for (std::uint32_t signs = 0; signs < 8; ++signs)
            EXPECT_EQ(quarter_of(face, signs), expected[face][signs]) << "face " << face << ", signs " << signs;
}

/// Equations 1 to 5, and the moments about the point itself, are the same numbers where nothing is rounded.
TEST(RopeExit, BothFormsOfTheProductAgree) {
    WholeNumbers numbers;
    for (int i = 0; i < 5000; ++i) {
        std::array<double, 3> o, d, p, from;
        for (std::size_t k = 0; k < 3; ++k) {
            o[k] = numbers.between(-50, 50);
            d[k] = numbers.between(-9, 9);
            p[k] = numbers.between(-50, 50);
            from[k] = o[k] - p[k];
        }
        ASSERT_EQ(plucker_signs(d.data(), from.data()), plucker_signs_at(plucker_line(o.data(), d.data()), p.data()));
    }
}

TEST(RopeExit, NumbersFacesAsThePaper) {
    const std::array<int, 6> axes = {1, 0, 1, 0, 2, 2};
    const std::array<bool, 6> high = {false, false, true, true, false, true};
    for (std::uint32_t face = 0; face < 6; ++face) {
        EXPECT_EQ(axis_of(face), axes[face]);
        EXPECT_EQ(is_high(face), high[face]);
        EXPECT_EQ(accel::face_at(axes[face], high[face]), face);
    }
}

template <class T>
class RopeExitOf : public ::testing::Test {};
using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(RopeExitOf, Reals);

template <class T>
RopeRay<T> ray_in_lattice(std::array<float, 3> o, std::array<float, 3> d) {
    accel::OctreeFrame frame;
    frame.depth = 4;
    return rope_ray<T>(frame, o.data(), d.data());
}

template <class T>
RopeExit<T> leave(const RopeRay<T>& r, const accel::RopeCube& cube) {
    T from[3];
    from_leaving_corner(r, cube, from);
    return exit_of(r, from);
}

constexpr accel::RopeCube middle_cube = {{4, 4, 4}, 4, 2};

/// Along axes, in faces' planes, along edges, through corners, with both zeros: always by a face that the ray faces,
/// and one whose plane comes first.
TYPED_TEST(RopeExitOf, DegenerateRaysLeaveByThePlaneThatComesFirst) {
    using T = TypeParam;
    int recovered = 0, tried = 0;
    const std::array<float, 4> parts = {0.0f, -0.0f, 1.0f, -1.0f};
    const std::array<float, 3> places = {4, 6, 8};
    for (int i = 0; i < 64 * 27; ++i) {
        const std::array<float, 3> d = {parts[static_cast<std::size_t>(i % 4)],
                                        parts[static_cast<std::size_t>(i / 4 % 4)],
                                        parts[static_cast<std::size_t>(i / 16 % 4)]};
        const int j = i / 64;
        const std::array<float, 3> o = {places[static_cast<std::size_t>(j % 3)],
                                        places[static_cast<std::size_t>(j / 3 % 3)],
                                        places[static_cast<std::size_t>(j / 9)]};
        const RopeRay<T> r = ray_in_lattice<T>(o, d);
        const RopeExit<T> exit = leave(r, middle_cube);
        ++tried;
        recovered += exit.is_recovered;
        if (d[0] == 0 && d[1] == 0 && d[2] == 0) {
            EXPECT_EQ(exit.face, invalid_exit);
            continue;
        }
        ASSERT_LT(exit.face, 6u);
        const auto axis = static_cast<std::size_t>(axis_of(exit.face));
        ASSERT_NE(d[axis], 0);
        ASSERT_EQ(is_high(exit.face), d[axis] > 0);
        T least = 1e30f;
        for (std::size_t k = 0; k < 3; ++k)
            if (d[k] != 0) least = std::min(least, ((d[k] > 0 ? 8 : 4) - T(o[k])) / T(d[k]));
        ASSERT_EQ(exit.t, least);
    }
    EXPECT_GT(recovered, 100);
    EXPECT_GT(tried - recovered, 500);
}

/// Denormal directions count as none.
TYPED_TEST(RopeExitOf, TakesNoExitAlongWhatIsAsGoodAsStill) {
    const RopeRay<TypeParam> r = ray_in_lattice<TypeParam>({5, 4, 4}, {1, -1e-40f, 1e-38f});
    const RopeExit<TypeParam> exit = leave(r, middle_cube);
    EXPECT_EQ(exit.face, 3u);
    EXPECT_EQ(exit.t, 3);
}

TYPED_TEST(RopeExitOf, RandomRaysLeaveByThePlaneThatComesFirst) {
    using T = TypeParam;
    std::mt19937 random(3);
    const auto next = [&] { return static_cast<float>(random() >> 8) * 0x1p-23f - 1; };
    int same = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::array<float, 3> d = {next(), next(), next()};
        const std::array<float, 3> o = {6 + 2 * next(), 6 + 2 * next(), 6 + 2 * next()};
        const RopeRay<T> r = ray_in_lattice<T>(o, d);
        T from[3];
        from_leaving_corner(r, middle_cube, from);
        const RopeExit<T> exit = exit_of(r, from);
        ASSERT_FALSE(exit.is_recovered);
        same += exit.face == first_plane(r, from).face;
    }
    EXPECT_GE(same, 19998);  // but within rounding of an edge
}

}  // namespace
}  // namespace enfilade::render

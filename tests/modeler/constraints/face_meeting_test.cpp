// Two faces that meet, against CGAL's exact intersections of the triangles that they are made of.

#include "modeler/constraints/face_meeting.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "modeler/constraints/ring_crossings.h"
#include "plans/random.h"

namespace enfilade::modeler {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Ids = std::vector<std::uint32_t>;

/// Whether two faces meet elsewhere than in what they share.
bool meet(const std::vector<Point3>& points, const Ids& a, const Ids& b) {
    return meeting_point(FlatFace(a, points), FlatFace(b, points), points).has_value();
}

TEST(FacesThatMeet, CrossOrTouchOrLieOnEachOther) {
    const std::vector<Point3> points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},  {1, 1, -1}, {3, 1, -1},
                                        {2, 2, 3}, {2, 2, 0}, {1, 1, 0}, {9, 1, 0},  {9, 3, 0},  {0, 0, 5},
                                        {4, 4, 5}, {6, 6, 0}, {6, 6, 5}, {-1, 2, 0}, {-1, 2, 5}, {0, 2, 0}};
    const Ids floor = {0, 1, 2, 3};
    EXPECT_TRUE(meet(points, floor, {4, 5, 6})) << "pierced";
    EXPECT_TRUE(meet(points, floor, {7, 11, 12})) << "touched by a corner";
    EXPECT_TRUE(meet(points, floor, {8, 9, 10})) << "overlapped in its plane";
    EXPECT_TRUE(meet(points, floor, {3, 2, 1, 0})) << "folded onto itself";
    EXPECT_TRUE(meet(points, floor, {0, 2, 12, 11})) << "cut from shared corner to shared corner";
    EXPECT_TRUE(meet(points, floor, {0, 13, 14, 11})) << "cut beyond a shared corner";
    EXPECT_TRUE(meet(points, floor, {15, 16, 17})) << "touched at its side";
    EXPECT_TRUE(meet(points, floor, {1, 2, 7})) << "folded over a shared side";
}

TEST(FacesThatMeet, AreNotThoseThatShareWhatTheyHaveInCommon) {
    const std::vector<Point3> points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {4, 0, 5}, {4, 4, 5},  {8, 0, 0},
                                        {8, 4, 0}, {9, 9, 3}, {2, 2, 1}, {3, 3, 7}, {8, 8, 0}, {8, -1, 4}, {2, 2, 9}};
    const Ids floor = {0, 1, 2, 3};
    EXPECT_FALSE(meet(points, floor, {1, 2, 5, 4})) << "a wall on its side";
    EXPECT_FALSE(meet(points, floor, {1, 6, 7, 2})) << "the floor beside it";
    EXPECT_FALSE(meet(points, floor, {2, 11, 7})) << "a corner in one plane";
    EXPECT_FALSE(meet(points, floor, {2, 8, 10})) << "a corner";
    EXPECT_FALSE(meet(points, floor, {9, 10, 13})) << "a unit above";
    EXPECT_FALSE(meet(points, {0, 1, 2}, {0, 2, 3})) << "halves";
}

Kernel::Point_3 exact(const Point3& p) { return {p[0], p[1], p[2]}; }

/// Whether the intersection of two triangles is no more than the part of the border that both faces have.
bool is_shared(const std::vector<Point3>& points, const Ids& a, const Ids& b, const Kernel::Triangle_3& s,
               const Kernel::Triangle_3& t) {
    const auto shared_vertex = [&](const Kernel::Point_3& p) {
        return std::any_of(a.begin(), a.end(), [&](std::uint32_t v) {
            return std::count(b.begin(), b.end(), v) > 0 && exact(points[v]) == p;
        });
    };
    const auto edges = [](const Ids& ring) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
        for (std::size_t k = 0; k < ring.size(); ++k)
            found.push_back(std::minmax(ring[k], ring[(k + 1) % ring.size()]));
        return found;
    };
    const auto on_shared_edge = [&](const Kernel::Segment_3& part) {
        for (const auto& [v, w] : edges(a))
            for (const auto& other : edges(b))
                if (other == std::pair(v, w)) {
                    const Kernel::Segment_3 edge(exact(points[v]), exact(points[w]));
                    if (edge.has_on(part.source()) && edge.has_on(part.target())) return true;
                }
        return false;
    };
    const CGAL::Object common = CGAL::intersection(s, t);
    if (common.empty()) return true;
    if (const auto* p = CGAL::object_cast<Kernel::Point_3>(&common))
        return shared_vertex(*p) || on_shared_edge(Kernel::Segment_3(*p, *p));
    if (const auto* part = CGAL::object_cast<Kernel::Segment_3>(&common)) return on_shared_edge(*part);
    return false;
}

/// A convex or concave quadrangle or triangle on a small raster in a random plane; corners from `pool` where it fits.
Ids any_face(std::vector<Point3>& points, plans::Random& random) {
    const auto number = [&](int from, int to) { return from + std::int32_t(random.below(std::uint32_t(to - from))); };
    Ids ids;
    for (int k = 0; k < 3; ++k) {
        if (!points.empty() && random.chance(0.3)) {
            ids.push_back(random.below(std::uint32_t(points.size())));
            continue;
        }
        points.push_back({number(-3, 4), number(-3, 4), number(-3, 4)});
        ids.push_back(std::uint32_t(points.size() - 1));
    }
    if (random.chance(0.5)) {  // a + s (b - a) + t (c - a)
        const Point3 a = points[ids[0]], b = points[ids[1]], c = points[ids[2]];
        const std::int32_t s = number(-1, 3), t = number(-1, 3);
        Point3 d;
        for (std::size_t i = 0; i < 3; ++i) d[i] = a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i]);
        points.push_back(d);
        ids.push_back(std::uint32_t(points.size() - 1));
    }
    return ids;
}

bool is_valid(const std::vector<Point3>& points, const Ids& ring) {
    const FlatFace face(ring, points);
    if (!face.has_extent) return false;
    std::vector<plans::GridPoint> flat;
    for (const std::uint32_t v : ring) flat.push_back({points[v][face.u], points[v][face.v]});
    return ring_crossings(flat).empty();
}

/// Triangles of a simple ring of three or four corners.
std::vector<Kernel::Triangle_3> triangles(const std::vector<Point3>& points, const Ids& ring) {
    const auto triangle = [&](std::size_t i, std::size_t j, std::size_t k) {
        return Kernel::Triangle_3(exact(points[ring[i]]), exact(points[ring[j]]), exact(points[ring[k]]));
    };
    if (ring.size() == 3) return {triangle(0, 1, 2)};
    // The diagonal that lies inside: its ends' triangles do not hold the corner across.
    const auto area = [](const Kernel::Triangle_3& t) { return CGAL::to_double(t.squared_area()); };
    const double by_02 = std::sqrt(area(triangle(0, 1, 2))) + std::sqrt(area(triangle(0, 2, 3)));
    const double by_13 = std::sqrt(area(triangle(1, 2, 3))) + std::sqrt(area(triangle(1, 3, 0)));
    std::vector<Kernel::Triangle_3> parts = {triangle(0, 1, 2), triangle(0, 2, 3)};
    if (by_13 < by_02 - 1e-9) parts = {triangle(1, 2, 3), triangle(1, 3, 0)};
    std::erase_if(parts, [](const Kernel::Triangle_3& t) { return t.is_degenerate(); });
    return parts;
}

TEST(FacesThatMeet, AreThoseOfWhichTheExactIntersectionSaysSo) {
    std::uint32_t meeting = 0, apart = 0;
    for (std::uint64_t seed = 0; seed < 100000; ++seed) {
        plans::Random random{4, seed};
        std::vector<Point3> points;
        const Ids a = any_face(points, random), b = any_face(points, random);
        std::vector<Point3> sorted = points;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) continue;
        if (!is_valid(points, a) || !is_valid(points, b)) continue;
        bool expected = false;
        for (const auto& s : triangles(points, a))
            for (const auto& t : triangles(points, b)) expected = expected || !is_shared(points, a, b, s, t);
        ++(expected ? meeting : apart);
        EXPECT_EQ(meet(points, a, b), expected) << "seed " << seed;
        EXPECT_EQ(meet(points, b, a), expected) << "seed " << seed;
    }
    EXPECT_GT(meeting, 3000u);
    EXPECT_GT(apart, 3000u);
}

/// Far out on the grid the products fill 119 bits.
TEST(FacesThatMeet, AreFoundAtTheEndsOfTheGrid) {
    const std::int32_t far = 1 << 28;
    const std::vector<Point3> points = {{-far, -far, -far}, {far, -far, -far + 1}, {far, far, far},
                                        {0, 0, 0},          {far, 1 - far, 7},     {-far, far, -far},
                                        {-far, far, far},   {far - 1, far, -3}};
    const auto expected = [&](const Ids& a, const Ids& b) {
        bool meets = false;
        for (const auto& s : triangles(points, a))
            for (const auto& t : triangles(points, b)) meets = meets || !is_shared(points, a, b, s, t);
        return meets;
    };
    const std::vector<Ids> faces = {{0, 1, 2}, {3, 4, 5}, {4, 5, 6}, {5, 6, 7}, {0, 4, 6}, {1, 6, 7}, {2, 3, 5}};
    for (const Ids& a : faces)
        for (const Ids& b : faces) {
            if (a == b) continue;
            EXPECT_EQ(meet(points, a, b), expected(a, b)) << a[0] << a[1] << a[2] << " " << b[0] << b[1] << b[2];
        }
}

}  // namespace
}  // namespace enfilade::modeler

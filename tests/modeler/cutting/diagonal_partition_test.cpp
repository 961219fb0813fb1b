// The cutter by diagonals: convex pieces that sum to the polygon, whatever its shape.
#include "modeler/cutting/diagonal_partition.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include "modeler/cutting/delaunay_partition.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

struct Polygon {
    std::vector<GridPoint> points;
    std::vector<PolygonSide> sides;

    /// A ring, counter-clockwise; every side its own line, look and faces.
    explicit Polygon(std::vector<GridPoint> loop) : points(std::move(loop)) {
        const auto count = std::uint32_t(points.size());
        for (std::uint32_t k = 0; k < count; ++k) sides.push_back({k, (k + 1) % count, k, 100 + k, 200 + k, 1 + k % 3});
    }

    [[nodiscard]] std::uint32_t reflex_count() const {
        std::uint32_t count = 0;
        const std::size_t n = sides.size();
        for (std::size_t k = 0; k < n; ++k)
            count += sides[k].line != sides[(k + n - 1) % n].line &&
                     orientation(points[sides[(k + n - 1) % n].from], points[k], points[sides[k].to]) < 0;
        return count;
    }
};

GridPoint rounded(double x, double y) { return {std::int32_t(std::lround(x)), std::int32_t(std::lround(y))}; }

/// What is wrong with a partition; empty if it is what a convex partition has to be.
std::string fault(const Polygon& polygon, const Partition& partition) {
    std::int64_t sum = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> cuts;
    std::map<std::uint32_t, std::uint32_t> lines;
    std::set<std::uint32_t> kept;
    for (std::uint32_t k = 0; k < partition.piece_count(); ++k) {
        const auto ring = partition.piece(k);
        std::vector<RingCorner> corners;
        std::set<std::uint32_t> visited;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const PolygonSide& side = ring[i];
            if (side.to != ring[(i + 1) % ring.size()].from) return "a ring is open";
            if (!visited.insert(side.from).second) return "a piece visits a point twice";
            corners.push_back({polygon.points[side.from], side.line});
            if (side.tag == cut_tag) {
                if (side.line < first_cut_line) return "a cut has a line of the polygon";
                if (!cuts.emplace(std::pair(side.from, side.to), side.line).second) return "a cut comes twice";
                ++lines[side.line];
                continue;
            }
            const PolygonSide& given = polygon.sides[side.tag - 100];
            if (given.from != side.from || given.to != side.to || given.line != side.line || given.look != side.look ||
                given.faces != side.faces)
                return "a side is not handed through";
            if (!kept.insert(side.tag).second) return "a side comes twice";
        }
        if (reflex_corner(corners)) return "a piece is not convex";
        if (area2(polygon.points, ring) <= 0) return "a piece has no area";
        sum += area2(polygon.points, ring);
    }
    for (const auto& [ends, line] : cuts) {
        const auto back = cuts.find({ends.second, ends.first});
        if (back == cuts.end() || back->second != line) return "a cut has no other side";
        if (lines[line] != 2) return "cuts share a line";
    }
    if (kept.size() != polygon.sides.size()) return "a side is missing";
    if (sum != area2(polygon.points, polygon.sides)) return "the pieces do not sum to the polygon";
    if (partition.piece_count() != cuts.size() / 2 + 1) return "the pieces are not those of a disc";
    if (!partition.new_points.empty()) return "there are new points";
    return "";
}

/// A star around the origin, `corners` corners.
Polygon star(int corners, const std::function<int()>& radius) {
    std::vector<GridPoint> loop;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * k / corners, r = radius();
        loop.push_back(rounded(r * std::cos(angle), r * std::sin(angle)));
    }
    return Polygon(loop);
}

TEST(DiagonalPartition, LeavesAConvexPolygonWhole) {
    const Polygon square({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    const Partition whole = diagonal_partition(square.points, square.sides);
    EXPECT_EQ(fault(square, whole), "");
    EXPECT_EQ(whole.piece_count(), 1u);
}

TEST(DiagonalPartition, CutsAnLInTwo) {
    const Polygon l({{0, 0}, {200, 0}, {200, 100}, {100, 100}, {100, 200}, {0, 200}});
    const Partition pieces = diagonal_partition(l.points, l.sides);
    EXPECT_EQ(fault(l, pieces), "");
    EXPECT_EQ(pieces.piece_count(), 2u);
    EXPECT_EQ(pieces.fallen_back, 0u);
}

RC_GTEST_PROP(DiagonalPartition, CutsStarsIntoConvexPieces, ()) {
    const Polygon polygon = star(*rc::gen::inRange(3, 200), [] { return *rc::gen::inRange(20000, 90000); });
    const Partition pieces = diagonal_partition(polygon.points, polygon.sides);
    RC_ASSERT(fault(polygon, pieces) == "");
    RC_ASSERT(pieces.fallen_back == 0u);
    RC_ASSERT(pieces.piece_count() <= 2 * polygon.reflex_count() + 1);
}

}  // namespace
}  // namespace enfilade::modeler

#include "gmap/orbit.h"

#include <algorithm>
#include <iterator>
#include <ranges>
#include <set>
#include <thread>

#include "maps.h"

namespace enfilade::gmap {
namespace {

static_assert(std::ranges::forward_range<Orbit>);

template <class Range>
std::set<DartId> as_set(Range&& range) {
    std::set<DartId> result;
    for (const DartId d : range) EXPECT_TRUE(result.insert(d).second) << "a dart twice";
    return result;
}

std::size_t size_of(Orbit orbit) { return as_set(orbit).size(); }

TEST(Orbit, HasTheSizesOfACube) {
    const Map map = cube();
    for (const DartId d : map.darts()) {
        EXPECT_EQ(size_of(orbit<>(map, d)), 1u);
        EXPECT_EQ(size_of(orbit<3>(map, d)), 2u);
        EXPECT_EQ(size_of(orbit<0, 1>(map, d)), 8u);
        EXPECT_EQ(size_of(orbit<1, 2>(map, d)), 6u);
        EXPECT_EQ(size_of(orbit<2, 3>(map, d)), 4u);
        EXPECT_EQ(size_of(cell<0>(map, d)), 12u);
        EXPECT_EQ(size_of(cell<1>(map, d)), 8u);
        EXPECT_EQ(size_of(cell<2>(map, d)), 16u);
        EXPECT_EQ(size_of(cell<3>(map, d)), 48u);
        EXPECT_EQ(size_of(cell_in_volume<1>(map, d)), 4u);
        EXPECT_EQ(size_of(orbit<0, 1, 2, 3>(map, d)), 96u);
    }
}

TEST(Orbit, IsTheDartsThatShareTheCell) {
    const Map map = grid(3, 2, 2);
    for (const DartId d : {DartId{0}, DartId{101}, DartId{203}}) {
        std::set<DartId> same;
        for (const DartId x : map.darts())
            if (map.volume(x) == map.volume(d)) same.insert(x);
        EXPECT_EQ(as_set(cell<3>(map, d)), same);
    }
}

TEST(Orbit, OfAFreeDartIsTheDart) {
    Map map;
    EXPECT_EQ(size_of(orbit<0, 1, 2, 3>(map, map.add_dart())), 1u);
}

TEST(Orbit, StartsWithItsDart) {
    const Map map = cube();
    EXPECT_EQ(*cell<2>(map, DartId{13}).begin(), DartId{13});
}

TEST(Orbit, CanBeWalkedTwice) {
    const Map map = cube();
    Orbit darts = cell<3>(map, DartId{0});
    EXPECT_EQ(std::ranges::distance(darts.begin(), darts.end()), 48);
    EXPECT_EQ(as_set(darts).size(), 48u);
}

TEST(Orbit, ComposesWithViews) {
    const Map map = cube();
    auto ends = cell<1>(map, DartId{0}) | std::views::filter([&](DartId d) { return map.volume(d) == VolumeId{0}; }) |
                std::views::transform([&](DartId d) { return map.vertex(d); });
    std::set<VertexId> vertices;
    for (const VertexId v : ends) vertices.insert(v);
    EXPECT_EQ(vertices, (std::set<VertexId>{VertexId{0}, VertexId{1}}));
}

TEST(Cells, GivesOneDartPerCell) {
    const Map map = grid(2, 2, 1);
    std::set<FaceId> faces;
    for (const DartId d : cells<2>(map)) EXPECT_TRUE(faces.insert(map.face(d)).second);
    EXPECT_EQ(faces.size(), map.face_count());
}

TEST(IncidentCells, OfACube) {
    const Map map = cube();
    const DartId d{0};
    EXPECT_EQ((incident_cells<0, 3>(map, d).size()), 8u);
    EXPECT_EQ((incident_cells<1, 3>(map, d).size()), 12u);
    EXPECT_EQ((incident_cells<2, 3>(map, d).size()), 6u);
    EXPECT_EQ((incident_cells<3, 2>(map, d).size()), 2u);
    EXPECT_EQ((incident_cells<2, 0>(map, d).size()), 3u);
    EXPECT_EQ((incident_cells<0, 1>(map, d).size()), 2u);
}

TEST(Orbit, IsReadByManyThreadsAtOnce) {
    const Map map = grid(5, 5, 5);
    std::vector<std::size_t> counts(4, 0);
    {
        std::vector<std::jthread> threads;
        for (std::size_t& count : counts)
            threads.emplace_back([&map, &count] {
                for (const DartId d : cells<0>(map)) count += incident_cells<3, 0>(map, d).size();
                if (!validate(map).is_sound()) count = 0;
            });
    }
    // Each of the 125 hexahedra has 8 corners; the outside has the vertices of the hull.
    EXPECT_EQ(counts, std::vector<std::size_t>(4, 125 * 8 + 6 * 6 * 6 - 4 * 4 * 4));
}

}  // namespace
}  // namespace enfilade::gmap

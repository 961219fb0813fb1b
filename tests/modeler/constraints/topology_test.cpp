// T1-T7, G5, G8: each fault of the map is told once, and what it spoils is not told again.

#include <gtest/gtest.h>

#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/faults_topology.h"

namespace enfilade::modeler {
namespace {

TEST(Topology, FindsEachBrokenLink) { testing::expect_found(testing::inject_t1, 20); }
TEST(Topology, FindsEachFreeDart) { testing::expect_found(testing::inject_t2, 20); }
TEST(Topology, FindsEachMirroredFace) { testing::expect_found(testing::inject_t3, 20); }
TEST(Topology, FindsEachCellWithTwoFaces) { testing::expect_found(testing::inject_t4, 20); }
TEST(Topology, FindsEachVertexThatIsTwo) { testing::expect_found(testing::inject_t5, 20); }
TEST(Topology, FindsEachDanglingEdge) { testing::expect_found(testing::inject_t6, 20); }
TEST(Topology, FindsEachVolumeWithAHole) { testing::expect_found(testing::inject_t7, 20); }
TEST(Partition, FindsEachHullThatIsNotTheSite) { testing::expect_found(testing::inject_g5, 20); }

TEST(Convexity, FindsEachCellThatMeasuresOtherwise) {
    // Half of the buildings are not convex, and offer no place for this fault.
    testing::expect_found(testing::inject_g8, 20);
}

}  // namespace
}  // namespace enfilade::modeler

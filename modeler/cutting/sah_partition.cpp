#include "modeler/cutting/sah_partition.h"

namespace enfilade::modeler {

Partition sah_partition(std::span<const plans::GridPoint> points, std::span<const PolygonSide> sides,
                        PartitionGoal goal, const SahOptions&) {
    return delaunay_partition(points, sides, goal);
}

}  // namespace enfilade::modeler

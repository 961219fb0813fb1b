#include "modeler/cutting/diagonal_partition.h"

#include "modeler/cutting/delaunay_partition.h"

namespace enfilade::modeler {

Partition diagonal_partition(std::span<const plans::GridPoint> points, std::span<const PolygonSide> sides) {
    return delaunay_partition(points, sides, PartitionGoal::Convex);
}

}  // namespace enfilade::modeler

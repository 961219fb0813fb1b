#include "accel/octree/lattice_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "accel/octree/octant_test.h"

namespace enfilade::accel::detail {
namespace {

constexpr std::size_t grain = 1 << 14;

struct Box {
    static constexpr float far = std::numeric_limits<float>::max();
    std::array<float, 3> low = {far, far, far}, high = {-far, -far, -far};
    void add(const std::array<float, 3>& p) {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    }
};

std::array<float, 3> place(const MeshPart& mesh, std::uint32_t vertex) {
    const Vertex& v = mesh.places[vertex];
    return {v.x, v.y, v.z};
}

Box box_of(const MeshPart& mesh, const Executor& executor) {
    std::vector<Box> boxes((mesh.used.size() + grain - 1) / grain);
    parallel_for(executor, mesh.used.size(), grain, [&](std::size_t begin, std::size_t end) {
        Box box;
        for (std::size_t i = begin; i < end; ++i)
            for (const std::uint32_t corner : mesh.triangles[mesh.used[i]].corners) box.add(place(mesh, corner));
        boxes[begin / grain] = box;
    });
    for (const Box& box : boxes) {
        boxes.front().add(box.low);
        boxes.front().add(box.high);
    }
    return boxes.front();
}

OctreeFrame cube_of(const MeshPart& mesh, std::uint32_t depth, const Executor& executor) {
    const Box box = box_of(mesh, executor);
    return cube_about(box.low, box.high, std::min(depth, largest_octree_depth));
}

}  // namespace

OctreeFrame cube_about(const std::array<float, 3>& low, const std::array<float, 3>& high, std::uint32_t depth) {
    OctreeFrame frame;
    frame.depth = depth;
    frame.low = low;
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) size = std::max(size, double{high[k]} - low[k]);
    const double widened = size * (1 + 0x1p-8);
    const double cells = widened > 0 ? std::min(double{frame.side()} / widened, 0x1p126) : 1.0;
    frame.cells_a_unit.fill(static_cast<float>(cells));
    return frame;
}

LatticeTriangles::LatticeTriangles(const MeshPart& mesh, const OctreeOptions& options, const Executor& executor)
    : LatticeTriangles(mesh, cube_of(mesh, options.depth, executor), executor) {}

LatticeTriangles::LatticeTriangles(const MeshPart& mesh, const OctreeFrame& frame, const Executor& executor)
    : frame_(frame), corners_(mesh.used.size()) {
    parallel_for(executor, corners_.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                const std::array<float, 3> p = place(mesh, mesh.triangles[mesh.used[i]].corners[c]);
                for (std::size_t k = 0; k < 3; ++k)
                    corners_[i][3 * c + k] = in_lattice(p[k], frame_.low[k], frame_.cells_a_unit[k]);
            }
        }
    });
}

// Roundings: corners are off by 2^-25 of the root's side once, by as much again about the node's centre; along a
// normal n the corners and the cube are then measured with less than 4 roundings each of |n| times the largest
// distance, which is at most the root's side: together less than 2^-21 of it. By so much the slack is widened.
void LatticeTriangles::find_octants(const OctreeNode& node, std::span<const std::uint32_t> listed,
                                    std::uint8_t* octants) const {
    const auto half = std::ldexp(0.25f, static_cast<int>(frame_.depth - node.level));
    const float slack = octant_slack(frame_.side());
    std::array<float, 3> centre;
    for (std::size_t k = 0; k < 3; ++k) centre[k] = static_cast<float>(node.low[k]) + 2 * half;
    TriangleBlock block;
    std::uint32_t found[TriangleBlock::size];
    for (std::size_t first = 0; first < listed.size(); first += TriangleBlock::size) {
        const std::size_t count = std::min<std::size_t>(TriangleBlock::size, listed.size() - first);
        for (std::size_t i = 0; i < TriangleBlock::size; ++i) {
            const Corners& corners = corners_[listed[first + std::min(i, count - 1)]];
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t k = 0; k < 3; ++k) block.at[c][k][i] = corners[3 * c + k] - centre[k];
        }
        if (!octants_of_boxes(block, slack, found)) refine_octants(block, half, half + slack, found);
        for (std::size_t i = 0; i < count; ++i) octants[first + i] = static_cast<std::uint8_t>(found[i]);
    }
}

}  // namespace enfilade::accel::detail

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "base/disjoint_sets.h"
#include "modeler/meshes/mesh_readers.h"
#include "modeler/meshes/point_index.h"

namespace enfilade::modeler {
namespace {

/// Cells so small that all points of one are within the distance of each other; then only pairs of cells are looked at.
class WeldGrid {
public:
    WeldGrid(const std::vector<MeshPoint>& points, double distance)
        : points_(points), distance_(distance), side_(distance / std::sqrt(3.0) * (1 - 1e-9)) {
        std::vector<MeshPoint> cells;
        PointIndex index(points.size() / 2);
        cell_of_.reserve(points.size());
        for (const MeshPoint& p : points) {
            const MeshPoint cell{std::floor(p[0] / side_), std::floor(p[1] / side_), std::floor(p[2] / side_)};
            const std::uint32_t number = index.find_or_add(cell, cells);
            if (number == cells.size()) cells.push_back(cell), members_.emplace_back();
            cell_of_.push_back(number);
            members_[number].push_back(static_cast<std::uint32_t>(cell_of_.size() - 1));
        }
        cells_ = std::move(cells);
        index_ = std::move(index);
    }

    void join_near(DisjointSets& clusters) {
        const auto count = static_cast<std::uint32_t>(cells_.size());
        for (std::uint32_t c = 0; c < count; ++c) {
            for (const std::uint32_t v : members_[c]) clusters.join(members_[c].front(), v);
            for (int dx = 0; dx <= 2; ++dx)
                for (int dy = dx == 0 ? 0 : -2; dy <= 2; ++dy)
                    for (int dz = dx == 0 && dy == 0 ? 1 : -2; dz <= 2; ++dz)
                        if (const auto other = neighbour(c, dx, dy, dz)) join_cells(c, *other, clusters);
        }
    }

private:
    std::optional<std::uint32_t> neighbour(std::uint32_t c, int dx, int dy, int dz) const {
        return index_.find({cells_[c][0] + dx, cells_[c][1] + dy, cells_[c][2] + dz}, cells_);
    }

    /// One pair is enough: each cell is one set already.
    void join_cells(std::uint32_t a, std::uint32_t b, DisjointSets& clusters) const {
        for (const std::uint32_t v : members_[a])
            for (const std::uint32_t w : members_[b]) {
                const MeshPoint &p = points_[v], &q = points_[w];
                if (std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) > distance_) continue;
                clusters.join(v, w);
                return;
            }
    }

    const std::vector<MeshPoint>& points_;
    double distance_;
    double side_;
    std::vector<std::uint32_t> cell_of_;
    std::vector<MeshPoint> cells_;
    std::vector<std::vector<std::uint32_t>> members_;
    PointIndex index_;
};

}  // namespace

std::vector<std::uint32_t> vertex_places(const Mesh& mesh, double distance) {
    std::vector<std::uint32_t> first_equal;  // [distinct point] lowest vertex there
    std::vector<std::uint32_t> distinct_of(mesh.points.size());
    std::vector<MeshPoint> distinct;
    PointIndex index(mesh.points.size());
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
        distinct_of[v] = index.find_or_add(mesh.points[v], distinct);
        if (distinct_of[v] == distinct.size()) distinct.push_back(mesh.points[v]), first_equal.push_back(v);
    }
    DisjointSets clusters(distinct.size());
    if (distance > 0) WeldGrid(distinct, distance).join_near(clusters);
    std::vector<std::uint32_t> result(mesh.points.size());
    for (std::uint32_t v = 0; v < result.size(); ++v) result[v] = first_equal[clusters.find(distinct_of[v])];
    return result;
}

namespace {

/// Sets of points that reach farther than the distance, each point near the next.
std::size_t count_chains(const Mesh& mesh, const std::vector<std::uint32_t>& lowest, double distance) {
    std::vector<std::uint32_t> far;
    for (std::uint32_t v = 0; v < lowest.size(); ++v) {
        const MeshPoint &p = mesh.points[v], &q = mesh.points[lowest[v]];
        if (std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) > distance) far.push_back(lowest[v]);
    }
    std::sort(far.begin(), far.end());
    return static_cast<std::size_t>(std::unique(far.begin(), far.end()) - far.begin());
}

/// Corners of one face that became one vertex are one corner; a face that is left with two of them is gone.
std::size_t drop_collapsed(Mesh& mesh, const std::vector<std::uint32_t>& lowest) {
    std::size_t touched = 0, write = 0;
    std::vector<std::uint32_t> first{0};
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::size_t begin = mesh.ring_first[f], end = mesh.ring_first[f + 1], start = write;
        bool shorter = false;
        for (std::size_t k = begin; k < end; ++k) {
            const std::uint32_t v = mesh.ring[k], before = mesh.ring[k == begin ? end - 1 : k - 1];
            // What the file itself repeats stays for G2 to find.
            if (end - begin > 1 && v != before && lowest[v] == lowest[before]) shorter = true;
            else mesh.ring[write++] = v;
        }
        if (shorter) ++touched;
        if (shorter && write - start < 3) write = start;
        first.push_back(static_cast<std::uint32_t>(write));
    }
    mesh.ring.resize(write);
    mesh.ring_first = std::move(first);
    for (std::uint32_t& v : mesh.ring) v = lowest[v];
    for (std::uint32_t& v : mesh.hole_ring) v = lowest[v];
    return touched;
}

}  // namespace

void weld(Mesh& mesh, double distance) {
    const std::vector<std::uint32_t> lowest = vertex_places(mesh, distance);
    std::size_t welded = 0;
    mesh.merged.assign(mesh.points.size(), false);
    for (std::uint32_t v = 0; v < lowest.size(); ++v)
        if (lowest[v] != v) mesh.merged[v] = true, ++welded;
    const std::size_t chains = count_chains(mesh, lowest, distance);
    const std::size_t collapsed = welded == 0 ? 0 : drop_collapsed(mesh, lowest);
    char distance_text[32];
    std::snprintf(distance_text, sizeof distance_text, "%g", distance);
    Finding finding{.code = "P811", .severity = chains == 0 ? Severity::Note : Severity::Warning};
    finding.sentence = std::to_string(welded) + " of " + std::to_string(mesh.points.size()) +
                       " vertices were welded to one " +
                       (distance > 0 ? std::string("within ") + distance_text : std::string("at the same place")) +
                       (collapsed == 0 ? "" : "; " + std::to_string(collapsed) + " faces lost corners by it") + ".";
    if (chains != 0) {
        finding.sentence += " " + std::to_string(chains) + " chains of vertices reach farther than that.";
        finding.hint = "Take a smaller distance.";
    }
    mesh.findings.push_back(std::move(finding));
}

}  // namespace enfilade::modeler

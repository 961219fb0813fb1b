#include "modeler/constraints/map_faces.h"

#include <cstdlib>

#include "modeler/cell_node.h"

namespace enfilade::modeler {
namespace {

void add_foot(plans::GridPoint p, MapFace& face) {
    for (std::uint8_t k = 0; k < face.foot_count && k < 2; ++k)
        if (face.feet[k] == p) return;
    if (face.foot_count < 2) face.feet[face.foot_count] = p;
    if (face.foot_count < 3) ++face.foot_count;
}

/// Calls visit(point) for the vertices of a face's ring, as long as the darts hold together.
template <class Visit>
void walk(const Building& building, const MapFace& face, Visit visit) {
    const gmap::MapArrays& arrays = building.map.arrays();
    if (!face.in_map()) return;
    std::uint32_t d = face.dart;
    for (std::size_t steps = 0; steps < arrays.alpha[0].size(); ++steps) {
        if (arrays.cell_id[0][d] < building.vertices.size()) visit(building.vertices[arrays.cell_id[0][d]]);
        d = arrays.alpha[1][arrays.alpha[0][d]];
        if (d == face.dart || d == UINT32_MAX) return;
    }
}

}  // namespace

MapFaces::MapFaces(const Building& building) : building_(&building) {
    const gmap::MapArrays& arrays = building.map.arrays();
    faces_.resize(std::max(building.map.cell_bound<2>(), building.faces.size()));
    const std::size_t volumes = std::max(building.map.cell_bound<3>(), building.volumes.size());
    for (std::uint32_t d = 0; d < arrays.alpha[0].size(); ++d) {
        if (arrays.alpha[0][d] == UINT32_MAX) continue;
        const std::uint32_t v = arrays.cell_id[3][d];
        MapFace& face = faces_[arrays.cell_id[2][d]];
        if (!face.in_map()) face.dart = d;
        if (face.volumes[0] != v && face.volumes[1] != v) {
            if (face.volumes[0] == UINT32_MAX) face.volumes[0] = v;
            else if (face.volumes[1] == UINT32_MAX) face.volumes[1] = v;
            else face.joins_two = false;
        }
        if (arrays.cell_id[0][d] >= building.vertices.size()) continue;
        const auto& p = building.vertices[arrays.cell_id[0][d]];
        face.z_low = std::min(face.z_low, p[2]);
        face.z_high = std::max(face.z_high, p[2]);
        if (face.foot_count < 3) add_foot({p[0], p[1]}, face);
    }

    first_.assign(volumes + 1, 0);
    for (MapFace& face : faces_) {
        if (face.volumes[1] < face.volumes[0]) std::swap(face.volumes[0], face.volumes[1]);
        for (const std::uint32_t v : face.volumes)
            if (v != UINT32_MAX) ++first_[v + 1];
    }
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    of_volume_.resize(first_.back());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::uint32_t f = 0; f < faces_.size(); ++f)
        for (const std::uint32_t v : faces_[f].volumes)
            if (v != UINT32_MAX) of_volume_[fill[v]++] = f;

    prism_.assign(volumes, false);
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v) {
        const Volume& row = building.volumes[v];
        bool fits = in_map(v), floor = false, ceiling = false;
        for (const std::uint32_t f : of_volume(v)) {
            const MapFace& face = faces_[f];
            if (face.level()) {
                floor = floor || face.z_low == row.z_low;
                ceiling = ceiling || face.z_high == row.z_high;
                fits = fits && (face.z_low == row.z_low || face.z_high == row.z_high);
            } else {
                fits = fits && face.upright() && face.z_low >= row.z_low && face.z_high <= row.z_high;
            }
        }
        prism_[v] = fits && floor && ceiling;
    }
}

int MapFaces::side(const MapFace& face, std::uint32_t volume) const {
    if (!face.level()) return 0;
    const Volume& row = building_->volumes[volume];
    // Seen from `Outside`, which is the space around its box, below is above.
    const int inside_out = row.label == Label::Outside ? -1 : 1;
    return inside_out * (face.z_low == row.z_low ? -1 : 1);
}

std::int64_t area2(const Building& building, const MapFace& face) {
    std::int64_t sum = 0;
    bool first = true;
    plans::GridPoint origin, last;
    walk(building, face, [&](const std::array<std::int32_t, 3>& v) {
        const plans::GridPoint p{v[0], v[1]};
        if (first) origin = p, first = false;
        else sum += orientation(origin, last, p);
        last = p;
    });
    return std::abs(sum);
}

std::array<double, 3> middle(const Building& building, const MapFace& face) {
    std::vector<plans::GridPoint> ring;
    walk(building, face, [&](const std::array<std::int32_t, 3>& v) { ring.push_back({v[0], v[1]}); });
    const plans::GridFrame& frame = building.frame;
    if (ring.empty()) return {frame.origin_x, frame.origin_y, frame.origin_z};
    std::array<double, 2> point = {};
    if (face.level()) {
        point = inner_point(ring);
    } else if (face.upright()) {
        point = {(double(face.feet[0].x) + face.feet[1].x) / 2, (double(face.feet[0].y) + face.feet[1].y) / 2};
    } else {
        for (const plans::GridPoint p : ring) point[0] += p.x, point[1] += p.y;
        for (double& coordinate : point) coordinate /= double(ring.size());
    }
    return {frame.origin_x + frame.unit * point[0], frame.origin_y + frame.unit * point[1],
            frame.origin_z + frame.unit * (double(face.z_low) + face.z_high) / 2};
}

}  // namespace enfilade::modeler

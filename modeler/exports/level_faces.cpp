#include "modeler/exports/level_faces.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "base/disjoint_sets.h"

namespace enfilade::modeler {

namespace {

constexpr std::uint32_t no_index = UINT32_MAX;

/// Twice the area on the left of a ring; sums wrap round, the result does not.
std::int64_t area2(const std::vector<plans::GridPoint>& points, std::span<const std::uint32_t> ring) {
    std::uint64_t sum = 0;
    for (std::size_t k = 1; k + 1 < ring.size(); ++k)
        sum += std::uint64_t(plans::orientation(points[ring[0]], points[ring[k]], points[ring[k + 1]]));
    return std::int64_t(sum);
}

}  // namespace

LevelFaces::LevelFaces(const Building& building) {
    for (const plans::GridPoint& p : building.points) points_.push_back({p.x, p.y});
    const auto key = [](std::int32_t x, std::int32_t y) {
        return std::uint64_t(std::uint32_t(x)) << 32 | std::uint32_t(y);
    };
    std::unordered_map<std::uint64_t, std::uint32_t> point_at;
    for (std::uint32_t p = 0; p < building.points.size(); ++p)
        point_at.emplace(key(building.points[p].x, building.points[p].y), p);

    const gmap::MapArrays& map = building.map.arrays();
    std::vector<std::uint32_t> dart_of(building.faces.size(), no_index);
    for (std::uint32_t d = 0; d < map.alpha[0].size(); ++d)
        if (const std::uint32_t f = map.cell_id[2][d]; f < dart_of.size() && dart_of[f] == no_index) dart_of[f] = d;

    first_ring_.push_back(0);
    for (std::uint32_t f = 0; f < building.faces.size(); ++f) {
        const Face& face = building.faces[f];
        if (face.direction == Direction::Up && dart_of[f] != no_index) {
            floors_.push_back({face.front, f, face.back});
            ceilings_.push_back({face.back, f, face.front});
            const std::size_t first = ring_.size();
            std::uint32_t d = dart_of[f];
            do {
                const auto& v = building.vertices[map.cell_id[0][d]];
                const auto at = point_at.find(key(v[0], v[1]));
                if (at != point_at.end()) ring_.push_back(at->second);
                d = map.alpha[1][map.alpha[0][d]];
            } while (d != dart_of[f] && ring_.size() - first <= map.alpha[0].size());
            const std::span ring(ring_.begin() + std::ptrdiff_t(first), ring_.end());
            if (area2(building.points, ring) < 0) std::reverse(ring.begin(), ring.end());
        }
        first_ring_.push_back(std::uint32_t(ring_.size()));
    }
    const auto by_volume = [](const LevelFace& a, const LevelFace& b) {
        return std::pair(a.volume, a.face) < std::pair(b.volume, b.face);
    };
    std::sort(floors_.begin(), floors_.end(), by_volume);
    std::sort(ceilings_.begin(), ceilings_.end(), by_volume);
}

std::span<const LevelFace> LevelFaces::of(const std::vector<LevelFace>& faces, std::uint32_t volume) {
    const auto first = std::lower_bound(faces.begin(), faces.end(), volume,
                                        [](const LevelFace& face, std::uint32_t v) { return face.volume < v; });
    auto last = first;
    while (last != faces.end() && last->volume == volume) ++last;
    return {first, last};
}

std::vector<RegionRings> LevelFaces::outlines(std::span<const std::uint32_t> faces) const {
    std::map<BorderSegment, std::uint32_t> owner;  // segment -> place in `faces`
    DisjointSets components(faces.size());
    for (std::uint32_t k = 0; k < faces.size(); ++k) {
        const std::uint32_t first = first_ring_[faces[k]], end = first_ring_[faces[k] + 1];
        for (std::uint32_t r = first; r < end; ++r) {
            const BorderSegment segment{ring_[r], ring_[r + 1 < end ? r + 1 : first]};
            owner.emplace(segment, k);
            if (const auto twin = owner.find({segment.to, segment.from}); twin != owner.end())
                components.join(k, twin->second);
        }
    }
    std::map<std::uint32_t, std::vector<BorderSegment>> borders;
    for (const auto& [segment, k] : owner) borders[components.find(k)].push_back(segment);
    std::vector<RegionRings> result;
    for (auto& [root, border] : borders) result.push_back(trace_rings(std::move(border), points_));
    return result;
}

}  // namespace enfilade::modeler

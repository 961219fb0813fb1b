#include "modeler/exports/plan_faces.h"

#include <algorithm>
#include <map>

#include "base/disjoint_sets.h"

namespace enfilade::modeler {

namespace {

constexpr std::uint32_t no_index = UINT32_MAX;

}  // namespace

PlanFaces::PlanFaces(const Building& building) {
    for (const plans::GridPoint& p : building.points) points_.push_back({p.x, p.y});
    trace(building.edges);
    stack_volumes(building);
}

/// Half-edges around each point by angle; the face on the left of one goes on with the one before its twin.
void PlanFaces::trace(const std::vector<PlanEdge>& edges) {
    const std::size_t n = 2 * edges.size();
    for (const PlanEdge& edge : edges) {
        segments_.push_back({edge.a, edge.b});
        segments_.push_back({edge.b, edge.a});
    }
    std::vector<std::uint32_t> order(n);
    for (std::uint32_t h = 0; h < n; ++h) order[h] = h;
    const auto direction = [&](std::uint32_t h) {
        const auto &a = points_[segments_[h].from], &b = points_[segments_[h].to];
        return std::array{b[0] - a[0], b[1] - a[1]};
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t g, std::uint32_t h) {
        if (segments_[g].from != segments_[h].from) return segments_[g].from < segments_[h].from;
        const auto p = direction(g), q = direction(h);
        const bool p_low = p[1] < 0 || (p[1] == 0 && p[0] < 0), q_low = q[1] < 0 || (q[1] == 0 && q[0] < 0);
        if (p_low != q_low) return q_low;
        return p[0] * q[1] - p[1] * q[0] > 0;
    });
    std::vector<std::uint32_t> before(n);  // clockwise around the point
    for (std::size_t k = 0; k < n;) {
        std::size_t end = k + 1;
        while (end < n && segments_[order[end]].from == segments_[order[k]].from) ++end;
        for (std::size_t i = k; i < end; ++i) before[order[i]] = order[i == k ? end - 1 : i - 1];
        k = end;
    }
    face_of_.assign(n, no_index);
    first_half_.push_back(0);
    for (std::uint32_t h = 0; h < n; ++h) {
        if (face_of_[h] != no_index) continue;
        for (std::uint32_t g = h; face_of_[g] == no_index; g = before[g ^ 1]) {
            face_of_[g] = count_;
            half_edges_.push_back(g);
        }
        first_half_.push_back(std::uint32_t(half_edges_.size()));
        ++count_;
    }
}

void PlanFaces::stack_volumes(const Building& building) {
    std::vector<std::vector<std::uint32_t>> volumes_of(building.pieces.size());
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v)
        if (building.volumes[v].label != Label::Outside) volumes_of[building.volumes[v].piece].push_back(v);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> over;  // face, volume
    std::vector<std::uint32_t> border_of(segments_.size(), no_index), reached(count_, no_index);
    std::vector<std::uint32_t> open;
    for (std::uint32_t p = 0; p < building.pieces.size(); ++p) {
        const Piece& piece = building.pieces[p];
        const auto visit = [&](std::uint32_t face) {
            if (reached[face] == p) return;
            reached[face] = p;
            open.push_back(face);
            for (const std::uint32_t v : volumes_of[p]) over.push_back({face, v});
        };
        for (std::uint32_t c = 0; c < piece.corner_count; ++c)
            border_of[building.corners[piece.first_corner + c].half_edge] = p;
        for (std::uint32_t c = 0; c < piece.corner_count; ++c)
            visit(face_of_[building.corners[piece.first_corner + c].half_edge]);
        while (!open.empty()) {
            const std::uint32_t face = open.back();
            open.pop_back();
            for (std::uint32_t k = first_half_[face]; k < first_half_[face + 1]; ++k)
                if (border_of[half_edges_[k]] != p) visit(face_of_[half_edges_[k] ^ 1]);
        }
    }
    std::sort(over.begin(), over.end(), [&](const auto& a, const auto& b) {
        return a.first != b.first ? a.first < b.first
                                  : building.volumes[a.second].z_low < building.volumes[b.second].z_low;
    });
    first_.assign(count_ + 1, 0);
    for (const auto& [face, volume] : over) {
        ++first_[face + 1];
        volumes_.push_back(volume);
    }
    for (std::size_t f = 1; f < first_.size(); ++f) first_[f] += first_[f - 1];
}

std::vector<RegionRings> PlanFaces::outlines(std::span<const std::uint32_t> faces) const {
    std::map<std::uint32_t, std::uint32_t> place;
    for (std::uint32_t k = 0; k < faces.size(); ++k) place.emplace(faces[k], k);
    DisjointSets components(faces.size());
    const auto for_each_half_edge = [&](auto visit) {
        for (std::uint32_t k = 0; k < faces.size(); ++k)
            for (std::uint32_t i = first_half_[faces[k]]; i < first_half_[faces[k] + 1]; ++i) {
                const auto beyond = place.find(face_of_[half_edges_[i] ^ 1]);
                visit(k, half_edges_[i], beyond == place.end() ? no_index : beyond->second);
            }
    };
    for_each_half_edge([&](std::uint32_t k, std::uint32_t, std::uint32_t beyond) {
        if (beyond != no_index) components.join(k, beyond);
    });
    std::map<std::uint32_t, std::vector<BorderSegment>> borders;
    for_each_half_edge([&](std::uint32_t k, std::uint32_t h, std::uint32_t beyond) {
        if (beyond == no_index) borders[components.find(k)].push_back(segments_[h]);
    });
    std::vector<RegionRings> result;
    for (auto& [root, border] : borders) result.push_back(trace_rings(std::move(border), points_));
    return result;
}

}  // namespace enfilade::modeler

#include "modeler/exports/part_sides.h"

#include <algorithm>
#include <unordered_map>

#include "base/error.h"
#include "modeler/cutting/polygon.h"
#include "modeler/outline.h"

namespace enfilade::modeler {

PartSides::PartSides(const Building& building) : building_(building) {
    first_face_.assign(building.edges.size() + 1, 0);
    for (std::uint32_t f = 0; f < building.faces.size(); ++f) {
        if (building.faces[f].direction != Direction::Side) continue;
        ++first_face_[building.faces[f].edge + 1];
        side_faces_.push_back(f);
    }
    for (std::size_t e = 1; e < first_face_.size(); ++e) first_face_[e] += first_face_[e - 1];
    std::sort(side_faces_.begin(), side_faces_.end(), [&](std::uint32_t a, std::uint32_t b) {
        const Face& p = building.faces[a];
        const Face& q = building.faces[b];
        return std::pair(p.edge, p.z_low) < std::pair(q.edge, q.z_low);
    });
}

SideStrip PartSides::strip(const SpacePart& part, std::uint32_t half_edge) const {
    SideStrip strip{half_edge, {}};
    const std::uint32_t edge = half_edge / 2;
    for (std::uint32_t k = first_face_[edge]; k < first_face_[edge + 1]; ++k) {
        const Face& face = building_.faces[side_faces_[k]];
        const std::uint32_t before = half_edge % 2 == 0 ? face.front : face.back;
        const std::uint32_t behind = half_edge % 2 == 0 ? face.back : face.front;
        if (!std::binary_search(part.volumes.begin(), part.volumes.end(), before)) continue;
        strip.intervals.push_back({face.z_low, face.z_high, behind});
    }
    std::int32_t z = part.z_low;
    for (const SideInterval& interval : strip.intervals)
        if (std::exchange(z, interval.z_high) != interval.z_low) z = part.z_high + 1;
    if (z != part.z_high)
        throw InputError("F22", "",
                         "The model cannot be exported: a side of one of its spaces has gaps. Check the plan and mend "
                         "what is reported first.");
    return strip;
}

std::vector<RingSides> PartSides::of(const SpacePart& part) const {
    std::unordered_map<std::uint32_t, std::uint32_t> line_of;
    for (const std::uint32_t v : part.volumes) {
        const Piece& piece = building_.pieces[building_.volumes[v].piece];
        for (std::uint32_t c = 0; c < piece.corner_count; ++c) {
            const Corner& corner = building_.corners[piece.first_corner + c];
            line_of[corner.half_edge] = corner.line;
        }
    }
    std::vector<RingSides> result;
    const auto add = [&](const HalfEdgeRing& ring) {
        const std::size_t n = ring.size();
        const auto goes_on = [&](std::size_t k) {  // from half-edge k - 1 to k
            const std::uint32_t in = ring[(k + n - 1) % n];
            const std::uint32_t out = ring[k % n];
            const auto point = [&](std::uint32_t h) { return building_.points[start_of(building_, h)]; };
            return goes_straight(point(in), point(out), point(out ^ 1), line_of[in], line_of[out]);
        };
        std::size_t first = 0;
        while (first < n && goes_on(first)) ++first;
        if (first == n) first = 0;
        RingSides sides;
        for (std::size_t k = first; k < first + n; ++k) {
            if (k == first || !goes_on(k)) sides.sides.emplace_back();
            sides.sides.back().strips.push_back(strip(part, ring[k % n]));
        }
        result.push_back(std::move(sides));
    };
    add(part.outer);
    for (const HalfEdgeRing& hole : part.holes) add(hole);
    return result;
}

}  // namespace enfilade::modeler

// G8: cells are convex, and pieces sum to their parent.

#include <algorithm>
#include <cmath>

#include "modeler/constraints/constraints.h"
#include "modeler/cutting/polygon.h"
#include "modeler/map_geometry.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

using Ring = std::vector<RingCorner>;

Ring ring_of(const Building& building, const Piece& piece) {
    Ring ring;
    for (std::uint32_t k = 0; k < piece.corner_count; ++k) {
        const Corner& corner = building.corners[piece.first_corner + k];
        ring.push_back({building.points[corner.vertex], corner.line});
    }
    return ring;
}

std::int64_t area2(const Ring& ring) {
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < ring.size(); ++k)
        sum += orientation(ring[0].point, ring[k].point, ring[(k + 1) % ring.size()].point);
    return sum;
}

/// Largest distance, in grid units, of a corner from the chord of the run of sides of one line on which it lies.
double stray(const Ring& ring) {
    const std::size_t n = ring.size();
    const auto at = [&](std::size_t k) -> const RingCorner& { return ring[k % n]; };
    const auto is_straight = [&](std::size_t k) {
        return goes_straight(at(k + n - 1).point, at(k).point, at(k + 1).point, at(k + n - 1).line, at(k).line);
    };
    std::size_t start = 0;
    while (start < n && is_straight(start)) ++start;
    double worst = 0;
    for (std::size_t run = start; run < start + n;) {
        std::size_t end = run + 1;
        while (end < start + n && is_straight(end)) ++end;
        const GridPoint a = at(run).point, b = at(end).point;
        const double length = std::hypot(double(b.x) - a.x, double(b.y) - a.y);
        for (std::size_t k = run + 1; k < end && length > 0; ++k)
            worst = std::max(worst, std::abs(double(orientation(a, b, at(k).point))) / length);
        run = end;
    }
    return worst;
}

void blame_volume(const Building& building, std::uint32_t v, std::string sentence, Blame& blame, CheckReport& report) {
    Finding finding{.code = "G8", .severity = Severity::Error, .sentence = std::move(sentence)};
    finding.hint = "This is a fault of the convexifier or of the grid: try a finer --snap-mm, and report the plan.";
    place_at_volume(building, v, finding);
    blame.volume[v] = true;
    report.findings.push_back(std::move(finding));
}

void check_shapes(const Building& building, Blame& blame, CheckReport& report) {
    std::vector<bool> seen(building.pieces.size(), false), at_fault(building.pieces.size(), false);
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v) {
        const Volume& volume = building.volumes[v];
        // A label that is not its space's is S1's: whether that volume is a cell is not known.
        if (!carries_light(volume.label) || volume.label != building.spaces[volume.space].label) continue;
        if (seen[volume.piece]) continue;
        seen[volume.piece] = true;
        if (blame.volume[v]) {
            ++report.suppressed;
            continue;
        }
        const Ring ring = ring_of(building, building.pieces[volume.piece]);
        if (const auto corner = reflex_corner(ring)) {
            blame_volume(building, v, "A piece of " + title(building.spaces[volume.space]) + " is not convex.", blame,
                         report);
            const GridPoint p = ring[*corner].point;
            report.findings.back().point = {building.frame.world_x(p.x), building.frame.world_y(p.y),
                                            building.frame.world_z(volume.z_low)};
        } else if (!is_convex(ring)) {
            blame_volume(building, v, "A piece of " + title(building.spaces[volume.space]) + " is not convex.", blame,
                         report);
        } else if (const double distance = stray(ring); distance > most_stray) {
            char text[32];
            std::snprintf(text, sizeof text, "%.2f", distance);
            blame_volume(building, v,
                         "A side of " + title(building.spaces[volume.space]) + " strays from its line by " +
                             std::string(text) + " grid units.",
                         blame, report);
        } else {
            continue;
        }
        at_fault[volume.piece] = true;
    }
    // All that stands over a piece has its shape.
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v)
        if (building.volumes[v].piece < at_fault.size() && at_fault[building.volumes[v].piece]) blame.volume[v] = true;
}

/// Pieces of one parent: their areas sum to the area within the parent's outline, and each volume of the map has
/// the measure of its prism.
void check_sums(const Building& building, Blame& blame, CheckReport& report) {
    const auto volumes = volumes6(building.map, building.vertices);
    std::vector<std::uint32_t> parent_of_half_edge(2 * building.edges.size(), UINT32_MAX);
    std::uint32_t parents = 0;
    for (const Volume& volume : building.volumes) parents = std::max(parents, volume.parent + 1);
    std::vector<std::vector<std::uint32_t>> members(parents);
    for (std::uint32_t v = 0; v + 1 < building.volumes.size(); ++v) members[building.volumes[v].parent].push_back(v);
    for (std::uint32_t parent = 0; parent < parents; ++parent) {
        std::int64_t pieces = 0, outline = 0;
        for (const std::uint32_t v : members[parent]) {
            const Piece& piece = building.pieces[building.volumes[v].piece];
            for (std::uint32_t k = 0; k < piece.corner_count; ++k)
                parent_of_half_edge[building.corners[piece.first_corner + k].half_edge] = parent;
        }
        for (const std::uint32_t v : members[parent]) {
            const Volume& volume = building.volumes[v];
            const Piece& piece = building.pieces[volume.piece];
            const std::int64_t area = area2(ring_of(building, piece));
            pieces += area;
            for (std::uint32_t k = 0; k < piece.corner_count; ++k) {
                const std::uint32_t h = building.corners[piece.first_corner + k].half_edge;
                if (parent_of_half_edge[h ^ 1] == parent) continue;
                const GridPoint a = building.points[building.corners[piece.first_corner + k].vertex];
                const GridPoint b =
                    building.points[building.corners[piece.first_corner + (k + 1) % piece.corner_count].vertex];
                outline += std::int64_t(a.x) * b.y - std::int64_t(a.y) * b.x;
            }
            if (volumes && !blame.volume[v] &&
                (*volumes)[v] != Int128(3) * area * (Int128(volume.z_high) - volume.z_low))
                blame_volume(building, v,
                             "A piece of " + title(building.spaces[volume.space]) +
                                 " measures otherwise in the map than in the plan.",
                             blame, report);
        }
        for (const std::uint32_t v : members[parent]) {
            const Piece& piece = building.pieces[building.volumes[v].piece];
            for (std::uint32_t k = 0; k < piece.corner_count; ++k)
                parent_of_half_edge[building.corners[piece.first_corner + k].half_edge] = UINT32_MAX;
        }
        if (pieces != outline && !members[parent].empty()) {
            const std::uint32_t v = members[parent].front();
            if (std::any_of(members[parent].begin(), members[parent].end(),
                            [&](std::uint32_t member) { return blame.volume[member]; }))
                ++report.suppressed;
            else
                blame_volume(
                    building, v,
                    "The pieces of " + title(building.spaces[building.volumes[v].space]) + " do not sum to it.", blame,
                    report);
        }
    }
}

}  // namespace

void check_convexity(const Building& building, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("G8");
    check_shapes(building, blame, report);
    // Volumes of a map whose links are broken (T1-T7) cannot be measured.
    const bool is_broken = std::any_of(report.findings.begin(), report.findings.end(), [](const Finding& finding) {
        return finding.code[0] == 'T' && finding.code != "T8";
    });
    if (blame.whole_map || is_broken) ++report.suppressed;
    else check_sums(building, blame, report);
}

}  // namespace enfilade::modeler

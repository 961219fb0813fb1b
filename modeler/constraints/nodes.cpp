// D1: the node that stands for a cell lies inside it.

#include <algorithm>
#include <cmath>

#include "modeler/cell_node.h"
#include "modeler/constraints/constraints.h"
#include "modeler/constraints/map_faces.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

using Int128 = __int128;

/// Nodes are compared with the map's integer points in this share of a grid unit, exactly.
constexpr int fine_bits = 20;
constexpr double fine = double(1 << fine_bits);

/// A cell may be thinner than a node can be told from its sides in doubles: a node this far outside is on the border.
constexpr double margin = 0.001;  // grid units

struct FinePoint {
    std::int64_t x, y, z;
};

std::int64_t to_fine(std::int32_t grid) { return std::int64_t(grid) << fine_bits; }

FinePoint fine_point(const plans::GridFrame& frame, const std::array<double, 3>& world) {
    const auto round = [&](double w, double origin) { return std::llround((w - origin) / frame.unit * fine); };
    return {round(world[0], frame.origin_x), round(world[1], frame.origin_y), round(world[2], frame.origin_z)};
}

/// Whether the ray from the point in the direction of x leaves the volume once more than it enters it.
bool is_inside(const MapFaces& faces, std::uint32_t volume, const FinePoint& at) {
    bool inside = false;
    for (const std::uint32_t f : faces.of_volume(volume)) {
        const MapFace& face = faces[f];
        if (!face.upright() || at.z < to_fine(face.z_low) || at.z >= to_fine(face.z_high)) continue;
        std::int64_t ax = to_fine(face.feet[0].x), ay = to_fine(face.feet[0].y);
        std::int64_t bx = to_fine(face.feet[1].x), by = to_fine(face.feet[1].y);
        if ((ay > at.y) == (by > at.y)) continue;
        if (ay > by) std::swap(ax, bx), std::swap(ay, by);
        // Left of the upward edge: the ray crosses it.
        if (Int128(bx - ax) * (at.y - ay) - Int128(by - ay) * (at.x - ax) > 0) inside = !inside;
    }
    return inside;
}

/// Distance to the nearest side, in grid units, for the few nodes that are not inside.
double distance_to_sides(const MapFaces& faces, std::uint32_t volume, const FinePoint& at) {
    double nearest = HUGE_VAL;
    const double x = double(at.x) / fine, y = double(at.y) / fine, z = double(at.z) / fine;
    for (const std::uint32_t f : faces.of_volume(volume)) {
        const MapFace& face = faces[f];
        if (!face.upright()) continue;
        const double dx = double(face.feet[1].x) - face.feet[0].x, dy = double(face.feet[1].y) - face.feet[0].y;
        const double px = x - face.feet[0].x, py = y - face.feet[0].y;
        const double t = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        const double up = std::max({face.z_low - z, z - face.z_high, 0.0});
        nearest = std::min(nearest, std::hypot(px - t * dx, py - t * dy, up));
    }
    return nearest;
}

}  // namespace

void check_nodes(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("D1");
    if (blame.whole_map) {
        ++report.suppressed;
        return;
    }
    const Building& building = subject.building;
    const MapFaces& faces = subject.faces;
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v) {
        if (!carries_light(building.volumes[v].label) || !faces.is_prism(v)) continue;
        const FinePoint node = fine_point(building.frame, cell_node(building, v));
        if (is_inside(faces, v, node) || distance_to_sides(faces, v, node) <= margin) continue;
        if (blame.volume[v]) {
            ++report.suppressed;
            continue;
        }
        Finding finding{.code = "D1", .severity = Severity::Error};
        finding.sentence =
            "The node of " + title(building.spaces[building.volumes[v].space]) + " lies outside its cell.";
        finding.hint = "Graphs made of this model would lead through walls here: report the plan.";
        for (const std::uint32_t f : faces.of_volume(v))
            if (faces[f].level() && !finding.point) finding.point = middle(building, faces[f]);
        place_at_volume(building, v, finding);
        blame.volume[v] = true;
        report.findings.push_back(std::move(finding));
    }
}

}  // namespace enfilade::modeler

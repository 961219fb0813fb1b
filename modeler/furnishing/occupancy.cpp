#include "modeler/furnishing/occupancy.h"

#include <algorithm>
#include <cmath>

#include "modeler/editing/footprint.h"
#include "modeler/furnishing/walkways.h"

namespace enfilade::modeler {

using plans::Point;

Point Pose::along() const { return {std::cos(angle), std::sin(angle)}; }
Point Pose::front() const { return {std::sin(angle), -std::cos(angle)}; }

bool is_obstacle(const RoomShape& room, std::int32_t z_low, std::int32_t z_high) {
    const double unit = room.frame.unit;
    return (z_low - room.z_floor) * unit < overhead && (z_high - room.z_floor) * unit > flat;
}

Body Occupancy::body(const CatalogueEntry& entry, const Pose& pose, double elevation) const {
    return body(entry, pose, elevation, entry.width, entry.depth);
}

Body Occupancy::body(const CatalogueEntry& entry, const Pose& pose, double elevation, double width,
                     double depth) const {
    const plans::GridFrame& frame = room_.frame;
    Body result;
    // Whole grid units: the same sums in the frame of the plan, wherever that lies.
    result.pose = {{std::floor(pose.at.x + 0.5), std::floor(pose.at.y + 0.5)}, pose.angle};
    result.width = width / frame.unit;
    result.depth = depth / frame.unit;
    result.height = entry.height / frame.unit;
    result.metres_wide = width;
    result.metres_deep = depth;
    result.metres_high = entry.height;
    result.ring = rectangle_footprint(frame, frame.origin_x + frame.unit * result.pose.at.x,
                                      frame.origin_y + frame.unit * result.pose.at.y, width, depth, pose.angle);
    result.box = box_around(result.ring);
    result.z_low = room_.z_floor + std::int32_t(std::ceil(elevation - 1e-6));
    result.z_high = std::int32_t(std::ceil(result.z_low + result.height - 1e-6));
    result.kind = entry.kind;
    result.entry = &entry;
    return result;
}

Ring Occupancy::around(const Body& body, double front, double behind, double left, double right) const {
    const Point along = body.pose.along(), look = body.pose.front();
    // Measured from the box, so that the floor begins where the piece ends; a millimetre less all around.
    const double slack = 0.001 / room_.frame.unit;
    const auto corner = [&](double u, double v) {
        const Point p = body.pose.at + along * u - look * v;
        return plans::GridPoint{std::int32_t(std::floor(p.x + 0.5)), std::int32_t(std::floor(p.y + 0.5))};
    };
    const double u0 = -body.width / 2 - left + slack, u1 = body.width / 2 + right - slack;
    const double v0 = -body.depth / 2 - front + slack, v1 = body.depth / 2 + behind - slack;
    return {corner(u0, v0), corner(u1, v0), corner(u1, v1), corner(u0, v1)};
}

bool Occupancy::blocks_opening(const Body& body) const {
    const double unit = room_.frame.unit;
    for (const RoomOpening& gate : room_.gates) {
        // From the leaf's lower edge to its upper one; what lies flat may be passed over.
        if (body.z_low >= gate.z_high || (body.z_high - room_.z_floor) * unit <= flat) continue;
        if (box_around(gate.keep_free).meets(body.box) && overlap(gate.keep_free, body.ring)) return true;
    }
    if (body.carrier != UINT32_MAX) return false;
    for (const RoomOpening& window : room_.windows) {
        if (body.z_high <= window.z_low || body.z_low >= window.z_high) continue;
        if (box_around(window.keep_free).meets(body.box) && overlap(window.keep_free, body.ring)) return true;
    }
    return false;
}

bool Occupancy::is_possible(const Body& body) const {
    if (body.z_low < room_.z_floor || body.z_high > room_.z_ceiling) return false;
    for (std::uint32_t k = 0; k < bodies_.size(); ++k) {
        const Body& other = bodies_[k];
        if (k == body.carrier || body.z_low >= other.z_high || other.z_low >= body.z_high) continue;
        if (other.box.meets(body.box) && overlap(other.ring, body.ring)) return false;
    }
    if (!body.hangs && body.carrier == UINT32_MAX)
        for (const FreeFloor& floor : free_)
            if (floor.group != body.group && floor.box.meets(body.box) && overlap(floor.ring, body.ring) &&
                is_obstacle(room_, body.z_low, body.z_high))
                return false;
    return !blocks_opening(body) && room_.floor.holds(body.ring);
}

bool Occupancy::is_free(const Ring& ring, std::uint32_t group) const {
    const GridBox box = box_around(ring);
    for (const Body& body : bodies_)
        if (body.group != group && body.box.meets(box) && is_obstacle(room_, body.z_low, body.z_high) &&
            overlap(body.ring, ring))
            return false;
    return room_.floor.holds(ring);
}

std::uint32_t Occupancy::add(Body body) {
    bodies_.push_back(std::move(body));
    return std::uint32_t(bodies_.size() - 1);
}

void Occupancy::add_free(Ring ring, std::uint32_t group) {
    const GridBox box = box_around(ring);
    free_.push_back({std::move(ring), box, group});
}

void Occupancy::undo(Mark mark) {
    bodies_.erase(bodies_.begin() + std::ptrdiff_t(mark.bodies), bodies_.end());
    free_.erase(free_.begin() + std::ptrdiff_t(mark.free), free_.end());
}

}  // namespace enfilade::modeler

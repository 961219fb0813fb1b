#pragma once
// What the tests of edits ask of a building.

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gmap/isomorphism.h"
#include "modeler/building.h"
#include "modeler/check.h"
#include "modeler/editing/box.h"

namespace enfilade::testing {

/// The space with this id, or name.
inline std::uint32_t space_called(const modeler::Building& building, const std::string& id) {
    for (std::uint32_t s = 0; s < building.spaces.size(); ++s)
        if (building.spaces[s].id == id || building.spaces[s].name == id) return s;
    return UINT32_MAX;
}

inline std::vector<std::uint32_t> spaces_labelled(const modeler::Building& building, accel::Label label) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t s = 0; s < building.spaces.size(); ++s)
        if (building.spaces[s].label == label) found.push_back(s);
    return found;
}

/// The rooms that have volumes, ascending.
inline std::vector<std::uint32_t> rooms_of(const modeler::Building& building) {
    std::vector<std::uint32_t> rooms;
    for (const modeler::Volume& volume : building.volumes)
        if (volume.label == accel::Label::Room) rooms.push_back(volume.space);
    std::sort(rooms.begin(), rooms.end());
    rooms.erase(std::unique(rooms.begin(), rooms.end()), rooms.end());
    return rooms;
}

/// Corners of a volume's floor.
inline std::vector<plans::GridPoint> floor_of(const modeler::Building& building, const modeler::Volume& volume) {
    std::vector<plans::GridPoint> ring;
    const modeler::Piece& piece = building.pieces[volume.piece];
    for (std::uint32_t k = 0; k < piece.corner_count; ++k)
        ring.push_back(building.points[building.corners[piece.first_corner + k].vertex]);
    return ring;
}

inline std::int64_t doubled_area(const std::vector<plans::GridPoint>& ring) {
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const plans::GridPoint a = ring[k], b = ring[(k + 1) % ring.size()];
        sum += std::int64_t(a.x) * b.y - std::int64_t(a.y) * b.x;
    }
    return sum;
}

/// Twice the volume, in grid units cubed, of the spaces that `wanted` accepts. 128 bits hold any building.
inline __int128 doubled_volume(const modeler::Building& building, const std::function<bool(std::uint32_t)>& wanted) {
    __int128 sum = 0;
    for (const modeler::Volume& volume : building.volumes)
        if (volume.label != accel::Label::Outside && wanted(volume.space))
            sum += __int128(doubled_area(floor_of(building, volume))) * (volume.z_high - volume.z_low);
    return sum;
}
inline __int128 doubled_volume(const modeler::Building& building, std::uint32_t space) {
    return doubled_volume(building, [&](std::uint32_t s) { return s == space; });
}

/// Corner of a dart, its volume's space and label: maps that agree in them are one model. Reckoned once.
inline gmap::DartLabel dart_labels(const modeler::Building& building) {
    const auto& ids = building.map.arrays().cell_id;
    std::vector<std::uint64_t> spaces;
    for (const modeler::Space& space : building.spaces) spaces.push_back(std::hash<std::string>{}(space.id));
    const auto labels = std::make_shared<std::vector<std::uint64_t>>(ids[3].size());
    for (std::size_t d = 0; d < labels->size(); ++d) {
        if (ids[3][d] >= building.volumes.size()) continue;  // a gap
        const modeler::Volume& volume = building.volumes[ids[3][d]];
        const std::array<std::int32_t, 3> at = building.vertices[ids[0][d]];
        std::uint64_t hash = spaces[volume.space];
        for (const std::uint64_t word : {std::uint64_t(volume.label), std::uint64_t(std::uint32_t(at[0])),
                                         std::uint64_t(std::uint32_t(at[1])), std::uint64_t(std::uint32_t(at[2]))})
            hash = (hash ^ word) * 0x9e3779b97f4a7c15u + (hash >> 31);
        (*labels)[d] = hash;
    }
    return [labels](gmap::DartId dart) { return (*labels)[std::size_t(index(dart))]; };
}

/// Empty where the two are one model: the maps isomorphic with the same corners, spaces and labels, the same counts.
inline std::string difference(const modeler::Building& a, const modeler::Building& b) {
    if (a.volumes.size() != b.volumes.size()) return "volumes";
    if (a.faces.size() != b.faces.size()) return "faces";
    if (a.vertices.size() != b.vertices.size()) return "vertices";
    if (a.pieces.size() != b.pieces.size()) return "pieces";
    if (a.spaces.size() != b.spaces.size()) return "spaces";
    if (!gmap::is_isomorphic(a.map, b.map, dart_labels(a), dart_labels(b))) return "map";
    return "";
}

/// Errors of the model, but for boxes before doors: who puts them in knows where doors are.
inline std::string errors_of(const modeler::Building& building) {
    std::string text;
    for (const Finding& finding : modeler::check(building).findings) {
        const bool is_door = std::any_of(finding.elements.begin(), finding.elements.end(),
                                         [](const ElementRef& element) { return element.kind == "door"; });
        if (finding.severity == Severity::Error && !(finding.code == "S6" && is_door))
            text += finding.code + ": " + finding.sentence + "\n";
    }
    return text;
}

/// A box from (x0, y0) to (x1, y1) in metres of the plan, between heights above the floor of the room's storey.
inline modeler::Box box(const modeler::Building& building, std::uint32_t room, std::string id, std::array<double, 4> at,
                        double low, double high) {
    modeler::Box result;
    result.space = room;
    result.id = result.name = std::move(id);
    const plans::GridFrame& frame = building.frame;
    result.footprint = {frame.grid(at[0], at[1]), frame.grid(at[2], at[1]), frame.grid(at[2], at[3]),
                        frame.grid(at[0], at[3])};
    const std::uint32_t storey = building.spaces[room].storey;
    const std::int32_t floor = storey < building.storeys.size() ? building.storeys[storey].z_floor : frame.grid_z(0);
    result.z_low = floor + std::int32_t(low / frame.unit);
    result.z_high = floor + std::int32_t(high / frame.unit);
    return result;
}

}  // namespace enfilade::testing

#include "modeler/face_label.h"

#include <algorithm>

namespace enfilade::modeler {

namespace {

Surface exterior_surface(Label behind, Looking looking) {
    if (behind == Label::Outside) return Surface::Sky;
    if (behind == Label::Ground) return Surface::Terrain;
    return looking == Looking::Down ? Surface::Roof : Surface::Facade;
}

}  // namespace

Surface surface(Label viewer, Label behind, Looking looking) {
    if (viewer == Label::Exterior) return exterior_surface(behind, looking);
    if (behind == Label::Outside) return Surface::Sky;
    const bool is_hole = viewer == Label::Door || viewer == Label::Window || viewer == Label::Opening;
    switch (looking) {
        case Looking::Sideways: return is_hole ? Surface::Jamb : Surface::WallPaper;
        case Looking::Up: return is_hole && behind == Label::Wall ? Surface::Lintel : Surface::Ceiling;
        case Looking::Down: return is_hole && behind == Label::Wall ? Surface::Sill : Surface::Floor;
    }
    return Surface::WallPaper;
}

std::uint32_t place_of(const Building& building, std::uint32_t space) {
    const Space& own = building.spaces[space];
    return own.label == Label::Object && own.room < building.spaces.size() ? own.room : space;
}

OpeningFaces::OpeningFaces(const Building& building) : towards_(building.spaces.size(), UINT32_MAX) {
    // The lower rank wins, then the lower space.
    const auto rank = [](Label opening, Label beside) {
        const Label wanted = opening == Label::Window ? Label::Exterior : Label::Room;
        return beside == wanted ? 0 : 1;
    };
    const auto consider = [&](const Volume& opening, const Volume& beside) {
        const bool has_face =
            opening.label == Label::Window || (opening.label == Label::Door && building.spaces[opening.space].closed);
        if (!has_face || !carries_light(beside.label) || beside.space == opening.space) return;
        const std::uint32_t place = place_of(building, beside.space);
        std::uint32_t& best = towards_[opening.space];
        const auto key = [&](std::uint32_t space) {
            return std::pair(rank(opening.label, building.spaces[space].label), space);
        };
        if (best == UINT32_MAX || key(place) < key(best)) best = place;
    };
    for (const Face& face : building.faces) {
        if (face.direction != Direction::Side) continue;
        consider(building.volumes[face.front], building.volumes[face.back]);
        consider(building.volumes[face.back], building.volumes[face.front]);
    }
}

FaceKind face_kind(const Building& building, const OpeningFaces& openings, const Face& face) {
    const Volume& front = building.volumes[face.front];
    const Volume& back = building.volumes[face.back];
    if (!carries_light(front.label) || !carries_light(back.label)) return {};
    if (front.space == back.space || (front.label == Label::Room && back.label == Label::Room))
        return {.is_portal = true, .portal = PortalKind::Virtual};
    for (const auto& [opening, beside] : {std::pair(&front, &back), std::pair(&back, &front)}) {
        if (face.direction != Direction::Side) continue;
        if (openings.closed_towards(opening->space) != place_of(building, beside->space)) continue;
        if (opening->label == Label::Door) return {.forced = Surface::Leaf};
        if (building.opaque_glass) return {.forced = Surface::Pane};
        return {.is_portal = true, .portal = PortalKind::Glass};
    }
    return {.is_portal = true, .portal = PortalKind::Clear};
}

}  // namespace enfilade::modeler

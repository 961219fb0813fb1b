#pragma once
// What a face is, from the labels of its two volumes and its direction (2-model, "Labels").

#include <cstdint>
#include <optional>
#include <vector>

#include "accel/label.h"
#include "modeler/building.h"

namespace enfilade::modeler {

using accel::PortalKind;
using accel::Surface;

/// The way a face looks from the volume that sees it.
enum class Looking : std::uint8_t { Sideways, Down, Up };

/// What a solid face shows to a viewer's volume with what is behind it. Pure: the labels and the direction decide.
[[nodiscard]] Surface surface(Label viewer, Label behind, Looking looking);

/// The space as light takes it: of an object's volume the room, or the exterior, in which it stands. What is seen
/// through the volume looks as if it was not there.
[[nodiscard]] std::uint32_t place_of(const Building& building, std::uint32_t space);

/// Where a window has its pane and a shut door its leaf: towards which space. Windows: the exterior, else the first
/// space beside them; doors: the first room, else the first space beside them ("exactly one glass portal, the outer
/// face"; "closed makes the inner face a solid leaf").
class OpeningFaces {
public:
    explicit OpeningFaces(const Building& building);
    /// The space towards which the pane or leaf of a window or shut door stands; UINT32_MAX for other spaces.
    [[nodiscard]] std::uint32_t closed_towards(std::uint32_t space) const { return towards_[space]; }

private:
    std::vector<std::uint32_t> towards_;  ///< [space]
};

/// A face of the map as light meets it.
struct FaceKind {
    bool is_portal = false;
    PortalKind portal = PortalKind::Clear;  ///< of portals
    std::optional<Surface> forced;          ///< of solid faces between two volumes that carry light: leaf or pane
};

/// Faces between two volumes that carry light are portals, but for the leaves of shut doors (and panes where the
/// building has opaque glass).
[[nodiscard]] FaceKind face_kind(const Building& building, const OpeningFaces& openings, const Face& face);

}  // namespace enfilade::modeler

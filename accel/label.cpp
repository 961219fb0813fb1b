#include "accel/label.h"

namespace enfilade::accel {

const char* name_of(Label label) {
    switch (label) {
        case Label::Room: return "room";
        case Label::Wall: return "wall";
        case Label::Slab: return "slab";
        case Label::Door: return "door";
        case Label::Window: return "window";
        case Label::Opening: return "opening";
        case Label::Stair: return "stair";
        case Label::Shaft: return "shaft";
        case Label::Object: return "object";
        case Label::Exterior: return "exterior";
        case Label::Ground: return "ground";
        case Label::Outside: return "outside";
    }
    return "unknown";
}

const char* name_of(PortalKind kind) {
    switch (kind) {
        case PortalKind::Clear: return "clear";
        case PortalKind::Virtual: return "virtual";
        case PortalKind::Glass: return "glass";
    }
    return "unknown";
}

const char* name_of(Surface surface) {
    switch (surface) {
        case Surface::WallPaper: return "wall paper";
        case Surface::Floor: return "floor";
        case Surface::Ceiling: return "ceiling";
        case Surface::Facade: return "facade";
        case Surface::Jamb: return "jamb";
        case Surface::Sill: return "sill";
        case Surface::Lintel: return "lintel";
        case Surface::Leaf: return "leaf";
        case Surface::Pane: return "pane";
        case Surface::Terrain: return "terrain";
        case Surface::Roof: return "roof";
        case Surface::Sky: return "sky";
    }
    return "unknown";
}

}  // namespace enfilade::accel

#pragma once
// What a volume is, and what a face shows (2-model, "Labels").

#include <cstdint>

namespace enfilade::accel {

enum class Label : std::uint8_t {
    Room,
    Wall,
    Slab,
    Door,
    Window,
    Opening,
    Stair,
    Shaft,
    Object,
    Exterior,
    Ground,
    Outside
};
inline constexpr int label_count = 12;

/// Volumes that light crosses: they become the cells of a scene.
[[nodiscard]] constexpr bool carries_light(Label label) {
    switch (label) {
        case Label::Room:
        case Label::Door:
        case Label::Window:
        case Label::Opening:
        case Label::Stair:
        case Label::Shaft:
        case Label::Object:
        case Label::Exterior: return true;
        default: return false;
    }
}

/// A face between two cells.
enum class PortalKind : std::uint8_t { Clear, Virtual, Glass };

/// A face where light stops, seen from the cell in front of it.
enum class Surface : std::uint8_t {
    WallPaper,
    Floor,
    Ceiling,
    Facade,
    Jamb,
    Sill,
    Lintel,
    Leaf,
    Pane,
    Terrain,
    Roof,
    Sky
};
inline constexpr int surface_count = 12;

[[nodiscard]] const char* name_of(Label label);
[[nodiscard]] const char* name_of(PortalKind kind);
[[nodiscard]] const char* name_of(Surface surface);

}  // namespace enfilade::accel

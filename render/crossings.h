#pragma once
// Everything that rays pass, walls included: what radio, sound and heat ask for.

#include <cstdint>
#include <span>
#include <vector>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/trace_rays.h"
#include "render/walk_events.h"

namespace enfilade::render {

class Solids;

/// What lies between two stretches of a ray.
enum class Border : std::uint8_t {
    Clear,    ///< a portal: a doorway, a hole
    Virtual,  ///< a portal that only cuts a room in two
    Glass,    ///< a portal with a pane in it
    Face,     ///< the face of a solid: face_in, face_out say which
    Inside,   ///< from one solid into the next, without a face that light sees
    End       ///< the ray's own begin or end
};

inline constexpr std::uint8_t no_surface = 255;

/// A stretch of a ray through one cell or one solid. What is not known or not there is `none`, 2^32 - 1.
struct Passage {
    double enter;                           ///< metres from the origin
    double leave;                           ///< not before `enter`; infinity where nothing says how far a solid reaches
    accel::CellId cell;                     ///< none: a solid
    accel::SpaceId space;                   ///< the room, door, window... or, where solids are known, the wall or slab
    accel::SourceFaceId face_in, face_out;  ///< the solid's faces towards light at both ends, where there are any
    accel::MaterialId material_in, material_out;  ///< of these faces
    accel::Label label;                           ///< of the cell or of the solid; Outside: beyond the site
    Border entered, left;
    std::uint8_t surface_in, surface_out;  ///< accel::Surface of these faces, or no_surface
    std::array<std::uint8_t, 3> reserved;

    [[nodiscard]] double length() const { return leave - enter; }
    [[nodiscard]] bool is_solid() const { return cell == none<accel::CellId>; }
};
static_assert(sizeof(Passage) == 48);

/// How a ray's passages end.
enum class PassagesEnd : std::uint8_t {
    Reached,  ///< at the ray's maximal distance, inside the site
    Left,     ///< beyond the site
    Buried,   ///< in a solid behind which no cell follows
    Refused,  ///< it was no ray: no passages
    Leak      ///< a walk did not end: a defect
};

/// The passages of ray i are [offsets[i], offsets[i + 1]). They cover the ray without gap or overlap from 0 to its
/// maximal distance; without one, to where it leaves the site.
struct PassageTable {
    std::vector<std::uint64_t> offsets;  ///< [ray_count + 1]
    std::vector<Passage> passages;
    std::vector<PassagesEnd> ends;  ///< [ray_count]
};

struct CrossingOptions {
    /// What solids are called and where one ends and the next begins; nullptr: the faces that light sees at both ends
    /// of a gap between two cells say what it probably is, and it is one passage.
    const Solids* solids = nullptr;
    const accel::Executor* executor = nullptr;  ///< nullptr: the calling thread. Results do not depend on it.
    RayStats* stats = nullptr;                  ///< where given, what happened to the walks is added
};

/// Walks each ray through cells and solids alike, in double. A ray whose `cell` is none starts in a solid, or beyond
/// the site. The reversed segment passes the same things in reverse.
/// Cost: a walk a cell, and a search through the locator's boxes a ray that meets a solid.
[[nodiscard]] PassageTable all_crossings(const accel::SceneView& scene, std::span<const RayQuery> rays,
                                         const CrossingOptions& options = {});

/// Where a ray that starts in no cell first enters one.
struct FirstEntry {
    accel::CellId cell;
    double distance;   ///< metres; at least 0
    double depth;      ///< metres of the origin behind the face by which it enters: 0 on it
    bool through_sky;  ///< from beyond the site
};

/// False (and nothing written) where it enters none, and for what is no ray.
[[nodiscard]] bool first_entry(const accel::SceneView& scene, Vec3d origin, Vec3d direction, FirstEntry& entry);

}  // namespace enfilade::render

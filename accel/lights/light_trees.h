#pragma once
// Which lamps each cell may see (PVS), and by which ways their light comes there (light trees): Maria, Horna, Aveneau
// 2013, section 5.2; README.md of this folder.

#include <cstdint>
#include <optional>
#include <vector>

#include "accel/parallel_for.h"
#include "accel/scene.h"

namespace enfilade::accel {

/// A plane through a lamp. A place p lies on its inner side where normal . (p - lamp) >= 0; of any length but 0.
struct BeamPlane {
    float x, y, z;
};

/// A node of a light tree: one way of a lamp's light into a cell, through the portals that it has crossed.
struct LightBeam {
    std::uint32_t first_plane;       ///< of those that bound it in its cell; beams may share them
    std::uint32_t parent;            ///< the beam that it continues; its own number at the lamp
    CellId cell;                     ///< to which it gets
    std::uint32_t tint : 22;         ///< into `tints`: what the glass on its way lets pass; 0: all
    std::uint32_t plane_count : 10;  ///< often 0: all of the cell sees the lamp
};

inline constexpr std::uint32_t no_beam = 0xffffffffu;

/// A lamp that a cell may see. Light that comes into the cell by several ways has several.
struct CellLight {
    LightId light;
    std::uint32_t beam;  ///< no_beam: the lamp has no tree, whether it is seen takes a walk
};

/// Where a beam's objects are in `beam_objects`.
struct BeamObjects {
    std::uint32_t first;
    std::uint32_t count : 31;
    std::uint32_t must_walk : 1;
};

/// The planes of one beam: a place is held where it lies on the inner side of all.
struct PlanesOfBeam {
    const BeamPlane* first;
    std::uint32_t count;
    ENFILADE_HD const BeamPlane* begin() const { return first; }
    ENFILADE_HD const BeamPlane* end() const { return first + count; }
};

/// The objects that can stand in a beam, ascending; never the lamp's carrier. A place that the beam holds sees the lamp
/// if none of them meets the way to it. must_walk: one of them reaches into a cell of the way in which it is not seen
/// (it pokes through a wall): where one meets, a walk decides whether that is in sight.
struct ObjectsOfBeam {
    const ObjectId* first;
    std::uint32_t count;
    bool must_walk;
    ENFILADE_HD const ObjectId* begin() const { return first; }
    ENFILADE_HD const ObjectId* end() const { return first + count; }
};

/// Everything that a tracer asks, as plain pointers, for host and device. A place in cell c sees lamp l if one of c's
/// beams of l holds it: if it lies on the inner side of all of that beam's planes (and nothing stands between: objects
/// are asked in the cells of the beam and its parents). No two beams of one lamp share more than a border in a cell.
struct LightTreesView {
    ArrayView<std::uint32_t> cell_offsets;  ///< [cell_count + 1] into `cell_lights`
    ArrayView<CellLight> cell_lights;       ///< of each cell, by ascending light, then beam
    ArrayView<LightBeam> beams;
    ArrayView<BeamPlane> planes;
    ArrayView<Vertex> tints;  ///< linear RGB; the first one is (1, 1, 1)
    // Of furnished scenes, where asked for; else empty.
    ArrayView<BeamObjects> beam_object_lists;  ///< [beam_count]
    ArrayView<ObjectId> beam_objects;

    ENFILADE_HD PlanesOfBeam planes_of(std::uint32_t beam) const {
        const LightBeam& of = beams[beam];
        return {planes.first + of.first_plane, of.plane_count};
    }
    /// What can stand between the beam's lamp and a place that the beam holds. \pre beam_object_lists is not empty
    ENFILADE_HD ObjectsOfBeam objects_of(std::uint32_t beam) const {
        const BeamObjects& of = beam_object_lists[beam];
        return {beam_objects.first + of.first, of.count, of.must_walk != 0};
    }
};

static_assert(sizeof(LightBeam) == 16 && sizeof(CellLight) == 8 && sizeof(BeamPlane) == 12);
static_assert(sizeof(BeamObjects) == 8);

struct LightTreeOptions {
    bool trees = true;  ///< false: which lamps a cell may see, and no more
    bool through_glass = true;
    bool objects = true;  ///< which objects can stand in each beam; nothing where the scene has none
    /// Grid units by which light may miss a portal's edge and still be followed; nothing: what a walk in float may.
    std::optional<std::int64_t> margin = std::nullopt;
    /// Lamps with a radius are balls: cells list them where any of the ball is seen, and they have no tree.
    bool balls = false;
    /// Lamps whose light takes more ways than this have no tree.
    std::uint32_t most_beams = 1u << 16;
    /// The same for all lamps together, shared out evenly: it bounds the memory, at about 60 B a beam.
    std::uint32_t most_beams_in_all = 1u << 25;
};

/// What light trees hold.
struct LightTreeFigures {
    std::size_t lamps = 0;
    std::size_t in_solids = 0;     ///< lamps that light nothing
    std::size_t without_tree = 0;  ///< lamps of which cells say no more than that they may see them
    std::size_t beams = 0;         ///< one for each portal that a lamp's light crosses, and one for the lamp
    std::size_t planes = 0;
    std::size_t objects = 0;       ///< in the lists of beams
    std::size_t lit_cells = 0;     ///< that list a lamp
    std::size_t listed_lamps = 0;  ///< in the lists of all cells, each once a cell
    std::size_t longest_list = 0;  ///< lamps in a cell's list
    std::size_t most_entries = 0;  ///< ways of lamps in a cell's list
    std::size_t list_bytes = 0;
    std::size_t tree_bytes = 0;
    std::size_t object_bytes = 0;
};

/// Owns the arrays. Movable; views stay valid while it lives.
class LightTrees {
public:
    [[nodiscard]] LightTreesView view() const;
    [[nodiscard]] std::size_t bytes() const;
    /// Lamps that have none, because their light takes too many ways.
    [[nodiscard]] std::size_t lamps_without_tree() const { return figures_.without_tree; }
    /// Cost: linear in the cells and their lists.
    [[nodiscard]] LightTreeFigures figures() const;

private:
    friend LightTrees build_light_trees(const SceneView&, const LightTreeOptions&, const Executor&);

    std::vector<std::uint32_t> cell_offsets_;
    std::vector<CellLight> cell_lights_;
    std::vector<LightBeam> beams_;
    std::vector<BeamPlane> planes_;
    std::vector<Vertex> tints_;
    std::vector<BeamObjects> beam_object_lists_;
    std::vector<ObjectId> beam_objects_;
    LightTreeFigures figures_;  ///< what the arrays do not say
};

/// Follows the light of each of the view's lamps through its portals. Conservative: no lamp that a ray reaches is
/// missing in a cell's list. The same on any number of threads. Cost: linear in what the lamps see. \pre the view is
/// sound; lamps without a cell light nothing
[[nodiscard]] LightTrees build_light_trees(const SceneView& view, const LightTreeOptions& options,
                                           const Executor& executor);

}  // namespace enfilade::accel

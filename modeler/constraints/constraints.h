#pragma once
// The constraints of 2-model, a function each; `check` calls them in the order of the table. D3 compares files:
// modeler/certify.h.

#include <cstdint>
#include <vector>

#include "modeler/building.h"
#include "modeler/check.h"
#include "modeler/constraints/face_rings.h"
#include "modeler/constraints/map_faces.h"
#include "modeler/constraints/space_index.h"
#include "plans/plan.h"

namespace enfilade::modeler {

/// Cells of the map that a finding blames already: later checks skip them, so that one fault is one finding.
struct Blame {
    std::vector<bool> volume;  ///< [volume]
    std::vector<bool> face;    ///< [face]
    std::vector<bool> vertex;  ///< [vertex]
    std::vector<bool> space;   ///< [space]
    bool whole_map = false;    ///< the topology is broken where no single cell can be blamed
    [[nodiscard]] bool any() const;
};

/// What a constraint looks at. The plan is read anew from the building, so that the model is compared with what was
/// asked for and not with itself; it is empty where the building has none.
struct Subject {
    const Building& building;
    const plans::Plan& plan;
    const CheckOptions& options;
    const MapFaces& faces;   ///< of the building's map
    const FaceRings& rings;  ///< of the building's map, with its vertices
    const SpaceIndex& spaces;
};

/// T1-T7: closed, oriented quasi-manifold of balls; by `gmap::validate` and the defects of the map's builder.
void check_topology(const Building& building, Blame& blame, CheckReport& report);

/// T8: each floor of a storey lies on a slab's top, each ceiling under a slab's underside, and they tile it. That the
/// areas on both sides are equal has a meaning where the geometry (G) has no fault: `check_tiling` comes after it.
void check_storeys(const Subject& subject, Blame& blame, CheckReport& report);
void check_tiling(const Subject& subject, Blame& blame, CheckReport& report);

/// G1: no two vertices of the map at one point.
void check_vertices(const Subject& subject, Blame& blame, CheckReport& report);

/// G2: every face is bounded by one simple ring. G3: every face is flat.
void check_rings(const Subject& subject, Blame& blame, CheckReport& report);
void check_planarity(const Subject& subject, Blame& blame, CheckReport& report);

/// G4: no two faces of a volume's shell meet but in the edges and vertices that they share.
void check_shells(const Subject& subject, Blame& blame, CheckReport& report);

/// G5: every volume positive, the hull the site box, and the volumes sum to it exactly: no overlap, no gap.
void check_partition(const Building& building, Blame& blame, CheckReport& report);

/// G6: walls and slabs are as thick as `CheckOptions::least_thickness` at least (a warning).
void check_thickness(const Subject& subject, Blame& blame, CheckReport& report);

/// G7: sides of volumes are vertical, floors and ceilings horizontal.
void check_directions(const Subject& subject, Blame& blame, CheckReport& report);

/// G8: no cell has a reflex corner between different lines, none strays from a line by more than rounding does, and
/// pieces sum to the volume that they are cut from.
void check_convexity(const Building& building, Blame& blame, CheckReport& report);

/// G9: the faces of a curved wall stray from its circle by no more than `Building::sagitta` and the grid's rounding.
void check_curves(const Subject& subject, Blame& blame, CheckReport& report);

/// S1: every volume and face of the map has its one label, that of its space.
void check_labels(const Subject& subject, Blame& blame, CheckReport& report);

/// S2: a door or window joins two parents (one and the same: a warning) and sits in the wall that the plan names.
void check_openings(const Subject& subject, Blame& blame, CheckReport& report);

/// S3: a room is bounded by walls, slabs, openings, objects and portals alone.
void check_room_bounds(const Subject& subject, Blame& blame, CheckReport& report);

/// S4: each flight of the plan links its storey to the next and pierces the slab between them.
void check_stairs(const Subject& subject, Blame& blame, CheckReport& report);

/// S5: one exterior; from every habitable room a path through doors leads to it (a warning names the room).
void check_access(const Subject& subject, Blame& blame, CheckReport& report);

/// S6: objects lie inside one room, are disjoint and keep out of door sweeps (warnings for pieces that the plan
/// places).
void check_objects(const Subject& subject, Blame& blame, CheckReport& report);

/// S7: lamps hang where light is, on the site, have power, and no two are at one place (warnings).
void check_lamps(const Subject& subject, CheckReport& report);

/// D1: the node that stands for a cell in graphs lies inside the cell.
void check_nodes(const Subject& subject, Blame& blame, CheckReport& report);

/// D2: portals and map agree: each face between two cells is a portal or a leaf, each portal joins the cells it names.
void check_portals(const Building& building, Blame& blame, CheckReport& report);

}  // namespace enfilade::modeler

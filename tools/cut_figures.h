#pragma once
// What a way of cutting makes of a building, in figures that need no clock.

#include <cstdint>

#include "accel/scene.h"
#include "modeler/building.h"
#include "modeler/cutting/cut_cost.h"

namespace enfilade::tools {

struct CutFigures {
    std::uint64_t rooms = 0;  ///< spaces that are rooms
    std::uint64_t cells = 0;  ///< openings and the exterior included
    std::uint64_t sections = 0;
    std::uint64_t side_faces = 0;
    double portal_area = 0;         ///< m2 of the virtual portals within a space
    double cell_surface = 0;        ///< m2, each cell's own
    double parent_surface = 0;      ///< m2 of the volumes that the cells are cut from
    double section_surface = 0;     ///< m2 times sections: a cell's surface by the number of its sections
    double face_surface = 0;        ///< m2 times side faces
    std::uint64_t walk_bytes = 0;   ///< of what a walk and the locator read, padding included
    std::uint64_t trace_bytes = 0;  ///< of all that tracers read: names, colours and the walls' outlines, too

    [[nodiscard]] double cells_a_room() const { return rooms == 0 ? 0 : double(cells) / double(rooms); }
    [[nodiscard]] double sections_a_cell() const { return cells == 0 ? 0 : double(sections) / double(cells); }
    [[nodiscard]] double faces_a_section() const { return sections == 0 ? 0 : double(side_faces) / double(sections); }
    [[nodiscard]] double bytes_a_cell() const { return cells == 0 ? 0 : double(walk_bytes) / double(cells); }
    [[nodiscard]] double all_bytes_a_cell() const { return cells == 0 ? 0 : double(trace_bytes) / double(cells); }
    /// Surface of the cells by what each costs a ray, over the surface of what they are cut from (cut_cost.h).
    [[nodiscard]] double sah_sum(const modeler::CutCost& cost) const {
        const double sum = cost.visit * cell_surface + cost.section * section_surface + cost.face * face_surface;
        return parent_surface > 0 ? sum / parent_surface : 0;
    }
};

/// \pre `scene` is the export of `building`
[[nodiscard]] CutFigures cut_figures(const modeler::Building& building, const accel::Scene& scene);

}  // namespace enfilade::tools

#pragma once
// The building seen from above: its parts by storey, its plan, and where drawings have their origin.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "modeler/building.h"
#include "modeler/space_parts.h"
#include "plans/plan.h"
#include "tools/report/svg_path.h"

namespace enfilade::tools {

class PlanView {
public:
    /// Throws InputError where the building's pieces do not close (a damaged model).
    explicit PlanView(const modeler::Building& building);

    [[nodiscard]] const modeler::Building& building() const { return building_; }
    [[nodiscard]] const modeler::Space& space(std::uint32_t s) const { return building_.spaces[s]; }
    [[nodiscard]] std::size_t storey_count() const { return building_.storeys.size(); }
    /// The storey as the plan has it; null where the building holds no plan that can be read.
    [[nodiscard]] const plans::Storey* plan_storey(std::uint32_t storey) const;

    /// Rooms, walls, openings, stairs and shafts between the floor and the ceiling of a storey.
    [[nodiscard]] const std::vector<modeler::SpacePart>& parts(std::uint32_t storey) const { return parts_[storey]; }
    /// Stairs and shafts in the slab under a storey.
    [[nodiscard]] const std::vector<modeler::SpacePart>& wells(std::uint32_t storey) const { return wells_[storey]; }
    /// Level at which a storey is cut to be drawn, as architects do: 1.1 m above its floor.
    [[nodiscard]] std::int32_t cut_level(std::uint32_t storey) const { return cut_levels_[storey]; }
    [[nodiscard]] bool is_cut(std::uint32_t storey, const modeler::Volume& volume) const {
        return volume.z_low <= cut_levels_[storey] && cut_levels_[storey] < volume.z_high;
    }
    /// The upright faces over an edge of the building, as indices into its faces.
    [[nodiscard]] std::span<const std::uint32_t> side_faces(std::uint32_t edge) const {
        return std::span(side_faces_).subspan(first_side_[edge], first_side_[edge + 1] - first_side_[edge]);
    }
    /// What all storeys fill together.
    [[nodiscard]] const MmBox& box() const { return box_; }
    /// World coordinates of the drawings' origin: whole metres.
    [[nodiscard]] std::array<double, 2> origin() const { return origin_; }

    [[nodiscard]] Mm mm(double x, double y) const;
    [[nodiscard]] Mm mm(plans::Point p) const { return mm(p.x, p.y); }
    [[nodiscard]] Mm mm(plans::GridPoint p) const;
    /// The centre of a piece's area.
    [[nodiscard]] Mm middle(const modeler::Piece& piece) const;
    [[nodiscard]] std::vector<Mm> ring(const modeler::HalfEdgeRing& ring) const;
    /// Outer ring and holes.
    [[nodiscard]] std::vector<std::vector<Mm>> rings(const modeler::SpacePart& part) const;
    void add(const modeler::SpacePart& part, SvgPath& path) const;

private:
    void sort_parts();
    void sort_faces();

    const modeler::Building& building_;
    std::optional<plans::Plan> plan_;
    std::vector<std::vector<modeler::SpacePart>> parts_, wells_;  ///< [storey]
    std::vector<std::int32_t> cut_levels_;                        ///< [storey]
    std::vector<std::uint32_t> first_side_, side_faces_;          ///< [edge + 1] into side_faces_
    std::array<double, 2> origin_ = {};
    MmBox box_;
};

}  // namespace enfilade::tools

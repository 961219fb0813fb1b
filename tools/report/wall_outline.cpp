#include "tools/report/wall_outline.h"

#include <algorithm>

#include "modeler/outline.h"
#include "tools/report/ring_chain.h"

namespace enfilade::tools {
namespace {

using modeler::HalfEdgeRing;
using modeler::Label;
using modeler::Volume;

/// Pieces in one outline: half-edges whose twin is there as well lie inside.
class Union {
public:
    explicit Union(const PlanView& view) : view_(view), held_(2 * view.building().edges.size(), 0) {}

    void add(const modeler::Piece& piece) {
        for (std::uint32_t k = 0; k < piece.corner_count; ++k)
            held_[view_.building().corners[piece.first_corner + k].half_edge] = 1;
    }

    [[nodiscard]] SvgPath path() const {
        const modeler::Building& building = view_.building();
        std::vector<std::uint32_t> border;  // half-edges
        std::vector<std::array<std::uint32_t, 2>> sides;
        for (std::uint32_t h = 0; h < held_.size(); ++h) {
            if (!held_[h] || held_[h ^ 1]) continue;
            border.push_back(h);
            sides.push_back({modeler::start_of(building, h), modeler::start_of(building, h ^ 1)});
        }
        SvgPath path;
        for (const std::vector<std::uint32_t>& chain : chain_rings(sides)) {
            HalfEdgeRing ring;
            for (const std::uint32_t k : chain) ring.push_back(border[k]);
            if (ring.size() >= 3) path.ring(view_.ring(ring));
        }
        return path;
    }

private:
    const PlanView& view_;
    std::vector<std::uint8_t> held_;  ///< [half-edge]
};

}  // namespace

WallOutlines wall_outlines(const PlanView& view, std::uint32_t storey) {
    const modeler::Building& building = view.building();
    const modeler::StoreyInfo& info = building.storeys[storey];
    Union cut(view), low(view), columns(view);
    std::vector<std::uint8_t> is_open(building.pieces.size(), 0);  // air where the level cuts the piece
    for (const Volume& volume : building.volumes)
        if (volume.piece < building.pieces.size() && view.is_cut(storey, volume))
            is_open[volume.piece] = volume.label == Label::Exterior || view.space(volume.space).id.ends_with("/above");
    for (const Volume& volume : building.volumes) {
        if (volume.label != Label::Wall || view.space(volume.space).storey != storey) continue;
        const modeler::Piece& piece = building.pieces[volume.piece];
        if (view.is_cut(storey, volume)) (view.space(volume.space).kind == "column" ? columns : cut).add(piece);
        else if (volume.z_low == info.z_floor && is_open[volume.piece]) low.add(piece);
    }
    return {cut.path(), low.path(), columns.path()};
}

}  // namespace enfilade::tools

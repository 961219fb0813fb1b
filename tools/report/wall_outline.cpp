#include "tools/report/wall_outline.h"

#include <algorithm>

#include "modeler/outline.h"

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

    /// Rings that go on anywhere where several meet: filled, they all look the same.
    [[nodiscard]] SvgPath path() const {
        const modeler::Building& building = view_.building();
        std::vector<std::pair<std::uint32_t, std::uint32_t>> border;  // starting point, half-edge
        for (std::uint32_t h = 0; h < held_.size(); ++h)
            if (held_[h] && !held_[h ^ 1]) border.push_back({modeler::start_of(building, h), h});
        std::sort(border.begin(), border.end());
        std::vector<std::uint8_t> used(border.size(), 0);
        const auto next = [&](std::uint32_t h) {
            const std::pair<std::uint32_t, std::uint32_t> low = {modeler::start_of(building, h ^ 1), 0};
            auto at = std::lower_bound(border.begin(), border.end(), low);
            while (at != border.end() && at->first == low.first && used[std::size_t(at - border.begin())]) ++at;
            return at == border.end() || at->first != low.first ? border.size() : std::size_t(at - border.begin());
        };
        SvgPath path;
        for (std::size_t k = 0; k < border.size(); ++k) {
            HalfEdgeRing ring;
            for (std::size_t at = k; at < border.size() && !used[at]; at = next(border[at].second)) {
                used[at] = 1;
                ring.push_back(border[at].second);
            }
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

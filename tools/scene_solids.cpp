#include "tools/scene_solids.h"

#include "modeler/model_group.h"

namespace enfilade::tools {

render::Solids solids_of(const accel::Scene& scene) {
    if (!scene.has_model()) return {};
    const modeler::Building building = modeler::read_model(scene);
    const double unit = scene.view().unit;
    std::vector<std::array<double, 2>> corners;
    corners.reserve(building.corners.size());
    for (const modeler::Corner& corner : building.corners) {
        const plans::GridPoint& point = building.points[corner.vertex];
        corners.push_back({unit * point.x, unit * point.y});
    }
    std::vector<render::SolidPrism> prisms;
    for (const modeler::Volume& volume : building.volumes) {
        if (accel::carries_light(volume.label) || volume.label == accel::Label::Outside) continue;
        const modeler::Piece& piece = building.pieces[volume.piece];
        const bool is_named = volume.space < scene.view().spaces.size();
        prisms.push_back({piece.first_corner, piece.corner_count, unit * volume.z_low, unit * volume.z_high,
                          volume.label, is_named ? accel::SpaceId(volume.space) : none<accel::SpaceId>});
    }
    return {std::move(prisms), std::move(corners)};
}

}  // namespace enfilade::tools

#pragma once
// Scenes with lamps that are put into them afterwards: no plan needs to know of them.

#include <cstdint>
#include <vector>

#include "accel/scene.h"
#include "render/vec.h"

namespace enfilade::test {

/// A scene and its lamps.
class LitScene {
public:
    explicit LitScene(accel::Scene scene) : scene_(std::move(scene)) {}

    /// Metres, scene frame; candela by linear RGB. Lamps in solids light nothing.
    void add_lamp(render::Vec3d position, render::Vec3f candela, accel::ObjectId carrier = none<accel::ObjectId>);

    /// `count` lamps inside of cells, all but those outdoors where `indoors`, half a metre to a few below ceilings or
    /// on levels of floors and ceilings; colours are drawn, too.
    void add_random_lamps(int count, std::uint64_t seed, bool indoors = true);

    /// Valid until lamps are added or the object is gone.
    [[nodiscard]] accel::SceneView view() const;

private:
    accel::Scene scene_;
    std::vector<accel::Light> lights_;
};

/// A place in the open, in a cell, and how its surface lies.
struct OpenPlace {
    render::Vec3f point;
    render::Vec3f normal;  ///< of length 1; of a place in the air none: 0
    std::uint32_t cell;
};

/// `count` places: in the air, on floors, and on the walls of cells, as a ray that ends there leaves them.
[[nodiscard]] std::vector<OpenPlace> open_places(const accel::SceneView& view, int count, std::uint64_t seed);

}  // namespace enfilade::test

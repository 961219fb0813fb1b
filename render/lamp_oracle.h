#pragma once
// Brute force over faces and triangles: which lamps places see. What walks, lists and light trees are checked against.

#include <cstdint>
#include <optional>

#include "accel/scene.h"
#include "render/object_oracle.h"
#include "render/oracle.h"

namespace enfilade::render {

/// Shares neither cells, nor trees, nor formulas with those who look for lamps. Doubles.
class LampOracle {
public:
    /// band: metres; ways that pass an edge nearer than that may rightly be open or not (error_band). The scene's
    /// memory must outlive it.
    LampOracle(const accel::SceneView& scene, double band);

    /// Whether nothing but glass, and the lamp's own carrier, lies between the place and the lamp: yes, no, or nothing
    /// where triangles are passed so closely that rounding decides. Lamps in solids are seen from nowhere. Cost: linear
    /// in faces and triangles.
    [[nodiscard]] std::optional<bool> sees(Vec3d place, std::uint32_t lamp) const;

    /// Whether the way to the lamp passes an edge of a face, or the place or the lamp a face in the way, nearer than
    /// the band.
    [[nodiscard]] bool is_close(Vec3d place, std::uint32_t lamp) const;

    /// Whether that answer is right, or rounding may rightly give it.
    [[nodiscard]] bool allows(Vec3d place, std::uint32_t lamp, bool is_seen) const;

private:
    [[nodiscard]] Vec3d position(std::uint32_t lamp) const;

    const accel::SceneView& scene_;
    Oracle faces_;
    std::optional<ObjectOracle> objects_;
    double band_;
};

}  // namespace enfilade::render

#pragma once
// Collects the shapes of one piece: closed skins, outward, welded, without a triangle of no area.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "modeler/catalogue/object_mesh.h"
#include "modeler/catalogue/own/paint.h"
#include "modeler/catalogue/own/vec.h"

namespace enfilade::modeler::own {

/// A closed curve of a skin; its first point is not repeated.
using Ring = std::vector<Vec>;

enum class Ends { Capped, Looped };  ///< flat lids over the first and the last ring, or the last leads to the first

class Shaper {
public:
    /// `detail` below 1 is taken as 1, above `most_detail` as that.
    explicit Shaper(std::uint32_t detail);

    static constexpr std::uint32_t most_detail = 8;
    [[nodiscard]] int detail() const { return detail_; }
    /// How many parts something has that is made of `plain` parts at detail 1: 1, 1.6, 2.2, 2.8 ... times as many.
    [[nodiscard]] int fine(int plain) const;

    /// What is shaped during the life of a Scope stands in its pose; scopes nest.
    class Scope {
    public:
        ~Scope() { shaper_.pose_ = before_; }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

    private:
        friend class Shaper;
        Scope(Shaper& shaper, const Pose& pose) : shaper_(shaper), before_(shaper.pose_) {
            shaper.pose_ = before_ * pose;
        }
        Shaper& shaper_;
        Pose before_;
    };
    [[nodiscard]] Scope inside(const Pose& pose) { return Scope(*this, pose); }

    /// A solid whose surface runs through `rings`. Points of a ring may share a place: what collapses is left out. It
    /// is turned outward, whichever way the rings run. \pre all rings have as many points; lids are simple polygons
    void skin(std::span<const Ring> rings, const Paint& paint, Ends ends = Ends::Capped);

    /// The mesh, fitted into the box of that size: the bottom at z = 0, the middle at the origin. \pre not empty
    [[nodiscard]] ObjectMesh finish(std::string_view name, const Size& size) &&;

private:
    std::uint32_t material_of(const Paint& paint);

    int detail_;
    Pose pose_;
    std::vector<Vec> vertices_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<std::uint32_t> triangle_materials_;
    std::vector<ObjectMaterial> materials_;
};

}  // namespace enfilade::modeler::own

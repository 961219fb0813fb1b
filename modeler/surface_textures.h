#pragma once
// The pictures that a plan lays on its walls, floors and ceilings: which face shows which, and how it lies there.

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "modeler/building.h"
#include "plans/outline.h"

namespace enfilade::modeler {

/// A texture of the plan, and its picture.
struct PlanTexture {
    plans::SurfaceTexture laid;
    std::uint32_t picture = 0;  ///< into Building::pictures
};

/// Reads the pictures that the building's plan names into `building.pictures`, by name, scaled down to `most_a_side`
/// texels a side (0: none are read). They are entries of `plan_file` where that is an archive, else files beside it or
/// below. What cannot be read is a finding (K160).
void read_surface_pictures(Building& building, const std::filesystem::path& plan_file, std::uint32_t most_a_side);

/// Those of a building, by space and side. A texture without its picture counts as none.
class SurfaceTextures {
public:
    static constexpr std::uint32_t no_wall = UINT32_MAX;

    explicit SurfaceTextures(const Building& building);

    /// Of the floor or ceiling that a room shows; nullptr: none.
    [[nodiscard]] const PlanTexture* of_floor(std::uint32_t space) const { return found(floors_, space); }
    [[nodiscard]] const PlanTexture* of_ceiling(std::uint32_t space) const { return found(ceilings_, space); }

    /// The textured wall, to ask with below, that shows its face over the edge from a to b (seen from its left), and
    /// behind which is a volume of that space; `no_wall` where it has none.
    [[nodiscard]] std::uint32_t wall_behind(std::uint32_t space, plans::GridPoint a, plans::GridPoint b) const;
    [[nodiscard]] const PlanTexture& of_wall(std::uint32_t wall, plans::GridPoint a, plans::GridPoint b) const;

    /// How they lie (accel/scene_input.h, InputSourceFace::frame).
    [[nodiscard]] std::array<float, 4> wall_frame(std::uint32_t wall, plans::GridPoint a, plans::GridPoint b) const;
    [[nodiscard]] std::array<float, 4> level_frame() const;

private:
    struct Wall {
        plans::WallAxis axis;
        double half = 0;  ///< of its thickness, metres
        std::uint32_t storey = 0;
        std::optional<PlanTexture> left, right;
    };
    /// Where an edge runs beside a wall.
    struct Beside {
        double share = 0;      ///< of the axis, at its middle
        double distance = 0;   ///< of its middle from the axis, metres, to the left
        double direction = 0;  ///< cosine to the axis
    };
    using ByName = std::map<std::pair<std::string, std::string>, std::uint32_t>;  ///< storey's id, own id -> space
    using BySpace = std::map<std::uint32_t, PlanTexture>;

    static const PlanTexture* found(const BySpace& all, std::uint32_t space) {
        const auto at = all.find(space);
        return at == all.end() ? nullptr : &at->second;
    }
    void add(const plans::Storey& storey, const ByName& spaces);
    [[nodiscard]] std::optional<PlanTexture> with_picture(const std::optional<plans::SurfaceTexture>& texture) const;
    [[nodiscard]] plans::Point world(plans::GridPoint p) const;
    [[nodiscard]] Beside beside(const Wall& wall, plans::GridPoint a, plans::GridPoint b) const;
    [[nodiscard]] const PlanTexture* shown(const Wall& wall, const Beside& at) const;

    const Building& building_;
    std::vector<Wall> walls_;
    std::map<std::uint32_t, std::uint32_t> wall_of_space_;
    BySpace floors_, ceilings_;
};

}  // namespace enfilade::modeler

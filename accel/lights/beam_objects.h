#pragma once
// Inside of accel: which objects can stand between a lamp and the places that its beams hold.

#include <span>
#include <vector>

#include "accel/lights/lamp_walk.h"
#include "accel/lights/light_trees.h"

namespace enfilade::accel::detail {

/// Lists the objects of one lamp's steps, then of the next one's. The scene must outlive it.
class BeamObjectLister {
public:
    explicit BeamObjectLister(const SceneView& view) : view_(view) {}

    /// Of each step: what stands in the cells of its way, and comes into its light before or in its own cell. Steps
    /// share the lists of their parents where they are the same.
    void list(const LampWalk& walk, const Light& light);
    [[nodiscard]] const std::vector<BeamObjects>& lists() const { return lists_; }  ///< [step_count]
    [[nodiscard]] const std::vector<ObjectId>& objects() const { return objects_; }

private:
    struct Box {
        float low[3], high[3];
    };

    void add(const LampWalk& walk, std::uint32_t number, const Light& light);
    [[nodiscard]] bool comes_into(const PlacedObject& object, const Box& box, const Light& light,
                                  std::span<const ConeVector> planes) const;
    [[nodiscard]] bool is_cut(const LampWalk& walk, std::uint32_t number, ObjectId object) const;
    [[nodiscard]] std::span<const ObjectId> objects_of(CellId cell) const;
    [[nodiscard]] Box box_of(const Cell& cell) const;
    [[nodiscard]] bool reaches_into(const PlacedObject& object, const Cell& cell) const;

    const SceneView& view_;
    std::vector<BeamObjects> lists_;
    std::vector<ObjectId> objects_;
    std::vector<ObjectId> found_;  ///< at hand
};

}  // namespace enfilade::accel::detail

#pragma once
// Streams through furnished rooms, cells and objects apart: the walk through cells stops where a ray may meet an
// object's box; whoever asks the object's tree then (the same thread, or a kernel of such questions alone, sorted by
// mesh) tells it how to go on. The answers are those of walk_furnished, object by object in the same order.

#include "render/cuda/streams_atomics.h"
#include "render/cuda/streams_questions.h"

namespace enfilade::render::cuda {

/// A ray at the box of an object.
struct alignas(16) ObjectQuestion {
    std::uint32_t ray;
    std::uint32_t place;  ///< of the object, in `cell_objects`
    float near, far;      ///< the part of the ray that counts
};

/// How far that ray's walk has come.
struct alignas(16) WalkSoFar {
    std::uint32_t cell;
    std::uint32_t steps;          ///< cells that it may still enter
    std::uint32_t best_object;    ///< nearest of this cell's objects that were asked before, at `far`; or no_object
    std::uint32_t best_triangle;  ///< of it
};

/// What became of a question: `triangle` is no_triangle where nothing was met.
struct alignas(8) ObjectAnswer {
    float t;
    std::uint32_t triangle;
};

enum class Outcome : std::uint8_t {
    Answered,  ///< the ray has ended
    Rare,      ///< it is to be walked whole
    Waits      ///< for the answer to a question
};

/// The walk between two questions.
template <class Scene, class Question>
struct ObjectWalk {
    using Traveller = typename Question::Traveller;
    const Scene& scene;
    const Question& question;

    /// Of ray i, which has begun: at its start.
    ENFILADE_HD void start(std::uint32_t i, const Traveller& t, ObjectQuestion& asked, WalkSoFar& so_far) const {
        so_far = {t.cell, most_steps(scene), no_object, no_triangle};
        asked = {i, objects_of(scene, t.cell).first, t.part.near, 0};
    }
    /// What was asked is answered; true: that answers the ray.
    ENFILADE_HD bool take(ObjectAnswer answer, const Traveller& t, ObjectQuestion& asked, WalkSoFar& so_far) const {
        if (answer.triangle != no_triangle && (so_far.best_object == no_object || answer.t < asked.far)) {
            so_far.best_object = static_cast<std::uint32_t>(scene.cell_objects[asked.place]);
            so_far.best_triangle = answer.triangle;
            asked.far = answer.t;
            if constexpr (Question::asked == ObjectsAsked::Any) {
                question.finish_at_object(asked.ray, t, so_far.cell, {});
                return true;
            }
        }
        ++asked.place;
        return false;
    }
    /// Walks on to the next question. knows_far: asked.far is already that of this cell
    ENFILADE_HD Outcome on(const Traveller& t, bool knows_far, ObjectQuestion& asked, WalkSoFar& so_far) const {
        const SlabRay slabs = scene_slabs(t.ray);
        WalkEnd<float> end;
        for (; so_far.steps > 0; --so_far.steps) {
            const std::uint32_t cell = so_far.cell;
            const bool is_last = t.stop.ends_in(cell);
            if (is_last) {
                end = {};
                end.cell = cell;
                end.status = WalkStatus::Reached;
            } else if (!leave_plainly(scene, t.ray, cell, t.stop, end)) {
                return Outcome::Rare;
            }
            const std::uint32_t past = objects_of(scene, cell).end;
            if (asked.place < past) {
                if (!knows_far)
                    asked.far = is_last ? t.part.far : stretch_end(parameter(scene, t.ray, end), t.part.far);
                if (comes_to_object(t, slabs, past, asked)) return Outcome::Waits;
            }
            if (so_far.best_object != no_object) {
                question.finish_at_object(asked.ray, t, cell,
                                          {so_far.best_object, so_far.best_triangle, asked.far, {0, 0, 0}});
                return Outcome::Answered;
            }
            if (end.status == WalkStatus::Reached || !end.target.is_portal()) {
                if (ends_behind(t.ray, end)) return Outcome::Rare;
                question.finish(scene, asked.ray, t, end);
                return Outcome::Answered;
            }
            so_far.cell = static_cast<std::uint32_t>(end.target.neighbour());
            const ObjectList list = objects_of(scene, so_far.cell);
            asked.place = list.first;
            asked.near = list.first != list.end ? stretch_start(parameter(scene, t.ray, end), t.part.near) : 0.0f;
            knows_far = false;
        }
        return Outcome::Rare;
    }

private:
    /// To the next object whose boxes the ray may meet.
    ENFILADE_HD bool comes_to_object(const Traveller& t, const SlabRay& slabs, std::uint32_t past,
                                     ObjectQuestion& asked) const {
        for (; asked.place < past; ++asked.place) {
            const accel::PlacedObject& object =
                scene.objects[static_cast<std::uint32_t>(scene.cell_objects[asked.place])];
            ObjectRay met;
            if (comes_near(scene, object, t.ray, slabs, asked.near, asked.far, met)) return true;
        }
        return false;
    }
};

/// Asks an object's tree.
template <ObjectsAsked asked_for, class Trees>
ENFILADE_HD ObjectAnswer answer_object(const accel::SceneView& scene, const Trees& trees, const Ray<float>& ray,
                                       const ObjectQuestion& asked) {
    const auto id = static_cast<std::uint32_t>(scene.cell_objects[asked.place]);
    const accel::PlacedObject& object = scene.objects[id];
    ObjectRay met = to_object(object, ray, asked.near, asked.far);
    if constexpr (asked_for == ObjectsAsked::Any) {
        const bool blocks =
            ask_blocked(trees, object.mesh, met) && !(scene.has_looks() && is_only_glass(scene, trees, id, met));
        return {0, blocks ? 0 : no_triangle};
    } else {
        ask_nearest(trees, object.mesh, met);
        return {met.far, met.triangle};
    }
}

}  // namespace enfilade::render::cuda

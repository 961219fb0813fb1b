#pragma once
// What --object-accel and the flags of octrees ask for, and what is said of the structures that were built.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "accel/octree/octree_figures.h"
#include "render/object_tracer.h"
#include "tools/commands.h"

namespace enfilade::tools {

/// How rays find the triangles of objects.
struct ObjectAccelChoice {
    render::ObjectAccelKind kind = render::ObjectAccelKind::Automatic;
    accel::OctreeOptions octree;
};

/// Refuses every flag of these where no ray asks the structures of objects. `why`: a sentence's beginning, like "The
/// oracle sees no objects". Throws InputError (F139).
void refuse_object_accel(const ObjectAccelFlags& flags, const std::string& why);

/// Reads and checks the flags, before any work. `asker`: the flag that needs octrees whatever else is said, like
/// "--show leaves"; empty: nothing does. Throws InputError (F139) where they contradict each other.
[[nodiscard]] ObjectAccelChoice object_accel_choice(const ObjectAccelFlags& flags, const std::string& asker = {});

/// What is told of the structures of a scene's objects.
struct ObjectsSummary {
    std::size_t count = 0;      ///< of objects; 0: nothing stands there, and nothing was built
    std::size_t triangles = 0;  ///< of the meshes that objects have, each once
    std::string accel;          ///< ObjectAccel::name
    std::size_t bytes = 0;
    double seconds = 0;  ///< that building took
    std::optional<accel::OctreeFigures> octrees;
    accel::OctreeOptions asked;  ///< how `octrees` were to be built

    /// In words, a line each.
    [[nodiscard]] std::string report() const;
    /// null where nothing stands there
    [[nodiscard]] nlohmann::ordered_json json() const;
};

/// With how many objects and triangles there are, and nothing else.
[[nodiscard]] ObjectsSummary counted_objects(const accel::SceneView& scene);

/// What stands in the rooms, made ready to be asked by rays.
struct PreparedObjects {
    std::unique_ptr<render::ObjectAccel> accel;  ///< nullptr: nothing stands there
    ObjectsSummary summary;
};

[[nodiscard]] PreparedObjects prepare_objects(const accel::SceneView& scene, const ObjectAccelChoice& choice,
                                              const accel::Executor& executor);

/// The same rooms without what stands in them.
[[nodiscard]] inline accel::SceneView without_objects(accel::SceneView scene) {
    scene.objects = {};
    return scene;
}

}  // namespace enfilade::tools

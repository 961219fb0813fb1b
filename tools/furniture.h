#pragma once
// What `build` puts into a building: the plan's own pieces, and what rules add, where it can be seen from.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "modeler/building.h"
#include "modeler/catalogue/catalogue.h"
#include "modeler/furnishing/furnish.h"
#include "plans/plan.h"
#include "tools/commands.h"
#include "tools/furniture_scope.h"
#include "tools/progress.h"

namespace enfilade::tools {

/// What came of it.
struct FurnitureMade {
    std::optional<FurnitureScope> scope;        ///< nothing: the whole building
    std::vector<modeler::RoomFurnished> rooms;  ///< by rule
    std::size_t of_plan = 0;                    ///< objects
    std::size_t by_rule = 0;
    std::size_t volumes = 0;  ///< objects that are volumes of their own
    std::size_t meshes = 0;
    std::uint64_t triangles = 0;            ///< of those meshes
    std::uint64_t instanced_triangles = 0;  ///< of all objects
    double catalogue_seconds = 0;
    double plan_seconds = 0;
    double rules_seconds = 0;
    double put_seconds = 0;

    [[nodiscard]] std::size_t requested() const;
};

/// The furniture of one building.
class Furniture {
public:
    /// Reads the rules and opens the catalogues; a home of Sweet Home 3D is one of its own pieces. Reads none where
    /// neither plan nor flags ask for furniture. \throws InputError where a flag, a rule file or a catalogue is wrong
    Furniture(const FurnishFlags& flags, const std::filesystem::path& plan_file, const plans::Plan& plan);

    [[nodiscard]] bool is_wanted() const { return is_wanted_; }
    /// Puts it into the building. What was found on the way joins `building.findings`. \pre is_wanted(), and the
    /// building is convex and holds its stack
    void put_into(modeler::Building& building, Progress& progress);
    [[nodiscard]] const FurnitureMade& made() const { return made_; }
    /// Where its pieces come from; nullptr where none are wanted.
    [[nodiscard]] const modeler::Catalogue* catalogue() const { return catalogue_ ? &*catalogue_ : nullptr; }

    /// Two sentences, one if there is no scope.
    [[nodiscard]] std::string text() const;
    /// The object `furniture` of the result.
    [[nodiscard]] nlohmann::ordered_json json(const modeler::Building& building) const;

private:
    void count(const modeler::Furnishing& furnishing);

    const FurnishFlags& flags_;
    bool is_wanted_ = false;
    std::optional<modeler::Rules> rules_;
    std::optional<modeler::Catalogue> catalogue_;
    FurnitureMade made_;
};

}  // namespace enfilade::tools

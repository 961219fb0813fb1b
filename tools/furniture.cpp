#include "tools/furniture.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "modeler/objects/plan_objects.h"
#include "modeler/objects/put_objects.h"
#include "plans/read.h"
#include "render/executor.h"
#include "tools/bench.h"

namespace enfilade::tools {

namespace {

bool has_furniture(const plans::Plan& plan) {
    return std::ranges::any_of(plan.storeys, [](const plans::Storey& storey) { return !storey.furniture.empty(); });
}

void check_flags(const FurnishFlags& flags) {
    if (flags.lit && !has_scope(flags))
        throw InputError("F116", "",
                         "--lit widens the scope of --rooms or --views to what lamps shine through: give one of them.");
}

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code none;
    return std::filesystem::equivalent(a, b, none);
}

void append(std::vector<Finding>& to, std::span<const Finding> findings) {
    to.insert(to.end(), findings.begin(), findings.end());
}

}  // namespace

std::size_t FurnitureMade::requested() const {
    std::size_t sum = 0;
    for (const modeler::RoomFurnished& room : rooms) sum += room.requested;
    return sum;
}

Furniture::Furniture(const FurnishFlags& flags, const std::filesystem::path& plan_file, const plans::Plan& plan)
    : flags_(flags) {
    check_flags(flags);
    const bool takes_plan = !flags.no_plan_furniture && has_furniture(plan);
    is_wanted_ = takes_plan || flags.rules.has_value();
    if (!is_wanted_) return;
    if (flags.rules) rules_ = flags.rules->empty() ? modeler::own_rules() : modeler::read_rules(*flags.rules);
    made_.catalogue_seconds = seconds_of([&] {
        modeler::CatalogueOptions options;
        options.detail = flags.detail;
        options.object_triangles = flags.object_triangles;
        options.texture_side = flags.texture_side;
        catalogue_.emplace(options);
        for (const std::filesystem::path& path : flags.catalogues) catalogue_->add(path);
        const auto is_plan = [&](const std::filesystem::path& path) { return same_file(path, plan_file); };
        if (takes_plan && plan_file.extension() == ".sh3d" && std::ranges::none_of(flags.catalogues, is_plan))
            catalogue_->add(plan_file);
    });
}

void Furniture::put_into(modeler::Building& building, Progress& progress) {
    const std::unique_ptr<accel::Executor> cores = render::make_executor();
    const plans::Plan plan = plans::read_json(building.plan_json, "the plan");
    if (has_scope(flags_)) made_.scope = furniture_scope(flags_, building, plan);
    progress.fraction(0.2);
    append(building.findings, catalogue_->findings());

    modeler::Furnishing furnishing;
    made_.plan_seconds = seconds_of([&] {
        if (flags_.no_plan_furniture) return;
        const std::vector<std::uint32_t> everything;
        furnishing = modeler::plan_objects(building, *catalogue_, made_.scope ? made_.scope->pieces : everything,
                                           building.findings);
    });
    progress.fraction(0.4);
    building.furnishing = std::move(furnishing);
    // An empty list means all rooms: a scope without rooms has none to furnish.
    if (rules_ && !(made_.scope && made_.scope->rooms.empty()))
        made_.rules_seconds = seconds_of([&] {
            modeler::FurnishOptions options{.seed = flags_.seed, .spaces = {}};
            if (made_.scope) options.spaces = made_.scope->rooms;
            modeler::Furnished furnished = modeler::furnish(building, *rules_, *catalogue_, options, *cores);
            append(building.findings, furnished.findings);
            made_.rooms = std::move(furnished.rooms);
            building.furnishing = std::move(furnished.furnishing);
        });
    progress.fraction(0.7);
    made_.put_seconds = seconds_of([&] {
        modeler::Furnishing all = std::move(building.furnishing);
        building.furnishing = {};
        all.cells = flags_.cut ? modeler::ObjectCells::Cut : modeler::ObjectCells::List;
        std::vector<Finding> findings;
        building = modeler::put_objects(building, std::move(all), findings, *cores);
        append(building.findings, findings);
    });
    count(building.furnishing);
}

void Furniture::count(const modeler::Furnishing& furnishing) {
    made_.meshes = furnishing.meshes.size();
    for (const auto& mesh : furnishing.meshes) made_.triangles += mesh->triangles.size();
    for (const modeler::FurnishedObject& object : furnishing.objects) {
        ++(object.by_rule ? made_.by_rule : made_.of_plan);
        made_.volumes += !object.volume.empty();
        made_.instanced_triangles += furnishing.meshes[object.mesh]->triangles.size();
    }
}

std::string Furniture::text() const {
    std::string text = counted(made_.of_plan + made_.by_rule, "object") + " of " +
                       counted(made_.triangles, "triangle") + " in " + counted(made_.meshes, "mesh", "meshes") + " (" +
                       grouped(made_.instanced_triangles) + " with all copies)";
    if (rules_)
        text += "; rules asked for " + grouped(made_.requested()) + " in " + counted(made_.rooms.size(), "room") +
                " and placed " + grouped(made_.by_rule);
    text += '.';
    if (made_.scope) {
        const FurnitureScope& scope = *made_.scope;
        text += " The scope is " + grouped(scope.rooms.size()) + " of " + counted(scope.all_rooms, "room") + ": from " +
                (flags_.views.empty()   ? "the rooms"
                 : flags_.rooms.empty() ? "the views"
                                        : "the rooms and views") +
                " named " + grouped(scope.scope.seen) + " of " + counted(scope.all_cells, "cell") +
                " can be seen, and " + grouped(scope.scope.cells.size() - scope.scope.seen) +
                " more matter to the light there.";
    }
    return text;
}

nlohmann::ordered_json Furniture::json(const modeler::Building& building) const {
    nlohmann::ordered_json json;
    json["rules"] = nullptr;
    if (rules_) json["rules"] = flags_.rules->empty() ? "own" : *flags_.rules;
    json["seed"] = flags_.seed;
    json["cells"] = flags_.cut ? "cut" : "list";
    json["scope"] = nullptr;
    if (made_.scope) {
        const FurnitureScope& scope = *made_.scope;
        nlohmann::ordered_json names = nlohmann::ordered_json::array();
        for (const std::uint32_t room : scope.rooms) names.push_back(building.spaces[room].id);
        json["scope"] = {{"rooms", std::move(names)},
                         {"of_rooms", scope.all_rooms},
                         {"spaces", scope.scope.spaces.size()},
                         {"of_spaces", scope.all_spaces},
                         {"cells", scope.scope.cells.size()},
                         {"of_cells", scope.all_cells},
                         {"seen_cells", scope.scope.seen},
                         {"darkening_cells", scope.scope.darkening},
                         {"sunlit_cells", scope.scope.sunlit},
                         {"lamplit_cells", scope.scope.lamplit},
                         {"lamps", scope.lamps}};
    }
    json["objects"] = made_.of_plan + made_.by_rule;
    json["of_plan"] = made_.of_plan;
    json["by_rule"] = made_.by_rule;
    json["requested"] = made_.requested();
    json["volumes"] = made_.volumes;
    json["meshes"] = made_.meshes;
    json["triangles"] = made_.triangles;
    json["instanced_triangles"] = made_.instanced_triangles;
    json["catalogue_entries"] = catalogue_->entries().size();
    json["rooms"] = nlohmann::ordered_json::array();
    for (const modeler::RoomFurnished& room : made_.rooms)
        json["rooms"].push_back({{"id", building.spaces[room.space].id},
                                 {"name", building.spaces[room.space].name},
                                 {"kind", room.kind},
                                 {"requested", room.requested},
                                 {"placed", room.placed},
                                 {"not_placed", room.not_placed}});
    json["seconds"] = {{"catalogue", made_.catalogue_seconds},
                       {"scope", made_.scope ? made_.scope->seconds : 0},
                       {"plan", made_.plan_seconds},
                       {"rules", made_.rules_seconds},
                       {"put", made_.put_seconds}};
    return json;
}

}  // namespace enfilade::tools

#include "tools/object_edit.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "base/error.h"
#include "modeler/catalogue/catalogue.h"
#include "modeler/objects/plan_objects.h"
#include "plans/number_text.h"
#include "tools/console.h"
#include "tools/suggestion.h"

namespace enfilade::tools {

namespace {

using modeler::Building;
using modeler::FurnishedObject;
using modeler::Furnishing;

const FurnishedObject& object_of(const Building& building, const std::string& id) {
    std::vector<std::string> known;
    for (const FurnishedObject& object : building.furnishing.objects) {
        if (object.id == id) return object;
        known.push_back(object.id);
    }
    throw InputError(
        "F119", "",
        "There is no object \"" + id + '"' + suggestion(id, known) + ": \"enfilade place SCENE.enf\" lists them.");
}

/// The object and all that stands on it, directly or not.
std::set<std::string> with_load(const Building& building, const std::string& id) {
    std::set<std::string> ids = {id};
    for (std::size_t before = 0; before != ids.size();) {
        before = ids.size();
        for (const FurnishedObject& object : building.furnishing.objects)
            if (ids.contains(object.stands_on)) ids.insert(object.id);
    }
    return ids;
}

std::string said(const char* done, const std::string& id, std::size_t count) {
    return std::string(done) + ' ' + id +
           (count > 1 ? " and what stands on it (" + counted(count - 1, "object") + ")" : "");
}

std::uint32_t space_of(const Building& building, const FurnishedObject& object) {
    const auto& [x, y, z] = object.position;
    const std::uint32_t space = modeler::space_at(building, x, y, z + std::min(0.5 * object.size[2], 0.05));
    if (space >= building.spaces.size())
        throw InputError("F120", "",
                         "(" + plans::rounded_text(x, 3) + ", " + plans::rounded_text(y, 3) + ", " +
                             plans::rounded_text(z, 3) +
                             ") lies in a wall, a slab or the ground, or beyond the site: choose a place in a room.");
    return space;
}

/// The objects of `ids`, turned about the first one's middle and moved with it.
EditedObjects carried(const Building& building, const FurnishedObject& first, const std::array<double, 3>& to,
                      double by, const char* done) {
    const std::set<std::string> ids = with_load(building, first.id);
    EditedObjects edited{building.furnishing, {ids.begin(), ids.end()}, said(done, first.id, ids.size())};
    const std::array<double, 3> from = first.position;
    FurnishedObject there = first;  // the place that was asked for, before those of what stands on it
    there.position = to;
    (void)space_of(building, there);
    const double c = std::cos(by), s = std::sin(by);
    for (FurnishedObject& object : edited.furnishing.objects) {
        if (!ids.contains(object.id)) continue;
        const double dx = object.position[0] - from[0], dy = object.position[1] - from[1];
        object.position = {to[0] + c * dx - s * dy, to[1] + s * dx + c * dy, to[2] + (object.position[2] - from[2])};
        object.angle += by;
        object.space = space_of(building, object);
        // It stands elsewhere now, unless it was carried.
        if (object.id == first.id && (to[0] != from[0] || to[1] != from[1] || to[2] != from[2]))
            object.stands_on.clear();
    }
    return edited;
}

/// The lowest floor of a room over the place.
double floor_at(const Building& building, double x, double y) {
    std::vector<double> floors;
    for (const modeler::StoreyInfo& storey : building.storeys) floors.push_back(building.frame.world_z(storey.z_floor));
    std::sort(floors.begin(), floors.end());
    for (const double z : floors) {
        const std::uint32_t space = modeler::space_at(building, x, y, z + 0.05);
        if (space < building.spaces.size() && building.spaces[space].label == accel::Label::Room) return z;
    }
    return floors.empty() ? 0 : floors.front();
}

std::string new_id(const Building& building, const std::string& model, const std::string& wanted) {
    const auto is_taken = [&](const std::string& id) {
        return std::ranges::any_of(building.furnishing.objects, [&](const auto& object) { return object.id == id; }) ||
               std::ranges::any_of(building.spaces, [&](const auto& space) { return space.id == id; });
    };
    if (!wanted.empty()) {
        if (is_taken(wanted))
            throw InputError("F122", "", "The id \"" + wanted + "\" is taken: give another with --id.");
        return wanted;
    }
    for (std::size_t k = 1;; ++k)
        if (std::string id = model + '-' + std::to_string(k); !is_taken(id)) return id;
}

/// What the catalogues know of a model, and its mesh among those of the furniture.
struct FoundModel {
    modeler::CatalogueEntry entry;
    std::uint32_t mesh = 0;
};

FoundModel find_model(const std::string& model, const std::vector<std::filesystem::path>& paths,
                      Furnishing& furnishing) {
    modeler::Catalogue catalogue;
    for (const std::filesystem::path& path : paths) catalogue.add(path);
    const modeler::CatalogueEntry* entry = catalogue.find(model);
    if (entry == nullptr)
        if (const auto of_kind = catalogue.of_kind(model); !of_kind.empty()) entry = of_kind.front();
    if (entry == nullptr) {
        std::vector<std::string> known;
        for (const modeler::CatalogueEntry& one : catalogue.entries()) known.insert(known.end(), {one.id, one.kind});
        throw InputError("F121", "",
                         "There is no model \"" + model + '"' + suggestion(model, known) +
                             " among our own pieces and the catalogues: --catalogue names more.");
    }
    modeler::ObjectMesh mesh = catalogue.load(*entry).mesh;
    const auto same = std::ranges::find_if(furnishing.meshes, [&](const auto& one) { return *one == mesh; });
    const auto number = std::uint32_t(same - furnishing.meshes.begin());
    if (same == furnishing.meshes.end())
        furnishing.meshes.push_back(std::make_shared<const modeler::ObjectMesh>(std::move(mesh)));
    return {*entry, number};
}

}  // namespace

PlaceAt parse_place(const std::string& text) {
    std::array<double, 3> numbers = {};
    std::size_t count = 0;
    const char* at = text.data();
    const char* const end = at + text.size();
    for (; count < 3; ++count) {
        const auto [stop, error] = std::from_chars(at, end, numbers[count]);
        if (error != std::errc() || !std::isfinite(numbers[count])) break;
        at = stop;
        if (at == end || *at != ',') {
            ++count;
            break;
        }
        if (count < 2) ++at;
    }
    if (at != end || count < 2)
        throw InputError("F117", "", "--at \"" + text + "\" is no place: give X,Y or X,Y,Z in metres, like 3.2,1.5.");
    PlaceAt place{numbers[0], numbers[1], std::nullopt};
    if (count == 3) place.z = numbers[2];
    return place;
}

EditedObjects moved(const Building& building, const std::string& id, const PlaceAt& at, std::optional<double> angle) {
    const FurnishedObject& object = object_of(building, id);
    return carried(building, object, {at.x, at.y, at.z.value_or(object.position[2])}, angle ? *angle - object.angle : 0,
                   "moved");
}

EditedObjects turned(const Building& building, const std::string& id, double by) {
    const FurnishedObject& object = object_of(building, id);
    return carried(building, object, object.position, by, "turned");
}

EditedObjects removed(const Building& building, const std::string& id) {
    (void)object_of(building, id);
    const std::set<std::string> ids = with_load(building, id);
    EditedObjects edited{building.furnishing, {ids.begin(), ids.end()}, said("removed", id, ids.size())};
    std::erase_if(edited.furnishing.objects, [&](const FurnishedObject& object) { return ids.contains(object.id); });
    return edited;
}

EditedObjects added(const Building& building, const std::string& model, const std::string& id, const PlaceAt& at,
                    double angle, const std::vector<std::filesystem::path>& catalogues) {
    EditedObjects edited{building.furnishing, {}, {}};
    const auto [entry, mesh] = find_model(model, catalogues, edited.furnishing);
    FurnishedObject object;
    object.id = new_id(building, entry.id, id);
    object.name = entry.name;
    object.model = entry.id;
    object.mesh = mesh;
    object.position = {at.x, at.y, at.z ? *at.z : floor_at(building, at.x, at.y) + entry.elevation};
    object.angle = angle;
    object.size = {entry.width, entry.depth, entry.height};
    object.space = space_of(building, object);
    object.by_rule = true;  // nobody has it in a plan already: it has to fit
    edited.ids = {object.id};
    edited.what = "added " + object.id;
    edited.furnishing.objects.push_back(std::move(object));
    return edited;
}

}  // namespace enfilade::tools

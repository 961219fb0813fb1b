#include "tools/furnished_floor.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "modeler/build.h"
#include "modeler/catalogue/catalogue.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "modeler/furnishing/rules.h"
#include "modeler/objects/put_objects.h"
#include "render/executor.h"
#include "tools/bench.h"

namespace enfilade::tools {

namespace {

template <class T>
std::size_t bytes_of(const accel::ArrayView<T>& array) {
    return array.size() * sizeof(T);
}

}  // namespace

std::size_t FurnishedFloor::instanced_triangles() const {
    std::size_t triangles = 0;
    for (const accel::PlacedObject& object : scene.view().objects)
        triangles += scene.view().meshes[index(object.mesh)].triangle_count;
    return triangles;
}

std::size_t FurnishedFloor::object_bytes() const {
    const accel::SceneView& view = scene.view();
    return bytes_of(view.meshes) + bytes_of(view.mesh_vertices) + bytes_of(view.mesh_triangles) +
           bytes_of(view.objects) + bytes_of(view.cell_object_offsets) + bytes_of(view.cell_objects);
}

std::size_t FurnishedFloor::room_bytes() const {
    std::size_t bytes = 0;
    for (const accel::SceneArray& array : scene.arrays())
        if (array.group == accel::Group::Trace) bytes += array.bytes.size();
    return bytes - object_bytes();
}

FurnishedFloor furnished_floor(std::string name, const plans::Plan& plan, const FloorOptions& options) {
    modeler::Building rooms;
    const double seconds = seconds_of([&] { rooms = modeler::convexify(modeler::build(plan)); });
    FurnishedFloor floor = furnished_floor(std::move(name), rooms, options);
    floor.times.rooms = seconds;
    return floor;
}

FurnishedFloor furnished_floor(std::string name, const modeler::Building& rooms, const FloorOptions& options) {
    const std::unique_ptr<accel::Executor> cores = render::make_executor();
    FurnishedFloor floor;
    floor.name = std::move(name);
    std::optional<modeler::Catalogue> catalogue;
    floor.times.catalogue = seconds_of([&] {
        catalogue.emplace(
            modeler::CatalogueOptions{.detail = options.detail, .object_triangles = options.object_triangles});
    });
    modeler::Furnished furnished;
    floor.times.placing = seconds_of([&] {
        furnished = modeler::furnish(rooms, modeler::own_rules(), *catalogue,
                                     {.seed = options.seed, .spaces = options.spaces}, *cores);
    });
    furnished.furnishing.cells = options.cells;
    floor.rooms = std::move(furnished.rooms);
    std::vector<Finding> findings;
    floor.times.putting = seconds_of(
        [&] { floor.building = modeler::put_objects(rooms, std::move(furnished.furnishing), findings, *cores); });
    floor.times.scene =
        seconds_of([&] { floor.scene = modeler::export_scene(floor.building, modeler::check(floor.building), "{}"); });
    return floor;
}

}  // namespace enfilade::tools

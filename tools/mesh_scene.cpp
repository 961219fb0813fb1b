#include "tools/mesh_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "accel/assemble.h"
#include "base/error.h"
#include "modeler/catalogue/file_tree.h"
#include "modeler/catalogue/fit_mesh.h"
#include "modeler/catalogue/read_model.h"
#include "tools/console.h"

namespace enfilade::tools {

namespace {

using accel::Surface;

constexpr std::int32_t plain_half = 1 << 21;  ///< grid units from the mesh to each side and up: 256 m
constexpr std::array<float, 3> clay = {0.56f, 0.50f, 0.44f};
constexpr std::uint32_t ground_material = 0, sky_material = 1, first_mesh_material = 2;

/// A square plain under a box of sky.
accel::SceneInput plain() {
    accel::SceneInput input;
    input.spaces.push_back({accel::Label::Exterior, "outdoors", "Outdoors", "", UINT32_MAX, 0});
    input.materials = {{"ground", {0.42f, 0.40f, 0.37f}}, {"sky", {0.50f, 0.68f, 0.92f}}};
    constexpr std::int32_t s = plain_half;
    constexpr std::int32_t corners[4][2] = {{-s, -s}, {s, -s}, {s, s}, {-s, s}};
    const auto add_face = [&](Surface surface, const std::vector<std::array<std::int32_t, 3>>& ring) {
        input.source_faces.push_back({surface, 0, surface == Surface::Sky ? sky_material : ground_material,
                                      static_cast<std::uint32_t>(input.vertices.size())});
        input.vertices.insert(input.vertices.end(), ring.begin(), ring.end());
        return accel::InputTarget{false, static_cast<std::uint32_t>(input.source_faces.size() - 1)};
    };
    accel::InputCell cell;
    cell.label = accel::Label::Exterior;
    cell.z_ceiling = s;
    // Rings run counter-clockwise seen from inside.
    cell.floor = add_face(Surface::Terrain, {{-s, -s, 0}, {s, -s, 0}, {s, s, 0}, {-s, s, 0}});
    cell.ceiling = add_face(Surface::Sky, {{-s, s, s}, {s, s, s}, {s, -s, s}, {-s, -s, s}});
    for (std::size_t k = 0; k < 4; ++k) {
        const auto& a = corners[k];
        const auto& b = corners[(k + 1) % 4];
        input.sections.push_back({a[0], a[1], static_cast<std::uint32_t>(k)});
        input.side_faces.push_back(
            {s, add_face(Surface::Sky, {{a[0], a[1], s}, {b[0], b[1], s}, {b[0], b[1], 0}, {a[0], a[1], 0}})});
    }
    input.cells.push_back(cell);
    return input;
}

/// What a file says nothing of comes in light grey, which is white in the sun.
std::array<float, 3> shown(const std::array<float, 3>& colour) {
    return colour == modeler::ObjectMaterial{}.colour ? clay : colour;
}

void stand(modeler::ObjectMesh mesh, accel::SceneInput& input) {
    for (modeler::ObjectMaterial& material : mesh.materials)
        input.materials.push_back({std::move(material.name), shown(material.colour)});
    for (std::uint32_t& material : mesh.triangle_materials) material += first_mesh_material;
    auto shared = std::make_shared<accel::InputMesh>();
    *shared = {mesh.name, std::move(mesh.vertices), std::move(mesh.triangles), std::move(mesh.triangle_materials)};
    accel::InputObject object;
    object.id = object.name = mesh.name;
    object.scene_from_object = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    input.meshes.push_back(std::move(shared));
    input.objects.push_back(std::move(object));
    input.cell_objects = {{0}};
}

}  // namespace

bool is_mesh_file(const std::filesystem::path& file) { return modeler::has_model_extension(file.filename().string()); }

MeshScene scene_of_mesh(const std::filesystem::path& file, std::optional<modeler::UpAxis> up) {
    const auto refuse = [&](const std::string& why) { throw InputError("F148", file.string(), why); };
    const std::unique_ptr<modeler::FileTree> files = modeler::open_file(file);
    const modeler::RawMesh raw = modeler::read_model(*files, file.filename().string(), modeler::ReadImages::Yes);
    MeshScene made;
    modeler::Fitting fitting;
    fitting.up = up;
    made.size = modeler::natural_size(raw, fitting);
    const double longest = *std::max_element(made.size.begin(), made.size.end());
    if (!(longest > 0)) refuse("All corners of this mesh lie in one point, so there is nothing to see.");
    made.scale = shown_mesh_size / longest;
    if (!std::isfinite(longest) || !std::isfinite(made.scale) || made.scale == 0)
        refuse("The corners of this mesh lie too near together or too far apart for numbers: give it another unit.");
    fitting.unit = made.scale;
    modeler::ObjectMesh mesh = modeler::fitted(raw, fitting, file.filename().string());
    made.triangles = mesh.triangles.size();
    if (mesh.triangles.empty()) refuse("All of this mesh is invisible.");
    made.defects = modeler::defects_of(mesh);
    made.defects.dropped = raw.dropped;
    if (made.defects.degenerate == made.triangles)
        refuse("No triangle of this mesh has an area, so there is nothing to see.");
    accel::SceneInput input = plain();
    stand(std::move(mesh), input);
    made.scene = accel::assemble(input);
    return made;
}

std::string MeshScene::report() const {
    std::string text = counted(triangles, "triangle");
    const auto say = [&](std::uint32_t count, const char* one, const char* many) {
        if (count > 0) text += ", " + grouped(count) + (count == 1 ? one : many);
    };
    say(defects.degenerate, " of them without area", " of them without area");
    say(defects.duplicate, " there twice", " there twice");
    say(defects.open_edges, " open edge", " open edges");
    say(defects.crowded_edges, " edge of three triangles or more", " edges of three triangles or more");
    constexpr const char* left_out = " more left out: a corner does not exist, is no number or lies beyond 1e12";
    say(defects.dropped, left_out, left_out);
    return text;
}

nlohmann::ordered_json MeshScene::json() const {
    return {{"triangles", triangles},
            {"degenerate", defects.degenerate},
            {"duplicate", defects.duplicate},
            {"open_edges", defects.open_edges},
            {"crowded_edges", defects.crowded_edges},
            {"left_out", defects.dropped},
            {"size", size},
            {"scale", scale}};
}

}  // namespace enfilade::tools

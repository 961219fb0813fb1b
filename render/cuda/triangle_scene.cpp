#include "render/cuda/triangle_scene.h"

#include <utility>

#include "base/error.h"
#include "render/ray.h"

namespace enfilade::render::cuda {
namespace {

constexpr std::size_t most_triangles = std::size_t{1} << 30;

bool has_area(const SceneTriangle& t) {
    const auto place = [](const accel::Vertex& v) { return Vec3f{v.x, v.y, v.z}; };
    if (!is_place(place(t.a)) || !is_place(place(t.b)) || !is_place(place(t.c))) return false;
    const Vec3d a = vec_cast<double>(place(t.a));
    const Vec3d normal = cross(vec_cast<double>(place(t.b)) - a, vec_cast<double>(place(t.c)) - a);
    return normal.x != 0 || normal.y != 0 || normal.z != 0;
}

BvhInstance instance_of(const accel::PlacedObject& object, std::uint32_t first_triangle) {
    BvhInstance instance = {};
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c)
            instance.object_from_scene[3 * r + c] = object.object_from_scene.rows[4 * r + c];
        instance.origin[r] = object.scene_from_object.rows[4 * r + 3];
    }
    instance.first_triangle = first_triangle;
    instance.look = no_look;
    return instance;
}

}  // namespace

TriangleScene::TriangleScene(const accel::SceneView& scene, bool is_bare) {
    detail::FaceMesh faces = detail::face_mesh(scene, FaceShapes::Triangles);
    looks = std::move(faces.looks);
    face_triangles = static_cast<std::uint32_t>(looks.size());
    std::size_t count = looks.size();
    if (!is_bare)
        for (const accel::ObjectMesh& mesh : scene.meshes) count += mesh.triangle_count;
    if (count > most_triangles) throw IoError("A tree holds 2^30 triangles at most: choose a smaller scene.");
    triangles.reserve(count);
    for (std::size_t k = 0; k < faces.corners.size(); k += 3)
        triangles.push_back({faces.vertices[faces.corners[k]], faces.vertices[faces.corners[k + 1]],
                             faces.vertices[faces.corners[k + 2]]});
    mesh_first.push_back(face_triangles);
    if (!is_bare) {
        meshes.assign(scene.meshes.begin(), scene.meshes.end());
        for (const accel::ObjectMesh& mesh : meshes) {
            add_triangles(scene, mesh);
            mesh_first.push_back(static_cast<std::uint32_t>(triangles.size()));
        }
        for (const accel::PlacedObject& object : scene.objects) add_object(scene, object);
    }
    find_those_to_hit();
}

TriangleScene TriangleScene::of_mesh(const accel::SceneView& scene, accel::MeshId mesh) {
    TriangleScene one;
    one.add_triangles(scene, scene.meshes[index(mesh)]);
    one.face_triangles = static_cast<std::uint32_t>(one.triangles.size());
    one.mesh_first.push_back(one.face_triangles);
    one.find_those_to_hit();
    return one;
}

void TriangleScene::add_triangles(const accel::SceneView& scene, const accel::ObjectMesh& mesh) {
    const accel::Vertex* vertices = scene.mesh_vertices.data() + mesh.first_vertex;
    for (std::uint32_t t = 0; t < mesh.triangle_count; ++t) {
        const accel::MeshTriangle& of = scene.mesh_triangles[mesh.first_triangle + t];
        triangles.push_back({vertices[of.corners[0]], vertices[of.corners[1]], vertices[of.corners[2]]});
        looks.push_back(detail::look_of(scene, of.material));
    }
}

void TriangleScene::add_object(const accel::SceneView& scene, const accel::PlacedObject& object) {
    BvhInstance instance = instance_of(object, mesh_first[index(object.mesh)]);
    if (object.material != none<accel::MaterialId>) {
        instance.look = static_cast<std::uint32_t>(looks.size());
        looks.push_back(detail::look_of(scene, object.material));
    }
    instances.push_back(instance);
    instance_boxes.push_back({object.low, object.high});
    mesh_of.push_back(static_cast<std::uint32_t>(object.mesh));
}

void TriangleScene::find_those_to_hit() {
    can_be_hit.reserve(triangles.size());
    for (const SceneTriangle& triangle : triangles) can_be_hit.push_back(has_area(triangle));
}

SahBox TriangleScene::box_of(std::uint32_t triangle) const {
    SahBox box = SahBox::none();
    box.add(triangles[triangle].a);
    box.add(triangles[triangle].b);
    box.add(triangles[triangle].c);
    return box;
}

}  // namespace enfilade::render::cuda

#pragma once
// What light finds where a ray ended: a colour, a mirror, glass, or shares of them. Included by loops alone, which are
// compiled once for each instruction set.

#include "render/rooms.h"
#include "render/texture.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

struct Surfacing {
    Vec3f colour = {0, 0, 0};   ///< diffuse reflectance of the share that is neither mirrored nor let through
    float diffuse = 1;          ///< that share
    float mirror = 0;           ///< share that goes on as from a mirror
    Vec3f through = {0, 0, 0};  ///< what goes straight on, by linear RGB
};

/// The numbers along a surface that its texture is laid by, and how they grow in the scene.
struct TexturePlane {
    float u, v;
    Vec3f grow_u, grow_v;
};

/// On a source face. normal: of length 1
ENFILADE_HD TexturePlane plane_of_face(const accel::FaceFrame& frame, Exit exit, Vec3f p) {
    TexturePlane plane;
    plane.grow_u = {frame.x_u, frame.y_u, 0};
    plane.grow_v = exit == Exit::Side ? Vec3f{0, 0, 1} : Vec3f{-frame.y_u, frame.x_u, 0};
    plane.u = dot(plane.grow_u, p) + frame.u_0;
    plane.v = dot(plane.grow_v, p) + frame.v_0;
    return plane;
}

ENFILADE_HD Vec3f placed(const accel::Placement& placement, const accel::Vertex& v) {
    const auto* m = reinterpret_cast<const float*>(&placement.rows);
    return {m[0] * v.x + m[1] * v.y + m[2] * v.z + m[3], m[4] * v.x + m[5] * v.y + m[6] * v.z + m[7],
            m[8] * v.x + m[9] * v.y + m[10] * v.z + m[11]};
}

/// On a triangle of an object: its corners' coordinates, between them by area.
ENFILADE_HD TexturePlane plane_of_triangle(const accel::SceneView& scene, std::uint32_t object, std::uint32_t triangle,
                                           Vec3f p) {
    const accel::PlacedObject& it = scene.objects[object];
    const accel::ObjectMesh& mesh = scene.meshes[static_cast<std::uint32_t>(it.mesh)];
    const accel::MeshTriangle& corners = scene.mesh_triangles[mesh.first_triangle + triangle];
    const auto* c = reinterpret_cast<const std::uint32_t*>(&corners.corners);
    const accel::Vertex* vertices = scene.mesh_vertices.data() + mesh.first_vertex;
    const Vec3f a = placed(it.scene_from_object, vertices[c[0]]);
    const Vec3f e1 = placed(it.scene_from_object, vertices[c[1]]) - a;
    const Vec3f e2 = placed(it.scene_from_object, vertices[c[2]]) - a;
    const Vec3f normal = cross(e1, e2);
    const float square = dot(normal, normal);
    if (!(square > 0)) return {0, 0, {0, 0, 0}, {0, 0, 0}};
    const Vec3f grow_1 = (1 / square) * cross(e2, normal), grow_2 = (1 / square) * cross(normal, e1);
    const accel::TexCoord* at = scene.mesh_texcoords.data() + (mesh.texcoords - 1) + 3 * triangle;
    TexturePlane plane;
    plane.grow_u = (at[1].u - at[0].u) * grow_1 + (at[2].u - at[0].u) * grow_2;
    plane.grow_v = (at[1].v - at[0].v) * grow_1 + (at[2].v - at[0].v) * grow_2;
    plane.u = at[0].u + dot(plane.grow_u, p - a);
    plane.v = at[0].v + dot(plane.grow_v, p - a);
    return plane;
}

/// What a beam of `width` metres that comes along `direction` covers of a texture on that plane. normal: of length 1
ENFILADE_HD TextureSpot spot_of(const accel::MaterialLook& look, const TexturePlane& plane, Vec3f direction,
                                Vec3f normal, float width) {
    constexpr float least_cosine = 1.0f / 64;
    const float inverse = 1 / length(direction);
    const Vec3f along = direction - dot(direction, normal) * normal;  // on the surface
    const float sine = length(along) * inverse;
    const float cosine = larger(magnitude(dot(direction, normal)) * inverse, least_cosine);
    // Any direction of the surface where the beam comes straight.
    const Vec3f any = magnitude(normal.x) < 0.5f ? Vec3f{1, 0, 0} : Vec3f{0, 1, 0};
    const Vec3f far = normalized(sine > 1e-4f ? along : cross(normal, any));
    const Vec3f sides[2] = {(width / cosine) * far, width * cross(normal, far)};
    TextureSpot spot;
    spot.s = texture_row(look, 0, plane.u, plane.v, 1);
    spot.t = texture_row(look, 1, plane.u, plane.v, 1);
    for (int k = 0; k < 2; ++k) {
        const float u = dot(plane.grow_u, sides[k]), v = dot(plane.grow_v, sides[k]);
        spot.side_s[k] = texture_row(look, 0, u, v, 0);
        spot.side_t[k] = texture_row(look, 1, u, v, 0);
    }
    return spot;
}

/// Without its texture.
ENFILADE_HD Surfacing plain_surfacing(const accel::SceneView& scene, std::uint32_t material) {
    Surfacing surfacing;
    const auto* c = reinterpret_cast<const float*>(&scene.materials[material].colour);
    surfacing.colour = {c[0], c[1], c[2]};
    if (!scene.has_looks()) return surfacing;
    const accel::MaterialLook& look = scene.material_looks[material];
    const auto* through = reinterpret_cast<const float*>(&look.through);
    surfacing.mirror = look.mirror;
    surfacing.through = {through[0], through[1], through[2]};
    surfacing.diffuse = larger(1 - look.mirror - largest_part(surfacing.through), 0.0f);
    return surfacing;
}

/// Where the texture is not, the surface is not.
ENFILADE_HD void lay_texture(const TextureSample& sample, Surfacing& surfacing) {
    surfacing.colour = sample.colour;
    surfacing.diffuse *= sample.alpha;
    surfacing.mirror *= sample.alpha;
    const float open = 1 - sample.alpha;
    surfacing.through = sample.alpha * surfacing.through + Vec3f{open, open, open};
}

/// Of a source face. width: of the beam there, metres. normal: of length 1
template <class T>
ENFILADE_HD Surfacing surfacing_of_face(const accel::SceneView& scene, const Ray<T>& ray, const WalkEnd<T>& end,
                                        Vec3f point, Vec3f normal, float width) {
    const auto face = end.target.bits;
    const auto material = static_cast<std::uint32_t>(scene.source_faces[face].material);
    Surfacing surfacing = plain_surfacing(scene, material);
    surfacing.through = {0, 0, 0};  // walls end the world of light
    surfacing.diffuse = 1 - surfacing.mirror;
    if (!scene.has_looks() || scene.face_frames.count == 0) return surfacing;
    const accel::MaterialLook& look = scene.material_looks[material];
    if (look.texture == static_cast<accel::TextureId>(0xffffffffu)) return surfacing;
    const TexturePlane plane = plane_of_face(scene.face_frames[face], end.exit, point);
    surfacing.colour =
        texture_mean(scene, look.texture, spot_of(look, plane, vec_cast<float>(ray.direction), normal, width)).colour;
    return surfacing;
}

/// Of a triangle of an object.
template <class T>
ENFILADE_HD Surfacing surfacing_of_object(const accel::SceneView& scene, const Ray<T>& ray, const ObjectHit<T>& hit,
                                          Vec3f normal, float width) {
    const std::uint32_t material = object_material(scene, hit.object, hit.triangle);
    Surfacing surfacing = plain_surfacing(scene, material);
    if (!scene.has_looks()) return surfacing;
    const accel::MaterialLook& look = scene.material_looks[material];
    const accel::PlacedObject& object = scene.objects[hit.object];
    if (look.texture == static_cast<accel::TextureId>(0xffffffffu) ||
        scene.meshes[static_cast<std::uint32_t>(object.mesh)].texcoords == 0)
        return surfacing;
    const Vec3f point = vec_cast<float>(ray.origin + hit.t * ray.direction);
    const TexturePlane plane = plane_of_triangle(scene, hit.object, hit.triangle, point);
    lay_texture(texture_mean(scene, look.texture, spot_of(look, plane, vec_cast<float>(ray.direction), normal, width)),
                surfacing);
    return surfacing;
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render

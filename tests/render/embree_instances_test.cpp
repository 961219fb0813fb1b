#include "render/embree_instances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "accel/assemble.h"
#include "render/oracle.h"
#include "render/trace.h"
#include "tests/render/walk_paths.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

/// A ball of triangles, each ring of them in another of two colours, squashed by nobody yet.
std::shared_ptr<const accel::InputMesh> ball(int rings, double radius) {
    auto mesh = std::make_shared<accel::InputMesh>();
    mesh->name = "ball";
    const int around = 2 * rings;
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < around; ++j) {
            const double polar = M_PI * i / rings, turn = 2 * M_PI * j / around;
            mesh->vertices.push_back({static_cast<float>(radius * std::sin(polar) * std::cos(turn)),
                                      static_cast<float>(radius * std::sin(polar) * std::sin(turn)),
                                      static_cast<float>(radius - radius * std::cos(polar))});
        }
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < around; ++j) {
            const auto at = [&](int row, int k) { return static_cast<std::uint32_t>(row * around + k % around); };
            mesh->triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
            mesh->triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
            mesh->triangle_materials.insert(mesh->triangle_materials.end(), 2, static_cast<std::uint32_t>(i % 2));
        }
    return mesh;
}

/// One triangle, upright.
std::shared_ptr<const accel::InputMesh> sail() {
    auto mesh = std::make_shared<accel::InputMesh>();
    mesh->name = "sail";
    mesh->vertices = {{-0.5f, 0, 0}, {0.5f, 0, 0}, {0, 0.1f, 1.5f}};
    mesh->triangles = {{0, 1, 2}};
    mesh->triangle_materials = {1};
    return mesh;
}

/// Balls and sails in an office: turned, leaning, mirrored, of other proportions; every third of one colour.
accel::Scene furnished_office() {
    accel::SceneInput input = test::synthetic_office({.rooms_per_row = 3, .rows = 2});
    const auto paint = static_cast<std::uint32_t>(input.materials.size());
    input.materials.push_back({"red", {0.7f, 0.1f, 0.1f}});
    input.materials.push_back({"green", {0.1f, 0.6f, 0.2f}});
    input.materials.push_back({"blue", {0.1f, 0.2f, 0.7f}});
    const auto painted = [&](const std::shared_ptr<const accel::InputMesh>& mesh) {
        auto copy = std::make_shared<accel::InputMesh>(*mesh);
        for (std::uint32_t& material : copy->triangle_materials) material += paint;
        return copy;
    };
    input.meshes = {painted(ball(9, 0.4)), painted(sail()), std::make_shared<accel::InputMesh>()};
    std::mt19937_64 random(3);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    for (int k = 0; k < 24; ++k) {
        const double turn = between(0, 6.28), lean = k % 4 == 3 ? between(-0.5, 0.5) : 0;
        const double c = std::cos(turn), s = std::sin(turn), sx = between(0.5, 2) * (k % 5 == 0 ? -1 : 1);
        const double sy = between(0.5, 1.5), sz = between(0.5, 1.5);
        accel::InputObject object;
        object.id = "object-" + std::string(k < 10 ? "0" : "") + std::to_string(k);
        object.mesh = k == 7 ? 2 : static_cast<std::uint32_t>(k % 2);
        if (k % 3 == 0) object.material = paint + 2;
        object.scene_from_object = {c * sx, -s * sy,        lean * sz, between(1, 12), s * sx, c * sy,
                                    0,      between(1, 12), 0,         lean * sy,      sz,     between(0, 1)};
        input.objects.push_back(object);
    }
    input.cell_objects.resize(input.cells.size());
    return accel::assemble(input);
}

/// What a ray meets first, by trying everything.
struct Met {
    double distance = INFINITY;  ///< in lengths of the direction
    accel::ObjectId object = none<accel::ObjectId>;
    std::uint32_t triangle = no_triangle;
    accel::SourceFaceId face = none<accel::SourceFaceId>;
    Vec3d normal = {0, 0, 1};
};

Vec3d corner(const accel::SceneView& scene, const accel::PlacedObject& object, std::uint32_t vertex) {
    const accel::Vertex& v = scene.mesh_vertices[scene.meshes[index(object.mesh)].first_vertex + vertex];
    const auto row = [&](std::size_t r) {
        const float* m = object.scene_from_object.rows.data() + 4 * r;
        return double{m[0]} * double{v.x} + double{m[1]} * double{v.y} + double{m[2]} * double{v.z} + double{m[3]};
    };
    return {row(0), row(1), row(2)};
}

class BruteForce {
public:
    explicit BruteForce(const accel::SceneView& scene) : scene_(scene), oracle_(scene) {}

    /// d: of length 1
    [[nodiscard]] Met meet(Vec3d o, Vec3d d) const {
        Met met;
        if (const auto hit = oracle_.trace(o, d)) {
            met.distance = hit->distance;
            met.face = hit->source_face;
        }
        for (std::uint32_t k = 0; k < scene_.objects.size(); ++k) meet_object(o, d, k, met);
        return met;
    }

private:
    void meet_object(Vec3d o, Vec3d d, std::uint32_t k, Met& met) const {
        const accel::PlacedObject& object = scene_.objects[k];
        const accel::ObjectMesh& mesh = scene_.meshes[index(object.mesh)];
        for (std::uint32_t t = 0; t < mesh.triangle_count; ++t) {
            const auto& corners = scene_.mesh_triangles[mesh.first_triangle + t].corners;
            const Vec3d a = corner(scene_, object, corners[0]), ab = corner(scene_, object, corners[1]) - a,
                        ac = corner(scene_, object, corners[2]) - a;
            const Vec3d p = cross(d, ac);
            const double determinant = dot(ab, p);
            if (std::abs(determinant) < 1e-15) continue;
            const double u = dot(o - a, p) / determinant;
            const Vec3d q = cross(o - a, ab);
            const double v = dot(d, q) / determinant, distance = dot(ac, q) / determinant;
            if (u < 0 || v < 0 || u + v > 1 || distance < 0 || distance >= met.distance) continue;
            met = {distance, static_cast<accel::ObjectId>(k), t, none<accel::SourceFaceId>, cross(ab, ac)};
        }
    }

    accel::SceneView scene_;
    Oracle oracle_;
};

struct Rays {
    std::vector<float> o[3], d[3];
    std::vector<Met> met;

    Rays(const accel::SceneView& scene, int count) {
        std::mt19937_64 random(29);
        const BruteForce force(scene);
        for (int i = 0; i < count; ++i) {
            const auto cell = static_cast<std::uint32_t>(random() % scene.cells.size());
            const Vec3f p = vec_cast<float>(test::random_point(scene, cell, random));
            const Vec3f along = vec_cast<float>(test::random_direction(random));
            o[0].push_back(p.x), o[1].push_back(p.y), o[2].push_back(p.z);
            d[0].push_back(along.x), d[1].push_back(along.y), d[2].push_back(along.z);
            met.push_back(force.meet(vec_cast<double>(p), vec_cast<double>(along)));
            if (!std::isfinite(met.back().distance)) throw std::logic_error("a ray that meets nothing");
        }
    }
    [[nodiscard]] RayColumns columns() const { return {o[0], o[1], o[2], d[0], d[1], d[2], {}, {}}; }
};

constexpr std::array all_objects = {EmbreeObjects::Instanced, EmbreeObjects::OneLevel, EmbreeObjects::Flattened};

TEST(EmbreeInstances, MeetWhatBruteForceMeetsInEveryWay) {
    const accel::Scene scene = furnished_office();
    const Rays rays(scene.view(), 20'003);
    const std::size_t count = rays.met.size();
    for (const EmbreeObjects objects : all_objects) {
        const EmbreeInstances embree(scene.view(), objects);
        for (const EmbreeWay way : embree_ways) {
            std::vector<float> distance(count);
            std::vector<accel::SourceFaceId> face(count);
            std::vector<accel::ObjectId> object(count);
            std::vector<std::uint32_t> triangle(count);
            std::vector<WalkStatus> status(count);
            embree.nearest(rays.columns(), {distance, face, {}, status, object, triangle}, way,
                           accel::SerialExecutor());
            int others = 0, objects_met = 0, far = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const Met& met = rays.met[i];
                const bool is_object = met.object != none<accel::ObjectId>;
                objects_met += is_object;
                others += object[i] != met.object || triangle[i] != met.triangle || face[i] != met.face ||
                          status[i] != (is_object ? WalkStatus::Object : WalkStatus::Hit);
                far += std::abs(double{distance[i]} - met.distance) > 1e-3;
            }
            EXPECT_GT(objects_met, 200);
            EXPECT_LE(others, 12) << text(way);  // through edges
            EXPECT_LE(far, 6) << text(way);
        }
    }
}

TEST(EmbreeInstances, SeeAsFarAsTheNearestThingInEveryWay) {
    const accel::Scene scene = furnished_office();
    const Rays from(scene.view(), 5'001);
    const std::size_t count = from.met.size();
    Rays to = from;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            to.o[k][i] += static_cast<float>(from.met[i].distance * (i % 3 == 0 ? 0.99 : 1.01)) * from.d[k][i];
    const SegmentColumns segments = {from.o[0], from.o[1], from.o[2], to.o[0], to.o[1], to.o[2], {}, {}};
    for (const EmbreeObjects objects : all_objects) {
        const EmbreeInstances embree(scene.view(), objects);
        for (const EmbreeWay way : embree_ways) {
            std::vector<std::uint8_t> visible(count, 2);
            embree.visible(segments, visible, way, accel::SerialExecutor());
            int wrong = 0;
            for (std::size_t i = 0; i < count; ++i) wrong += visible[i] != (i % 3 == 0 ? 1 : 0);
            EXPECT_LE(wrong, 6) << text(way);
        }
    }
}

/// Lambert's light on what was met, as a framebuffer has it.
std::uint32_t pixel_of(const accel::SceneView& scene, const Met& met, Vec3d direction) {
    const accel::PlacedObject& object = scene.objects[index(met.object)];
    const accel::ObjectMesh& mesh = scene.meshes[index(object.mesh)];
    const accel::MaterialId material = object.material != none<accel::MaterialId>
                                           ? object.material
                                           : scene.mesh_triangles[mesh.first_triangle + met.triangle].material;
    const double cosine = std::abs(dot(met.normal, direction)) / (length(met.normal) * length(direction));
    const auto& colour = scene.materials[index(material)].colour;
    return encoded({static_cast<float>(double{colour[0]} * cosine), static_cast<float>(double{colour[1]} * cosine),
                    static_cast<float>(double{colour[2]} * cosine)});
}

TEST(EmbreeInstances, ShadeObjectsByTheirNormalAndColourInEveryWay) {
    const accel::Scene scene = furnished_office();
    const accel::SceneView& view = scene.view();
    const BruteForce force(view);
    constexpr int side = 96;
    Camera camera;
    camera.eye = {2, 6.4, 1.6};
    camera.target = {10, 6, 1.2};
    camera.fov_deg = 100;
    camera.width = camera.height = side;
    const CameraFrame frame = make_frame(camera);
    std::vector<std::uint32_t> expected(side * side, 0);
    int seen = 0;
    for (int pixel = 0; pixel < side * side; ++pixel) {
        const Vec3d along = vec_cast<double>(frame.direction(float(pixel % side) + 0.5f, float(pixel / side) + 0.5f));
        const Met met = force.meet(vec_cast<double>(frame.origin), normalized(along));
        if (met.object == none<accel::ObjectId>) continue;
        expected[static_cast<std::size_t>(pixel)] = pixel_of(view, met, along);
        ++seen;
    }
    EXPECT_GT(seen, 200);
    for (const EmbreeObjects objects : all_objects) {
        const EmbreeInstances embree(view, objects);
        for (const EmbreeWay way : embree_ways) {
            Framebuffer picture(side, side);
            embree.trace_lambert(frame, way, accel::SerialExecutor(), picture);
            int wrong = 0;
            for (std::size_t i = 0; i < expected.size(); ++i)
                for (int shift = 0; shift < 24 && expected[i] != 0; shift += 8)
                    wrong += std::abs(static_cast<int>(expected[i] >> shift & 255u) -
                                      static_cast<int>(picture.rgba[i] >> shift & 255u)) > 1;
            EXPECT_LE(wrong, 12) << text(way);
        }
    }
}

}  // namespace
}  // namespace enfilade::render

// What the options of furniture cost and err: how fine pieces are, how cells know objects, who looks inside of them,
// and how much of a building is furnished.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>

#include "modeler/build.h"
#include "modeler/catalogue/catalogue.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "modeler/objects/put_objects.h"
#include "modeler/objects/scope.h"
#include "render/executor.h"
#include "render/trace.h"
#include "tools/bench_dial.h"
#include "tools/bench_furnished.h"
#include "tools/examples.h"

namespace enfilade::tools {

namespace {

constexpr int side = 512;
constexpr std::size_t view_count = 4;

/// Pictures of the same views in several scenes of one floor.
class ObjectDial {
public:
    ObjectDial(Bench& bench, std::string name, const plans::Plan& plan)
        : bench_(&bench), name_(std::move(name)), rooms_(modeler::convexify(modeler::build(plan))) {
        const accel::Scene bare = modeler::export_scene(rooms_, {}, "{}");
        cameras_ = floor_views(bare.view(), view_count, side);
        scope_scene_ = modeler::export_scene(rooms_, {}, "{}");
    }

    void detail() {
        const Drawn finest = drawn(furnished_floor(name_, rooms_, {.detail = 4}), render::ObjectAccelKind::Bvh);
        for (std::uint32_t detail = 1; detail <= 4; ++detail)
            add("detail " + std::to_string(detail), furnished_floor(name_, rooms_, {.detail = detail}), finest);
    }

    /// A scanned mesh before a camera, with fewer and fewer triangles.
    void object_triangles() {
        const std::filesystem::path file = bench_->data() / "mesh" / "cgal_armadillo.off";
        if (!std::filesystem::exists(file)) {
            bench_->remark("object-triangles is not measured: there is no " + file.string() + " (--data).");
            return;
        }
        const modeler::LoadedMesh whole = scanned(file, 0);
        const std::vector<render::Camera> cameras = {scan_camera()};
        const auto drawn_one = [&](const modeler::ObjectMesh& mesh) {
            return drawn(with_one(mesh, cameras.front()), render::ObjectAccelKind::Bvh, cameras);
        };
        const Drawn finest = drawn_one(whole.mesh);
        for (const std::uint32_t most : {0u, 16'000u, 4'000u, 1'000u, 250u}) {
            const std::string setting = "object-triangles " + std::to_string(most);
            modeler::LoadedMesh mesh;
            const double seconds = seconds_of([&] { mesh = scanned(file, most); });
            const Drawn own = drawn_one(mesh.mesh);
            row(setting + ": time", seconds + own.accel_seconds, "s");
            row(setting + ": memory", own.accel_bytes / 1e6, "MB");
            row(setting + ": triangles", double(mesh.mesh.triangles.size()), "triangles");
            row(setting + ": surface moved at most", mesh.error * scan_width / width_of(whole.mesh) * 1000, "mm");
            row(setting + ": speed", own.speed, "Mrays/s");
            row(setting + ": other pixels", unlike(finest, own), "per million");
        }
    }

    void cells() {
        const Drawn listed = drawn(furnished_floor(name_, rooms_, {}), render::ObjectAccelKind::Bvh);
        add("objects list", furnished_floor(name_, rooms_, {}), listed);
        add("objects cut", furnished_floor(name_, rooms_, {.cells = modeler::ObjectCells::Cut}), listed);
    }

    void accel() {
        const FurnishedFloor floor = furnished_floor(name_, rooms_, {});
        const Drawn finest = drawn(floor, render::ObjectAccelKind::Bvh);
        for (const auto& [kind, setting] : {std::pair{render::ObjectAccelKind::Bvh, "object-accel bvh"},
                                            std::pair{render::ObjectAccelKind::Plain, "object-accel plain"},
                                            std::pair{render::ObjectAccelKind::Octree, "object-accel octree"}}) {
            const Drawn other = drawn(floor, kind);
            row(std::string(setting) + ": time", other.accel_seconds, "s");
            row(std::string(setting) + ": memory", other.accel_bytes / 1e6, "MB");
            row(std::string(setting) + ": speed", other.speed, "Mrays/s");
            row(std::string(setting) + ": other pixels", unlike(finest, other), "per million");
        }
    }

    /// Rooms that can be seen from one room, from one camera, all.
    void scope() {
        const accel::SceneView& scene = scope_scene_.view();
        const PreparedView view = prepared(scene, {cameras_.front()}).front();
        modeler::ScopeEyes room, one_view;
        room.rooms = {scene.cells[index(view.start)].space};
        one_view.points = {{view.start, {cameras_.front().eye.x, cameras_.front().eye.y, cameras_.front().eye.z}}};
        add_scope("scope view", &one_view);
        add_scope("scope room", &room);
        add_scope("scope all", nullptr);
    }

private:
    struct Drawn {
        std::vector<render::Framebuffer> pictures;
        double speed = 0;
        double accel_seconds = 0;
        double accel_bytes = 0;
    };

    [[nodiscard]] static double width_of(const modeler::ObjectMesh& mesh) {
        float low = INFINITY, high = -INFINITY;
        for (const auto& vertex : mesh.vertices) low = std::min(low, vertex[0]), high = std::max(high, vertex[0]);
        return double(high) - double(low);
    }

    void row(std::string what, double value, std::string unit) {
        bench_->add({.row = std::move(what), .scene = name_, .value = value, .unit = std::move(unit)});
    }

    /// A mesh of a file, at most so many triangles of it.
    [[nodiscard]] static modeler::LoadedMesh scanned(const std::filesystem::path& file, std::uint32_t most) {
        modeler::Catalogue catalogue({.object_triangles = most, .use_cache = false});
        catalogue.add(file);
        return catalogue.load(catalogue.entries().front());
    }

    /// The width that the scanned mesh is shown with, and how far it stands from the camera: metres.
    static constexpr double scan_width = 0.5, scan_distance = 1;

    /// In the largest cell of a room, towards its middle.
    [[nodiscard]] render::Camera scan_camera() const {
        const accel::SceneView& scene = scope_scene_.view();
        render::Camera best;
        double largest = 0;
        for (std::size_t c = 0; c < scene.cells.size(); ++c) {
            const accel::Cell& cell = scene.cells[c];
            double twice = 0;
            render::Vec3d middle = {0, 0, cell.z_floor + 1.2};
            for (std::uint32_t i = 0; i < cell.section_count; ++i) {
                const std::uint32_t p = cell.first_section + i, q = cell.first_section + (i + 1) % cell.section_count;
                twice +=
                    double(scene.section_x[p]) * scene.section_y[q] - double(scene.section_x[q]) * scene.section_y[p];
                middle = middle + (1.0 / cell.section_count) * render::Vec3d{scene.section_x[p], scene.section_y[p], 0};
            }
            if (cell.label != accel::Label::Room || twice <= largest) continue;
            largest = twice;
            best.target = middle;
            best.eye = middle - render::Vec3d{scan_distance, 0, 0};
        }
        best.width = best.height = side;
        return best;
    }

    /// The rooms with nothing but this mesh, which the camera looks at.
    [[nodiscard]] accel::Scene with_one(const modeler::ObjectMesh& mesh, const render::Camera& camera) const {
        const accel::SceneView& bare = scope_scene_.view();
        modeler::FurnishedObject object;
        object.id = "scan";
        object.space =
            std::uint32_t(index(bare.cells[index(render::start_cell(bare, render::make_frame(camera)))].space));
        const render::Vec3d at = camera.target;
        object.position = {at.x + bare.origin[0], at.y + bare.origin[1], at.z - scan_width / 2 + bare.origin[2]};
        object.size = {scan_width, scan_width, scan_width};
        modeler::Furnishing one;
        one.meshes.push_back(std::make_shared<const modeler::ObjectMesh>(mesh));
        one.objects.push_back(std::move(object));
        std::vector<Finding> findings;
        return modeler::export_scene(modeler::put_objects(rooms_, std::move(one), findings), {}, "{}");
    }

    [[nodiscard]] Drawn drawn(const FurnishedFloor& floor, render::ObjectAccelKind kind) const {
        return drawn(floor.scene, kind, cameras_);
    }
    [[nodiscard]] Drawn drawn(const accel::Scene& of, render::ObjectAccelKind kind,
                              const std::vector<render::Camera>& cameras) const {
        Drawn drawn;
        const accel::SceneView& scene = of.view();
        const accel::SerialExecutor one;
        std::unique_ptr<render::ObjectAccel> accel;
        drawn.accel_seconds = seconds_of([&] { accel = render::build_object_accel(scene, kind, one); });
        drawn.accel_bytes = double(accel->bytes());
        const render::ObjectTracer objects = accel->tracer();
        const std::vector<PreparedView> views = prepared(scene, cameras);
        drawn.pictures.assign(views.size(), render::Framebuffer(side, side));
        const std::array<std::function<void()>, 1> work = {[&] {
            for (std::size_t k = 0; k < views.size(); ++k)
                render::trace_lambert(scene, views[k].frame, views[k].start, {.objects = &objects}, one,
                                      drawn.pictures[k]);
        }};
        drawn.speed =
            double(side) * side * double(views.size()) / Contest(bench_->quick() ? 1 : 5, work).median_of(0) / 1e6;
        return drawn;
    }

    [[nodiscard]] static double unlike(const Drawn& a, const Drawn& b) {
        std::uint64_t pixels = 0, unlike = 0;
        for (std::size_t k = 0; k < a.pictures.size(); ++k) {
            pixels += a.pictures[k].rgba.size();
            unlike += unlike_pixels(a.pictures[k], b.pictures[k]);
        }
        return 1e6 * double(unlike) / double(pixels);
    }

    void add(const std::string& setting, const FurnishedFloor& floor, const Drawn& finest) {
        const Drawn own = drawn(floor, render::ObjectAccelKind::Bvh);
        row(setting + ": time", floor.times.all(), "s");
        row(setting + ": memory", (double(floor.object_bytes() + floor.room_bytes()) + own.accel_bytes) / 1e6, "MB");
        row(setting + ": triangles", double(floor.unique_triangles()), "triangles");
        row(setting + ": speed", own.speed, "Mrays/s");
        row(setting + ": other pixels", unlike(finest, own), "per million");
    }

    void add_scope(const std::string& setting, const modeler::ScopeEyes* eyes) {
        std::vector<std::uint32_t> spaces;
        double seconds = 0;
        if (eyes != nullptr) {
            modeler::Scope scope;
            seconds = seconds_of([&] { scope = modeler::scope_of(scope_scene_.view(), *eyes, {}); });
            for (const accel::SpaceId space : scope.spaces)
                if (scope_scene_.view().spaces[index(space)].label == accel::Label::Room)
                    spaces.push_back(std::uint32_t(index(space)));
        }
        const FurnishedFloor floor = furnished_floor(name_, rooms_, {.spaces = spaces});
        const Drawn own = drawn(floor, render::ObjectAccelKind::Bvh);
        // The catalogue is the same for all.
        row(setting + ": time", seconds + floor.times.all() - floor.times.catalogue + own.accel_seconds, "s");
        row(setting + ": memory", (double(floor.object_bytes()) + own.accel_bytes) / 1e6, "MB");
        row(setting + ": rooms", double(eyes != nullptr ? spaces.size() : floor.rooms.size()), "rooms");
        row(setting + ": objects", double(floor.scene.view().objects.size()), "objects");
    }

    Bench* bench_;
    std::string name_;
    modeler::Building rooms_;
    std::vector<render::Camera> cameras_;
    accel::Scene scope_scene_;
};

}  // namespace

void dial_objects(Bench& bench) {
    const ExamplePlan example = example_plan(bench, "office-46", 46);
    ObjectDial dial(bench, example.name, example.plan);
    dial.detail();
    dial.object_triangles();
    dial.cells();
    dial.accel();
    dial.scope();
}

}  // namespace enfilade::tools

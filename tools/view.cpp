#include "tools/view.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "render/trace_rays.h"
#include "tools/console.h"
#include "tools/visible_rooms.h"

namespace enfilade::tools {

namespace {

using accel::Label;
using render::Vec3d;

constexpr double eye_height = 1.6;
constexpr double cut_height = 2.0;   ///< of a dollhouse, above the floor: doors are open at it
constexpr double shown_below = 3;    ///< metres under the floor of a dollhouse
constexpr double wall_margin = 0.5;  ///< around the rooms of a storey, for the walls that are no cells
constexpr const char* help =
    "from where: exterior (from the garden), aerial (from above), dollhouse or dollhouse:STOREY (one storey, cut open; "
    "storeys count from 0), or X,Y,Z:X,Y,Z (the eye, and what it looks at; metres, as in the plan). (dollhouse; of a "
    "mesh exterior)";

struct Box {
    Vec3d low = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                 std::numeric_limits<double>::infinity()};
    Vec3d high = -low;
    void add(const Vec3d& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    [[nodiscard]] bool empty() const { return !(low.x <= high.x); }
    [[nodiscard]] Vec3d middle() const { return 0.5 * (low + high); }
    [[nodiscard]] std::array<Vec3d, 8> corners() const {
        std::array<Vec3d, 8> all;
        for (unsigned k = 0; k < 8; ++k)
            all[k] = {(k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y, (k & 4) != 0 ? high.z : low.z};
        return all;
    }
};

/// Box of the cells that `wanted` takes.
template <class Wanted>
Box box_of(const accel::SceneView& scene, const Wanted& wanted) {
    Box box;
    for (const accel::Cell& cell : scene.cells) {
        if (!wanted(cell)) continue;
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
            box.add({scene.section_x[s], scene.section_y[s], cell.z_floor});
            box.add({scene.section_x[s], scene.section_y[s], cell.z_ceiling});
        }
    }
    return box;
}

const accel::Space& space_of(const accel::SceneView& scene, const accel::Cell& cell) {
    return scene.spaces[index(cell.space)];
}

/// What people built: all cells but the outdoors; where there are none, what stands outdoors.
Box building_box(const accel::SceneView& scene) {
    Box box = box_of(scene, [](const accel::Cell& cell) { return cell.label != Label::Exterior; });
    if (!box.empty()) return box;
    for (const accel::PlacedObject& object : scene.objects) {
        box.add({object.low[0], object.low[1], object.low[2]});
        box.add({object.high[0], object.high[1], object.high[2]});
    }
    if (box.empty())
        throw InputError("F106", "", "There is no room in this scene to take a picture of: give --camera X,Y,Z:X,Y,Z.");
    return box;
}

/// Axes of a camera that looks along `-back`.
struct Axes {
    Vec3d right, up, back;
    explicit Axes(Vec3d direction) {
        back = render::normalized(direction);
        right = render::normalized(render::cross(Vec3d{0, 0, 1}, back));
        up = render::cross(back, right);
    }
};

/// The camera that sees `box` whole from the side of `direction`, with a margin.
render::Camera fitted(const Box& box, Vec3d direction, double fov_deg, int width, int height) {
    const Axes axes(direction);
    const double longer = std::tan(fov_deg / 2 * std::numbers::pi / 180) / 1.06;
    const double across = width >= height ? longer : longer * width / height;
    const double along = width >= height ? longer * height / width : longer;
    // Slide the eye back until every corner lies between the sides of the picture; then aim at their middle.
    double distance = 0;
    for (const Vec3d& corner : box.corners()) {
        const Vec3d p = corner - box.middle();
        const double depth = render::dot(p, axes.back);
        distance = std::max({distance, depth + std::abs(render::dot(p, axes.right)) / across,
                             depth + std::abs(render::dot(p, axes.up)) / along});
    }
    render::Camera camera;
    camera.eye = box.middle() + distance * axes.back;
    camera.target = box.middle();
    camera.fov_deg = fov_deg;
    camera.width = width;
    camera.height = height;
    return camera;
}

View dollhouse(const accel::SceneView& scene, std::uint32_t storey, int width, int height) {
    Box box = box_of(scene, [&](const accel::Cell& cell) {
        return space_of(scene, cell).storey_index == storey && cell.label == Label::Room;
    });
    if (box.empty()) {
        std::uint32_t count = 0;
        for (const accel::Space& space : scene.spaces)
            if (space.label == Label::Room) count = std::max(count, space.storey_index + 1);
        throw InputError("F107", "",
                         "There is no storey " + std::to_string(storey) + " with rooms: this scene has " +
                             counted(count, "storey") + ", counted from 0.");
    }
    View view;
    view.cut_z = box.low.z + std::min(cut_height, 0.8 * (box.high.z - box.low.z));
    box.high.z = *view.cut_z;
    // An upper storey stands on what is below it: some of that is shown, too.
    const Box outdoors = box_of(scene, [](const accel::Cell& cell) { return cell.label == Label::Exterior; });
    const double below = outdoors.empty() ? 0 : std::clamp(box.low.z - outdoors.low.z, 0.0, shown_below);
    box.low = box.low - Vec3d{wall_margin, wall_margin, below};
    box.high = box.high + Vec3d{wall_margin, wall_margin, 0};
    view.camera = fitted(box, {0.28, -0.62, 0.9}, 36, width, height);
    return view;
}

/// Height of the highest roof; of the building where none is seen.
double roof_height(const accel::SceneView& scene, const Box& building) {
    double height = building.high.z;
    for (std::size_t f = 0; f < scene.source_face_count(); ++f)
        if (scene.source_faces[f].surface == accel::Surface::Roof)
            height = std::max(height, double(scene.vertices[scene.source_faces[f].first_vertex].z));
    return height;
}

/// From above, with the air over the roof taken off, so that the sky's box is not in the way.
View aerial(const accel::SceneView& scene, int width, int height) {
    const Box site = box_of(scene, [](const accel::Cell&) { return true; });
    Box building = building_box(scene);
    building.high.z = roof_height(scene, building);
    View view;
    view.cut_z = std::min(building.high.z + 0.05, site.high.z - 4 * scene.unit);
    view.camera = fitted(building, {0.6, -0.8, 0.62}, 40, width, height);
    return view;
}

/// From the corner of the site on the sun's side, as far as the site goes; a single object from somewhat above.
View exterior(const accel::SceneView& scene, int width, int height) {
    const Box building = building_box(scene);
    if (std::ranges::all_of(scene.cells, [](const accel::Cell& cell) { return cell.label == Label::Exterior; })) {
        View view;
        view.camera = fitted(building, {0.42, -0.85, 0.3}, 30, width, height);
        return view;
    }
    const Box outdoors = box_of(scene, [](const accel::Cell& cell) { return cell.label == Label::Exterior; });
    if (outdoors.empty()) throw InputError("F106", "", "This scene has no outdoors: choose another --camera.");
    const double inside = 0.25;  // metres from the end of the site
    const double eye_top = outdoors.low.z + std::max(eye_height, 0.75 * (building.high.z - outdoors.low.z));
    View view;
    view.camera = fitted(building, {0.75, -0.85, 0.16}, 60, width, height);
    Vec3d& eye = view.camera.eye;
    eye = {std::clamp(eye.x, outdoors.low.x + inside, outdoors.high.x - inside),
           std::clamp(eye.y, outdoors.low.y + inside, outdoors.high.y - inside),
           std::clamp(eye.z, outdoors.low.z + eye_height, std::max(eye_top, outdoors.low.z + eye_height))};
    // Nearer than asked for: open the lens until the building is in the picture.
    const Axes axes(eye - view.camera.target);
    double widest = 0;
    for (const Vec3d& corner : building.corners()) {
        const Vec3d p = corner - eye;
        const double depth = -render::dot(p, axes.back);
        const double aspect = double(std::max(width, height)) / std::min(width, height);
        const double x = std::abs(render::dot(p, axes.right)) * (width >= height ? 1 : aspect);
        const double y = std::abs(render::dot(p, axes.up)) * (width >= height ? aspect : 1);
        widest = std::max(widest, depth > 0 ? std::max(x, y) / depth : 10.0);
    }
    view.camera.fov_deg = std::clamp(2.1 * std::atan(widest) * 180 / std::numbers::pi, 30.0, 105.0);
    return view;
}

/// "1.5,2,-3" to three finite numbers.
std::optional<Vec3d> parse_point(std::string_view text) {
    std::array<double, 3> values;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t comma = k < 2 ? text.find(',') : text.size();
        if (comma == std::string_view::npos) return std::nullopt;
        const auto [end, error] = std::from_chars(text.data(), text.data() + comma, values[k]);
        if (error != std::errc() || end != text.data() + comma || !std::isfinite(values[k])) return std::nullopt;
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    return Vec3d{values[0], values[1], values[2]};
}

/// How far along its direction (of length 1) a ray enters the object's box, 0 inside it; infinity where it does not.
double way_into(const accel::PlacedObject& object, const Vec3d& eye, const Vec3d& along) {
    const std::array<double, 3> from = {eye.x, eye.y, eye.z}, step = {along.x, along.y, along.z};
    double enter = 0, leave = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const double low = object.low[k] - from[k], high = object.high[k] - from[k];
        if (step[k] == 0) {
            if (low > 0 || high < 0) return std::numeric_limits<double>::infinity();
            continue;
        }
        enter = std::max(enter, std::min(low / step[k], high / step[k]));
        leave = std::min(leave, std::max(low / step[k], high / step[k]));
    }
    return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

/// Geometric mean of the distances seen through a coarse picture of this camera: a column before the eye spoils it, as
/// it would spoil the picture, and so does furniture of the room, as its boxes.
double mean_depth(const accel::SceneView& scene, render::Camera camera, accel::CellId cell) {
    camera.width = 12;
    camera.height = 8;
    const render::CameraFrame frame = render::make_frame(camera);
    std::vector<render::RayQuery> rays;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            rays.push_back({render::vec_cast<double>(frame.origin),
                            render::vec_cast<double>(frame.direction(float(x) + 0.5f, float(y) + 0.5f)), cell});
    std::vector<render::RayHit> hits(rays.size());
    render::trace_rays(scene, rays, hits);
    const accel::SpaceId room = scene.cells[index(cell)].space;
    double sum = 0;
    for (std::size_t k = 0; k < hits.size(); ++k) {
        double distance = hits[k].distance;
        const Vec3d along = render::normalized(rays[k].direction);
        for (const accel::PlacedObject& object : scene.objects)
            if (object.space == room) distance = std::min(distance, way_into(object, rays[k].origin, along));
        sum += std::log(std::clamp(distance, 0.05, 30.0));
    }
    return std::exp(sum / double(hits.size()));
}

}  // namespace

std::string camera_help() { return help; }

View named_view(const accel::SceneView& scene, const std::string& text, int width, int height) {
    if (text == "exterior") return exterior(scene, width, height);
    if (text == "aerial") return aerial(scene, width, height);
    if (text == "dollhouse") return dollhouse(scene, 0, width, height);
    constexpr std::string_view dollhouse_of = "dollhouse:";
    if (text.starts_with(dollhouse_of)) {
        std::uint32_t storey = 0;
        const auto [end, error] = std::from_chars(text.data() + dollhouse_of.size(), text.data() + text.size(), storey);
        if (error == std::errc() && end == text.data() + text.size()) return dollhouse(scene, storey, width, height);
    }
    const std::size_t colon = text.find(':');
    if (colon != std::string::npos) {
        const std::optional<Vec3d> eye = parse_point(std::string_view(text).substr(0, colon));
        const std::optional<Vec3d> target = parse_point(std::string_view(text).substr(colon + 1));
        if (eye && target) {
            const Vec3d origin = {scene.origin[0], scene.origin[1], scene.origin[2]};
            View view;
            view.camera.eye = *eye - origin;
            view.camera.target = *target - origin;
            view.camera.width = width;
            view.camera.height = height;
            return view;
        }
    }
    throw InputError(
        "F108", "",
        "--camera \"" + text + "\" is no view: give exterior, aerial, dollhouse, dollhouse:STOREY, or X,Y,Z:X,Y,Z.");
}

View room_view(const accel::SceneView& scene, const std::string& room, int width, int height) {
    const accel::SpaceId found = room_by_name(scene, room);
    const Box box = box_of(scene, [&](const accel::Cell& cell) { return cell.space == found; });
    View best;
    double best_depth = -1;
    for (std::size_t c = 0; c < scene.cells.size(); ++c) {
        const accel::Cell& cell = scene.cells[c];
        if (cell.space != found) continue;
        Vec3d middle = {0, 0, 0};
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s)
            middle = middle + (1.0 / cell.section_count) * Vec3d{scene.section_x[s], scene.section_y[s], 0};
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
            // A step away from the corner: the cell is convex, so it stays inside.
            const Vec3d corner = {scene.section_x[s], scene.section_y[s], 0};
            const Vec3d inward = middle - corner;
            const double step = std::min(0.5, 0.4 / std::max(render::length(inward), 1e-6));
            View view;
            view.camera.eye = corner + step * inward;
            view.camera.eye.z = cell.z_floor + std::min(eye_height, 0.6 * (double(cell.z_ceiling) - cell.z_floor));
            view.camera.target = {box.middle().x, box.middle().y, view.camera.eye.z - 0.35};
            if (render::length(view.camera.target - view.camera.eye) < 0.4) continue;
            view.camera.fov_deg = 88;
            view.camera.width = width;
            view.camera.height = height;
            const double depth = mean_depth(scene, view.camera, accel::CellId(c));
            if (depth > best_depth) {
                best_depth = depth;
                best = view;
            }
        }
    }
    if (best_depth < 0)
        throw InputError("F109", "", "The room \"" + room + "\" is too small to stand in: give --camera X,Y,Z:X,Y,Z.");
    return best;
}

}  // namespace enfilade::tools

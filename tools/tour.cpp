#include "tools/tour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "accel/locate.h"
#include "base/error.h"
#include "render/trace_rays.h"
#include "tools/footpath.h"
#include "tools/walkways.h"

namespace enfilade::tools {

namespace {

using accel::CellId;
using accel::Label;
using render::Vec3d;

constexpr double stop_clearance = 0.4;  ///< from the sides of the cell in which one stops, metres
constexpr double seen_again = 0.25;     ///< worth of another stop in the same room
constexpr double look_distance = 2.2;   ///< of the target, metres
constexpr double lowered = 0.1;         ///< the target, metres
constexpr double stride = 0.1;          ///< metres, in which the way is measured
constexpr double on_the_way = 0.35;     ///< views a metre outside the rooms visited, against inside
constexpr double step_off = 0.6;        ///< from gates, metres
constexpr double way_back = 2;          ///< metres walked after the last stop
constexpr double stair_inset = 0.35;    ///< of the ends of a flight from the stairwell's
constexpr double least_choice = 0.6;    ///< metres between views that choose the best place between them
constexpr double better_by = 1.1;       ///< times as open, to leave a place for another
constexpr double fov_deg = 80;

/// Cells to stop in: the ones with room around their middles, in the part of the building where most of them are.
std::vector<CellId> possible_stops(const accel::SceneView& scene, const Walkways& walkways) {
    const std::vector<std::uint32_t> parts = walkways.parts();
    std::map<std::uint32_t, std::vector<CellId>> stops_of;
    for (std::size_t c = 0; c < scene.cells.size(); ++c)
        if (scene.cells[c].label == Label::Room && walkways.is_walkable(CellId(c)) &&
            walkways.room_around(CellId(c)) >= stop_clearance)
            stops_of[parts[c]].push_back(CellId(c));
    std::vector<CellId> best;
    for (auto& [part, stops] : stops_of)
        if (stops.size() > best.size()) best = std::move(stops);
    return best;
}

/// A door to the outdoors, of the lowest storey that has one; nothing where none leads to the stops.
std::optional<CellId> entrance(const accel::SceneView& scene, const Walkways& walkways, CellId stop) {
    const Walkways::Ways ways = walkways.ways_from(stop);
    std::optional<CellId> best;
    for (std::size_t c = 0; c < scene.cells.size(); ++c) {
        const CellId cell = CellId(c);
        if (scene.cells[c].label != Label::Door || !std::isfinite(ways.metres[c]) || !walkways.leads_outdoors(cell))
            continue;
        if (!best || scene.cells[c].z_floor < scene.cells[index(*best)].z_floor) best = cell;
    }
    return best;
}

/// From `start`, always what lies farthest from everything chosen so far; rooms not yet seen first.
std::vector<CellId> spread_stops(const accel::SceneView& scene, const Walkways& walkways,
                                 const std::vector<CellId>& possible, CellId start, std::size_t count) {
    std::vector<double> nearest(scene.cells.size(), std::numeric_limits<double>::infinity());
    std::vector<CellId> chosen;
    std::set<accel::SpaceId> spaces = {scene.cells[index(start)].space};
    CellId last = start;
    while (chosen.size() < count) {
        const Walkways::Ways ways = walkways.ways_from(last);
        double best_worth = 0;
        std::optional<CellId> best;
        for (const CellId cell : possible) {
            double& metres = nearest[index(cell)];
            metres = std::min(metres, ways.metres[index(cell)]);
            const double worth = metres * (spaces.contains(scene.cells[index(cell)].space) ? seen_again : 1);
            if (!(worth > best_worth)) continue;
            best_worth = worth;
            best = cell;
        }
        if (!best || best_worth < stop_clearance) break;
        chosen.push_back(*best);
        spaces.insert(scene.cells[index(*best)].space);
        last = *best;
    }
    return chosen;
}

/// The long way through a stairwell, from end to end at the height of the floors; z is left to the caller.
std::array<Vec3d, 2> ends_of(const accel::SceneView& scene, const Walkways& walkways, CellId id) {
    const accel::Cell& cell = scene.cells[index(id)];
    const Vec3d middle = walkways.middle(id);
    Vec3d along = {1, 0, 0};
    double longest = 0;
    for (std::uint32_t k = 0; k < cell.section_count; ++k) {
        const std::uint32_t s = cell.first_section + k, next = cell.first_section + (k + 1) % cell.section_count;
        const Vec3d side = {double(scene.section_x[next]) - scene.section_x[s],
                            double(scene.section_y[next]) - scene.section_y[s], 0};
        if (!(render::length(side) > longest)) continue;
        longest = render::length(side);
        along = render::normalized(side);
    }
    double low = 0, high = 0;
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
        const double at = render::dot(Vec3d{scene.section_x[s], scene.section_y[s], middle.z} - middle, along);
        low = std::min(low, at);
        high = std::max(high, at);
    }
    return {middle + std::min(0.0, low + stair_inset) * along, middle + std::max(0.0, high - stair_inset) * along};
}

/// Straight through a gate, from a step before it to a step after: ways between doors in one wall keep off that wall.
void add_passage(const Walkways& walkways, const Gate& gate, std::vector<Vec3d>& points) {
    const double before = std::min(step_off, 0.5 * walkways.depth(gate.from, gate.eye, -gate.way));
    const double after = std::min(step_off, 0.5 * walkways.depth(gate.to, gate.eye, gate.way));
    points.push_back(gate.eye - before * gate.way);
    points.push_back(gate.eye);
    points.push_back(gate.eye + after * gate.way);
}

/// The way of the eyes from the last of the points to `goal`, through the gates. On stairs it rises evenly from one end
/// to the other.
void add_way(const accel::SceneView& scene, const Walkways& walkways, const std::vector<Gate>& gates, Vec3d goal,
             std::vector<Vec3d>& points) {
    for (std::size_t g = 0; g < gates.size(); ++g) {
        std::size_t end = g;
        while (end < gates.size() && gates[end].is_level) ++end;
        if (end == g) {
            add_passage(walkways, gates[g], points);
            continue;
        }
        const Vec3d before = points.back(), after = end < gates.size() ? gates[end].eye : goal;
        std::array<Vec3d, 2> ends = ends_of(scene, walkways, gates[g].from);
        const auto apart = [](Vec3d a, Vec3d b) { return std::hypot(a.x - b.x, a.y - b.y); };
        if (apart(ends[0], after) < apart(ends[1], after)) std::swap(ends[0], ends[1]);
        ends[0].z = before.z;
        ends[1].z = after.z;
        const bool is_free = can_walk(scene, before, ends[0], 0) && can_walk(scene, ends[0], ends[1], 0) &&
                             can_walk(scene, ends[1], after, 0);
        if (is_free) points.insert(points.end(), ends.begin(), ends.end());
        else
            for (std::size_t k = g; k < end; ++k) points.push_back(gates[k].eye);
        g = end - 1;
    }
    points.push_back(goal);
}

/// Where the eyes go, through all stops, the nearest one first.
Footpath path_through(const accel::SceneView& scene, const Walkways& walkways, CellId start,
                      std::vector<CellId> stops) {
    std::vector<Vec3d> points = {walkways.middle(start)};
    std::vector<std::size_t> stop_points;
    CellId here = start;
    while (!stops.empty()) {
        const Walkways::Ways ways = walkways.ways_from(here);
        const auto next = std::ranges::min_element(
            stops, {}, [&](CellId cell) { return std::pair(ways.metres[index(cell)], index(cell)); });
        here = *next;
        stops.erase(next);
        add_way(scene, walkways, walkways.gates_to(ways, here), walkways.middle(here), points);
        stop_points.push_back(points.size() - 1);
    }
    // At the end one turns and looks back into the room, not at its wall.
    if (points.size() > 1) {
        const Vec3d back = points[points.size() - 2] - points.back();
        if (const double metres = render::length(back); metres > 0)
            points.push_back(points.back() + std::min(1.0, way_back / metres) * back);
    }
    return Footpath(scene, points, stop_points);
}

std::optional<CellId> cell_at(const accel::SceneView& scene, Vec3d p) { return accel::locate(scene, {p.x, p.y, p.z}); }

/// Metres along the path at which the views stand: close together in the rooms visited.
std::vector<double> view_places(const accel::SceneView& scene, const Footpath& path,
                                const std::set<accel::SpaceId>& visited, std::size_t count) {
    std::vector<double> worth = {0};  // of the path up to every stride
    const std::size_t strides = std::max<std::size_t>(1, std::size_t(std::ceil(path.length() / stride)));
    const double step = path.length() / double(strides);
    for (std::size_t k = 0; k < strides; ++k) {
        const std::optional<CellId> cell = cell_at(scene, path.at((double(k) + 0.5) * step));
        const bool is_visited = cell && visited.contains(scene.cells[index(*cell)].space);
        worth.push_back(worth.back() + (is_visited ? 1 : on_the_way));
    }
    std::vector<double> places;
    for (std::size_t v = 0; v < count; ++v) {
        const double wanted = count == 1 ? 0 : worth.back() * double(v) / double(count - 1);
        const std::size_t k = std::min(std::size_t(std::ranges::upper_bound(worth, wanted) - worth.begin()), strides);
        const double part = (wanted - worth[k - 1]) / (worth[k] - worth[k - 1]);
        places.push_back((double(k - 1) + std::clamp(part, 0.0, 1.0)) * step);
    }
    return places;
}

render::Camera camera_at(const Footpath& path, double metres) {
    render::Camera camera;
    camera.eye = path.at(metres);
    camera.target = camera.eye + look_distance * path.look(metres) - Vec3d{0, 0, lowered};
    camera.fov_deg = fov_deg;
    return camera;
}

/// How far one sees, on the geometric average of a few rays: near things spoil a picture more than far ones mend it.
double openness(const accel::SceneView& scene, const render::Camera& camera) {
    render::Camera coarse = camera;
    coarse.width = 8;
    coarse.height = 6;
    const render::CameraFrame frame = render::make_frame(coarse);
    const std::optional<CellId> cell = cell_at(scene, render::vec_cast<double>(frame.origin));
    if (!cell) return 0;
    std::vector<render::RayQuery> rays;
    for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x)
            rays.push_back({render::vec_cast<double>(frame.origin),
                            render::vec_cast<double>(frame.direction(float(x) + 0.5f, float(y) + 0.5f)), *cell});
    std::vector<render::RayHit> hits(rays.size());
    render::trace_rays(scene, rays, hits);
    double sum = 0;
    for (const render::RayHit& hit : hits) sum += std::log(std::clamp(hit.distance, 0.1, 12.0));
    return std::exp(sum / double(hits.size()));
}

/// The camera near that place of the path, less than half the way to its neighbours, which sees most; in a film, where
/// they are close, the one at the place.
render::Camera best_camera_near(const accel::SceneView& scene, const Footpath& path, const std::vector<double>& places,
                                std::size_t view) {
    render::Camera best = camera_at(path, places[view]);
    if (view == 0) return best;  // in the door
    double best_openness = openness(scene, best);
    for (const int step : {-2, -1, 1, 2}) {
        if (step > 0 && view + 1 == places.size()) continue;
        const double away = (step < 0 ? places[view - 1] : places[view + 1]) - places[view];
        if (std::abs(away) < least_choice) continue;
        const render::Camera camera = camera_at(path, places[view] + 0.22 * std::abs(step) * away);
        const double open = openness(scene, camera);
        if (!(open > better_by * best_openness)) continue;
        best = camera;
        best_openness = open;
    }
    return best;
}

/// What people call the place: the name of its space, or its id, or what it is.
std::string place_name(const accel::SceneView& scene, CellId id) {
    const accel::Cell& cell = scene.cells[index(id)];
    const accel::Space& space = scene.spaces[index(cell.space)];
    for (const accel::TextId text : {space.name, space.id})
        if (!scene.string(text).empty()) return std::string(scene.string(text));
    return accel::name_of(cell.label);
}

}  // namespace

std::vector<SavedView> make_tour(const accel::SceneView& scene, const TourOptions& options) {
    const Walkways walkways(scene);
    const std::vector<CellId> possible = possible_stops(scene, walkways);
    if (possible.empty())
        throw InputError("F137", "",
                         "There is no room to walk in: a tour needs one that is 1.8 m high and 0.8 m wide.");
    const CellId start = entrance(scene, walkways, possible.front()).value_or(possible.front());
    const std::vector<CellId> stops = spread_stops(scene, walkways, possible, start, options.rooms);
    const Footpath path = path_through(scene, walkways, start, stops);

    std::set<accel::SpaceId> visited = {scene.cells[index(start)].space};
    for (const CellId stop : stops) visited.insert(scene.cells[index(stop)].space);
    std::vector<SavedView> views;
    std::map<std::string, int> named;
    const std::vector<double> places = view_places(scene, path, visited, options.views);
    for (std::size_t k = 0; k < places.size(); ++k) {
        SavedView view = as_saved({"the tour", best_camera_near(scene, path, places, k), {}}, scene);
        const std::string name = place_name(scene, view.cell);
        const int number = ++named[name];
        view.name = number == 1 ? name : name + ' ' + std::to_string(number);
        views.push_back(std::move(view));
    }
    return views;
}

}  // namespace enfilade::tools

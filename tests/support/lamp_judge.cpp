#include "tests/support/lamp_judge.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "accel/locate.h"
#include "render/executor.h"
#include "render/lamp_light.h"
#include "render/lamp_oracle.h"
#include "render/trace_rays.h"

namespace enfilade::test {
namespace {

using namespace render;

constexpr LampSearch searches[] = {LampSearch::Naive, LampSearch::Pvs, LampSearch::Tree};
constexpr const char* names[] = {"the walk", "the list", "the tree"};

template <class Rooms>
bool sees(const accel::SceneView& scene, const Lamps& lamps, const Rooms& rooms, const LitPlace<float>& place,
          std::uint32_t lamp) {
    NoEvents events;
    LampLight<Rooms, NoEvents> light(scene, lamps, rooms, events);
    Vec3f throughput = {1, 1, 1};
    return light.sees(place, lamp, throughput);
}

std::string in_words(const accel::SceneView& scene, const LitPlace<float>& place, std::uint32_t lamp, const char* who,
                     bool answer) {
    std::ostringstream text;
    text.precision(9);
    const auto& p = scene.lights[lamp].position;
    text << who << (answer ? " sees" : " does not see") << " lamp " << lamp << " at (" << p[0] << ", " << p[1] << ", "
         << p[2] << ") from (" << place.point.x << ", " << place.point.y << ", " << place.point.z << ") in cell "
         << place.cell;
    return text.str();
}

/// All that answers about a scene's lamps.
struct Judge {
    const accel::SceneView& scene;
    const LampOracle& oracle;
    accel::LightTreesView trees;
    bool is_thorough;

    template <class Rooms>
    void ask(const Rooms& rooms, const LitPlace<float>& place, std::uint32_t lamp, PairTally& tally) const {
        bool answers[3];
        for (int i = 0; i < 3; ++i) answers[i] = sees(scene, Lamps{trees, searches[i], 1}, rooms, place, lamp);
        ++tally.pairs;
        tally.lit += answers[0] ? 1 : 0;
        const bool is_same = answers[0] == answers[1] && answers[0] == answers[2];
        tally.differing += is_same ? 0 : 1;
        if (is_same && !is_thorough) return;
        for (int i = 0; i < 3; ++i) {
            if (oracle.allows(vec_cast<double>(place.point), lamp, answers[i])) continue;
            if (tally.wrong == 0) tally.first_wrong = in_words(scene, place, lamp, names[i], answers[i]);
            ++tally.wrong;
            tally.missed += i > 0 && !answers[i] ? 1 : 0;
        }
    }
};

LampOracle oracle_of(const accel::SceneView& scene) { return {scene, 2 * error_band(scene)}; }

/// Whether a pixel's place sees some lamp by a way along which rounding decides.
bool may_differ(const accel::SceneView& scene, const LampOracle& oracle, const CameraFrame& frame, accel::CellId start,
                const ObjectTracer* objects, int x, int y) {
    const Vec3d direction =
        vec_cast<double>(frame.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
    const RayQuery query = {vec_cast<double>(frame.origin), direction, start};
    const RayHit hit = trace_ray(scene, query, Precision::Float, objects);
    const Vec3d place = query.origin + (hit.distance / length(direction)) * direction;
    for (std::uint32_t l = 0; l < scene.lights.size(); ++l)
        if (oracle.is_close(place, l) || !oracle.sees(place, l)) return true;
    return false;
}

}  // namespace

void PairTally::add(const PairTally& other) {
    if (wrong == 0) first_wrong = other.first_wrong;
    pairs += other.pairs;
    lit += other.lit;
    differing += other.differing;
    wrong += other.wrong;
    missed += other.missed;
}

PairTally judge_pairs(const accel::SceneView& scene, const ObjectTracer* objects, int count, std::uint64_t seed,
                      bool is_thorough) {
    PairTally tally;
    const auto executor = make_executor(1);
    const accel::LightTrees trees = accel::build_light_trees(scene, {}, *executor);
    const LampOracle oracle = oracle_of(scene);
    const Judge judge = {scene, oracle, trees.view(), is_thorough};
    const std::vector<OpenPlace> places = open_places(scene, count, seed);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const LitPlace<float> place = {places[i].point, places[i].normal, places[i].cell};
        const bool is_on_face = !(place.normal == Vec3f{0, 0, 0});
        // Every other lamp is one that the place's cell may see: most of all are behind walls.
        auto lamp = static_cast<std::uint32_t>((i * 2654435761u) % scene.lights.size());
        const std::uint32_t first = trees.view().cell_offsets[place.cell],
                            end = trees.view().cell_offsets[place.cell + 1];
        if (i % 2 == 0 && first != end)
            lamp = static_cast<std::uint32_t>(trees.view().cell_lights[first + (i / 2) % (end - first)].light);
        // No light comes from behind a face, and nobody asks for it there.
        const Vec3f to_lamp = position_of<float>(scene.lights[lamp]) - place.point;
        if (is_on_face && !(dot(place.normal, to_lamp) > 0)) continue;
        if (objects != nullptr && scene.has_objects()) judge.ask(FurnishedRooms{*objects}, place, lamp, tally);
        else judge.ask(BareRooms{}, place, lamp, tally);
    }
    return tally;
}

int pairs_to_ask(int usual) {
    const char* asked = std::getenv("ENFILADE_LAMP_PAIRS");
    return asked != nullptr ? std::max(1, std::atoi(asked)) : usual;
}

PictureTally judge_pictures(const accel::SceneView& scene, const Camera& camera, TraceOptions options,
                            const ObjectTracer* objects) {
    PictureTally tally;
    const auto executor = make_executor(1);
    const accel::LightTrees trees = accel::build_light_trees(scene, {}, *executor);
    const LampOracle oracle = oracle_of(scene);
    const CameraFrame frame = make_frame(camera);
    options.executor = executor.get();
    options.objects = objects;
    if (!options.lamps) options.lamps = LampOptions{.exposure = 0.02f};
    options.lamps->trees = trees.view();
    options.lamps->search = LampSearch::Naive;
    const Image walked = trace(scene, camera, options);
    const bool is_direct = !options.cut_z && !(options.mirror_floor > 0) && options.samples_per_pixel == 1;
    for (const int s : {1, 2}) {
        options.lamps->search = searches[s];
        const Image image = trace(scene, camera, options);
        for (std::size_t i = 0; i < image.rgb.size() / 3; ++i) {
            double difference = 0, most = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                difference = std::max(difference, std::abs(double{image.rgb[3 * i + k]} - walked.rgb[3 * i + k]));
                most = std::max(most, double{walked.rgb[3 * i + k]});
            }
            ++tally.pixels;
            tally.lit += most > 0 ? 1 : 0;
            if (difference <= 1e-5 * most + 1e-9) continue;
            const int x = static_cast<int>(i) % camera.width, y = static_cast<int>(i) / camera.width;
            if (is_direct && may_differ(scene, oracle, frame, start_cell(scene, frame), objects, x, y)) {
                ++tally.differing;
                continue;
            }
            if (tally.wrong++ == 0) {
                std::ostringstream text;
                text << names[s] << " at pixel " << x << ", " << y << ": off by " << difference << " of " << most;
                tally.first_wrong = text.str();
            }
        }
    }
    return tally;
}

std::vector<Camera> cameras_by_lamps(const accel::SceneView& scene, int count, int pixels) {
    std::vector<Camera> cameras;
    for (std::uint32_t l = 0; l < scene.lights.size() && cameras.size() < static_cast<std::size_t>(count); ++l) {
        const accel::Light& light = scene.lights[l];
        if (light.cell == none<accel::CellId>) continue;
        const accel::Cell& cell = scene.cells[index(light.cell)];
        double x = 0, y = 0;
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
            x += double{scene.section_x[s]} / cell.section_count;
            y += double{scene.section_y[s]} / cell.section_count;
        }
        const double z = 0.5 * (double{cell.z_floor} + double{cell.z_ceiling});
        if (!accel::locate(scene, {x, y, z})) continue;
        const double turn = 2.4 * static_cast<double>(cameras.size());
        Camera camera;
        camera.eye = {x, y, z};
        camera.target = {x + std::cos(turn), y + std::sin(turn), z - 0.3};
        camera.width = camera.height = pixels;
        camera.fov_deg = 100;
        cameras.push_back(camera);
    }
    return cameras;
}

}  // namespace enfilade::test

// The dial's options of light: how lamps are found, in which precision, lamps that stand for others, samples a pixel,
// and paths. Errors are those of pictures, in parts of white, against walks to all lamps in double precision, against
// all lamps, or against many samples.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "accel/lights/light_clusters.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/generate.h"
#include "plans/number_text.h"
#include "render/executor.h"
#include "render/path_trace.h"
#include "render/trace.h"
#include "tools/bench_dial.h"
#include "tools/bench_lights.h"
#include "tools/view.h"

namespace enfilade::tools {

namespace {

using render::Image;
using render::LampSearch;

constexpr std::array cluster_errors = {0.0, 0.05, 0.1, 0.2, 0.4};

/// How far a picture is from another, channel by channel, white being 1.
struct PictureError {
    double mean = 0, most = 0, largest = 0;  ///< most: what 999 of 1000 do not exceed
    double largest_share = 0;                ///< of the truth, or of a hundredth of white where that is darker
};

PictureError error_between(const Image& image, const Image& truth) {
    std::vector<double> errors;
    double sum = 0, share = 0;
    for (std::size_t i = 0; i < truth.rgb.size(); ++i) {
        const auto shown = [](float light) { return std::clamp(double(light), 0.0, 1.0); };
        errors.push_back(std::abs(shown(image.rgb[i]) - shown(truth.rgb[i])));
        sum += errors.back();
        share = std::max(share, errors.back() / std::max(shown(truth.rgb[i]), 0.01));
    }
    std::sort(errors.begin(), errors.end());
    return {sum / double(errors.size()), errors[errors.size() * 999 / 1000], errors.back(), share};
}

/// One value of an option: how the picture is made, and what it keeps beside the scene.
struct Setting {
    std::string name;
    std::function<Image()> picture;
    std::size_t bytes = 0;
    bool is_told_by_first = false;  ///< time and error are those over the first setting's, too
};

void add_rows(Bench& bench, const std::string& scene, const std::vector<Setting>& settings, const Image& truth) {
    std::vector<Image> images(settings.size());
    std::vector<std::function<void()>> works;
    for (std::size_t k = 0; k < settings.size(); ++k) works.push_back([&, k] { images[k] = settings[k].picture(); });
    const bool is_cheap = settings[0].is_told_by_first;  // milliseconds a picture
    const Contest contest(is_cheap ? 15 : bench.quick() ? 1 : 3, works);
    for (std::size_t k = 0; k < settings.size(); ++k) {
        const auto row = [&](const char* what, double value, const char* unit) {
            bench.add({.row = settings[k].name + ": " + what, .scene = scene, .value = value, .unit = unit});
        };
        const PictureError error = error_between(images[k], truth);
        BenchRow time = {
            .row = settings[k].name + ": time", .scene = scene, .value = contest.median_of(k), .unit = "s"};
        if (settings[k].is_told_by_first && k > 0) {
            time.reference = settings[0].name;
            time.reference_value = contest.median_of(0);
            time.ratio = contest.faster(k, 0);
            time.spread = contest.spread(k, 0);
        }
        bench.add(time);
        row("memory", double(settings[k].bytes) / 1e6, "MB");
        row("error, mean", error.mean, "of white");
        row("error, 999 of 1000", error.most, "of white");
        row("error, largest", error.largest, "of white");
        if (settings[k].is_told_by_first) row("error, largest share", error.largest_share, "of the light");
    }
}

/// Makes pictures of one view of a lit scene on one thread.
class DialPictures {
public:
    DialPictures(const LitScene& scene, int side)
        : scene_(&scene), camera_(camera_at(scene, side)), flat_(lists_alone(scene)) {}

    [[nodiscard]] Image lit(LampSearch search, render::Precision precision, int samples) const {
        render::TraceOptions options;
        options.tracer = render::Tracer::Scalar;
        options.precision = precision;
        options.shading = render::Shading::Lambert;
        options.samples_per_pixel = samples;
        options.executor = &one_;
        options.lamps = render::LampOptions{search, LitScene::exposure, trees_of(search).view()};
        return render::trace(scene_->view, camera_, options);
    }
    /// By lanes.
    [[nodiscard]] Image clustered(LampSearch search, const accel::LightClusters& clusters) const {
        render::TraceOptions options;
        options.tracer = render::Tracer::Simd;
        options.shading = render::Shading::Lambert;
        options.executor = &one_;
        options.lamps = render::LampOptions{search, LitScene::exposure, clusters.lists(trees_of(search).view())};
        accel::SceneView scene = scene_->view;
        scene.lights = clusters.lights();
        return render::trace(scene, camera_, options);
    }
    [[nodiscard]] accel::LightClusters clusters(LampSearch search, double error) const {
        return accel::cluster_lights(scene_->view, trees_of(search).view(), {.error = error}, one_);
    }
    [[nodiscard]] Image paths(int samples, int lamps_per_bounce, const accel::Executor& executor) const {
        render::PathOptions options;
        options.samples_per_pixel = samples;
        options.lamps_per_bounce = lamps_per_bounce;
        options.exposure = LitScene::exposure;
        options.sky = options.sun = 0;  // lamps alone, as in the other pictures
        options.trees = scene_->trees.view();
        options.executor = &executor;
        return render::trace_paths(scene_->view, camera_, options).image;
    }
    [[nodiscard]] const accel::LightTrees& trees_of(LampSearch search) const {
        return search == LampSearch::Tree ? scene_->trees : flat_;
    }
    [[nodiscard]] const accel::Executor& one() const { return one_; }

private:
    /// From the garden where lamps stand outside, else from a room.
    static render::Camera camera_at(const LitScene& scene, int side) {
        if (scene.places == LampPlaces::Outside) return named_view(scene.view, "exterior", side, side).camera;
        return floor_views(scene.view, 3, side)[1];
    }
    static accel::LightTrees lists_alone(const LitScene& scene) {
        return accel::build_light_trees(scene.view, {.trees = false}, accel::SerialExecutor());
    }

    const LitScene* scene_;
    render::Camera camera_;
    accel::LightTrees flat_;
    accel::SerialExecutor one_;
};

void dial_searches(Bench& bench, const LitScene& scene) {
    const DialPictures pictures(scene, bench.quick() ? 96 : 256);
    const auto picture = [&](LampSearch search, render::Precision precision, int samples) {
        return [&, search, precision, samples] { return pictures.lit(search, precision, samples); };
    };
    std::vector<Setting> settings;
    for (const auto& [name, search] : {std::pair{"lights naive", LampSearch::Naive},
                                       {"lights pvs", LampSearch::Pvs},
                                       {"lights tree", LampSearch::Tree}})
        settings.push_back({name, picture(search, render::Precision::Float, 1),
                            search == LampSearch::Naive ? 0 : pictures.trees_of(search).bytes()});
    const std::size_t bytes = scene.trees.bytes();
    settings.push_back({"light-real float", picture(LampSearch::Tree, render::Precision::Float, 1), bytes});
    settings.push_back({"light-real double", picture(LampSearch::Tree, render::Precision::Double, 1), bytes});
    add_rows(bench, scene.name, settings, pictures.lit(LampSearch::Naive, render::Precision::Double, 1));
}

/// Clusters, by trees and by walks: pictures of lanes.
void dial_clusters(Bench& bench, const LitScene& scene) {
    const DialPictures pictures(scene, bench.quick() ? 64 : 192);
    for (const auto& [name, search] :
         {std::pair{"light-clusters ", LampSearch::Tree}, {"light-clusters-pvs ", LampSearch::Pvs}}) {
        std::vector<accel::LightClusters> all;
        for (const double error : cluster_errors) all.push_back(pictures.clusters(search, error));
        std::vector<Setting> settings;
        for (std::size_t k = 0; k < all.size(); ++k)
            settings.push_back({name + plans::rounded_text(cluster_errors[k], 2),
                                [&, k, how = search] { return pictures.clustered(how, all[k]); },
                                pictures.trees_of(search).bytes() + (k > 0 ? all[k].bytes() : 0), true});
        add_rows(bench, scene.name, settings, settings[0].picture());
    }
}

void dial_samples(Bench& bench, const LitScene& scene) {
    const DialPictures pictures(scene, bench.quick() ? 64 : 128);
    std::vector<Setting> settings;
    for (const int samples : {1, 4, 16, 64})
        settings.push_back({"samples " + std::to_string(samples), [&, samples] {
                                return pictures.lit(LampSearch::Tree, render::Precision::Float, samples);
                            }});
    add_rows(bench, scene.name, settings,
             pictures.lit(LampSearch::Tree, render::Precision::Float, bench.quick() ? 144 : 576));
}

void dial_paths(Bench& bench, const LitScene& scene) {
    const DialPictures pictures(scene, bench.quick() ? 24 : 64);
    const std::unique_ptr<accel::Executor> cores = render::make_executor();
    const int most = bench.quick() ? 16 : 64;
    std::vector<Setting> settings;
    for (int samples = 4; samples <= most; samples *= bench.quick() ? 2 : 4)
        settings.push_back({"path-samples " + std::to_string(samples),
                            [&, samples] { return pictures.paths(samples, 0, pictures.one()); }});
    for (const int lamps : {1, 4})
        settings.push_back({"path-lamps " + std::to_string(lamps),
                            [&, lamps] { return pictures.paths(most / 4, lamps, pictures.one()); }});
    settings.push_back({"path-lamps all", [&] { return pictures.paths(most / 4, 0, pictures.one()); }});
    add_rows(bench, scene.name, settings, pictures.paths(32 * most, 0, *cores));
}

}  // namespace

void dial_lights(Bench& bench) {
    const modeler::Building building = modeler::convexify(modeler::build(plans::generate({.rooms = 46})));
    const accel::Scene rooms = modeler::export_scene(building, modeler::check(building), "{}");
    const LitScene scene("46 rooms", rooms.view(), 55, LampPlaces::Rooms);
    dial_searches(bench, scene);
    dial_samples(bench, scene);
    dial_clusters(bench, LitScene("46 rooms", rooms.view(), 200, LampPlaces::Rooms));
    dial_clusters(bench, LitScene("46 rooms", rooms.view(), bench.quick() ? 500 : 2500, LampPlaces::Outside));
    dial_paths(bench, LitScene("46 rooms, hanging", rooms.view(), 55, LampPlaces::Hanging));
}

}  // namespace enfilade::tools

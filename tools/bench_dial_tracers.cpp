// What float, double, lanes and packets cost and err.

#include <algorithm>
#include <cstdlib>

#include "render/oracle.h"
#include "render/trace.h"
#include "tools/bench_cells.h"
#include "tools/bench_dial.h"
#include "tools/random_rays.h"

namespace enfilade::tools {

namespace {

constexpr int side = 1024;
constexpr std::size_t view_count = 8;

/// Adds rows of one setting of one option.
class SettingRows {
public:
    SettingRows(Bench& bench, std::string setting, std::string scene)
        : bench_(&bench), setting_(std::move(setting)), scene_(std::move(scene)) {}
    void add(const char* what, double value, const char* unit) const {
        bench_->add({.row = setting_ + ": " + what, .scene = scene_, .value = value, .unit = unit});
    }
    void add(const render::Agreement& agreement) const {
        const double per_million = 1e6 / double(agreement.rays);
        add("other face, inside the band", double(agreement.differing_inside_band) * per_million, "per million");
        add("other face, no edge near", double(agreement.differing_outside_band) * per_million, "per million");
        add("largest error of the distance", agreement.largest_distance_error * 1000, "mm");
    }

private:
    Bench* bench_;
    std::string setting_, scene_;
};

/// Float against double: the same random rays one at a time. Errors are against the oracle.
void dial_real(Bench& bench, const accel::SceneView& scene, const std::string& name) {
    const render::Oracle oracle(scene);
    const std::vector<render::RayQuery> timed = RandomRays(scene, 11).take(bench.quick() ? 200'000 : 2'000'000);
    const std::span<const render::RayQuery> checked(timed.data(), timed.size() / 10);
    std::vector<render::RayHit> hits(timed.size());
    constexpr std::array precisions = {render::Precision::Float, render::Precision::Double};
    std::vector<std::function<void()>> works;
    for (const render::Precision precision : precisions)
        works.push_back([&, precision] { render::trace_rays(scene, timed, hits, precision); });
    const Contest contest(bench.quick() ? 3 : 9, works);
    for (std::size_t k = 0; k < precisions.size(); ++k) {
        const SettingRows rows(bench, k == 0 ? "real float" : "real double", name);
        rows.add("speed", double(timed.size()) / contest.median_of(k) / 1e6, "Mrays/s");
        render::trace_rays(scene, checked, hits, precisions[k]);
        rows.add(render::compare(oracle, checked, {hits.data(), checked.size()}, render::error_band(scene)));
    }
}

/// Settings of the picture's tracers, timed in turn, with the pixels that they paint unlike the scalar tracer does.
class PictureDial {
public:
    struct Setting {
        std::string name;
        render::Tracer tracer;
        render::PacketSizes packets = {};
    };

    PictureDial(const accel::SceneView& scene, std::vector<Setting> settings)
        : scene_(&scene),
          views_(prepared(scene, floor_views(scene, view_count, side))),
          settings_(std::move(settings)) {
        for (const PreparedView& view : views_) {
            scalar_.emplace_back(side, side);
            trace({"scalar", render::Tracer::Scalar}, view, scalar_.back());
        }
    }

    void add_rows(Bench& bench, const std::string& name) {
        std::vector<std::function<void()>> works;
        for (const Setting& setting : settings_)
            works.push_back([&] {
                for (const PreparedView& view : views_) trace(setting, view, image_);
            });
        const Contest contest(bench.quick() ? 3 : 9, works);
        for (std::size_t k = 0; k < settings_.size(); ++k) {
            const SettingRows rows(bench, settings_[k].name, name);
            const double pixels = double(side) * side * double(view_count);
            rows.add("speed", pixels / contest.median_of(k) / 1e6, "Mrays/s");
            const Difference difference = difference_of(settings_[k]);
            rows.add("pixels unlike the scalar ones", 1e6 * double(difference.pixels) / pixels, "per million");
            rows.add("largest difference of a channel", difference.largest, "of 255");
        }
    }

private:
    struct Difference {
        std::uint64_t pixels = 0;  ///< that differ by more than one step
        int largest = 0;           ///< of a channel, of 255
    };

    void trace(const Setting& setting, const PreparedView& view, render::Framebuffer& image) const {
        render::trace_lambert(*scene_, view.frame, view.start, {.tracer = setting.tracer, .packets = setting.packets},
                              one_, image);
    }

    [[nodiscard]] Difference difference_of(const Setting& setting) {
        Difference difference;
        for (std::size_t v = 0; v < views_.size(); ++v) {
            trace(setting, views_[v], image_);
            for (std::size_t i = 0; i < image_.rgba.size(); ++i) {
                int largest = 0;
                for (int shift = 0; shift < 24; shift += 8)
                    largest = std::max(largest, std::abs(int(image_.rgba[i] >> shift & 255u) -
                                                         int(scalar_[v].rgba[i] >> shift & 255u)));
                if (largest > 1) ++difference.pixels;
                difference.largest = std::max(difference.largest, largest);
            }
        }
        return difference;
    }

    const accel::SceneView* scene_;
    std::vector<PreparedView> views_;
    std::vector<Setting> settings_;
    std::vector<render::Framebuffer> scalar_;  ///< [view]
    render::Framebuffer image_{side, side};
    accel::SerialExecutor one_;
};

std::vector<PictureDial::Setting> tracer_settings() {
    std::vector<PictureDial::Setting> settings;
    for (const render::Tracer tracer : tracers) settings.push_back({std::string("tracer ") + name_of(tracer), tracer});
    return settings;
}

std::vector<PictureDial::Setting> packet_settings(bool is_quick) {
    std::vector<PictureDial::Setting> settings;
    for (int largest = 16; largest <= 256; largest *= is_quick ? 4 : 2)
        for (int smallest = 4; smallest <= 16; smallest *= 2)
            settings.push_back({"packet " + std::to_string(largest) + " to " + std::to_string(smallest),
                                render::Tracer::Packet,
                                {largest, smallest}});
    return settings;
}

}  // namespace

void dial_tracers(Bench& bench, const accel::SceneView& scene, const std::string& name) {
    dial_real(bench, scene, name);
    PictureDial(scene, tracer_settings()).add_rows(bench, name);
    PictureDial(scene, packet_settings(bench.quick())).add_rows(bench, name);
}

}  // namespace enfilade::tools

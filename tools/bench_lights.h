#pragma once
// What the benchmarks of lit pictures share (bench_lights*.cpp).

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "render/embree_lamps.h"
#include "render/trace.h"
#include "tools/bench_furnished.h"
#include "tools/spread_lamps.h"

namespace enfilade::tools {

/// A scene with lamps spread over it, its light trees, and the lists that Embree is given of them.
struct LitScene {
    std::string name;  ///< "office-135, 200 lamps"
    LampPlaces places;
    std::vector<accel::Light> lamps;
    accel::SceneView view;
    double tree_seconds = 0;
    accel::LightTrees trees;
    render::LampLists lists;

    /// On all cores. The scene stays where it is.
    LitScene(const std::string& building, const accel::SceneView& scene, std::size_t count, LampPlaces places);
    [[nodiscard]] render::Lamps asked(render::LampSearch search) const;
    /// What a white surface in a light of pi lux becomes.
    static constexpr float exposure = 0.05f;
};

/// Views of a lit scene, and what their pixels see.
class LitViews {
public:
    /// objects: what stands in the rooms, or nullptr
    LitViews(const LitScene& scene, const std::vector<PreparedView>& views, int side,
             const render::ObjectTracer* objects);

    [[nodiscard]] double primary_rays() const { return double(side_) * side_ * double(views_.size()); }
    /// Pairs of a pixel and a lamp that its cell may see.
    [[nodiscard]] double shadow_rays() const { return shadow_rays_; }
    /// Pixels that show neither the sky nor nothing.
    [[nodiscard]] double lit_pixels() const { return lit_pixels_; }
    [[nodiscard]] std::size_t count() const { return views_.size(); }
    [[nodiscard]] int side() const { return side_; }

    /// Our pictures of all views, or of the first `count`.
    void draw(render::Tracer tracer, const render::Lamps* lamps, render::Framebuffer& image,
              std::size_t count = ~std::size_t{0}) const;
    /// By `Embree` (EmbreeReference, EmbreeInstances). seen: nothing, or the first hits of each view
    template <class Embree>
    void draw_by(const Embree& embree, const render::EmbreeLitWay& way, const std::vector<render::SeenPlaces>& seen,
                 render::Framebuffer& image, std::size_t count = ~std::size_t{0}) const {
        for (std::size_t k = 0; k < std::min(count, views_.size()); ++k)
            embree.trace_lit(views_[k].frame,
                             {scene_->view.lights, &scene_->lists, LitScene::exposure, cells_[k].data(),
                              seen.empty() ? nullptr : &seen[k]},
                             way, one_, image);
    }
    template <class Embree>
    [[nodiscard]] std::vector<render::SeenPlaces> first_hits(const Embree& embree) const {
        std::vector<render::SeenPlaces> seen;
        for (const PreparedView& view : views_) seen.push_back(embree.seen_places(view.frame, side_, side_, one_));
        return seen;
    }

private:
    void look(const PreparedView& view);

    const LitScene* scene_;
    std::vector<PreparedView> views_;
    int side_;
    const render::ObjectTracer* objects_;
    std::vector<std::vector<std::uint32_t>> cells_;  ///< [view][pixel]
    double shadow_rays_ = 0, lit_pixels_ = 0;
    accel::SerialExecutor one_;
};

/// Embree's fastest way at the first of the views, of `ways`.
template <class Embree>
[[nodiscard]] render::EmbreeLitWay fastest_lit_way(const LitViews& views, const Embree& embree,
                                                   const std::vector<render::EmbreeLitWay>& ways, int rounds) {
    render::Framebuffer image(views.side(), views.side());
    std::vector<std::function<void()>> works;
    for (const render::EmbreeLitWay& way : ways)
        works.push_back([&, way] { views.draw_by(embree, way, {}, image, 1); });
    const Contest contest(rounds, works);
    std::size_t best = 0;
    for (std::size_t k = 0; k < ways.size(); ++k)
        if (contest.least_of(k) < contest.least_of(best)) best = k;
    return ways[best];
}
/// Those that are worth a try: all, or in quick runs packets from places alone.
[[nodiscard]] std::vector<render::EmbreeLitWay> lit_ways(const Bench& bench);

/// "scalar tree"
[[nodiscard]] std::string name_of(render::Tracer tracer, render::LampSearch search);

/// Of a million pixels of a view, those with a channel that differs by more than a step.
[[nodiscard]] double unlike_per_million(const render::Framebuffer& a, const render::Framebuffer& b);

/// The paper's table 3: walks to all lamps, to those of lists, and trees.
void bench_lit_searches(Bench& bench, const LitScene& scene);
/// Lanes and packets against Embree, and against themselves without lamps. has_goals: whether the hold
void bench_lit_pictures(Bench& bench, const LitScene& scene, const render::EmbreeReference& embree, bool has_goals);
/// The same with what stands in the rooms.
void bench_lit_furniture(Bench& bench, const TracedFloor& floor, std::size_t lamps);
/// How good the lists are, how long they and the trees take, and how large they are.
void bench_lamp_lists(Bench& bench, const LitScene& scene, double most_seconds);
/// Trees of larger and larger floors, and of more and more lamps.
void bench_lamp_growth(Bench& bench);
/// The paper's figure 13: speed over the number of lamps.
void bench_lamp_counts(Bench& bench, const std::string& building, const accel::SceneView& scene);

}  // namespace enfilade::tools

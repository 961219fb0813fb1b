#include "tools/count_pictures.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "accel/lights/light_trees.h"
#include "plans/number_text.h"

namespace enfilade::tools {

namespace {

constexpr int coarse_side = 160;
constexpr std::size_t fewest_counted = 400;  ///< pixels, of which one in two hundred may be above the scale

std::size_t counted_pixels(std::span<const render::PixelNumbers> pictures) {
    std::size_t count = 0;
    for (const render::PixelNumbers& numbers : pictures)
        count += std::size_t(std::ranges::count_if(numbers.of_pixel, [](float value) { return value > 0; }));
    return count;
}

/// How many lamps each cell may see.
std::vector<std::uint32_t> lamps_of_cells(const accel::SceneView& scene, const accel::Executor& executor) {
    const accel::LightTrees trees = accel::build_light_trees(scene, {.trees = false}, executor);
    const accel::LightTreesView view = trees.view();
    std::vector<std::uint32_t> lamps(scene.cells.size());
    for (std::size_t c = 0; c < lamps.size(); ++c)
        for (std::uint32_t k = view.cell_offsets[c]; k < view.cell_offsets[c + 1]; ++k)
            lamps[c] += k == view.cell_offsets[c] || view.cell_lights[k].light != view.cell_lights[k - 1].light ? 1 : 0;
    return lamps;
}

/// The same view with at most `coarse_side` pixels a side.
View coarse(View view) {
    int& width = view.camera.width;
    int& height = view.camera.height;
    const int longer = std::max(width, height);
    if (longer <= coarse_side) return view;
    width = std::max(1, width * coarse_side / longer);
    height = std::max(1, height * coarse_side / longer);
    return view;
}

}  // namespace

CountPictures::CountPictures(const accel::SceneView& scene, std::span<const View> views, const std::string& shown,
                             const accel::Executor& executor, const render::OctreeCounter* octrees)
    : scene_(scene), octrees_(octrees), shown_(shown) {
    if (shown_ == "lamps") lamps_of_cell_ = lamps_of_cells(scene, executor);
    std::vector<render::PixelNumbers> small;
    for (const View& view : views) small.push_back(numbers(coarse(view), executor));
    if (counted_pixels(small) < fewest_counted)
        for (std::size_t k = 0; k < views.size(); ++k) small[k] = numbers(views[k], executor);
    // Few rays pass along a surface, but those meet ten times what others do: above the scale, they leave its colours
    // to the rest.
    range_ = range_of(small, octrees != nullptr ? 0.995 : 1);
}

render::PixelNumbers CountPictures::numbers(const View& view, const accel::Executor& executor) const {
    const render::RayCount count = shown_ == "cells"    ? render::RayCount::Cells
                                   : shown_ == "sides"  ? render::RayCount::SideTests
                                   : shown_ == "lamps"  ? render::RayCount::OfCell
                                   : shown_ == "leaves" ? render::RayCount::Leaves
                                                        : render::RayCount::Blocks;
    return render::count_by_pixel(scene_, view.camera, count, view.cut_z, &executor, octrees_, lamps_of_cell_);
}

render::Image CountPictures::picture(const View& view, const accel::Executor& executor, int rows) {
    const render::PixelNumbers counted = numbers(view, executor);
    for (const float value : counted.of_pixel) {
        if (std::isnan(value)) continue;
        seen_.least = pixels_ == 0 ? double{value} : std::min(seen_.least, double{value});
        seen_.most = pixels_ == 0 ? double{value} : std::max(seen_.most, double{value});
        sum_ += double{value};
        ++pixels_;
    }
    return false_colour(counted, range_, unit(), rows);
}

std::string CountPictures::report() const {
    if (pixels_ == 0) return "no ray in these pictures";
    return unit() + ": " + plans::rounded_text(seen_.least, 0) + " to " + plans::rounded_text(seen_.most, 0) + ", " +
           plans::rounded_text(sum_ / double(pixels_), 2) + " on average";
}

nlohmann::ordered_json CountPictures::json() const {
    nlohmann::ordered_json json = {{"shown", shown_}, {"rays", pixels_}};
    json["least"] = seen_.least;
    json["most"] = seen_.most;
    json["mean"] = pixels_ == 0 ? 0 : sum_ / double(pixels_);
    json["scale"] = {range_.least, range_.most};
    if (pixels_ == 0) json["least"] = json["most"] = nullptr;
    return json;
}

}  // namespace enfilade::tools

#pragma once
// What --show makes: pictures of what rays cost, all of one run on one colour scale.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "accel/parallel_for.h"
#include "render/ray_counts.h"
#include "tools/false_colour.h"
#include "tools/view.h"

namespace enfilade::tools {

class CountPictures {
public:
    /// `shown`: "cells", "sides", "lamps" (how many the cell that is seen may see, by its list), "leaves" or "blocks";
    /// the latter two are of `octrees`. The scale spans what small pictures of the views show (large ones where hardly
    /// any ray of these meets anything to count), so that it is the same in all of them. \throws InputError as
    /// count_by_pixel
    CountPictures(const accel::SceneView& scene, std::span<const View> views, const std::string& shown,
                  const accel::Executor& executor, const render::OctreeCounter* octrees = nullptr);

    /// Of the view's size, with the scale in `rows` more below it (bar_rows()).
    [[nodiscard]] render::Image picture(const View& view, const accel::Executor& executor, int rows);

    /// "cells a ray: 1 to 9, 1.62 on average": of the pictures made so far.
    [[nodiscard]] std::string report() const;
    [[nodiscard]] nlohmann::ordered_json json() const;

private:
    [[nodiscard]] render::PixelNumbers numbers(const View& view, const accel::Executor& executor) const;
    [[nodiscard]] std::string unit() const { return shown_ == "lamps" ? "lamps in sight" : shown_ + " a ray"; }

    const accel::SceneView& scene_;
    const render::OctreeCounter* octrees_;
    std::string shown_;
    std::vector<std::uint32_t> lamps_of_cell_;  ///< [cell_count] where lamps are shown
    ScaleRange range_;
    std::uint64_t pixels_ = 0;
    double sum_ = 0;
    ScaleRange seen_ = {1, 0};  ///< least > most: nothing yet
};

}  // namespace enfilade::tools

#pragma once
// Inside of render: what the samples of a picture's pixels have come to, in tiles, and how noisy it is.

#include <cstddef>
#include <vector>

#include "render/path_job.h"
#include "render/path_trace.h"

namespace enfilade::render::detail {

/// Of the mean luminance: from what the means of the sequences differ by. \pre samples > 0, a multiple of their number
[[nodiscard]] double standard_error(const PathSum& sum, int samples);

struct FilmTile {
    int x0, y0, x1, y1;
};

/// Tiles may be worked at by different threads; everything else is for one.
class PathFilm {
public:
    PathFilm(int width, int height);

    [[nodiscard]] PathSum* sums() { return sums_.data(); }
    [[nodiscard]] std::vector<std::size_t> all_tiles() const;
    [[nodiscard]] FilmTile tile(std::size_t i) const;
    void set_samples(std::size_t tile, int samples) { samples_[tile] = samples; }

    /// PathNoise::typical of a tile.
    [[nodiscard]] double noise(std::size_t tile) const;
    [[nodiscard]] PathNoise noise() const;
    /// The share of the pixels that lie in none of those tiles.
    [[nodiscard]] double share_without(const std::vector<std::size_t>& tiles) const;
    [[nodiscard]] PathResult result() const;

private:
    [[nodiscard]] std::size_t pixel(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_, height_;
    std::size_t columns_, rows_;  ///< of tiles
    std::vector<PathSum> sums_;
    std::vector<int> samples_;  ///< of each tile's pixels
};

}  // namespace enfilade::render::detail

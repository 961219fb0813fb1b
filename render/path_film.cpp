#include "render/path_film.h"

#include <algorithm>
#include <cmath>

namespace enfilade::render::detail {
namespace {

constexpr std::size_t tile_side = 32;
constexpr double dark = 0.02;  ///< PathNoise

/// Sums over pixels for PathNoise.
struct NoiseSums {
    double squares = 0, noise = 0, above = 0, luminance = 0, variance = 0, pixels = 0;

    void add(const PathSum& sum, int samples) {
        const double error = standard_error(sum, samples);
        double mean = 0;
        for (const double of_sequence : sum.luminance) mean += of_sequence / samples;
        const double relative = error / (mean + dark);
        squares += relative * relative;
        noise += relative;
        above += relative >= 0.05 ? 1 : 0;
        luminance += mean;
        variance += error * error;
        pixels += 1;
    }
};

}  // namespace

double standard_error(const PathSum& sum, int samples) {
    const double each = double(samples) / path_sequences;
    double mean = 0, squares = 0;
    for (const double of_sequence : sum.luminance) mean += of_sequence / each / path_sequences;
    for (const double of_sequence : sum.luminance) {
        const double off = of_sequence / each - mean;
        squares += off * off;
    }
    return std::sqrt(squares / (path_sequences * (path_sequences - 1)));
}

PathFilm::PathFilm(int width, int height)
    : width_(width),
      height_(height),
      columns_((static_cast<std::size_t>(width) + tile_side - 1) / tile_side),
      rows_((static_cast<std::size_t>(height) + tile_side - 1) / tile_side),
      sums_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      samples_(columns_ * rows_) {}

std::vector<std::size_t> PathFilm::all_tiles() const {
    std::vector<std::size_t> tiles(samples_.size());
    for (std::size_t i = 0; i < tiles.size(); ++i) tiles[i] = i;
    return tiles;
}

FilmTile PathFilm::tile(std::size_t i) const {
    const int x = static_cast<int>(i % columns_ * tile_side), y = static_cast<int>(i / columns_ * tile_side);
    const int side = static_cast<int>(tile_side);
    return {x, y, std::min(x + side, width_), std::min(y + side, height_)};
}

double PathFilm::noise(std::size_t i) const {
    const FilmTile at = tile(i);
    NoiseSums sums;
    for (int y = at.y0; y < at.y1; ++y)
        for (int x = at.x0; x < at.x1; ++x) sums.add(sums_[pixel(x, y)], samples_[i]);
    return std::sqrt(sums.squares / sums.pixels);
}

PathNoise PathFilm::noise() const {
    NoiseSums sums;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        if (samples_[i] == 0) continue;
        const FilmTile at = tile(i);
        for (int y = at.y0; y < at.y1; ++y)
            for (int x = at.x0; x < at.x1; ++x) sums.add(sums_[pixel(x, y)], samples_[i]);
    }
    const double n = std::max(sums.pixels, 1.0);
    return {std::sqrt(sums.squares / n), sums.noise / n, sums.above / n, sums.luminance / n,
            std::sqrt(sums.variance) / n};
}

double PathFilm::share_without(const std::vector<std::size_t>& tiles) const {
    std::size_t pixels = 0;
    for (const std::size_t i : tiles) {
        const FilmTile at = tile(i);
        pixels += static_cast<std::size_t>(at.x1 - at.x0) * static_cast<std::size_t>(at.y1 - at.y0);
    }
    return 1 - double(pixels) / double(sums_.size());
}

PathResult PathFilm::result() const {
    PathResult result;
    result.image = Image(width_, height_);
    result.standard_error.resize(sums_.size());
    result.samples.resize(sums_.size());
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        const FilmTile at = tile(i);
        const double n = std::max(samples_[i], 1);
        for (int y = at.y0; y < at.y1; ++y)
            for (int x = at.x0; x < at.x1; ++x) {
                const std::size_t p = pixel(x, y);
                for (std::size_t k = 0; k < 3; ++k)
                    result.image.rgb[3 * p + k] = static_cast<float>(sums_[p].rgb[k] / n);
                if (samples_[i] > 0)
                    result.standard_error[p] = static_cast<float>(standard_error(sums_[p], samples_[i]));
                result.samples[p] = samples_[i];
            }
    }
    result.noise = noise();
    return result;
}

}  // namespace enfilade::render::detail

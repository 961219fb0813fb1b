#include "modeler/catalogue/image_mean.h"

#include <cmath>
#include <cstdint>

#include "modeler/catalogue/picture.h"

namespace enfilade::modeler {
namespace {

double linear_of(double value) { return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4); }

/// Sums up pixels; integers, so that the order of rows does not matter.
class Mean {
public:
    Mean() {
        for (std::size_t k = 0; k < 256; ++k)
            linear_[k] = static_cast<std::uint32_t>(std::lround(linear_of(double(k) / 255) * 65535));
    }
    void add(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t alpha) {
        sum_[0] += std::uint64_t{linear_[r]} * alpha;
        sum_[1] += std::uint64_t{linear_[g]} * alpha;
        sum_[2] += std::uint64_t{linear_[b]} * alpha;
        weight_ += alpha;
    }
    [[nodiscard]] std::optional<std::array<float, 3>> colour() const {
        if (weight_ == 0) return std::nullopt;
        std::array<float, 3> mean;
        for (std::size_t k = 0; k < 3; ++k) mean[k] = static_cast<float>(double(sum_[k]) / double(weight_) / 65535);
        return mean;
    }

private:
    std::array<std::uint32_t, 256> linear_{};
    std::array<std::uint64_t, 3> sum_{};
    std::uint64_t weight_ = 0;
};

}  // namespace

std::array<float, 3> linear_colour(const std::array<double, 3>& srgb) {
    std::array<float, 3> linear;
    for (std::size_t k = 0; k < 3; ++k) linear[k] = static_cast<float>(linear_of(srgb[k]));
    return linear;
}

std::optional<std::array<float, 3>> mean_colour(std::string_view bytes) {
    const std::optional<Picture> picture = read_picture(
        bytes, [](std::uint32_t width, std::uint32_t height) { return width > 64 && height > 64 ? 8u : 1u; });
    if (!picture) return std::nullopt;
    Mean mean;
    for (const auto& [r, g, b, alpha] : picture->pixels) mean.add(r, g, b, alpha);
    return mean.colour();
}

}  // namespace enfilade::modeler

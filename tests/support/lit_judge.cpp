#include "tests/support/lit_judge.h"

#include <algorithm>
#include <cmath>

namespace enfilade::test {
namespace {

/// expected(x, y, c) and actual(x, y, c): channels in units of which `tolerance(value)` are allowed.
template <class Expected, class Actual, class Tolerance>
LitVerdict judge(int width, int height, float tenth, const Expected& expected, const Actual& actual,
                 const Tolerance& tolerance) {
    LitVerdict verdict;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            ++verdict.pixels;
            bool differs = false, is_explained = true, is_bright = false;
            for (int c = 0; c < 3; ++c) {
                const float want = expected(x, y, c), got = actual(x, y, c);
                is_bright = is_bright || want > tenth;
                if (std::abs(got - want) <= tolerance(want)) continue;
                differs = true;
                float low = want, high = want;
                for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
                    for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u) {
                        low = std::min(low, expected(u, v, c));
                        high = std::max(high, expected(u, v, c));
                    }
                is_explained = is_explained && got >= low - tolerance(low) && got <= high + tolerance(high);
            }
            verdict.bright += is_bright ? 1 : 0;
            verdict.differing += differs ? 1 : 0;
            if (is_explained) continue;
            if (verdict.unexplained++ != 0) continue;
            verdict.first = "pixel " + std::to_string(x) + " " + std::to_string(y) + " is";
            for (int c = 0; c < 3; ++c) verdict.first += " " + std::to_string(actual(x, y, c));
            verdict.first += ", not";
            for (int c = 0; c < 3; ++c) verdict.first += " " + std::to_string(expected(x, y, c));
        }
    return verdict;
}

}  // namespace

std::string LitVerdict::text() const {
    return std::to_string(pixels) + " pixels, " + std::to_string(differing) + " differ, " +
           std::to_string(unexplained) + " unexplained" + (first.empty() ? "" : ": " + first);
}

void LitVerdict::add(const LitVerdict& other) {
    pixels += other.pixels;
    bright += other.bright;
    differing += other.differing;
    unexplained += other.unexplained;
    if (first.empty()) first = other.first;
}

LitVerdict compare(const render::Framebuffer& expected, const render::Framebuffer& actual) {
    const auto channel = [](const render::Framebuffer& picture) {
        return [&picture](int x, int y, int c) {
            const std::uint32_t pixel =
                picture.rgba[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                             static_cast<std::size_t>(x)];
            return static_cast<float>(pixel >> (8 * c) & 255u);
        };
    };
    return judge(expected.width, expected.height, 80, channel(expected), channel(actual), [](float) { return 2.0f; });
}

LitVerdict compare(const render::Image& expected, const render::Image& actual) {
    const auto channel = [](const render::Image& picture) {
        return [&picture](int x, int y, int c) {
            return picture.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                    static_cast<std::size_t>(x)) +
                               static_cast<std::size_t>(c)];
        };
    };
    return judge(expected.width, expected.height, 0.1f, channel(expected), channel(actual),
                 [](float value) { return 1e-3f * value + 1e-5f; });
}

}  // namespace enfilade::test

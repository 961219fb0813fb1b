#include "tools/gpu/picture_difference.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

namespace enfilade::tools::gpu {

namespace {

int channel(std::uint32_t pixel, int c) { return static_cast<int>(pixel >> (8 * c) & 255u); }

std::uint32_t at(const render::Framebuffer& picture, int x, int y) {
    return picture
        .rgba[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x)];
}

bool is_within(std::uint32_t a, std::uint32_t b, int steps) {
    for (int c = 0; c < 4; ++c)
        if (std::abs(channel(a, c) - channel(b, c)) > steps) return false;
    return true;
}

bool is_among_neighbours(const render::Framebuffer& expected, std::uint32_t pixel, int x, int y, int steps) {
    for (int c = 0; c < 3; ++c) {
        int low = 255, high = 0;
        for (int v = std::max(0, y - 1); v <= std::min(expected.height - 1, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(expected.width - 1, x + 1); ++u) {
                low = std::min(low, channel(at(expected, u, v), c));
                high = std::max(high, channel(at(expected, u, v), c));
            }
        if (channel(pixel, c) < low - steps || channel(pixel, c) > high + steps) return false;
    }
    return true;
}

/// What a tracer paints where it found nothing, whatever glass it came through.
bool is_leak(std::uint32_t expected, std::uint32_t actual) {
    return channel(actual, 1) == 0 && channel(actual, 0) > 0 && channel(actual, 2) > 0 && channel(expected, 1) > 2;
}

std::string words(const char* what, int x, int y, std::uint32_t expected, std::uint32_t actual) {
    std::array<char, 160> text;
    std::snprintf(text.data(), text.size(), "%s at pixel (%d, %d): (%d %d %d) instead of (%d %d %d)", what, x, y,
                  channel(actual, 0), channel(actual, 1), channel(actual, 2), channel(expected, 0),
                  channel(expected, 1), channel(expected, 2));
    return text.data();
}

}  // namespace

void PictureDifference::add(const PictureDifference& other) {
    pixels += other.pixels;
    exact += other.exact;
    same += other.same;
    at_edges += other.at_edges;
    unexplained += other.unexplained;
    leaks += other.leaks;
    if (first.empty()) first = other.first;
}

PictureDifference difference(const render::Framebuffer& expected, const render::Framebuffer& actual, int steps) {
    PictureDifference found;
    for (int y = 0; y < expected.height; ++y)
        for (int x = 0; x < expected.width; ++x) {
            const std::uint32_t want = at(expected, x, y), got = at(actual, x, y);
            ++found.pixels;
            if (want == got) ++found.exact;
            if (is_within(want, got, steps)) {
                ++found.same;
            } else if (is_leak(want, got)) {
                ++found.leaks;
                found.first = words("a leak", x, y, want, got);
            } else if (is_among_neighbours(expected, got, x, y, steps)) {
                ++found.at_edges;
            } else {
                ++found.unexplained;
                if (found.first.empty()) found.first = words("another colour", x, y, want, got);
            }
        }
    return found;
}

}  // namespace enfilade::tools::gpu

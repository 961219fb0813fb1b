#pragma once
// Pictures by packets on a device against pictures that are right, pixel by pixel.

#include <algorithm>
#include <cstdint>

#include "render/cuda/buffer.h"
#include "render/cuda/packets.h"
#include "render/framebuffer.h"

namespace enfilade::test {

/// What a pixel holds that nobody has written.
inline constexpr std::uint32_t poison = 0x00abcdefu;

/// The picture of a job, whose `rgba` is given here, on an image that was poisoned before.
inline render::Framebuffer drawn_by_packets(render::cuda::Device& device, render::cuda::PacketJob job) {
    render::Framebuffer picture(job.width, job.height);
    std::fill(picture.rgba.begin(), picture.rgba.end(), poison);
    const std::size_t bytes = picture.rgba.size() * sizeof(std::uint32_t);
    render::cuda::Buffer<std::uint32_t> image(device, picture.rgba.size());
    device.upload(image.data(), picture.rgba.data(), bytes);
    job.rgba = image.data();
    render::cuda::draw_packets(device, job);
    device.wait();
    device.download(picture.rgba.data(), image.data(), bytes);
    return picture;
}

/// Of pictures: pixels that differ by more than a step of a channel, that were not written, that are not black.
struct PictureTally {
    std::size_t pixels = 0, others = 0, unwritten = 0, lit = 0;

    void add(const render::Framebuffer& expected, const render::Framebuffer& actual) {
        pixels += expected.rgba.size();
        for (std::size_t i = 0; i < expected.rgba.size(); ++i) {
            if (actual.rgba[i] == poison) ++unwritten;
            if (expected.rgba[i] != 0xff000000u) ++lit;
            int most = 0;
            for (int channel = 0; channel < 32; channel += 8) {
                const int e = static_cast<int>(expected.rgba[i] >> channel & 255u);
                const int a = static_cast<int>(actual.rgba[i] >> channel & 255u);
                most = std::max({most, e - a, a - e});
            }
            if (most > 1) ++others;
        }
    }
};

}  // namespace enfilade::test

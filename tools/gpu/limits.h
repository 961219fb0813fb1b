#pragma once
// What a card cannot beat: measured in the same run as everything else, so that one sees how far from it a figure is.

#include <cstddef>
#include <cstdint>

#include "render/cuda/device.h"

namespace enfilade::tools::gpu {

/// Asks for a copy of `bytes` bytes (a multiple of 16) from one place of the device's memory to another by a kernel, 16
/// a thread: twice as many bytes travel.
void ask_copy(render::cuda::Device& device, const void* from, void* to, std::size_t bytes);

/// Asks for an image of one colour: what a frame would take whose pixels need no ray. rgba: [pixels]
void ask_image(render::cuda::Device& device, std::uint32_t* rgba, std::size_t pixels);

/// Asks for a kernel of one thread that does nothing but look at one number of its arguments.
void ask_empty(render::cuda::Device& device, std::uint32_t* never_written);

}  // namespace enfilade::tools::gpu

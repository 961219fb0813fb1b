#include "tools/gpu/limits.h"

#include "render/cuda/launch.h"

namespace enfilade::tools::gpu {

namespace {

struct alignas(16) Sixteen {
    std::uint32_t word[4];
};

struct CopyKernel {
    const Sixteen* from;
    Sixteen* to;
    ENFILADE_HD void operator()(std::uint64_t i) const { to[i] = from[i]; }
};

/// A thread a pixel, as pictures have it.
struct ImageKernel {
    std::uint32_t* rgba;
    ENFILADE_HD void operator()(std::uint64_t i) const { rgba[i] = 0xff808080u; }
};

struct EmptyKernel {
    std::uint32_t* written;
    std::uint32_t is_asked;
    ENFILADE_HD void operator()(std::uint64_t) const {
        if (is_asked != 0) *written = is_asked;
    }
};

}  // namespace

void ask_copy(render::cuda::Device& device, const void* from, void* to, std::size_t bytes) {
    render::cuda::for_each(device, bytes / sizeof(Sixteen),
                           CopyKernel{static_cast<const Sixteen*>(from), static_cast<Sixteen*>(to)});
}

void ask_image(render::cuda::Device& device, std::uint32_t* rgba, std::size_t pixels) {
    render::cuda::for_each(device, pixels, ImageKernel{rgba});
}

void ask_empty(render::cuda::Device& device, std::uint32_t* never_written) {
    render::cuda::for_each(device, 1, EmptyKernel{never_written, 0});
}

}  // namespace enfilade::tools::gpu

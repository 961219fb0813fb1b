#include "render/cuda/card.h"

#if defined(__CUDACC__)
#include <cuda_runtime.h>

#include "render/cuda/warp.h"
#endif

namespace enfilade::render::cuda {

#if defined(__CUDACC__)

namespace {

/// Is there for the driver to find: a card that cannot run it can run none of ours.
__global__ void nothing() {}

bool can_run(int number) {
    int before = 0;
    if (cudaGetDevice(&before) != cudaSuccess || cudaSetDevice(number) != cudaSuccess) return false;
    cudaFuncAttributes attributes = {};
    const bool can = cudaFuncGetAttributes(&attributes, nothing) == cudaSuccess;
    cudaGetLastError();  // a card too old is no error of whoever comes next
    cudaSetDevice(before);
    return can;
}

int count_cards() {
    int count = 0;
    const bool has_driver = cudaGetDeviceCount(&count) == cudaSuccess;
    cudaGetLastError();
    return has_driver ? count : 0;
}

}  // namespace

bool has_device_code() { return true; }

std::vector<Card> cards() {
    std::vector<Card> found;
    int driver = 0;
    cudaDriverGetVersion(&driver);
    const int count = count_cards();
    for (int number = 0; number < count; ++number) {
        cudaDeviceProp properties = {};
        if (cudaGetDeviceProperties(&properties, number) != cudaSuccess || !can_run(number)) continue;
        found.push_back({number, properties.name, properties.major, properties.minor, properties.multiProcessorCount,
                         properties.totalGlobalMem, static_cast<std::size_t>(properties.l2CacheSize), driver});
    }
    return found;
}

std::string why_no_card(int number) {
    int driver = 0;
    if (cudaDriverGetVersion(&driver) != cudaSuccess || driver == 0)
        return "There is no NVIDIA driver on this machine, so CUDA has no card: choose another --tracer.";
    const int count = count_cards();
    if (count == 0) return "There is no CUDA card on this machine: choose another --tracer.";
    if (number < 0 || number >= count)
        return "There is no CUDA card " + std::to_string(number) +
               " on this machine: give --device a number from 0 to " + std::to_string(count - 1) + ".";
    if (!can_run(number))
        return "CUDA card " + std::to_string(number) +
               " is older than the device code of this program, or its driver is: give --device another card, or "
               "choose "
               "another --tracer.";
    return "";
}

#else

bool has_device_code() { return false; }
std::vector<Card> cards() { return {}; }
std::string why_no_card(int) {
    return "This program was built without CUDA: build it where nvcc is found (ENFILADE_CUDA=ON), or choose another "
           "--tracer.";
}

#endif

}  // namespace enfilade::render::cuda

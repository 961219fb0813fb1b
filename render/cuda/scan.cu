#include "render/cuda/scan.h"

#include <functional>
#include <numeric>

#if defined(__CUDACC__)
#include <cub/device/device_scan.cuh>

#include "render/cuda/check_call.h"
#endif

namespace enfilade::render::cuda {

void Scanner::sums_before(const std::uint32_t* from, std::uint32_t* to, std::size_t count) {
    if (count == 0) return;
#if defined(__CUDACC__)
    if (device_.is_card()) {
        const auto scan = [&](void* room, std::size_t& bytes) {
            check_call(cub::DeviceScan::ExclusiveSum(room, bytes, from, to, static_cast<std::int64_t>(count),
                                                     static_cast<cudaStream_t>(device_.stream())),
                       "summing up");
        };
        std::size_t bytes = 0;
        scan(nullptr, bytes);
        if (room_.size() < bytes) {
            device_.wait();
            room_ = {};
            room_ = Buffer<std::uint8_t>(device_, bytes);
        }
        return scan(room_.data(), bytes);
    }
#endif
    std::exclusive_scan(from, from + count, to, std::uint32_t{0}, std::plus<>());
}

}  // namespace enfilade::render::cuda

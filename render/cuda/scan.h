#pragma once
// Sums of all numbers before each: how passes over data find where each of their results goes.

#include <cstddef>
#include <cstdint>

#include "render/cuda/buffer.h"

namespace enfilade::render::cuda {

/// Keeps the memory that it needs, for the next time. The device must outlive it.
class Scanner {
public:
    explicit Scanner(Device& device) : device_(device) {}
    /// to[i] = from[0] + ... + from[i - 1], modulo 2^32. Not in place. \throws CudaError
    void sums_before(const std::uint32_t* from, std::uint32_t* to, std::size_t count);

private:
    Device& device_;
    Buffer<std::uint8_t> room_;
};

}  // namespace enfilade::render::cuda

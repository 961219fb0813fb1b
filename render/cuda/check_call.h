#pragma once
// What CUDA's functions answer, as exceptions. For files that nvcc compiles.

#include <cuda_runtime.h>

#include <string>

#include "render/cuda/card.h"

namespace enfilade::render::cuda {

/// \throws CudaError if the call failed. doing: "copying to the card"
inline void check_call(cudaError_t answer, const char* doing) {
    if (answer == cudaSuccess) return;
    throw CudaError(std::string("The card failed while ") + doing + ": " + cudaGetErrorString(answer) + ".");
}

}  // namespace enfilade::render::cuda

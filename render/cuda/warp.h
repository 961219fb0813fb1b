#pragma once
// The 32 threads of a warp, for functions that they run together: on a card each thread is one lane, on the host one
// thread plays all of them, one after the other. What is computed outside of `for (int lane : warp.lanes())` is the
// same for all lanes; what differs is kept in PerLane.

#include <cstdint>

#include "accel/host_device.h"

namespace enfilade::render::cuda {

inline constexpr int warp_size = 32;

/// A number of each lane.
template <class T>
class PerLane {
public:
#if defined(__CUDA_ARCH__)
    ENFILADE_HD T& operator[](int) { return own_; }
    ENFILADE_HD const T& operator[](int) const { return own_; }

private:
    T own_;
#else
    T& operator[](int lane) { return of_[lane]; }
    const T& operator[](int lane) const { return of_[lane]; }

private:
    T of_[warp_size];
#endif
};

/// The lanes that this thread plays.
struct Lanes {
    struct Iterator {
        int lane;
        ENFILADE_HD int operator*() const { return lane; }
        ENFILADE_HD void operator++() { ++lane; }
        ENFILADE_HD bool operator!=(Iterator other) const { return lane != other.lane; }
    };
    int first, past;
    ENFILADE_HD Iterator begin() const { return {first}; }
    ENFILADE_HD Iterator end() const { return {past}; }
};

/// All of its functions are called by all lanes together.
class Warp {
public:
    ENFILADE_HD Lanes lanes() const {
#if defined(__CUDA_ARCH__)
        const int lane = static_cast<int>(threadIdx.x % warp_size);
        return {lane, lane + 1};
#else
        return {0, warp_size};
#endif
    }
    /// Bit i: of lane i.
    ENFILADE_HD std::uint32_t ballot(const PerLane<bool>& holds) const {
#if defined(__CUDA_ARCH__)
        return __ballot_sync(0xffffffffu, holds[0]);
#else
        std::uint32_t bits = 0;
        for (int lane = 0; lane < warp_size; ++lane) bits |= static_cast<std::uint32_t>(holds[lane]) << lane;
        return bits;
#endif
    }
    /// What one lane has. lane: the same for all
    template <class T>
    ENFILADE_HD T of_lane(const PerLane<T>& values, int lane) const {
#if defined(__CUDA_ARCH__)
        return __shfl_sync(0xffffffffu, values[0], lane);
#else
        return values[lane];
#endif
    }
    /// What lane `from[i]` has, for each lane i.
    template <class T>
    ENFILADE_HD PerLane<T> gathered(const PerLane<T>& values, const PerLane<int>& from) const {
        PerLane<T> result;
#if defined(__CUDA_ARCH__)
        result[0] = __shfl_sync(0xffffffffu, values[0], from[0]);
#else
        for (int lane = 0; lane < warp_size; ++lane) result[lane] = values[from[lane]];
#endif
        return result;
    }
    /// Waits until all lanes have come here, and see what each has written.
    ENFILADE_HD void meet() const {
#if defined(__CUDA_ARCH__)
        __syncwarp();
#endif
    }
};

}  // namespace enfilade::render::cuda

#pragma once
// Inside of the reference: Embree's device, and how its threads count.

#include <embree3/rtcore.h>

#include <string>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace enfilade::render::detail {

/// Denormal numbers as zero on the calling thread while it lives, as Embree advises.
class ZeroDenormals {
public:
    ZeroDenormals() {
#if defined(__SSE2__)
        saved_ = _mm_getcsr();
        _mm_setcsr(saved_ | 0x8040u);
#endif
    }
    ~ZeroDenormals() {
#if defined(__SSE2__)
        _mm_setcsr(saved_);
#endif
    }
    ZeroDenormals(const ZeroDenormals&) = delete;
    ZeroDenormals& operator=(const ZeroDenormals&) = delete;

private:
    unsigned saved_ = 0;
};

/// Stays where it is: Embree keeps its address.
class EmbreeDevice {
public:
    /// \throws IoError if Embree does not start
    EmbreeDevice();
    ~EmbreeDevice();
    EmbreeDevice(const EmbreeDevice&) = delete;
    EmbreeDevice& operator=(const EmbreeDevice&) = delete;

    [[nodiscard]] RTCDevice get() const { return device_; }
    /// \throws IoError if anything went wrong since it was made
    void require_success() const;

private:
    RTCDevice device_;
    std::string error_;
};

}  // namespace enfilade::render::detail

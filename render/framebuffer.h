#pragma once
// A picture for a screen: what is written when frames follow each other.

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

#include "render/isa.h"
#include "render/vec.h"

namespace enfilade::render {

/// Memory that begins at a line of the cache: stores of whole registers then cross none.
template <class T>
struct CacheAligned {
    using value_type = T;
    static constexpr std::align_val_t alignment = std::align_val_t(64);

    CacheAligned() = default;
    template <class U>
    CacheAligned(const CacheAligned<U>&) {}  // NOLINT: allocators convert
    T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), alignment)); }
    void deallocate(T* memory, std::size_t) { ::operator delete(memory, alignment); }
    friend bool operator==(const CacheAligned&, const CacheAligned&) { return true; }
};

/// Rows from the top, 32 bits a pixel: red in the lowest byte, then green, blue, and 255. A channel is the square root
/// of its linear light (gamma 2, near sRGB, one instruction), times 255, rounded; light beyond 1 is clipped.
struct Framebuffer {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t, CacheAligned<std::uint32_t>> rgba;  ///< [width * height]

    Framebuffer() = default;
    Framebuffer(int width_, int height_)
        : width(width_), height(height_), rgba(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}
    friend bool operator==(const Framebuffer&, const Framebuffer&) = default;
};

inline namespace ENFILADE_ISA {

ENFILADE_HD std::uint32_t encoded_channel(float linear) {
    const float clipped = linear > 0.0f ? (linear < 1.0f ? linear : 1.0f) : 0.0f;
    return static_cast<std::uint32_t>(fused(255.0f, root(clipped), 0.5f));
}

/// Linear light as a pixel of a framebuffer.
ENFILADE_HD std::uint32_t encoded(Vec3f linear) {
    return encoded_channel(linear.x) | encoded_channel(linear.y) << 8 | encoded_channel(linear.z) << 16 | 0xff000000u;
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render

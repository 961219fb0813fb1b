#pragma once
// A pointer and a count that device code understands.

#include <cstddef>
#include <cstdint>
#include <span>

#include "accel/host_device.h"

namespace enfilade::accel {

/// A read-only array that somebody else owns; plain data, so that it can be passed to a kernel.
template <class T>
struct ArrayView {
    const T* first = nullptr;
    std::uint64_t count = 0;

    ENFILADE_HD const T& operator[](std::size_t i) const { return first[i]; }
    ENFILADE_HD const T* data() const { return first; }
    ENFILADE_HD const T* begin() const { return first; }
    ENFILADE_HD const T* end() const { return first + count; }
    ENFILADE_HD std::size_t size() const { return static_cast<std::size_t>(count); }
    ENFILADE_HD bool empty() const { return count == 0; }
    operator std::span<const T>() const { return {first, static_cast<std::size_t>(count)}; }
};

}  // namespace enfilade::accel

#pragma once
// An array in a device's memory.

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "accel/array_view.h"
#include "render/cuda/device.h"

namespace enfilade::render::cuda {

/// Owns it. Movable; the device must outlive it.
template <class T>
class Buffer {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Buffer() = default;
    /// What is in it is not defined.
    Buffer(Device& device, std::size_t count)
        : device_(&device),
          data_(count == 0 ? nullptr : static_cast<T*>(device.allocate(count * sizeof(T)))),
          count_(count) {}
    Buffer(Device& device, std::span<const T> values) : Buffer(device, values.size()) {
        if (!values.empty()) device.upload(data_, values.data(), values.size_bytes());
    }
    Buffer(Buffer&& other) noexcept
        : device_(other.device_), data_(std::exchange(other.data_, nullptr)), count_(std::exchange(other.count_, 0)) {}
    Buffer& operator=(Buffer&& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(data_, other.data_);
        std::swap(count_, other.count_);
        return *this;
    }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    ~Buffer() {
        if (data_ != nullptr) device_->release(data_);
    }

    [[nodiscard]] T* data() const { return data_; }
    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] std::size_t bytes() const { return count_ * sizeof(T); }
    /// For kernels.
    [[nodiscard]] accel::ArrayView<T> view() const { return {data_, count_}; }
    /// Waits for all work before.
    [[nodiscard]] std::vector<T> read() const {
        std::vector<T> values(count_);
        if (count_ != 0) device_->download(values.data(), data_, bytes());
        return values;
    }
    void write(std::span<const T> values) { device_->upload(data_, values.data(), values.size_bytes()); }
    void clear() {
        if (count_ != 0) device_->clear(data_, bytes());
    }

private:
    Device* device_ = nullptr;
    T* data_ = nullptr;
    std::size_t count_ = 0;
};

}  // namespace enfilade::render::cuda

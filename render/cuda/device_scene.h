#pragma once
// A scene where kernels read it: uploaded once, for any number of pictures and rays.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "accel/array_view.h"
#include "accel/lights/light_trees.h"
#include "accel/scene.h"
#include "render/cuda/device.h"

namespace enfilade::render::cuda {

/// Copies of arrays in a device's memory, all released together.
class DeviceArrays {
public:
    explicit DeviceArrays(Device& device) : device_(&device) {}
    DeviceArrays(const DeviceArrays&) = delete;
    DeviceArrays& operator=(const DeviceArrays&) = delete;
    ~DeviceArrays();

    /// The device's copy of so many of them, nullptr for none. \throws CudaError
    template <class T>
    [[nodiscard]] const T* copy(const T* values, std::size_t count) {
        return static_cast<const T*>(copy_bytes(values, count * sizeof(T)));
    }
    template <class T>
    [[nodiscard]] accel::ArrayView<T> copy(const accel::ArrayView<T>& values) {
        return {copy(values.first, values.size()), values.count};
    }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }
    [[nodiscard]] Device& device() const { return *device_; }

private:
    [[nodiscard]] const void* copy_bytes(const void* values, std::size_t bytes);

    Device* device_;
    std::vector<void*> memory_;
    std::size_t bytes_ = 0;
};

/// The arrays that rays read, as they lie in the file.
[[nodiscard]] accel::SceneView copy_scene(const accel::SceneView& scene, DeviceArrays& arrays);

/// The arrays of light trees.
[[nodiscard]] accel::LightTreesView copy_trees(const accel::LightTreesView& trees, DeviceArrays& arrays);

}  // namespace enfilade::render::cuda

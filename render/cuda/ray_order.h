#pragma once
// In which order a device takes the rays of a stream: neighbours in space and direction make warps that stay together.

#include <cstddef>
#include <cstdint>
#include <memory>

#include "accel/scene.h"
#include "render/cuda/device.h"

namespace enfilade::render::cuda {

enum class RayOrder {
    AsGiven,
    Morton,  ///< along a curve through origins, and through directions where origins are near
    ByCell   ///< by the cell of the origin, and by the direction on the plan
};

/// What orders look at: columns in the device's memory.
struct OrderedColumns {
    const float* origin[3];
    const float* other[3];  ///< directions, or the other ends of segments
    bool other_is_end;
    const accel::CellId* cell;  ///< of the origin
};

/// Sorts numbers by keys. Equal keys keep their order: the same on any device.
class KeySorter {
public:
    explicit KeySorter(Device& device);
    KeySorter(const KeySorter&) = delete;
    KeySorter& operator=(const KeySorter&) = delete;
    ~KeySorter();

    /// Where the next keys and numbers are written: room for so many.
    void reserve(std::size_t count);
    [[nodiscard]] std::uint32_t* keys() const;
    [[nodiscard]] std::uint32_t* numbers() const;
    /// Asks for the first `count` of these numbers by ascending lower `bits` bits of their keys; valid until the next
    /// call. bits: 1 to 32
    [[nodiscard]] const std::uint32_t* sort(std::size_t count, int bits);
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// What keys of rays are counted from.
struct OrderFrame {
    float low[3];    ///< of the scene, metres
    float scale[3];  ///< to [0, 1]
    std::uint32_t cells;
};
[[nodiscard]] OrderFrame order_frame(const accel::SceneView& scene);

/// Asks for the numbers of `count` rays in that order; nullptr: as given. Valid until the sorter's next call.
[[nodiscard]] const std::uint32_t* order_rays(Device& device, KeySorter& sorter, const OrderFrame& frame,
                                              RayOrder order, const OrderedColumns& rays, std::size_t count);

}  // namespace enfilade::render::cuda

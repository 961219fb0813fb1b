#include "render/cuda/ray_order.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "render/cuda/buffer.h"
#include "render/cuda/launch.h"
#include "render/cuda/ray_order_keys.h"

#if defined(__CUDACC__)
#include <cub/device/device_radix_sort.cuh>
#endif

namespace enfilade::render::cuda {
namespace {

/// The same on this machine's cores.
void sort_on_host(const std::uint32_t* keys, const std::uint32_t* numbers, std::uint32_t* sorted, std::size_t count,
                  int bits) {
    const std::uint32_t mask = ~0u >> (32 - bits);
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return (keys[a] & mask) < (keys[b] & mask); });
    for (std::size_t i = 0; i < count; ++i) sorted[i] = numbers[order[i]];
}

struct KeyKernel {
    OrderFrame frame;
    RayOrder order;
    OrderedColumns rays;
    std::uint32_t* keys;
    std::uint32_t* numbers;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        const Vec3f o = {rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]};
        Vec3f d = {rays.other[0][i], rays.other[1][i], rays.other[2][i]};
        if (rays.other_is_end) d = d - o;
        keys[i] = order == RayOrder::Morton ? morton_key(frame, o, d)
                                            : cell_key(frame, static_cast<std::uint32_t>(rays.cell[i]), d);
        numbers[i] = static_cast<std::uint32_t>(i);
    }
};

}  // namespace

struct KeySorter::Parts {
    Device& device;
    Buffer<std::uint32_t> keys, numbers, sorted_keys, sorted_numbers;
    Buffer<std::uint8_t> room;  ///< of the card's sort
};

KeySorter::KeySorter(Device& device) : parts_(new Parts{device, {}, {}, {}, {}, {}}) {}

KeySorter::~KeySorter() = default;

void KeySorter::reserve(std::size_t count) {
    Parts& p = *parts_;
    if (p.keys.size() >= count) return;
    for (Buffer<std::uint32_t>* buffer : {&p.keys, &p.numbers, &p.sorted_keys, &p.sorted_numbers}) {
        *buffer = {};  // before the larger one
        *buffer = Buffer<std::uint32_t>(p.device, count);
    }
}

std::uint32_t* KeySorter::keys() const { return parts_->keys.data(); }
std::uint32_t* KeySorter::numbers() const { return parts_->numbers.data(); }

const std::uint32_t* KeySorter::sort(std::size_t count, int bits) {
    Parts& p = *parts_;
    if (count == 0) return p.sorted_numbers.data();
#if defined(__CUDACC__)
    if (p.device.is_card()) {
        const auto sort = [&](void* room, std::size_t& bytes) {
            check_call(cub::DeviceRadixSort::SortPairs(
                           room, bytes, p.keys.data(), p.sorted_keys.data(), p.numbers.data(), p.sorted_numbers.data(),
                           static_cast<std::int64_t>(count), 0, bits, static_cast<cudaStream_t>(p.device.stream())),
                       "sorting rays");
        };
        std::size_t bytes = 0;
        sort(nullptr, bytes);
        if (p.room.size() < bytes) {
            p.device.wait();
            p.room = {};
            p.room = Buffer<std::uint8_t>(p.device, bytes);
        }
        sort(p.room.data(), bytes);
        return p.sorted_numbers.data();
    }
#endif
    sort_on_host(p.keys.data(), p.numbers.data(), p.sorted_numbers.data(), count, bits);
    return p.sorted_numbers.data();
}

std::size_t KeySorter::bytes() const {
    const Parts& p = *parts_;
    return p.keys.bytes() + p.numbers.bytes() + p.sorted_keys.bytes() + p.sorted_numbers.bytes() + p.room.bytes();
}

OrderFrame order_frame(const accel::SceneView& scene) {
    float low[3] = {0, 0, 0}, high[3] = {1, 1, 1};
    const auto widen = [&](int axis, float at) {
        low[axis] = std::min(low[axis], at);
        high[axis] = std::max(high[axis], at);
    };
    for (std::size_t axis = 0; axis < 2 && !scene.cells.empty(); ++axis) {
        const accel::ArrayView<float>& at = axis == 0 ? scene.section_x : scene.section_y;
        low[axis] = high[axis] = at[0];
        for (std::size_t i = 0; i + 1 < at.size(); ++i) widen(static_cast<int>(axis), at[i]);
    }
    if (!scene.cells.empty()) low[2] = high[2] = scene.cells[0].z_floor;
    for (const accel::Cell& cell : scene.cells) {
        widen(2, cell.z_floor);
        widen(2, cell.z_ceiling);
    }
    OrderFrame frame = {};
    for (int k = 0; k < 3; ++k) {
        frame.low[k] = low[k];
        frame.scale[k] = high[k] > low[k] ? 1 / (high[k] - low[k]) : 1;
    }
    frame.cells = static_cast<std::uint32_t>(scene.cells.size());
    return frame;
}

const std::uint32_t* order_rays(Device& device, KeySorter& sorter, const OrderFrame& frame, RayOrder order,
                                const OrderedColumns& rays, std::size_t count) {
    if (order == RayOrder::AsGiven || count == 0) return nullptr;
    sorter.reserve(count);
    for_each(device, count, KeyKernel{frame, order, rays, sorter.keys(), sorter.numbers()});
    return sorter.sort(count, key_bits(frame, order));
}

}  // namespace enfilade::render::cuda

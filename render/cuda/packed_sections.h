#pragma once
// A scene's cells and sections as records of 16 and 32 bytes, which a device loads in one or two instructions each:
// made once, at upload. For the walk (render/walk.h), which sees the same numbers in the same order.

#include <cstdint>
#include <span>
#include <vector>

#include "accel/scene.h"
#include "render/cuda/device_scene.h"
#include "render/object_walk.h"
#include "render/sign_bits.h"

namespace enfilade::render::cuda {

/// How sections lie in a device's memory.
enum class SectionLayout {
    Columns,  ///< as in the file: x and y of a line apart
    Points,   ///< records, and lines of 8 bytes: (x, y)
    Pairs     ///< records, and two lines in 16 bytes
};

/// What a walk reads of a cell, and its objects.
struct alignas(16) PackedCell {
    std::uint32_t first_section;
    std::uint32_t section_count;
    float z_floor;
    float z_ceiling;
    accel::Target floor;
    accel::Target ceiling;
    std::uint32_t first_object, past_object;  ///< places in `cell_objects`
};
static_assert(sizeof(PackedCell) == 32);

/// A section's stack: of one face or two, all that a walk reads.
struct alignas(16) PackedStack {
    float z_top;                 ///< of the lowest face
    accel::Target lowest;        ///< behind it
    std::uint32_t above;         ///< of two faces: the target behind the upper one; of more: their number
    std::uint32_t first_of_few;  ///< the lowest face; in the upper two bits how many there are: 1, 2, 3 for more
};
static_assert(sizeof(PackedStack) == 16);

/// Two lines, or one.
struct alignas(8) PackedLine {
    float x, y;
};

/// A record, by loads of 16 (8) bytes through the read-only cache.
template <class Record>
ENFILADE_HD Record load_record(const Record* at) {
#if defined(__CUDA_ARCH__)
    static_assert(sizeof(Record) % 8 == 0);
    Record record;
    if constexpr (sizeof(Record) % 16 == 0) {
        for (unsigned k = 0; k < sizeof(Record) / 16; ++k)
            reinterpret_cast<uint4*>(&record)[k] = __ldg(reinterpret_cast<const uint4*>(at) + k);
    } else {
        for (unsigned k = 0; k < sizeof(Record) / 8; ++k)
            reinterpret_cast<uint2*>(&record)[k] = __ldg(reinterpret_cast<const uint2*>(at) + k);
    }
    return record;
#else
    return *at;
#endif
}

/// The scene with its records. Its own arrays are there as well: shading reads them, and recoveries.
template <bool pairs>
struct PackedScene : accel::SceneView {
    const PackedCell* packed_cells;
    const PackedLine* packed_lines;  ///< one more behind the last, to make them pairs
    const PackedStack* packed_stacks;
};

// What the walk reads (render/walk.h, object_walk.h): beside the functions for a SceneView, those for records.
using render::left_lines;
using render::line_at;
using render::most_lines;
using render::objects_of;
using render::stack_face;
using render::walked_cell;

template <bool pairs>
ENFILADE_HD PackedCell walked_cell(const PackedScene<pairs>& scene, std::uint32_t cell) {
    return load_record(scene.packed_cells + cell);
}

template <bool pairs>
ENFILADE_HD ObjectList objects_of(const PackedScene<pairs>& scene, std::uint32_t cell) {
    const PackedCell c = load_record(scene.packed_cells + cell);
    return {c.first_object, c.past_object};
}

template <bool pairs>
ENFILADE_HD LinePlace line_at(const PackedScene<pairs>& scene, std::uint32_t section) {
    const PackedLine line = load_record(scene.packed_lines + section);
    return {line.x, line.y};
}

/// A stray line may stand before the first one of a pair and behind the last.
template <bool pairs>
ENFILADE_HD constexpr std::uint32_t most_lines(const PackedScene<pairs>&) {
    return pairs ? 30 : 32;
}

template <bool pairs>
ENFILADE_HD std::uint32_t left_lines(const PackedScene<pairs>& scene, const Ray<float>& ray, std::uint32_t first,
                                     std::uint32_t count) {
    struct alignas(16) Pair {
        PackedLine a, b;
    };
    const NegatedSide side(ray);
    SignBits bits;
    if constexpr (pairs) {
        const std::uint32_t stray = first & 1u;
        const Pair* at = reinterpret_cast<const Pair*>(scene.packed_lines + (first - stray));
        const std::size_t count_of_pairs = (stray + count + 1) / 2;
        for (std::size_t i = 0; i < count_of_pairs; ++i) {
            const Pair pair = load_record(at + i);
            bits.push(side(pair.a.x, pair.a.y));
            bits.push(side(pair.b.x, pair.b.y));
        }
        return (bits.in_order(static_cast<std::uint32_t>(2 * count_of_pairs)) >> stray) ^ ray.zero_mask;
    } else {
        const PackedLine* at = scene.packed_lines + first;
        const std::size_t size = count;
        for (std::size_t i = 0; i < size; ++i) {
            const PackedLine line = load_record(at + i);
            bits.push(side(line.x, line.y));
        }
        return bits.in_order(count) ^ ray.zero_mask;
    }
}

/// In double, where rounding led out behind the origin.
template <bool pairs>
ENFILADE_HD std::uint32_t left_lines(const PackedScene<pairs>& scene, const Ray<double>& ray, std::uint32_t first,
                                     std::uint32_t count) {
    return left_lines(static_cast<const accel::SceneView&>(scene), ray, first, count);
}

/// As StackFace.
struct PackedFace {
    std::uint32_t face;
    bool is_top;
    accel::Target behind;
    ENFILADE_HD accel::Target target(const accel::SceneView&) const { return behind; }
};

template <bool pairs, class T>
ENFILADE_HD PackedFace stack_face(const PackedScene<pairs>& scene, std::uint32_t section, T scaled_dz, T origin_z,
                                  T den) {
    const PackedStack stack = load_record(scene.packed_stacks + section);
    const std::uint32_t few = stack.first_of_few >> 30, first = stack.first_of_few & 0x3fffffffu;
    const bool is_above = few != 1 && !(scaled_dz < (T(stack.z_top) - origin_z) * den);
    if (!is_above) return {first, few == 1, stack.lowest};
    if (few == 2) return {first + 1, true, {stack.above}};
    const std::uint32_t top = first + stack.above - 1;
    std::uint32_t face = first + 1;
    while (face < top && !(scaled_dz < (T(scene.side_faces[face].z_top) - origin_z) * den)) ++face;
    return {face, face == top, scene.side_faces[face].target};
}

/// The records of a scene, on the host.
struct PackedArrays {
    std::vector<PackedCell> cells;
    std::vector<PackedLine> lines;
    std::vector<PackedStack> stacks;

    /// \throws LimitError if the scene has 2^30 side faces or more
    explicit PackedArrays(const accel::SceneView& scene);
};

/// Copies of them beside `copy` (copy_scene's), which has the same arrays.
template <bool pairs>
[[nodiscard]] PackedScene<pairs> copy_packed(const accel::SceneView& copy, const PackedArrays& packed,
                                             DeviceArrays& arrays) {
    return {copy, arrays.copy(packed.cells.data(), packed.cells.size()),
            arrays.copy(packed.lines.data(), packed.lines.size()),
            arrays.copy(packed.stacks.data(), packed.stacks.size())};
}

}  // namespace enfilade::render::cuda

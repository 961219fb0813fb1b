#pragma once
// Rays and segments that a test owns, asked of the scalar tracer and of a device.

#include <gtest/gtest.h>

#include <cstring>
#include <utility>
#include <vector>

#include "render/cuda/buffer.h"
#include "render/cuda/streams.h"
#include "render/ray_stream.h"
#include "tests/support/ray_table.h"

namespace enfilade::test {

using render::cuda::Buffer;
using render::cuda::Device;
using render::cuda::DeviceStream;

/// What became of rays, all columns.
struct Answers {
    std::vector<float> distance;
    std::vector<accel::SourceFaceId> source_face;
    std::vector<accel::CellId> cell;
    std::vector<render::WalkStatus> status;
    std::vector<accel::ObjectId> object;
    std::vector<std::uint32_t> triangle;

    static Answers of(std::size_t count) {
        return {std::vector<float>(count),           std::vector<accel::SourceFaceId>(count),
                std::vector<accel::CellId>(count),   std::vector<render::WalkStatus>(count),
                std::vector<accel::ObjectId>(count), std::vector<std::uint32_t>(count)};
    }
    [[nodiscard]] std::size_t size() const { return status.size(); }
    [[nodiscard]] render::HitColumns columns() { return {distance, source_face, cell, status, object, triangle}; }
};

/// Those of the scalar tracer. rays: see RayTable
inline Answers scalar_answers(const accel::SceneView& scene, const RayTable& rays,
                              const render::ObjectTracer* objects = nullptr) {
    Answers a = Answers::of(rays.size());
    render::nearest(scene, rays.columns(), a.columns(), {.tracer = render::Tracer::Scalar, .objects = objects});
    return a;
}

/// Rays in a device's memory, and room for their answers.
class RaysOnDevice {
public:
    RaysOnDevice(Device& device, const RayTable& rays)
        : start_(device, rays.start),
          limit_(device, rays.max_distance),
          distance_(device, rays.size()),
          face_(device, rays.size()),
          cell_(device, rays.size()),
          status_(device, rays.size()),
          object_(device, rays.size()),
          triangle_(device, rays.size()) {
        for (int k = 0; k < 3; ++k) {
            origin_[k] = Buffer<float>(device, rays.origin[k]);
            direction_[k] = Buffer<float>(device, rays.direction[k]);
        }
    }
    [[nodiscard]] render::cuda::DeviceRays rays() const {
        return {{origin_[0].data(), origin_[1].data(), origin_[2].data()},
                {direction_[0].data(), direction_[1].data(), direction_[2].data()},
                start_.data(),
                limit_.data(),
                start_.size()};
    }
    [[nodiscard]] render::cuda::DeviceHits hits() const {
        return {distance_.data(), face_.data(), cell_.data(), status_.data(), object_.data(), triangle_.data()};
    }
    /// stream: whoever answers as DeviceStream does
    template <class Stream>
    [[nodiscard]] Answers ask(Stream& stream) const {
        stream.nearest(rays(), hits());
        return {distance_.read(), face_.read(), cell_.read(), status_.read(), object_.read(), triangle_.read()};
    }

private:
    Buffer<float> origin_[3], direction_[3];
    Buffer<accel::CellId> start_;
    Buffer<float> limit_, distance_;
    Buffer<accel::SourceFaceId> face_;
    Buffer<accel::CellId> cell_;
    Buffer<render::WalkStatus> status_;
    Buffer<accel::ObjectId> object_;
    Buffer<std::uint32_t> triangle_;
};

/// From the origins of rays to places of other rays.
struct SegmentTable {
    std::vector<float> from[3], to[3];
    std::vector<accel::CellId> from_cell, to_cell;

    [[nodiscard]] std::size_t size() const { return from_cell.size(); }
    [[nodiscard]] render::SegmentColumns columns(bool cells_known) const {
        render::SegmentColumns all = {from[0], from[1], from[2], to[0], to[1], to[2], from_cell, {}};
        if (cells_known) all.to_cell = to_cell;
        return all;
    }
    [[nodiscard]] std::vector<std::uint8_t> scalar_answers(const accel::SceneView& scene, bool cells_known,
                                                           const render::ObjectTracer* objects = nullptr) const {
        std::vector<std::uint8_t> seen(size(), 77);
        render::visible(scene, columns(cells_known), seen, {.tracer = render::Tracer::Scalar, .objects = objects});
        return seen;
    }
    template <class Stream>
    [[nodiscard]] std::vector<std::uint8_t> ask(Device& device, Stream& stream, bool cells_known) const {
        const Buffer<float> p[3] = {{device, from[0]}, {device, from[1]}, {device, from[2]}};
        const Buffer<float> q[3] = {{device, to[0]}, {device, to[1]}, {device, to[2]}};
        const Buffer<accel::CellId> p_cell(device, from_cell), q_cell(device, to_cell);
        const Buffer<std::uint8_t> seen(device, size());
        stream.visible({{p[0].data(), p[1].data(), p[2].data()},
                        {q[0].data(), q[1].data(), q[2].data()},
                        p_cell.data(),
                        cells_known ? q_cell.data() : nullptr,
                        size()},
                       seen.data());
        return seen.read();
    }
};

/// Segments between the origins of rays that follow each other.
inline SegmentTable segments_between(const RayTable& rays) {
    SegmentTable segments;
    for (std::size_t i = 0; i + 1 < rays.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            segments.from[k].push_back(rays.origin[k][i]);
            segments.to[k].push_back(rays.origin[k][i + 1]);
        }
        segments.from_cell.push_back(rays.start[i]);
        segments.to_cell.push_back(rays.start[i + 1]);
    }
    return segments;
}

/// How many of the answers differ; distances bit by bit.
inline std::size_t count_differing(const Answers& expected, const Answers& actual) {
    std::size_t differing = expected.size() != actual.size() ? 1 : 0;
    for (std::size_t i = 0; i < expected.size() && expected.size() == actual.size(); ++i) {
        std::uint32_t a = 0, b = 0;
        std::memcpy(&a, &expected.distance[i], 4);
        std::memcpy(&b, &actual.distance[i], 4);
        const bool both_nan = std::isnan(expected.distance[i]) && std::isnan(actual.distance[i]);
        const bool is_same = (a == b || both_nan) && expected.source_face[i] == actual.source_face[i] &&
                             expected.cell[i] == actual.cell[i] && expected.status[i] == actual.status[i] &&
                             expected.object[i] == actual.object[i] && expected.triangle[i] == actual.triangle[i];
        differing += is_same ? 0 : 1;
    }
    return differing;
}

/// On the host's cores the same bits; on a card 99.999 % of them.
inline void expect_same(const Device& device, const Answers& expected, const Answers& actual) {
    ASSERT_EQ(expected.size(), actual.size());
    EXPECT_LE(count_differing(expected, actual), device.is_card() ? expected.size() / 100000 : 0);
}

inline void expect_same(const Device& device, const std::vector<std::uint8_t>& expected,
                        const std::vector<std::uint8_t>& actual) {
    ASSERT_EQ(expected.size(), actual.size());
    std::size_t differing = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) differing += expected[i] != actual[i] ? 1 : 0;
    EXPECT_LE(differing, device.is_card() ? expected.size() / 100000 : 0);
}

}  // namespace enfilade::test

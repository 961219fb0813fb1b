// Shadow rays by all tracers, orders and instruction sets against the scalar walk and the oracle.
#include <gtest/gtest.h>

#include <limits>
#include <tuple>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "render/ray_stream.h"
#include "tests/render/walk_paths.h"
#include "tests/support/error_band.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/rounded_to_float.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

struct Segments {
    std::vector<Vec3d> p, q;
    std::vector<float> from[3], to[3];
    std::vector<accel::CellId> from_cell, to_cell;
    std::vector<accel::SourceFaceId> on;  ///< the faces on which they start, if they do

    void add(Vec3d a, accel::CellId a_cell, Vec3d b, accel::CellId b_cell) {
        p.push_back(a);
        q.push_back(b);
        const double from_xyz[3] = {a.x, a.y, a.z}, to_xyz[3] = {b.x, b.y, b.z};
        for (int k = 0; k < 3; ++k) {
            from[k].push_back(static_cast<float>(from_xyz[k]));
            to[k].push_back(static_cast<float>(to_xyz[k]));
        }
        from_cell.push_back(a_cell);
        to_cell.push_back(b_cell);
    }

    [[nodiscard]] std::vector<std::uint8_t> seen(const accel::SceneView& scene, bool goals_known,
                                                 const StreamOptions& options) const {
        std::vector<std::uint8_t> answers(p.size(), 77);
        SegmentColumns columns = {from[0], from[1], from[2], to[0], to[1], to[2], from_cell, {}};
        if (goals_known) columns.to_cell = to_cell;
        visible(scene, columns, answers, options);
        return answers;
    }
};

class ShadowsAgree : public testing::TestWithParam<std::tuple<double, test::InstructionSet>> {
protected:
    ShadowsAgree()
        : set_(std::get<1>(GetParam())),
          scene_(accel::assemble(
              test::synthetic_office({.rooms_per_row = 5, .rows = 4, .storeys = 2, .turn = std::get<0>(GetParam())}))),
          oracle_(scene_.view()),
          band_(error_band(scene_.view())) {}

    [[nodiscard]] std::uint32_t any_cell() {
        return static_cast<std::uint32_t>(random_() % scene_.view().cells.size());
    }

    /// From points of one cell to points of one other, sixteen at a time: what lights ask for.
    Segments towards_lamps(std::size_t lamps, std::size_t points) {
        Segments segments;
        for (std::size_t l = 0; l < lamps; ++l) {
            const std::uint32_t lamp_cell = any_cell();
            const Vec3d lamp = test::random_point(scene_.view(), lamp_cell, random_);
            const std::uint32_t cell = any_cell();
            for (std::size_t i = 0; i < points; ++i)
                segments.add(test::random_point(scene_.view(), cell, random_), static_cast<accel::CellId>(cell), lamp,
                             static_cast<accel::CellId>(lamp_cell));
        }
        return segments;
    }

    /// From points where rays ended, on faces, to points of the cells where they began: shadow rays of pictures.
    Segments from_faces(std::size_t count) {
        Segments segments;
        const accel::SceneView& view = scene_.view();
        const auto on_face = [&](std::uint32_t cell) {
            const Vec3d p = test::random_point(view, cell, random_), d = test::random_direction(random_);
            const RayHit hit = trace_ray(view, {p, d, static_cast<accel::CellId>(cell)});
            return std::tuple(test::rounded_to_float(p + hit.distance * d), hit.cell, hit.source_face);
        };
        while (segments.p.size() < count) {
            const std::uint32_t cell = any_cell();
            const auto [p, p_cell, p_face] = on_face(cell);
            segments.add(p, p_cell, test::random_point(scene_.view(), cell, random_), static_cast<accel::CellId>(cell));
            segments.on.push_back(p_face);
        }
        return segments;
    }

    /// 1, 0, or 2 where rounding decides: the segment passes an edge, or ends at a face, within the band.
    [[nodiscard]] int truth(Vec3d p, Vec3d q) const {
        const Vec3d way = q - p;
        const double metres = length(way);
        if (!(metres > 0)) return 1;
        if (oracle_.edge_distance(p, way, metres) <= band_) return 2;
        const auto hit = oracle_.trace(p, way);
        if (!hit) return 1;
        const double slack = band_ / std::max(1e-5, std::abs(dot(oracle_.normal(hit->source_face), normalized(way))));
        if (oracle_.plane_distance(p, hit->source_face) <= band_) return 2;
        if (std::abs(hit->distance - metres) <= slack) return 2;
        return hit->distance > metres ? 1 : 0;
    }

    void expect_true(const Segments& segments, const char* name, bool doubtful_often = false) const {
        std::vector<int> expected(segments.p.size());
        std::size_t doubtful = 0, seeing = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            expected[i] = truth(segments.p[i], segments.q[i]);
            // In the plane of the face where it starts, rounding decides on which side of it the segment runs.
            if (!segments.on.empty() && oracle_.plane_distance(segments.q[i], segments.on[i]) <= band_) expected[i] = 2;
            doubtful += expected[i] == 2;
            seeing += expected[i] == 1;
        }
        if (!doubtful_often) {
            EXPECT_LT(doubtful, expected.size() / 50) << name;
        }
        EXPECT_GT(seeing, 0u) << name;
        for (const Tracer tracer : {Tracer::Scalar, Tracer::Simd, Tracer::Packet})
            for (const StreamOrder order : {StreamOrder::Coherent, StreamOrder::Any})
                for (const bool goals_known : {false, true}) {
                    const std::vector<std::uint8_t> seen =
                        segments.seen(scene_.view(), goals_known, {.tracer = tracer, .order = order});
                    std::size_t wrong = 0;
                    for (std::size_t i = 0; i < seen.size(); ++i) {
                        if (seen[i] <= 1 && (expected[i] == 2 || seen[i] == expected[i])) continue;
                        if (wrong++ > 2) continue;
                        const Vec3d p = segments.p[i], q = segments.q[i];
                        ADD_FAILURE() << name << ", tracer " << int(tracer) << ", order " << int(order)
                                      << ", goals known " << goals_known << ": segment " << i << " from "
                                      << std::hexfloat << p.x << " " << p.y << " " << p.z << " cell "
                                      << index(segments.from_cell[i]) << " to " << q.x << " " << q.y << " " << q.z
                                      << " cell " << index(segments.to_cell[i]) << " answers " << int(seen[i])
                                      << " instead of " << expected[i];
                    }
                    EXPECT_EQ(wrong, 0u) << name;
                }
    }

    test::UsingInstructionSet set_;
    accel::Scene scene_;
    Oracle oracle_;
    double band_;
    std::mt19937_64 random_{31};
};

TEST_P(ShadowsAgree, FromTheCellsPointsToALamp) { expect_true(towards_lamps(250, 16), "to lamps"); }

TEST_P(ShadowsAgree, InBatchesOfAnySize) { expect_true(towards_lamps(300, 7), "to lamps"); }

TEST_P(ShadowsAgree, FromPointsOnFaces) { expect_true(from_faces(2000), "from faces", true); }

TEST_P(ShadowsAgree, WithinACellAndBetweenEqualPoints) {
    Segments segments;
    for (int i = 0; i < 500; ++i) {
        const std::uint32_t cell = any_cell();
        const Vec3d p = test::random_point(scene_.view(), cell, random_);
        const Vec3d q = i % 3 == 0 ? p : test::random_point(scene_.view(), cell, random_);
        segments.add(p, static_cast<accel::CellId>(cell), q, static_cast<accel::CellId>(cell));
    }
    expect_true(segments, "within a cell");
}

TEST_P(ShadowsAgree, StraightUpAndAlongAxes) {
    Segments segments;
    const accel::SceneView& view = scene_.view();
    while (segments.p.size() < 2000) {
        const std::uint32_t cell = any_cell();
        const Vec3d p = test::random_point(view, cell, random_);
        Vec3d q = p;
        const double step = std::uniform_real_distribution<double>(-9, 9)(random_);
        const auto axis = random_() % 3;
        (axis == 0 ? q.x : axis == 1 ? q.y : q.z) += step;
        q = test::rounded_to_float(q);
        const auto goal = accel::locate(view, {q.x, q.y, q.z});
        if (goal) segments.add(p, static_cast<accel::CellId>(cell), q, *goal);
    }
    expect_true(segments, "along axes");
}

TEST_P(ShadowsAgree, ThatWhatIsNoSegmentSeesNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const Vec3d p = test::centre_of(scene_.view(), 0);
    Segments segments;
    for (const double bad : {nan, inf, -inf}) {
        segments.add(p, accel::CellId{0}, {bad, p.y, p.z}, accel::CellId{1});
        segments.add({p.x, p.y, bad}, accel::CellId{0}, p + Vec3d{1, 0, 0}, accel::CellId{1});
    }
    for (const Tracer tracer : {Tracer::Scalar, Tracer::Simd, Tracer::Packet})
        for (const bool goals_known : {false, true})
            for (const std::uint8_t answer : segments.seen(scene_.view(), goals_known, {.tracer = tracer}))
                EXPECT_EQ(answer, 0);
}

INSTANTIATE_TEST_SUITE_P(Turned, ShadowsAgree,
                         testing::Combine(testing::Values(0.0, 0.3), testing::ValuesIn(test::instruction_sets())),
                         [](const auto& one) {
                             return "Turn" + std::to_string(int(10 * std::get<0>(one.param))) + "_" +
                                    std::get<1>(one.param).name;
                         });

}  // namespace
}  // namespace enfilade::render

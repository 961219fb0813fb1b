// Streams of rays by all tracers, orders and instruction sets against the scalar walk, ray by ray.
#include <gtest/gtest.h>

#include <tuple>

#include "accel/assemble.h"
#include "render/ray_stream.h"
#include "tests/support/degenerate_rays.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/stream_judge.h"
#include "tests/support/synthetic_scene.h"
#include "tools/random_rays.h"

namespace enfilade::render {
namespace {

using test::RayTable;
using test::StreamVerdict;

using Case = std::tuple<double, test::InstructionSet>;  ///< the turn of the office

class StreamsAgree : public testing::TestWithParam<Case> {
protected:
    StreamsAgree()
        : set_(std::get<1>(GetParam())),
          scene_(accel::assemble(
              test::synthetic_office({.rooms_per_row = 6, .rows = 5, .storeys = 3, .turn = std::get<0>(GetParam())}))),
          judge_(scene_.view()) {}

    /// Every tracer and order. Few differ at all, except of rays that seek edges.
    void expect_right(const std::vector<RayQuery>& rays, const char* name, double most_differing = 2e-4) const {
        std::vector<RayHit> expected(rays.size());
        trace_rays(scene_.view(), rays, expected);
        RayTable table(rays);
        for (const Tracer tracer : {Tracer::Scalar, Tracer::Simd, Tracer::Packet})
            for (const StreamOrder order : {StreamOrder::Coherent, StreamOrder::Any}) {
                StreamOptions options;
                options.tracer = tracer;
                options.order = order;
                RayStats stats;
                options.stats = &stats;
                table.trace(scene_.view(), options);
                const StreamVerdict verdict = judge_.compare(rays, expected, table);
                EXPECT_TRUE(verdict.is_right())
                    << name << ", tracer " << int(tracer) << ", order " << int(order) << ": " << verdict.text();
                EXPECT_LE(static_cast<double>(verdict.differing), 4 + most_differing * static_cast<double>(rays.size()))
                    << name << ", tracer " << int(tracer) << ", order " << int(order) << ": " << verdict.text();
                EXPECT_EQ(stats.leaks, 0u) << name;
            }
    }

    test::UsingInstructionSet set_;
    accel::Scene scene_;
    test::StreamJudge judge_;
};

TEST_P(StreamsAgree, OnRaysOfAllFamilies) {
    for (const tools::RayFamily family : tools::ray_families)
        expect_right(tools::RandomRays(scene_.view(), 21).take(20000, family), tools::name_of(family), 0.04);
}

TEST_P(StreamsAgree, OnDegenerateRays) {
    for (const test::Degenerate family : test::degenerate_families)
        expect_right(test::degenerate_rays(scene_.view(), family, 5000, 22), test::name_of(family),
                     family == test::Degenerate::OnCorners ? 0.15 : 0.03);
}

TEST_P(StreamsAgree, OnRaysOfOneCellInOneBatch) {
    std::vector<RayQuery> rays;
    for (RayQuery ray : tools::RandomRays(scene_.view(), 23).take(300)) {
        for (int i = 0; i < 40; ++i) {  // coherent: sixteen at once
            ray.direction.x += 0x1p-8;
            ray.direction.z -= 0x1p-9;
            rays.push_back(ray);
        }
    }
    expect_right(rays, "coherent");
}

TEST_P(StreamsAgree, WhenRaysOfAllKindsAreMixed) {
    std::vector<std::vector<RayQuery>> families;
    for (const test::Degenerate family : test::degenerate_families)
        families.push_back(test::degenerate_rays(scene_.view(), family, 1000, 24));
    for (const tools::RayFamily family : tools::ray_families)
        families.push_back(tools::RandomRays(scene_.view(), 25).take(1000, family));
    std::vector<RayQuery> rays;
    for (std::size_t i = 0; i < 1000; ++i)
        for (const std::vector<RayQuery>& family : families) rays.push_back(family[i]);
    expect_right(rays, "mixed", 0.05);
}

TEST_P(StreamsAgree, OnAnyNumberOfRays) {
    const std::vector<RayQuery> all = tools::RandomRays(scene_.view(), 26).take(70);
    for (std::size_t count = 0; count <= 70; ++count)
        expect_right({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)}, "few");
}

INSTANTIATE_TEST_SUITE_P(Turned, StreamsAgree,
                         testing::Combine(testing::Values(0.0, 0.0001, 0.3),
                                          testing::ValuesIn(test::instruction_sets())),
                         [](const auto& one) {
                             return "Turn" + std::to_string(int(10000 * std::get<0>(one.param))) + "_" +
                                    std::get<1>(one.param).name;
                         });

// A judge that finds nothing wrong is none.
class StreamJudging : public testing::Test {
protected:
    StreamJudging()
        : scene_(accel::assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2, .turn = 0.3}))),
          judge_(scene_.view()),
          rays_(tools::RandomRays(scene_.view(), 3).take(500)),
          expected_(500),
          table_(rays_) {
        trace_rays(scene_.view(), rays_, expected_);
        table_.trace(scene_.view(), {.tracer = Tracer::Scalar});
    }
    [[nodiscard]] StreamVerdict judged() const { return judge_.compare(rays_, expected_, table_); }

    accel::Scene scene_;
    test::StreamJudge judge_;
    std::vector<RayQuery> rays_;
    std::vector<RayHit> expected_;
    RayTable table_;
};

TEST_F(StreamJudging, AcceptsTheScalarTracersAnswers) { EXPECT_TRUE(judged().is_right()) << judged().text(); }

TEST_F(StreamJudging, FindsAnswersThatBelongToTheNextRay) {
    std::rotate(table_.source_face.begin(), table_.source_face.begin() + 1, table_.source_face.end());
    std::rotate(table_.cell.begin(), table_.cell.begin() + 1, table_.cell.end());
    EXPECT_GT(judged().outside_band, 400u) << judged().text();
}

TEST_F(StreamJudging, FindsADistanceOffByFourInAHundredThousand) {
    for (float& distance : table_.distance) distance *= 1.00004f;
    EXPECT_GT(judged().wrong_distance, 200u) << judged().text();
}

TEST_F(StreamJudging, FindsAFaceOfAnotherCell) {
    for (accel::CellId& cell : table_.cell) cell = static_cast<accel::CellId>(index(cell) + 1);
    EXPECT_GT(judged().wrong_cell, 250u) << judged().text();
}

TEST_F(StreamJudging, FindsWhatWasNotAnswered) {
    table_.status[7] = static_cast<WalkStatus>(77);
    table_.status[8] = WalkStatus::Refused;
    table_.status[9] = WalkStatus::Leak;
    EXPECT_EQ(judged().wrong_status, 2u) << judged().text();
    EXPECT_EQ(judged().leaks, 1u);
}

TEST_F(StreamJudging, FindsALimitThatWasNone) {
    for (std::size_t i = 0; i < 500; ++i) {
        table_.status[i] = WalkStatus::Reached;
        table_.source_face[i] = none<accel::SourceFaceId>;
    }
    EXPECT_GT(judged().outside_band, 490u) << judged().text();
}

}  // namespace
}  // namespace enfilade::render

#include "tests/support/ray_census.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "tests/support/degenerate_rays.h"
#include "tools/random_rays.h"

namespace enfilade::test {

using render::RayHit;
using render::RayQuery;
using render::WalkStatus;

namespace {

constexpr std::uint64_t chunk = 20000;

struct Way {
    const char* name;
    render::Tracer tracer;
    render::StreamOrder order;
};
constexpr std::array ways = {Way{"scalar", render::Tracer::Scalar, render::StreamOrder::Coherent},
                             Way{"simd", render::Tracer::Simd, render::StreamOrder::Any},
                             Way{"packet", render::Tracer::Packet, render::StreamOrder::Any}};

bool is_answer(const RayTable& table, std::size_t i) {
    return table.status[i] == WalkStatus::Hit || table.status[i] == WalkStatus::Reached;
}

void trace(const accel::SceneView& scene, const StreamJudge& judge, const std::vector<RayQuery>& rays,
           const std::string& family, std::uint64_t most_judged, RayCensus& census) {
    RayTable table(rays);
    std::vector<RayHit> expected;
    for (const Way& way : ways) {
        CensusRow& row = census[{family, way.name}];
        render::RayStats stats;
        table.trace(scene, {.tracer = way.tracer, .order = way.order, .stats = &stats});
        row.rays += rays.size();
        row.several += stats.several;
        row.none += stats.none;
        if (expected.empty()) {
            expected.resize(rays.size());
            for (std::size_t i = 0; i < rays.size(); ++i) {
                expected[i].status = table.status[i];
                expected[i].source_face = table.source_face[i];
                expected[i].distance = table.distance[i];
                expected[i].cell = table.cell[i];
            }
        }
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (!is_answer(table, i)) {
                ++row.leaks;
                if (row.fault.empty()) row.fault = "a leak: " + text_of(rays[i]);
                continue;
            }
            if (table.source_face[i] == expected[i].source_face) continue;
            ++row.differing;
            if (row.judged >= most_judged) continue;
            ++row.judged;
            RayHit answered = expected[i];
            answered.status = table.status[i];
            answered.source_face = table.source_face[i];
            answered.distance = double{table.distance[i]};
            if (judge.is_doubtful(rays[i], expected[i]) || judge.is_doubtful(rays[i], answered)) continue;
            ++row.outside_band;
            if (row.fault.empty()) row.fault = "another face: " + text_of(rays[i]);
        }
    }
}

}  // namespace

void CensusRow::add(const CensusRow& other) {
    rays += other.rays;
    leaks += other.leaks;
    several += other.several;
    none += other.none;
    differing += other.differing;
    judged += other.judged;
    outside_band += other.outside_band;
    if (fault.empty()) fault = other.fault;
}

void take_census(const accel::SceneView& scene, const StreamJudge& judge, std::uint64_t count, std::uint64_t seed,
                 std::uint64_t most_judged, RayCensus& census) {
    for (std::uint64_t done = 0; done < count; done += chunk) {
        const std::size_t size = static_cast<std::size_t>(std::min(chunk, count - done));
        const std::uint64_t chunk_seed = seed * 1000003 + done;
        for (const tools::RayFamily family : tools::ray_families)
            trace(scene, judge, tools::RandomRays(scene, chunk_seed).take(size, family), tools::name_of(family),
                  most_judged, census);
        for (const Degenerate family : degenerate_families) {
            if (family == Degenerate::NoRay || family == Degenerate::Limited) continue;
            trace(scene, judge, degenerate_rays(scene, family, size, chunk_seed), name_of(family), most_judged, census);
        }
    }
}

void add(RayCensus& census, const RayCensus& more) {
    for (const auto& [key, row] : more) census[key].add(row);
}

std::string text_of(const RayCensus& census) {
    std::string text;
    for (const auto& [key, row] : census) {
        std::array<char, 256> line;
        std::snprintf(line.data(), line.size(), "rays | %s | %s | %llu | %llu | %llu | %llu | %llu | %llu | %llu |\n",
                      key.first.c_str(), key.second.c_str(), static_cast<unsigned long long>(row.rays),
                      static_cast<unsigned long long>(row.leaks), static_cast<unsigned long long>(row.several),
                      static_cast<unsigned long long>(row.none), static_cast<unsigned long long>(row.differing),
                      static_cast<unsigned long long>(row.judged), static_cast<unsigned long long>(row.outside_band));
        text += line.data();
    }
    return text;
}

}  // namespace enfilade::test

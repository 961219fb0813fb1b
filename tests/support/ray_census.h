#pragma once
// Very many rays of every family, by every tracer: what leaked, what had to be recovered, what differs.

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "accel/scene.h"
#include "tests/support/stream_judge.h"

namespace enfilade::test {

struct CensusRow {
    std::uint64_t rays = 0;
    std::uint64_t leaks = 0;      ///< no answer, or one that is none
    std::uint64_t several = 0;    ///< recoveries (RayStats)
    std::uint64_t none = 0;       ///< recoveries (RayStats)
    std::uint64_t differing = 0;  ///< name another face than the scalar walk in float does
    std::uint64_t judged = 0;     ///< of those: the first ones, each looked at with all edges
    std::uint64_t outside_band = 0;
    std::string fault;  ///< the first, in words

    void add(const CensusRow& other);
};

/// By family and tracer.
using RayCensus = std::map<std::pair<std::string, std::string>, CensusRow>;

/// Traces `count` rays of every family by every tracer. Rays differ with the seed. Cost: some 100 ns a ray, and 100 us
/// for each of `most_judged` differing ones of a family and tracer.
void take_census(const accel::SceneView& scene, const StreamJudge& judge, std::uint64_t count, std::uint64_t seed,
                 std::uint64_t most_judged, RayCensus& census);

void add(RayCensus& census, const RayCensus& more);

/// Rows of a table, each `rays | family | tracer | ... |`.
[[nodiscard]] std::string text_of(const RayCensus& census);

}  // namespace enfilade::test

// Who is fastest at the same rays.

#include <algorithm>
#include <limits>
#include <memory>
#include <thread>

#include "render/executor.h"
#include "tools/bench_cells.h"

namespace enfilade::tools {

namespace {

std::vector<std::function<void()>> works_of(const std::vector<Competitor>& competitors) {
    std::vector<std::function<void()>> works;
    for (const Competitor& competitor : competitors) works.push_back(competitor.work);
    return works;
}

}  // namespace

const char* name_of(render::Tracer tracer) {
    switch (tracer) {
        case render::Tracer::Scalar: return "scalar";
        case render::Tracer::Simd: return "simd";
        case render::Tracer::Packet: return "packet";
    }
    return "scalar";
}

RayContest::RayContest(int rounds, double rays, std::vector<Competitor> competitors, Clock clock)
    : competitors_(std::move(competitors)), rays_(rays), contest_(rounds, works_of(competitors_), clock) {}

std::size_t RayContest::find(const std::string& name) const {
    return std::size_t(std::find_if(competitors_.begin(), competitors_.end(),
                                    [&](const Competitor& competitor) { return competitor.name == name; }) -
                       competitors_.begin());
}

BenchRow RayContest::row(const std::string& what, std::size_t k, std::size_t reference) const {
    return {.row = what,
            .value = speed(k),
            .unit = "Mrays/s",
            .reference = competitors_[reference].name,
            .reference_value = speed(reference),
            .ratio = contest_.faster(k, reference),
            .spread = contest_.spread(k, reference)};
}

std::size_t RayContest::fastest(std::size_t begin, std::size_t end) const {
    std::size_t best = begin;
    for (std::size_t k = begin; k < end; ++k)
        if (contest_.median_of(k) < contest_.median_of(best)) best = k;
    return best;
}

std::span<const Cores> one_and_all_cores() {
    static const accel::SerialExecutor one;
    static const std::unique_ptr<accel::Executor> all = render::make_executor();
    static const std::array<Cores, 2> cores = {
        Cores{1, &one, Clock::Thread},
        Cores{std::max(1u, std::thread::hardware_concurrency()), all.get(), Clock::Wall}};
    return cores;
}

render::EmbreeWay fastest_way(std::span<const render::EmbreeWay> ways, int rounds,
                              const std::function<void(render::EmbreeWay)>& work) {
    std::vector<std::function<void()>> works;
    for (const render::EmbreeWay way : ways) works.push_back([&work, way] { work(way); });
    const Contest contest(rounds, works);
    std::size_t best = 0;
    for (std::size_t k = 0; k < ways.size(); ++k)
        if (contest.least_of(k) < contest.least_of(best)) best = k;
    return ways[best];
}

std::vector<render::EmbreeWay> ways_where(const std::function<bool(render::EmbreeWay)>& passes) {
    std::vector<render::EmbreeWay> ways;
    std::copy_if(render::embree_ways.begin(), render::embree_ways.end(), std::back_inserter(ways), passes);
    return ways;
}

}  // namespace enfilade::tools

#pragma once
// What the benchmarks of tracers share (bench_cells*.cpp).

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "accel/scene.h"
#include "render/embree_reference.h"
#include "render/tracer.h"
#include "tools/bench.h"
#include "tools/contest.h"
#include "tools/floor_views.h"

namespace enfilade::tools {

inline constexpr std::array tracers = {render::Tracer::Scalar, render::Tracer::Simd, render::Tracer::Packet};
[[nodiscard]] const char* name_of(render::Tracer tracer);

/// A building as tracers see it, with Embree's scene of it.
struct TracedBuilding {
    std::string name;
    accel::Scene scene;
    render::EmbreeReference embree;

    TracedBuilding(std::string name_, accel::Scene scene_)
        : name(std::move(name_)), scene(std::move(scene_)), embree(scene.view()) {}
};

/// A generated floor of so many rooms.
[[nodiscard]] TracedBuilding office_floor(std::uint32_t rooms);
/// The example, or what stands for it (examples.h).
[[nodiscard]] TracedBuilding example_building(Bench& bench, const std::string& name, std::uint32_t rooms);

/// Whoever takes part in a contest, and how often.
struct Competitor {
    std::string name;
    std::function<void()> work;
};

/// A contest of competitors by name, which does `rays` rays in each of their turns.
class RayContest {
public:
    RayContest(int rounds, double rays, std::vector<Competitor> competitors, Clock clock);

    [[nodiscard]] std::size_t find(const std::string& name) const;
    /// Mrays/s
    [[nodiscard]] double speed(std::size_t k) const { return rays_ / contest_.median_of(k) / 1e6; }
    /// The row of competitor k against `reference`: scene, threads and goal are the caller's.
    [[nodiscard]] BenchRow row(const std::string& what, std::size_t k, std::size_t reference) const;
    /// The fastest of competitors [begin, end).
    [[nodiscard]] std::size_t fastest(std::size_t begin, std::size_t end) const;
    [[nodiscard]] const std::string& name(std::size_t k) const { return competitors_[k].name; }

private:
    std::vector<Competitor> competitors_;
    double rays_;
    Contest contest_;
};

/// Who runs the rays of a contest.
struct Cores {
    unsigned threads;
    const accel::Executor* executor;
    Clock clock;
};
/// One thread, then all.
[[nodiscard]] std::span<const Cores> one_and_all_cores();

/// The fastest of `ways` at `work`, by the least of `rounds` rounds in turn.
[[nodiscard]] render::EmbreeWay fastest_way(std::span<const render::EmbreeWay> ways, int rounds,
                                            const std::function<void(render::EmbreeWay)>& work);
/// Those of `render::embree_ways` that pass.
[[nodiscard]] std::vector<render::EmbreeWay> ways_where(const std::function<bool(render::EmbreeWay)>& passes);

/// Pictures: every tracer against Embree's single rays and packets.
void bench_primary(Bench& bench, const TracedBuilding& building);
/// Rays that leave surfaces in all directions, in the order of an image and shuffled.
void bench_bounces(Bench& bench, const TracedBuilding& building);
/// Rays from surfaces to the lamps of rooms.
void bench_shadows(Bench& bench, const TracedBuilding& building);
/// Whether all see the same faces, and the oracle too; leaks.
void bench_agreement(Bench& bench, const TracedBuilding& building);
/// What a ray costs in a large building and in a small one.
void bench_growth(Bench& bench, const TracedBuilding& small, const TracedBuilding& large);

}  // namespace enfilade::tools

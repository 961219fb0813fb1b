#pragma once
// Several competitors in turn, so that a slow moment of the machine meets all of them. Time is that of the calling
// thread on its core: what other programs take meanwhile does not count.

#include <time.h>

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "tools/bench.h"

namespace enfilade::tools {

/// Seconds that one call keeps the calling thread's core busy.
template <class F>
[[nodiscard]] double busy_seconds_of(F&& work) {
    const auto now = [] {
        timespec t;
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
        return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
    };
    const double start = now();
    std::forward<F>(work)();
    return now() - start;
}

enum class Clock {
    Thread,  ///< of the calling thread's core
    Wall     ///< for competitors that use all cores
};

/// Seconds of each competitor in each round.
class Contest {
public:
    /// Each competitor runs once to warm the caches, then `rounds` times in turn, every other round backwards.
    Contest(int rounds, std::span<const std::function<void()>> competitors, Clock clock = Clock::Thread)
        : seconds_(competitors.size()) {
        for (const auto& work : competitors) work();
        for (int round = 0; round < rounds; ++round)
            for (std::size_t i = 0; i < competitors.size(); ++i) {
                const std::size_t k = round % 2 == 0 ? i : competitors.size() - 1 - i;
                seconds_[k].push_back(clock == Clock::Thread ? busy_seconds_of(competitors[k])
                                                             : seconds_of(competitors[k]));
            }
    }

    [[nodiscard]] double median_of(std::size_t k) const { return median(seconds_[k]); }
    [[nodiscard]] double least_of(std::size_t k) const {
        return *std::min_element(seconds_[k].begin(), seconds_[k].end());
    }
    /// How many times faster k is than `reference`: median of the ratios within the rounds.
    [[nodiscard]] double faster(std::size_t k, std::size_t reference) const { return median(ratios(k, reference)); }
    /// How much that differs between rounds: half of what lies between the quartiles, over the median. Nothing where
    /// there were fewer than three.
    [[nodiscard]] std::optional<double> spread(std::size_t k, std::size_t reference) const {
        std::vector<double> sorted = ratios(k, reference);
        if (sorted.size() < 3) return std::nullopt;
        std::sort(sorted.begin(), sorted.end());
        const std::size_t quarter = sorted.size() / 4;
        return (sorted[sorted.size() - 1 - quarter] - sorted[quarter]) / 2 / median(sorted);
    }

private:
    [[nodiscard]] std::vector<double> ratios(std::size_t k, std::size_t reference) const {
        std::vector<double> ratios;
        for (std::size_t round = 0; round < seconds_[k].size(); ++round)
            ratios.push_back(seconds_[reference][round] / seconds_[k][round]);
        return ratios;
    }

    std::vector<std::vector<double>> seconds_;  ///< [competitor][round]
};

}  // namespace enfilade::tools

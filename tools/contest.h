#pragma once
// Several competitors in turn, so that a slow moment of the machine meets all of them. Time is that of the calling
// thread on its core: what other programs take meanwhile does not count.

#include <time.h>

#include <functional>
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

/// Seconds of each competitor in each round.
class Contest {
public:
    /// Each competitor runs once to warm the caches, then `rounds` times in turn, every other round backwards.
    Contest(int rounds, std::span<const std::function<void()>> competitors) : seconds_(competitors.size()) {
        for (const auto& work : competitors) work();
        for (int round = 0; round < rounds; ++round)
            for (std::size_t i = 0; i < competitors.size(); ++i) {
                const std::size_t k = round % 2 == 0 ? i : competitors.size() - 1 - i;
                seconds_[k].push_back(busy_seconds_of(competitors[k]));
            }
    }

    [[nodiscard]] double median_of(std::size_t k) const { return median(seconds_[k]); }
    [[nodiscard]] double least_of(std::size_t k) const {
        return *std::min_element(seconds_[k].begin(), seconds_[k].end());
    }
    /// How many times faster k is than `reference`: median of the ratios within the rounds.
    [[nodiscard]] double faster(std::size_t k, std::size_t reference) const {
        std::vector<double> ratios;
        for (std::size_t round = 0; round < seconds_[k].size(); ++round)
            ratios.push_back(seconds_[reference][round] / seconds_[k][round]);
        return median(std::move(ratios));
    }

private:
    std::vector<std::vector<double>> seconds_;  ///< [competitor][round]
};

}  // namespace enfilade::tools

#include "tools/gpu/device_contest.h"

#include <algorithm>
#include <chrono>

namespace enfilade::tools::gpu {

double median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

DeviceContest::DeviceContest(render::cuda::Device& device, int rounds,
                             std::span<const std::function<void()>> competitors, double patience)
    : seconds_(competitors.size()) {
    double once = 0;
    for (const auto& ask : competitors) {
        ask();
        device.wait();
        if (device.is_card()) once += device.seconds_of(ask);
    }
    if (!device.is_card()) return;
    if (once * rounds > patience) rounds = std::max(3, static_cast<int>(patience / once));
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < competitors.size(); ++i) {
            const std::size_t k = round % 2 == 0 ? i : competitors.size() - 1 - i;
            seconds_[k].push_back(device.seconds_of(competitors[k]));
        }
}

std::optional<double> DeviceContest::seconds(std::size_t k) const {
    if (seconds_[k].empty()) return std::nullopt;
    return median_of(seconds_[k]);
}

std::optional<double> DeviceContest::faster(std::size_t k, std::size_t reference) const {
    if (seconds_[k].empty()) return std::nullopt;
    std::vector<double> ratios;
    for (std::size_t round = 0; round < seconds_[k].size(); ++round)
        ratios.push_back(seconds_[reference][round] / seconds_[k][round]);
    return median_of(std::move(ratios));
}

std::optional<double> DeviceContest::spread(std::size_t k) const {
    if (seconds_[k].size() < 3) return std::nullopt;
    std::vector<double> sorted = seconds_[k];
    std::sort(sorted.begin(), sorted.end());
    const std::size_t quarter = sorted.size() / 4;
    return (sorted[sorted.size() - 1 - quarter] - sorted[quarter]) / 2 / median_of(sorted);
}

std::optional<double> seconds_with_waiting(render::cuda::Device& device, int rounds, const std::function<void()>& ask) {
    std::vector<double> seconds;
    for (int round = -1; round < rounds; ++round) {
        device.wait();
        const auto start = std::chrono::steady_clock::now();
        ask();
        device.wait();
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        if (round >= 0) seconds.push_back(passed.count());
        if (!device.is_card()) return std::nullopt;
    }
    return median_of(std::move(seconds));
}

}  // namespace enfilade::tools::gpu

#pragma once
// Several competitors on one device in turn, so that a slow moment of the card meets all of them.

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "render/cuda/device.h"

namespace enfilade::tools::gpu {

/// Seconds of each competitor, by the device's own clock. This machine's cores are no card: on them everybody runs
/// once, and nothing is measured.
class DeviceContest {
public:
    /// Each competitor's work is asked for twice to warm up, then measured in `rounds` rounds in turn, every other
    /// round backwards; in fewer, three at least, where all rounds would take longer than `patience` seconds.
    DeviceContest(render::cuda::Device& device, int rounds, std::span<const std::function<void()>> competitors,
                  double patience = 4);

    /// Median over the rounds; nothing where it was not measured.
    [[nodiscard]] std::optional<double> seconds(std::size_t k) const;
    /// How many times faster k is than `reference`: median of the ratios within the rounds.
    [[nodiscard]] std::optional<double> faster(std::size_t k, std::size_t reference) const;
    /// Half of what lies between the quartiles of k's seconds, as a share of their median.
    [[nodiscard]] std::optional<double> spread(std::size_t k) const;

private:
    std::vector<std::vector<double>> seconds_;  ///< [competitor][round]
};

/// The middle one; of an even count the mean of both. \pre not empty
[[nodiscard]] double median_of(std::vector<double> values);

/// Seconds by this machine's clock from asking to the end of the work, median of `rounds`; nothing on the host.
[[nodiscard]] std::optional<double> seconds_with_waiting(render::cuda::Device& device, int rounds,
                                                         const std::function<void()>& ask);

}  // namespace enfilade::tools::gpu

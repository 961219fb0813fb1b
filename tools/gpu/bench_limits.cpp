#include <functional>

#include "render/cuda/buffer.h"
#include "tools/gpu/bench.h"
#include "tools/gpu/device_contest.h"
#include "tools/gpu/limits.h"

namespace enfilade::tools::gpu {

namespace {

using render::cuda::Buffer;

constexpr int launches = 1000;

std::size_t pixels_of(int side) { return static_cast<std::size_t>(side) * static_cast<std::size_t>(side); }

std::optional<double> divided(std::optional<double> value, double by) {
    if (value) *value /= by;
    return value;
}

}  // namespace

Limits bench_limits(render::cuda::Device& device, const BenchOptions& options, Report& report) {
    report.progress("limits of the device");
    const std::size_t copied = device.is_card() ? std::size_t{1} << 30 : std::size_t{1} << 16;
    const Buffer<std::uint32_t> large(device, pixels_of(options.large_side)), small(device, pixels_of(options.side)),
        never(device, 1);
    const Buffer<char> from(device, copied), to(device, copied);
    const std::vector<std::function<void()>> competitors = {[&] {
                                                                for (int i = 0; i < launches; ++i)
                                                                    ask_empty(device, never.data());
                                                            },
                                                            [&] { ask_copy(device, from.data(), to.data(), copied); },
                                                            [&] {
                                                                for (int i = 0; i < 16; ++i)
                                                                    ask_image(device, small.data(), small.size());
                                                            },
                                                            [&] { ask_image(device, large.data(), large.size()); }};
    const DeviceContest contest(device, options.rounds, competitors);

    Limits limits;
    limits.empty_kernel = divided(contest.seconds(0), launches);
    limits.empty_waited = seconds_with_waiting(device, 50, [&] { ask_empty(device, never.data()); });
    if (contest.seconds(1)) limits.copy = 2 * static_cast<double>(copied) / *contest.seconds(1);
    limits.image = divided(contest.seconds(2), 16);
    limits.large_image = contest.seconds(3);

    const auto rate = [](std::optional<double> seconds, std::size_t pixels) -> std::optional<double> {
        if (!seconds) return std::nullopt;
        return static_cast<double>(pixels) / *seconds / 1e6;
    };
    const auto in = [](std::optional<double> value, double unit) -> std::optional<double> {
        if (!value) return std::nullopt;
        return *value * unit;
    };
    report.section("Limits", "What nothing on this card beats, measured in the same run.");
    MarkdownTable table({"what", "figure"});
    table.add({"an empty kernel, launched one after the other", measured(in(limits.empty_kernel, 1e6), " us")});
    table.add({"an empty kernel, waited for each time", measured(in(limits.empty_waited, 1e6), " us")});
    table.add({"copying " + bytes_text(copied) + ", bytes read and written", measured(in(limits.copy, 1e-9), " GB/s")});
    table.add({"writing an image of one colour, " + std::to_string(options.side) + " x " + std::to_string(options.side),
               measured(rate(limits.image, small.size()), " million pixels/s")});
    table.add({"the same, " + std::to_string(options.large_side) + " x " + std::to_string(options.large_side),
               measured(rate(limits.large_image, large.size()), " million pixels/s")});
    report.table(table);
    return limits;
}

}  // namespace enfilade::tools::gpu

#pragma once
// What a benchmark measures, against what, and whether that is enough (docs/benchmarks.md).

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/console.h"

namespace enfilade::tools {

/// What a row must reach: the figure, kept beside the measurement.
struct Goal {
    enum class Of { Value, Ratio };
    enum class Side { AtMost, AtLeast };
    Of of = Of::Value;
    Side side = Side::AtMost;
    double bound = 0;
    [[nodiscard]] std::string text() const;  ///< "value <= 0.3"
};
[[nodiscard]] inline Goal value_at_most(double bound) { return {Goal::Of::Value, Goal::Side::AtMost, bound}; }
[[nodiscard]] inline Goal value_at_least(double bound) { return {Goal::Of::Value, Goal::Side::AtLeast, bound}; }
[[nodiscard]] inline Goal ratio_at_least(double bound) { return {Goal::Of::Ratio, Goal::Side::AtLeast, bound}; }

struct BenchRow {
    std::string bench = {};
    std::string row = {};
    std::string scene = {};
    unsigned threads = 1;
    double value = 0;
    std::string unit = {};
    std::string reference = {};                  ///< what it is measured against; empty: nothing
    std::optional<double> reference_value = {};  ///< in the same unit, from the same run
    std::optional<double> ratio = {};            ///< how many times better than the reference, > 1 is better
    std::optional<Goal> goal = {};
    std::optional<double> spread = {};  ///< of the ratio between rounds (contest.h), a share of it

    /// Whether the goal is reached; nothing where there is none, or where the reference is absent.
    [[nodiscard]] std::optional<bool> met() const;
};

/// The run of one benchmark or of several: collects rows and prints each one as it comes.
class Bench {
public:
    /// `data`: the folder of real plans, absent or not.
    Bench(const Console& console, bool quick, std::filesystem::path data)
        : console_(&console), quick_(quick), data_(std::move(data)) {}

    /// Short enough that the whole benchmark ends within 40 s.
    [[nodiscard]] bool quick() const { return quick_; }
    [[nodiscard]] const std::filesystem::path& data() const { return data_; }
    [[nodiscard]] const Console& console() const { return *console_; }
    [[nodiscard]] const std::vector<BenchRow>& rows() const { return rows_; }

    void begin(std::string name, const std::string& sentence);
    /// Its `bench` is filled in.
    void add(BenchRow row);
    /// The same without a line of its own: for many rows that a remark sums up.
    void add_silently(BenchRow row);
    /// A remark that belongs to the table: what was skipped, and why.
    void remark(const std::string& sentence);

private:
    const Console* console_;
    bool quick_;
    std::filesystem::path data_;
    std::string name_;
    std::vector<BenchRow> rows_;
};

/// The table's line of a row.
[[nodiscard]] std::string row_text(const BenchRow& row);
/// docs/bench.schema.json
[[nodiscard]] nlohmann::ordered_json bench_json(const Bench& bench);

/// Seconds that one call takes.
template <class F>
[[nodiscard]] double seconds_of(F&& work) {
    const auto start = std::chrono::steady_clock::now();
    std::forward<F>(work)();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

[[nodiscard]] double median(std::vector<double> values);

/// Median seconds of `runs` calls, after one that warms the caches.
template <class F>
[[nodiscard]] double median_seconds(int runs, F&& work) {
    work();
    std::vector<double> times;
    for (int run = 0; run < runs; ++run) times.push_back(seconds_of(work));
    return median(std::move(times));
}

/// Two competitors in turn, so that a slow moment of the machine meets both.
struct Duel {
    double a_seconds = 0;
    double b_seconds = 0;
    double b_over_a = 0;  ///< median of the ratios of neighbouring runs
};
template <class A, class B>
[[nodiscard]] Duel duel(int runs, A&& a, B&& b) {
    a();
    b();
    std::vector<double> a_times, b_times, ratios;
    for (int run = 0; run < runs; ++run) {
        a_times.push_back(seconds_of(a));
        b_times.push_back(seconds_of(b));
        ratios.push_back(b_times.back() / a_times.back());
    }
    return {median(std::move(a_times)), median(std::move(b_times)), median(std::move(ratios))};
}

/// Exponent of seconds over size: slope of the line through the points (log size, log seconds), by least squares.
[[nodiscard]] double growth_exponent(const std::vector<std::array<double, 2>>& points);

/// Largest resident memory of this process since the last `reset_peak_memory`, in bytes.
[[nodiscard]] double peak_memory();
void reset_peak_memory();
/// Resident memory now, in bytes.
[[nodiscard]] double resident_memory();

/// Keeps the calling thread and all that it starts on one core while it lives.
class OneCore {
public:
    OneCore();
    ~OneCore();
    OneCore(const OneCore&) = delete;
    OneCore& operator=(const OneCore&) = delete;

private:
    struct Saved;
    std::unique_ptr<Saved> saved_;
};

// The benchmarks, one file each (bench_<name>.cpp).
void bench_build(Bench& bench);
void bench_cells(Bench& bench);
void bench_check(Bench& bench);
void bench_convexify(Bench& bench);
void bench_dial(Bench& bench);
void bench_edit(Bench& bench);
void bench_furnished(Bench& bench);
void bench_furniture(Bench& bench);
void bench_gmap(Bench& bench);
void bench_lights(Bench& bench);
void bench_octree(Bench& bench);
void bench_queries(Bench& bench);
void bench_scene(Bench& bench);

}  // namespace enfilade::tools

#include "tools/bench.h"

#include <malloc.h>
#include <sched.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "tools/version.h"

namespace enfilade::tools {

namespace {

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, value >= 1000 ? "%.0f" : "%.3g", value);
    return text;
}

/// A field of /proc/self/status in bytes; 0 where it is not there.
double status_bytes(const std::string& field) {
    std::ifstream status("/proc/self/status");
    std::string line;
    while (std::getline(status, line))
        if (line.compare(0, field.size(), field) == 0) return 1024 * std::stod(line.substr(field.size()));
    return 0;
}

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    std::string line;
    while (std::getline(info, line))
        if (line.compare(0, 10, "model name") == 0) return line.substr(line.find(':') + 2);
    return "unknown";
}

}  // namespace

std::string Goal::text() const {
    return std::string(of == Of::Value ? "value" : "ratio") + (side == Side::AtMost ? " <= " : " >= ") + number(bound);
}

std::optional<bool> BenchRow::met() const {
    if (!goal) return std::nullopt;
    if (goal->of == Goal::Of::Ratio && !ratio) return std::nullopt;
    const double reached = goal->of == Goal::Of::Ratio ? *ratio : value;
    return goal->side == Goal::Side::AtMost ? reached <= goal->bound : reached >= goal->bound;
}

void Bench::begin(std::string name, const std::string& sentence) {
    name_ = std::move(name);
    console_->say("\n" + name_ + ": " + sentence);
}

void Bench::add(BenchRow row) {
    console_->say(row_text(row));
    add_silently(std::move(row));
}

void Bench::add_silently(BenchRow row) {
    row.bench = name_;
    rows_.push_back(std::move(row));
}

void Bench::remark(const std::string& sentence) { console_->say("  " + sentence); }

std::string row_text(const BenchRow& row) {
    std::string against;
    if (row.reference_value) against = row.reference + " " + number(*row.reference_value);
    if (row.ratio) against += ", ratio " + number(*row.ratio);
    if (row.spread) against += " +-" + number(*row.spread * 100) + " %";
    const std::optional<bool> met = row.met();
    const std::string verdict = !row.goal ? ""
                                          : row.goal->text() + (!met   ? "  not measured"
                                                                : *met ? "  met"
                                                                       : "  NOT MET");
    char text[512];
    std::snprintf(text, sizeof text, "  %-42s %-22s %2u thr %10s %-12s %-40s %s", row.row.c_str(), row.scene.c_str(),
                  row.threads, number(row.value).c_str(), row.unit.c_str(), against.c_str(), verdict.c_str());
    std::string line = text;
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

nlohmann::ordered_json bench_json(const Bench& bench) {
    nlohmann::ordered_json json = {{"program", "enfilade"}, {"version", version}};
    json["machine"] = {{"processor", processor_name()}, {"cores", std::thread::hardware_concurrency()}};
    json["quick"] = bench.quick();
    json["rows"] = nlohmann::ordered_json::array();
    const auto optional = [](const auto& value) {
        return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
    };
    for (const BenchRow& row : bench.rows()) {
        nlohmann::ordered_json entry = {{"bench", row.bench}, {"row", row.row}, {"scene", row.scene}};
        entry["threads"] = row.threads;
        entry["value"] = row.value;
        entry["unit"] = row.unit;
        entry["reference"] = row.reference.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(row.reference);
        entry["reference_value"] = optional(row.reference_value);
        entry["ratio"] = optional(row.ratio);
        entry["spread"] = optional(row.spread);
        entry["goal"] = row.goal ? nlohmann::ordered_json(row.goal->text()) : nlohmann::ordered_json();
        entry["met"] = optional(row.met());
        json["rows"].push_back(std::move(entry));
    }
    return json;
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

double growth_exponent(const std::vector<std::array<double, 2>>& points) {
    double x_sum = 0, y_sum = 0, xx_sum = 0, xy_sum = 0;
    for (const auto& [size, seconds] : points) {
        const double x = std::log(size);
        const double y = std::log(seconds);
        x_sum += x;
        y_sum += y;
        xx_sum += x * x;
        xy_sum += x * y;
    }
    const double count = double(points.size());
    return (count * xy_sum - x_sum * y_sum) / (count * xx_sum - x_sum * x_sum);
}

double peak_memory() { return status_bytes("VmHWM:"); }
double resident_memory() { return status_bytes("VmRSS:"); }

void reset_peak_memory() {
    malloc_trim(0);  // what earlier work gave back must not count for the next
    std::ofstream("/proc/self/clear_refs") << 5;
}

struct OneCore::Saved {
    tbb::global_control limit{tbb::global_control::max_allowed_parallelism, 1};
    cpu_set_t cores;
};

OneCore::OneCore() : saved_(std::make_unique<Saved>()) {
    sched_getaffinity(0, sizeof saved_->cores, &saved_->cores);
    const int here = sched_getcpu();
    if (here < 0) return;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(here, &one);
    sched_setaffinity(0, sizeof one, &one);
}

OneCore::~OneCore() { sched_setaffinity(0, sizeof saved_->cores, &saved_->cores); }

}  // namespace enfilade::tools
